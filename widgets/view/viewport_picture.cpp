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

QImage Viewport::screenshot(const ViewPicture& wish)
{
    finishScene();
    const QSize pixels = wish.size.isEmpty() ? pixelSize() : wish.size;
    RenderOptions options = d->options(devicePixelRatioF());
    options.shadowTaps = 24;
    options.smoothing = options.sparing = options.hurried = false;
    options.outline = false;
    options.world = !wish.transparent;
    options.grid = wish.grid.value_or(options.grid);
    d->updateShown();
    auto image = renderImage(d->shownScene(), d->camera(), pixels, options);
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
