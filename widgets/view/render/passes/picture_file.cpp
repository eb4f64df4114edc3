#include "widgets/view/render/passes/picture_file.h"

#include "core/base/file_writer.h"
#include <QBuffer>
#include <QFile>
#include <QFileInfo>
#include <QImageWriter>

namespace ramure {

Expected<void> savePicture(const QImage& image, const std::string& path)
{
    const auto refuse = [&path](const char* text, const QString& why) {
        Error error = fail(ErrorCode::Unknown, text, {why.toStdString()}).value();
        error.file = path;
        return fail(std::move(error));
    };
    const QByteArray ending = QFileInfo(QFile::decodeName(path.c_str())).suffix().toLower().toLatin1();
    if (!QImageWriter::supportedImageFormats().contains(ending))
        return refuse(RAMURE_NOOP("Pictures cannot be written as '%1'"), QString::fromLatin1(ending));
    // Encoded first: then all that can go wrong is writing.
    QBuffer bytes;
    bytes.open(QIODevice::WriteOnly);
    QImageWriter writer(&bytes, ending);
    if (!writer.write(image))
        return refuse(RAMURE_NOOP("cannot be encoded: %1"), writer.errorString());
    return writeFile(path, {bytes.data().constData(), static_cast<std::size_t>(bytes.data().size())});
}

} // namespace ramure
