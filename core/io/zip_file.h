/// \file
/// Files that are ZIP archives, such as 3MF. Everything about libzip stays in zip_file.cpp.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace ramure {

struct ZipEntry
{
    std::string name;
    std::string_view bytes; ///< not owned
    bool isPacked = true;   ///< deflated; else it stands in the file as it is
    int alignment = 1;      ///< its bytes begin at a multiple of this; of entries that are not packed
};

/// The archive at once, with the beginning of 1980 as the date of all entries: the same entries make the same
/// bytes. Errors: Io, Cancelled; the old file is intact then.
Expected<void> writeZip(const std::string& path, std::span<const ZipEntry> entries,
                        const Progress& progress = {});

class ZipReader
{
public:
    /// Errors: Io, Syntax (no ZIP archive).
    static Expected<ZipReader> open(const std::string& path);
    ZipReader(ZipReader&&) noexcept;
    ZipReader& operator=(ZipReader&&) noexcept;
    ~ZipReader();

    /// The name of the first entry; empty: there is none.
    [[nodiscard]] std::string first() const;
    [[nodiscard]] bool has(const std::string& name) const;
    /// Unpacks an entry piece by piece; \p take returns false to stop, which is not an error. Errors: Unknown
    /// (no such entry); Limit (more than \p mostBytes declared or unpacked, or packed so tightly that it can
    /// only be a zip bomb); Syntax (broken); Cancelled.
    Expected<void> read(const std::string& name, std::uint64_t mostBytes,
                        const std::function<bool(std::string_view)>& take,
                        const Progress& progress = {}) const;

private:
    struct Archive;
    explicit ZipReader(std::unique_ptr<Archive> archive);
    std::unique_ptr<Archive> m_archive;
};

} // namespace ramure
