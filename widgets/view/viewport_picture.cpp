// Pictures on the screen, and screenshots.
#include "widgets/view/render/passes/offscreen_renderer.h"
#include "widgets/view/render/passes/picture_file.h"
#include "widgets/view/viewport_private.h"
#include <QClipboard>
#include <QFile>
#include <QGuiApplication>
#include <limits>

namespace ramure {

/// The best takes a processor seconds: a quick picture is shown at once, and the good one is made in parts.
/// Through a lens that is open there is picture after picture, each finer.
void Viewport::Private::draw(QSize pixels, const RenderOptions& options)
{
    const GLuint target = widget->defaultFramebufferObject();
    const bool blurs = through != noNode && lens.diameter > 0.0 && !settling.isActive() &&
                       !context.isPlaying() && !isWindy();
    const bool inParts = isMadeInParts(options);
    if (!blurs && !inParts) {
        forgetPicture();
        return renderer->draw(shownScene(), camera(), pixels, target, options);
    }
    Pictured now{shown.scene() ? shown.scene() : scene, camera(), pixels, options};
    now.options.outline = false; // it fades, and lies over the picture, which need not be made again for it
    now.options.outlineOpacity = 1.0f;
    now.options.lens = through != noNode ? lens : Lens();
    now.options.hurried = false;
    const bool isNew = !(now == pictured);
    if (isNew) {
        forgetPicture();
        pictured = std::move(now);
    }
    const int wanted = blurs ? lensSamples : options.hurried ? 0 : 1;
    if (inParts && isNew) {
        RenderOptions quick = pictured.options;
        quick.hurried = true;
        renderer->draw(*pictured.scene, camera(), pixels, target, quick);
    } else {
        if (!inParts && pictures < wanted)
            drawPart();
        renderer->show(pixels, target);
    }
    if (options.outline)
        renderer->outline(*pictured.scene, camera(), pixels, target, options);
    if (pictures < wanted)
        drawing.start();
}

/// All of it at once, unless it is made in parts.
void Viewport::Private::drawPart()
{
    constexpr double partMs = 20.0;
    const double ms = isMadeInParts(pictured.options) ? partMs : std::numeric_limits<double>::infinity();
    if (renderer->drawPart(*pictured.scene, pictured.camera, pictured.size, pictured.options, pictures, ms))
        ++pictures;
}

void Viewport::Private::forgetPicture()
{
    drawing.stop();
    pictured = {};
    pictures = 0;
    if (renderer)
        renderer->restartParts();
}

void Viewport::drawOn()
{
    if (!d->renderer || !d->isMadeInParts(d->pictured.options))
        return update();
    const int before = d->pictures;
    makeCurrent();
    d->drawPart();
    doneCurrent();
    d->pictures > before ? update() : d->drawing.start();
}

bool Viewport::isPictureInMaking() const
{
    const RenderOptions now = d->options(devicePixelRatioF());
    return d->renderer && d->isMadeInParts(now) && !now.hurried && d->pictures == 0;
}

QSize Viewport::pixelSize() const
{
    return (QSizeF(size()) * devicePixelRatioF()).toSize();
}

ViewShot Viewport::shot(const ViewPicture& wish)
{
    finishScene();
    ViewShot shot;
    shot.pixels = wish.size.isEmpty() ? pixelSize() : wish.size;
    RenderOptions& options = shot.options = d->options(devicePixelRatioF());
    options.shadowTaps = 24;
    options.smoothing = options.sparing = options.hurried = false;
    options.outline = false;
    options.world = !wish.transparent;
    options.grid = wish.grid.value_or(options.grid);
    d->updateShown();
    shot.scene = std::make_shared<const RenderScene>(d->shownScene()); // of shared blocks: quickly copied
    shot.camera = d->camera();
    return shot;
}

QImage Viewport::screenshot(const ViewPicture& wish)
{
    const ViewShot shot = this->shot(wish);
    auto image = renderImage(*shot.scene, shot.camera, shot.pixels, shot.options);
    return image ? *image : QImage();
}

Expected<void> Viewport::saveScreenshot(const QString& path, const ViewPicture& wish)
{
    const QImage image = screenshot(wish);
    if (image.isNull()) {
        Error error = fail(ErrorCode::Unknown, RAMURE_NOOP("The graphics driver gave no picture")).value();
        error.file = path.toStdString();
        return fail(std::move(error));
    }
    return savePicture(image, QFile::encodeName(path).toStdString());
}

void Viewport::copyScreenshot()
{
    const QImage image = screenshot();
    if (!image.isNull())
        QGuiApplication::clipboard()->setImage(image);
}

} // namespace ramure
