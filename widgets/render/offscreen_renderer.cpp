#include "widgets/render/offscreen_renderer.h"

#include "widgets/render/renderer.h"
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>

namespace ramure {
namespace {

constexpr int maxSide = 16384;

/// A context of our own, current on its own surface.
struct OffscreenContext
{
    QOffscreenSurface surface;
    QOpenGLContext context;

    bool start()
    {
        QSurfaceFormat format = QSurfaceFormat::defaultFormat();
        format.setRenderableType(QSurfaceFormat::OpenGL);
        format.setVersion(3, 3);
        format.setProfile(QSurfaceFormat::CoreProfile);
        context.setFormat(format);
        if (!context.create())
            return false;
        surface.setFormat(context.format());
        surface.create();
        return surface.isValid() && context.makeCurrent(&surface);
    }
};

QOpenGLFramebufferObjectFormat targetFormat(int samples)
{
    QOpenGLFramebufferObjectFormat format;
    format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
    format.setInternalTextureFormat(GL_RGBA8);
    format.setSamples(samples);
    return format;
}

} // namespace

Expected<QImage> renderImage(const RenderScene& scene, const Camera& camera, QSize size,
                             const RenderOptions& options)
{
    if (size.width() < 1 || size.height() < 1 || size.width() > maxSide || size.height() > maxSide)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("The picture's sides must be 1 to %1 pixels"),
                    {std::to_string(maxSide)});
    OffscreenContext offscreen;
    if (!qobject_cast<QGuiApplication*>(QCoreApplication::instance()) || !offscreen.start())
        return fail(ErrorCode::Unknown, RAMURE_NOOP("No OpenGL 3.3 context is available here"));
    auto renderer = Renderer::make();
    if (!renderer)
        return fail(std::move(renderer.error()));
    QOpenGLFramebufferObject target(size, targetFormat(options.samples));
    if (!target.isValid() || target.size() != size)
        return fail(ErrorCode::Unknown,
                    RAMURE_NOOP("The graphics driver refuses a picture of %1 x %2 pixels"),
                    {std::to_string(size.width()), std::to_string(size.height())});
    (*renderer)->draw(scene, camera, size, target.handle(), options);
    // toImage resolves the samples; the colours are not multiplied by the alpha of a missing background.
    QImage image = target.toImage().convertToFormat(QImage::Format_ARGB32);
    renderer->reset();
    return image;
}

} // namespace ramure
