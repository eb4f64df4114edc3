#include "app/cli/batch/file_hash.h"

#include "core/qt/base/system_path.h"
#include <QFile>
#include <nettle/sha2.h>

namespace ramure::cli {

QByteArray sha256Of(const QString& path)
{
    constexpr qint64 piece = 1 << 18; // stays in the cache between reading and hashing
    QFile file;
    if (!openToRead(file, path))
        return {};
    sha256_ctx hash{};
    sha256_init(&hash);
    QByteArray bytes(piece, Qt::Uninitialized);
    qint64 count = 0;
    while ((count = file.read(bytes.data(), piece)) > 0)
        sha256_update(&hash, std::size_t(count), reinterpret_cast<const std::uint8_t*>(bytes.constData()));
    if (count < 0)
        return {};
    QByteArray digest(SHA256_DIGEST_SIZE, Qt::Uninitialized);
    sha256_digest(&hash, SHA256_DIGEST_SIZE, reinterpret_cast<std::uint8_t*>(digest.data()));
    return digest.toHex();
}

} // namespace ramure::cli
