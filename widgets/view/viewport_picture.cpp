// Pictures on the screen, and what screenshots are drawn from.
#include "widgets/view/viewport_private.h"
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
    Fine::Subject now{shown.scene() ? shown.scene() : scene, camera(), pixels, options};
    now.options.outline = false; // it fades, and lies over the picture, which need not be made again for it
    now.options.outlineOpacity = 1.0f;
    now.options.lens = through != noNode ? lens : Lens();
    now.options.hurried = false;
    const bool isNew = !(now == fine.of);
    if (isNew) {
        forgetPicture();
        fine.of = std::move(now);
    }
    const int wanted = blurs ? lensSamples : options.hurried ? 0 : 1;
    if (inParts && isNew) {
        RenderOptions quick = fine.of.options;
        quick.hurried = true;
        renderer->draw(*fine.of.scene, camera(), pixels, target, quick);
    } else {
        if (!inParts && fine.whole < wanted)
            drawPart();
        renderer->show(pixels, target);
    }
    if (options.outline)
        renderer->outline(*fine.of.scene, camera(), pixels, target, options);
    if (fine.whole < wanted)
        fine.turns.start();
}

/// All of it at once, unless it is made in parts.
void Viewport::Private::drawPart()
{
    constexpr double partMs = 20.0;
    const double ms = isMadeInParts(fine.of.options) ? partMs : std::numeric_limits<double>::infinity();
    if (renderer->drawPart(*fine.of.scene, fine.of.camera, fine.of.size, fine.of.options, fine.whole, ms))
        ++fine.whole;
}

void Viewport::Private::forgetPicture()
{
    fine.turns.stop();
    fine.of = {};
    fine.whole = 0;
    if (renderer)
        renderer->restartParts();
}

void Viewport::drawOn()
{
    if (!d->renderer || !d->isMadeInParts(d->fine.of.options))
        return update();
    const int before = d->fine.whole;
    makeCurrent();
    d->drawPart();
    doneCurrent();
    d->fine.whole > before ? update() : d->fine.turns.start();
}

ViewWork Viewport::work() const
{
    const RenderOptions now = d->options(devicePixelRatioF());
    return {d->isStale() || d->sceneIsNew || d->highlightsStale || d->pending.isBusy(),
            d->settling.isActive(),
            d->renderer && d->isMadeInParts(now) && !now.hurried && d->fine.whole == 0,
            d->tools.picks().isPending(), d->tools.tool<GizmoTool>().isBusy()};
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
    options.pictures = wish.samples;
    options.lens = wish.lens;
    d->updateShown();
    shot.scene = std::make_shared<const RenderScene>(d->shownScene()); // of shared blocks: quickly copied
    shot.camera = d->camera();
    return shot;
}

} // namespace ramure
