#include "core/base/file_writer.h"
#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <filesystem>
#include <optional>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

namespace ramure {

namespace {

/// The file that a chain of links ends in, also where that does not exist yet.
std::string linkTarget(const std::string& path)
{
    namespace fs = std::filesystem;
    std::error_code ignored;
    if (!fs::is_symlink(path, ignored))
        return path;
    const fs::path resolved = fs::weakly_canonical(path, ignored);
    return resolved.empty() ? path : resolved.string();
}

constexpr const char* partMark = ".new-";
constexpr std::time_t restSeconds = 10;     ///< a writer that is alive writes more often
constexpr std::time_t forgetSeconds = 3600; ///< processes of other machines and sandboxes cannot be asked

/// Digits, then the end or \p after; nothing where there is something else.
std::optional<long> takeNumber(std::string_view& text, char after)
{
    const auto digits = std::min(text.find_first_not_of("0123456789"), text.size());
    const bool ends = digits == text.size();
    if (digits == 0 || digits > 10 || ends != (after == 0) || (!ends && text[digits] != after))
        return std::nullopt;
    const long number = std::stol(std::string(text.substr(0, digits)));
    text.remove_prefix(ends ? digits : digits + 1);
    return number;
}

/// The process that a temporary file's name tells, where \p name is one of \p target.
std::optional<long> writerOf(std::string_view name, std::string_view target)
{
    if (!name.starts_with(target))
        return std::nullopt;
    name.remove_prefix(target.size());
    if (!name.starts_with(partMark))
        return std::nullopt;
    name.remove_prefix(std::strlen(partMark));
    const auto process = takeNumber(name, '-');
    return process && takeNumber(name, 0) ? process : std::nullopt;
}

bool isAbandoned(const std::string& part, long process)
{
    struct stat state = {};
    if (::lstat(part.c_str(), &state) != 0 || !S_ISREG(state.st_mode))
        return false;
    const std::time_t age = std::time(nullptr) - state.st_mtime;
    const bool gone = ::kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH;
    return age > forgetSeconds || (age > restSeconds && gone);
}

/// A name that nobody else has: exclusive creation tells.
int openTemporary(const std::string& target, std::string& name)
{
    static std::atomic<unsigned> counter = 0;
    for (int attempt = 0; attempt < 100; ++attempt) {
        name = target + partMark + std::to_string(::getpid()) + "-" + std::to_string(counter++);
        const int file = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file >= 0 || errno != EEXIST)
            return file;
    }
    return -1;
}

/// The new name is a change of the folder. It is in place already: where this fails there is nothing to undo.
void syncFolder(const std::string& target)
{
    const std::filesystem::path folder = std::filesystem::path(target).parent_path();
    const int file = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (file < 0)
        return;
    ::fsync(file);
    ::close(file);
}

} // namespace

FileWriter::FileWriter(std::string path, Durability durability)
    : m_durability(durability)
    , m_path(std::move(path))
    , m_target(linkTarget(m_path))
    , m_buffer(new char[bufferSize])
{
}

FileWriter::FileWriter(FileWriter&& other) noexcept
    : m_durability(other.m_durability)
    , m_path(std::move(other.m_path))
    , m_target(std::move(other.m_target))
    , m_temporary(std::exchange(other.m_temporary, {}))
    , m_file(std::exchange(other.m_file, -1))
    , m_errno(other.m_errno)
    , m_used(other.m_used)
    , m_buffer(std::move(other.m_buffer))
{
}

FileWriter::~FileWriter()
{
    if (m_file >= 0)
        ::close(m_file);
    if (!m_temporary.empty())
        ::unlink(m_temporary.c_str());
}

Error FileWriter::error(int code) const
{
    Error out;
    out.code = ErrorCode::Io;
    out.text = RAMURE_NOOP("cannot be written: %1");
    out.args = {std::generic_category().message(code)};
    out.file = m_path;
    return out;
}

Expected<FileWriter> FileWriter::open(const std::string& path, Durability durability)
{
    FileWriter out(path, durability);
    struct stat old = {};
    const bool exists = ::stat(out.m_target.c_str(), &old) == 0;
    if (exists && S_ISDIR(old.st_mode))
        return fail(out.error(EISDIR));
    if (exists && ::access(out.m_target.c_str(), W_OK) != 0)
        return fail(out.error(errno)); // replacing it would go round its protection
    if (exists && !S_ISREG(old.st_mode)) {
        out.m_file = ::open(out.m_target.c_str(), O_WRONLY | O_CLOEXEC);
        if (out.m_file < 0)
            return fail(out.error(errno));
        return out;
    }
    removeAbandonedParts(out.m_target);
    std::string name;
    out.m_file = openTemporary(out.m_target, name);
    if (out.m_file < 0)
        return fail(out.error(errno));
    out.m_temporary = std::move(name);
    if (exists && ::fchmod(out.m_file, old.st_mode & 07777) != 0)
        return fail(out.error(errno));
    return out;
}

void FileWriter::append(std::string_view text)
{
    while (!text.empty()) {
        const std::size_t part = std::min(text.size(), largestRoom);
        char* const to = room(part);
        std::memcpy(to, text.data(), part);
        advance(to + part);
        text.remove_prefix(part);
    }
}

void FileWriter::flush(std::size_t bytes)
{
    const char* from = m_buffer.get();
    const char* const end = from + bytes;
    while (from != end && m_errno == 0) {
        const ssize_t written = ::write(m_file, from, static_cast<std::size_t>(end - from));
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0) {
            m_errno = written < 0 ? errno : ENOSPC;
            break;
        }
        from += written;
    }
    m_used -= bytes;
    std::memmove(m_buffer.get(), end, m_used);
}

Expected<void> FileWriter::finish()
{
    flush(m_used);
    // Not every file system can (EINVAL): then there is nothing to wait for.
    const bool syncs = m_durability == Durability::Power && isRegular() && m_errno == 0;
    if (syncs && ::fsync(m_file) != 0 && errno != EINVAL)
        m_errno = errno;
    // Some file systems say only now that the disk is full.
    if (::close(std::exchange(m_file, -1)) != 0 && m_errno == 0)
        m_errno = errno;
    if (m_errno != 0)
        return fail(error(m_errno));
    return {};
}

Expected<void> FileWriter::commit()
{
    if (m_temporary.empty())
        return {};
    if (::rename(m_temporary.c_str(), m_target.c_str()) != 0)
        return fail(error(errno));
    m_temporary.clear();
    if (m_durability == Durability::Power)
        syncFolder(m_target);
    return {};
}

void makeFileLimitAnError()
{
    std::signal(SIGXFSZ, SIG_IGN);
}

int removeAbandonedParts(const std::string& path)
{
    namespace fs = std::filesystem;
    const fs::path target = linkTarget(path);
    const std::string name = target.filename().string();
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    std::error_code error;
    std::vector<std::string> parts;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        const auto process = name.empty() ? std::nullopt : writerOf(at->path().filename().string(), name);
        if (process && isAbandoned(at->path().string(), *process))
            parts.push_back(at->path().string());
    }
    int gone = 0;
    for (const std::string& part : parts)
        gone += ::unlink(part.c_str()) == 0 ? 1 : 0;
    return gone;
}

} // namespace ramure
