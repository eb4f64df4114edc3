#include "widgets/view/render/offscreen_renderer.h"

#include "widgets/view/render/gl_setup.h"
#include "widgets/view/render/renderer.h"
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QThread>
#include <optional>

namespace ramure {
namespace {

constexpr int maxSide = 16384;

QOpenGLFramebufferObjectFormat targetFormat(int samples)
{
    QOpenGLFramebufferObjectFormat format;
    format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
    format.setInternalTextureFormat(GL_RGBA8);
    format.setSamples(samples);
    return format;
}

} // namespace

struct OffscreenRenderer::Private
{
    QOffscreenSurface surface;
    std::optional<QOpenGLContext> context;
    std::unique_ptr<Renderer> renderer;
};

OffscreenRenderer::OffscreenRenderer()
    : d(std::make_unique<Private>())
{
    if (!qobject_cast<QGuiApplication*>(QCoreApplication::instance()))
        return;
    d->surface.setFormat(openGlFormat());
    d->surface.create();
}

OffscreenRenderer::~OffscreenRenderer() = default;

Expected<void> OffscreenRenderer::begin()
{
    const auto* application = qobject_cast<QGuiApplication*>(QCoreApplication::instance());
    if (application && QThread::currentThread() != application->thread() &&
        !QOpenGLContext::supportsThreadedOpenGL())
        return fail(ErrorCode::Unknown, RAMURE_NOOP("The graphics driver cannot draw beside the window: "
                                                    "`ramure-cli render` writes the same pictures"));
    if (application && d->surface.isValid()) {
        d->context.emplace();
        d->context->setFormat(d->surface.requestedFormat());
        if (!d->context->create() || !d->context->makeCurrent(&d->surface))
            d->context.reset();
    }
    if (!d->context)
        return fail(ErrorCode::Unknown, RAMURE_NOOP("No OpenGL 3.3 context is available here"));
    auto renderer = Renderer::make();
    if (!renderer) {
        d->context.reset();
        return fail(std::move(renderer.error()));
    }
    d->renderer = std::move(*renderer);
    return {};
}

Expected<QImage> OffscreenRenderer::draw(const RenderScene& scene, const Camera& camera, QSize size,
                                         const RenderOptions& options)
{
    if (size.width() < 1 || size.height() < 1 || size.width() > maxSide || size.height() > maxSide)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("The picture's sides must be 1 to %1 pixels"),
                    {std::to_string(maxSide)});
    QOpenGLFramebufferObject target(size, targetFormat(options.samples));
    if (!target.isValid() || target.size() != size)
        return fail(ErrorCode::Unknown,
                    RAMURE_NOOP("The graphics driver refuses a picture of %1 x %2 pixels"),
                    {std::to_string(size.width()), std::to_string(size.height())});
    d->renderer->draw(scene, camera, size, target.handle(), options);
    (void)d->renderer->takeReleased(); // nobody waits for the memory here
    // toImage resolves the samples; the colours are not multiplied by the alpha of a missing background.
    return target.toImage().convertToFormat(QImage::Format_ARGB32);
}

void OffscreenRenderer::end()
{
    d->renderer.reset();
    d->context.reset();
}

Expected<QImage> renderImage(const RenderScene& scene, const Camera& camera, QSize size,
                             const RenderOptions& options)
{
    OffscreenRenderer offscreen;
    if (auto begun = offscreen.begin(); !begun)
        return fail(std::move(begun.error()));
    auto image = offscreen.draw(scene, camera, size, options);
    offscreen.end();
    return image;
}

} // namespace ramure
