#include "widgets/view/render/passes/offscreen_renderer.h"

#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/render/passes/renderer.h"
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QThread>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec4.hpp>
#include <optional>
#include <vector>

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

Expected<void> checkSize(QSize size)
{
    if (size.width() < 1 || size.height() < 1 || size.width() > maxSide || size.height() > maxSide)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("The picture's sides must be 1 to %1 pixels"),
                    {std::to_string(maxSide)});
    return {};
}

Expected<void> checkTarget(const QOpenGLFramebufferObject& target, QSize size)
{
    if (!target.isValid() || target.size() != size)
        return fail(ErrorCode::Unknown,
                    RAMURE_NOOP("The graphics driver refuses a picture of %1 x %2 pixels"),
                    {std::to_string(size.width()), std::to_string(size.height())});
    return {};
}

/// Light adds up, the numbers of sRGB do not.
const std::array<float, 256>& linearOf()
{
    static const std::array<float, 256> table = [] {
        std::array<float, 256> made{};
        for (std::size_t i = 0; i < made.size(); ++i) {
            const double s = double(i) / 255.0;
            made[i] = float(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
        }
        return made;
    }();
    return table;
}

int srgbOf(float linear)
{
    const float s = linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
    return int(std::lround(255.0f * std::clamp(s, 0.0f, 1.0f)));
}

/// The mean of pictures of one size. Where something is seen through, its colour counts as far as it covers.
class LightSum
{
public:
    explicit LightSum(QSize size)
        : m_size(size)
        , m_sums(std::size_t(size.width()) * std::size_t(size.height()))
    {
    }
    void add(const QImage& image)
    {
        const auto& linear = linearOf();
        glm::vec4* sum = m_sums.data();
        for (int y = 0; y < m_size.height(); ++y) {
            const auto* row = reinterpret_cast<const QRgb*>(image.constScanLine(y));
            for (int x = 0; x < m_size.width(); ++x, ++sum) {
                const auto alpha = float(qAlpha(row[x]));
                *sum +=
                    alpha * glm::vec4(linear[std::size_t(qRed(row[x]))], linear[std::size_t(qGreen(row[x]))],
                                      linear[std::size_t(qBlue(row[x]))], 1.0f);
            }
        }
        m_count += 255.0f;
    }
    [[nodiscard]] QImage mean() const
    {
        QImage image(m_size, QImage::Format_ARGB32);
        const glm::vec4* sum = m_sums.data();
        for (int y = 0; y < m_size.height(); ++y) {
            auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
            for (int x = 0; x < m_size.width(); ++x, ++sum) {
                const glm::vec3 colour = glm::vec3(*sum) / std::max(sum->a, 1e-6f);
                row[x] = qRgba(srgbOf(colour.r), srgbOf(colour.g), srgbOf(colour.b),
                               int(std::lround(255.0f * sum->a / m_count)));
            }
        }
        return image;
    }

private:
    QSize m_size;
    std::vector<glm::vec4> m_sums;
    float m_count = 0.0f;
};

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
                                         const RenderOptions& options, const Progress& progress)
{
    RAMURE_TRY(checkSize(size));
    QOpenGLFramebufferObject target(size, targetFormat(options.samples));
    RAMURE_TRY(checkTarget(target, size));
    const bool isWatched = progress.onFraction || progress.stop.stop_possible();
    const auto picture = [&](const Camera& seenBy, const Progress& part) {
        d->renderer->setProgress(isWatched ? &part : nullptr);
        d->renderer->draw(scene, seenBy, size, target.handle(), options);
        d->renderer->setProgress(nullptr);
        (void)d->renderer->takeReleased(); // nobody waits for the memory here
        // toImage resolves the samples; the colours are not multiplied by the alpha of a missing background.
        return target.toImage().convertToFormat(QImage::Format_ARGB32);
    };
    const bool hasLens = options.lens.diameter > 0.0 && !camera.orthographic;
    const int count = std::max(options.pictures, hasLens ? lensSamples : 1);
    const auto cancelled = [] { return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled")); };
    if (count == 1) {
        QImage image = picture(camera, progress);
        if (progress.cancelled())
            return cancelled();
        return image;
    }
    const Lens lens = hasLens ? options.lens : Lens();
    LightSum light(size);
    for (int i = 0; i < count; ++i) {
        light.add(picture(throughLens(camera, lens, size, i, count),
                          progress.part(double(i) / count, double(i + 1) / count)));
        if (progress.cancelled())
            return cancelled();
    }
    return light.mean();
}

Expected<SurfacePictures> OffscreenRenderer::drawSurfaces(const RenderScene& scene, const Camera& camera,
                                                          QSize size, double reach, bool sparing)
{
    RAMURE_TRY(checkSize(size));
    QOpenGLFramebufferObject target(size, targetFormat(0));
    target.addColorAttachment(size, GL_RGBA8);
    RAMURE_TRY(checkTarget(target, size));
    d->renderer->drawSurfaces(scene, camera, size, target.handle(), reach, sparing);
    (void)d->renderer->takeReleased();
    // Qt takes the alpha for what the colours were multiplied by, which it is not.
    const auto numbers = [&](int attachment) {
        QImage image = target.toImage(true, attachment);
        image.reinterpretAsFormat(image.format() == QImage::Format_RGBA8888_Premultiplied
                                      ? QImage::Format_RGBA8888
                                      : QImage::Format_ARGB32);
        return image.convertToFormat(QImage::Format_ARGB32);
    };
    return SurfacePictures{numbers(0), numbers(1)};
}

void OffscreenRenderer::end()
{
    d->renderer.reset();
    d->context.reset();
}

std::shared_ptr<OffscreenRenderer> rendererForJob()
{
    return {new OffscreenRenderer, [](OffscreenRenderer* last) {
                QMetaObject::invokeMethod(QCoreApplication::instance(), [last] { delete last; });
            }};
}

Expected<QImage> renderImage(const RenderScene& scene, const Camera& camera, QSize size,
                             const RenderOptions& options)
{
    OffscreenRenderer offscreen;
    RAMURE_TRY(offscreen.begin());
    auto image = offscreen.draw(scene, camera, size, options);
    offscreen.end();
    return image;
}

} // namespace ramure
