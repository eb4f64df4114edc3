#include "core/io/zip_file.h"

#include "core/base/file_writer.h"
#include <array>
#include <cerrno>
#include <system_error>
#include <utility>
#include <zip.h>

namespace ramure {
namespace {

/// Meshes as text shrink to a twelfth at best; deflate itself ends at 1032.
constexpr std::uint64_t mostRatio = 100;
/// Below it nobody counts.
constexpr std::uint64_t harmless = std::uint64_t(16) << 20;
constexpr zip_uint16_t firstDate = 0x21; // 1980-01-01 as DOS wrote it
constexpr int quickLevel = 3;            // of deflate's nine

tl::unexpected<Error> refuse(const std::string& path, ErrorCode code, const char* text,
                             std::vector<std::string> args = {})
{
    auto error = fail(code, text, std::move(args));
    error.value().file = path;
    return error;
}

tl::unexpected<Error> zipError(const std::string& path, const char* what)
{
    return refuse(path, ErrorCode::Io, RAMURE_NOOP("the archive cannot be written: %1"), {what});
}

using ZipSource = std::unique_ptr<zip_source_t, decltype(&zip_source_free)>;
using File = std::unique_ptr<zip_file_t, decltype(&zip_fclose)>;

/// A field that nobody reads moves the bytes to where they are to begin.
/// \param place in the file where the entry begins; becomes that of the next one
bool align(zip_t* archive, zip_uint64_t number, const ZipEntry& entry, std::size_t& place)
{
    constexpr std::size_t header = 30, fieldHeader = 4;
    constexpr zip_uint16_t padding = 0x1986; // as in packages of USD
    const std::size_t begin = place + header + entry.name.size() + fieldHeader;
    const auto alignment = static_cast<std::size_t>(entry.alignment);
    const std::string zeros((alignment - begin % alignment) % alignment, '\0');
    place = begin + zeros.size() + entry.bytes.size();
    return zip_file_extra_field_set(archive, number, padding, ZIP_EXTRA_FIELD_NEW,
                                    reinterpret_cast<const zip_uint8_t*>(zeros.data()),
                                    static_cast<zip_uint16_t>(zeros.size()), ZIP_FL_LOCAL) == 0;
}

/// \param place see align
bool add(zip_t* archive, const ZipEntry& entry, std::size_t& place)
{
    zip_source_t* bytes = zip_source_buffer(archive, entry.bytes.data(), entry.bytes.size(), 0);
    if (!bytes)
        return false;
    const zip_int64_t at = zip_file_add(archive, entry.name.c_str(), bytes, ZIP_FL_ENC_UTF_8);
    if (at < 0) {
        zip_source_free(bytes);
        return false;
    }
    const auto number = static_cast<zip_uint64_t>(at);
    if (entry.alignment > 1 && !align(archive, number, entry, place))
        return false;
    return zip_file_set_dostime(archive, number, 0, firstDate, 0) == 0 &&
           zip_set_file_compression(archive, number, entry.isPacked ? ZIP_CM_DEFLATE : ZIP_CM_STORE,
                                    entry.isPacked ? quickLevel : 0) == 0;
}

void tellProgress(zip_t*, double fraction, void* progress)
{
    static_cast<const Progress*>(progress)->report(fraction);
}

int isCancelled(zip_t*, void* progress)
{
    return static_cast<const Progress*>(progress)->cancelled() ? 1 : 0;
}

Expected<void> copyTo(const std::string& path, zip_source_t* from)
{
    auto out = FileWriter::open(path);
    RAMURE_TRY(out);
    if (zip_source_open(from) != 0)
        return zipError(path, zip_error_strerror(zip_source_error(from)));
    std::array<char, FileWriter::largestRoom> block{};
    zip_int64_t got = 0;
    while (out->isGood() && (got = zip_source_read(from, block.data(), block.size())) > 0)
        out->append({block.data(), static_cast<std::size_t>(got)});
    zip_source_close(from);
    if (got < 0)
        return zipError(path, zip_error_strerror(zip_source_error(from)));
    return out->commit();
}

} // namespace

Expected<void> writeZip(const std::string& path, std::span<const ZipEntry> entries, const Progress& progress)
{
    zip_error_t problem;
    zip_error_init(&problem);
    const ZipSource bytes(zip_source_buffer_create(nullptr, 0, 0, &problem), &zip_source_free);
    if (!bytes)
        throw std::bad_alloc();
    zip_source_keep(bytes.get()); // closing the archive lets go of it once
    zip_t* archive = zip_open_from_source(bytes.get(), ZIP_TRUNCATE, &problem);
    if (!archive) {
        zip_source_free(bytes.get());
        return zipError(path, zip_error_strerror(&problem));
    }
    Progress packing = progress.part(0.0, 0.9);
    zip_register_progress_callback_with_state(archive, 0.01, &tellProgress, nullptr, &packing);
    zip_register_cancel_callback_with_state(archive, &isCancelled, nullptr, &packing);
    std::size_t place = 0;
    for (const ZipEntry& entry : entries)
        if (!add(archive, entry, place)) {
            const std::string why = zip_strerror(archive);
            zip_discard(archive);
            return zipError(path, why.c_str());
        }
    if (zip_close(archive) != 0) {
        const std::string why = zip_strerror(archive);
        zip_discard(archive);
        return progress.cancelled() ? refuse(path, ErrorCode::Cancelled, RAMURE_NOOP("cancelled"))
                                    : zipError(path, why.c_str());
    }
    return copyTo(path, bytes.get());
}

struct ZipReader::Archive
{
    std::string path;
    zip_t* zip = nullptr;

    explicit Archive(std::string file)
        : path(std::move(file))
    {
    }
    Archive(const Archive&) = delete;
    Archive& operator=(const Archive&) = delete;
    ~Archive()
    {
        if (zip)
            zip_discard(zip);
    }
};

ZipReader::ZipReader(std::unique_ptr<Archive> archive)
    : m_archive(std::move(archive))
{
}
ZipReader::ZipReader(ZipReader&&) noexcept = default;
ZipReader& ZipReader::operator=(ZipReader&&) noexcept = default;
ZipReader::~ZipReader() = default;

Expected<ZipReader> ZipReader::open(const std::string& path)
{
    auto archive = std::make_unique<Archive>(path);
    int code = 0;
    archive->zip = zip_open(path.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &code);
    if (archive->zip)
        return ZipReader(std::move(archive));
    if (code == ZIP_ER_NOENT || code == ZIP_ER_OPEN || code == ZIP_ER_READ)
        return refuse(path, ErrorCode::Io, RAMURE_NOOP("cannot be read: %1"),
                      {std::generic_category().message(code == ZIP_ER_NOENT ? ENOENT : errno)});
    return refuse(path, ErrorCode::Syntax, RAMURE_NOOP("not a ZIP archive, or a broken one"));
}

std::string ZipReader::first() const
{
    const char* name = zip_get_name(m_archive->zip, 0, ZIP_FL_ENC_GUESS);
    return name ? name : "";
}

bool ZipReader::has(const std::string& name) const
{
    return zip_name_locate(m_archive->zip, name.c_str(), ZIP_FL_NOCASE) >= 0;
}

Expected<void> ZipReader::read(const std::string& name, std::uint64_t mostBytes,
                               const std::function<bool(std::string_view)>& take,
                               const Progress& progress) const
{
    const std::string& path = m_archive->path;
    const auto tooMuch = [&] {
        return refuse(path, ErrorCode::Limit,
                      RAMURE_NOOP("%1 would unpack to more than a file of this kind can hold"), {name});
    };
    const auto broken = [&] {
        return refuse(path, ErrorCode::Syntax, RAMURE_NOOP("%1 is broken or cut off"), {name});
    };
    zip_stat_t facts;
    if (zip_stat(m_archive->zip, name.c_str(), ZIP_FL_NOCASE, &facts) != 0)
        return refuse(path, ErrorCode::Unknown, RAMURE_NOOP("there is no %1 in the archive"), {name});
    constexpr zip_uint64_t needed = ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE;
    if ((facts.valid & needed) != needed)
        return broken();
    const bool isTrap = facts.size > harmless && facts.size / mostRatio > facts.comp_size;
    if (facts.size > mostBytes || isTrap)
        return tooMuch();
    const File file(zip_fopen(m_archive->zip, name.c_str(), ZIP_FL_NOCASE), &zip_fclose);
    if (!file)
        return broken();
    std::array<char, std::size_t(1) << 16> block{};
    std::uint64_t total = 0;
    for (;;) {
        if (progress.cancelled())
            return refuse(path, ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        const zip_int64_t got = zip_fread(file.get(), block.data(), block.size());
        if (got < 0)
            return broken();
        if (got == 0)
            return total == facts.size ? Expected<void>() : broken();
        total += static_cast<std::uint64_t>(got);
        if (total > facts.size) // more than it declares
            return tooMuch();
        progress.report(double(total) / double(facts.size));
        if (!take({block.data(), static_cast<std::size_t>(got)}))
            return {};
    }
}

} // namespace ramure
