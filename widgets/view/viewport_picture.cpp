// Screenshots of the viewport.
#include "widgets/view/render/offscreen_renderer.h"
#include "widgets/view/viewport_private.h"
#include <QClipboard>
#include <QGuiApplication>
#include <QImageWriter>
#include <QSaveFile>

namespace ramure {

QImage Viewport::screenshot()
{
    finishScene();
    const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
    RenderOptions options = d->options(devicePixelRatioF());
    options.shadowTaps = 24;
    options.smoothing = false;
    options.outline = false;
    d->updateShown();
    auto image = renderImage(*d->shown, d->camera, pixels, options);
    return image ? *image : QImage();
}

Expected<void> Viewport::saveScreenshot(const QString& path)
{
    const auto refuse = [&path](ErrorCode code, const char* text, const QString& why) {
        Error error = fail(code, text, {why.toStdString()}).value();
        error.file = path.toStdString();
        return fail(std::move(error));
    };
    const QByteArray ending = path.section(QLatin1Char('.'), -1).toLower().toLatin1();
    if (!path.contains(QLatin1Char('.')) || !QImageWriter::supportedImageFormats().contains(ending))
        return refuse(ErrorCode::Unknown, RAMURE_NOOP("Pictures cannot be written as '%1'"),
                      QString::fromLatin1(ending));
    const QImage image = screenshot();
    if (image.isNull())
        return refuse(ErrorCode::Unknown, RAMURE_NOOP("The graphics driver gave no picture"), {});
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return refuse(ErrorCode::Io, RAMURE_NOOP("Cannot write the picture: %1"), file.errorString());
    QImageWriter writer(&file, ending);
    if (!writer.write(image))
        return refuse(ErrorCode::Io, RAMURE_NOOP("Cannot write the picture: %1"), writer.errorString());
    if (!file.commit())
        return refuse(ErrorCode::Io, RAMURE_NOOP("Cannot write the picture: %1"), file.errorString());
    return {};
}

void Viewport::copyScreenshot()
{
    const QImage image = screenshot();
    if (!image.isNull())
        QGuiApplication::clipboard()->setImage(image);
}

} // namespace ramure
