#include "core/qt/base/system_path.h"

#include "core/base/utf8.h"
#include <QFile>
#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace ramure {

namespace {

constexpr char16_t firstByte = 0xDC00; ///< stands for a byte that is no UTF-8; they begin at 0x80

} // namespace

QString pathText(std::string_view bytes)
{
    QString text;
    while (!bytes.empty()) {
        const std::size_t length = utf8Length(bytes);
        if (length == 0)
            text += QChar(char16_t(firstByte + static_cast<unsigned char>(bytes.front())));
        else
            text += QString::fromUtf8(bytes.data(), qsizetype(length));
        bytes.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return text;
}

std::string systemPath(const QString& path)
{
    std::string bytes;
    qsizetype from = 0;
    const auto addText = [&](qsizetype end) {
        bytes += QStringView(path).mid(from, end - from).toUtf8().toStdString();
        from = end + 1;
    };
    for (qsizetype i = 0; i < path.size(); ++i) {
        const char16_t unit = path[i].unicode();
        const bool isLow = i > 0 && path[i - 1].isHighSurrogate();
        if (isLow || unit < firstByte + 0x80 || unit > firstByte + 0xFF)
            continue;
        addText(i);
        bytes += static_cast<char>(unit - firstByte);
    }
    addText(path.size());
    return bytes;
}

Expected<void> openToRead(QFile& file, const QString& path)
{
    const std::string name = systemPath(path);
    const int descriptor = ::open(name.c_str(), O_RDONLY | O_CLOEXEC);
    struct stat kind = {};
    const bool isFolder = descriptor >= 0 && ::fstat(descriptor, &kind) == 0 && S_ISDIR(kind.st_mode);
    const int code = isFolder ? EISDIR : errno;
    if (descriptor >= 0 && !isFolder &&
        file.open(descriptor, QIODevice::ReadOnly, QFileDevice::AutoCloseHandle))
        return {};
    if (descriptor >= 0)
        ::close(descriptor);
    auto error =
        fail(ErrorCode::Io, RAMURE_NOOP("cannot be opened: %1"), {std::generic_category().message(code)});
    error.value().file = name;
    return error;
}

} // namespace ramure
