#include "widgets/view/screenshot.h"

#include "widgets/view/render/passes/offscreen_renderer.h"
#include "widgets/view/render/passes/picture_file.h"
#include <QClipboard>
#include <QFile>
#include <QGuiApplication>

namespace ramure {

QImage screenshot(Viewport& view, const ViewPicture& wish)
{
    const ViewShot shot = view.shot(wish);
    auto image = renderImage(*shot.scene, shot.camera, shot.pixels, shot.options);
    return image ? *image : QImage();
}

Expected<void> saveScreenshot(Viewport& view, const QString& path, const ViewPicture& wish)
{
    const QImage image = screenshot(view, wish);
    if (image.isNull()) {
        Error error = fail(ErrorCode::Unknown, RAMURE_NOOP("The graphics driver gave no picture")).value();
        error.file = path.toStdString();
        return fail(std::move(error));
    }
    return savePicture(image, QFile::encodeName(path).toStdString());
}

void copyScreenshot(Viewport& view)
{
    const QImage image = screenshot(view);
    if (!image.isNull())
        QGuiApplication::clipboard()->setImage(image);
}

} // namespace ramure
