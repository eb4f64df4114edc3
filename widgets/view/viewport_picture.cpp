// Screenshots of the viewport.
#include "widgets/view/render/offscreen_renderer.h"
#include "widgets/view/render/picture_file.h"
#include "widgets/view/viewport_private.h"
#include <QClipboard>
#include <QFile>
#include <QGuiApplication>

namespace ramure {

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
