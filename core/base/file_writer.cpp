#include "core/base/file_writer.h"
#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
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
        const int file = fileCalls().open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file >= 0 || errno != EEXIST)
            return file;
    }
    return -1;
}

std::string folderOf(const std::string& target)
{
    const std::string folder = std::filesystem::path(target).parent_path().string();
    return folder.empty() ? "." : folder;
}

/// Not every file system can sync every kind of file (EINVAL): then there is nothing to wait for.
int syncOpen(int file)
{
    return fileCalls().sync(file) == 0 || errno == EINVAL ? 0 : errno;
}

/// A file that stays as it is, or a folder: a new name is a change of that. Returns 0 or the reason.
int syncPath(const std::string& path)
{
    const int file = fileCalls().open(path.c_str(), O_RDONLY | O_CLOEXEC, 0);
    if (file < 0)
        return errno == EACCES ? 0 : errno; // a folder one may write to but not list
    const int code = syncOpen(file);
    ::close(file);
    return code;
}

/// By the address of its text an error says that it is one of these: people read the same words.
constexpr char refused[] = RAMURE_NOOP("cannot be written: %1");
constexpr char full[] = RAMURE_NOOP("cannot be written: %1");

} // namespace

Error writeError(const std::string& path, int code)
{
    Error out;
    out.code = ErrorCode::Io;
    out.text = code == ENOSPC || code == EDQUOT ? full : refused;
    out.args = {std::generic_category().message(code)};
    out.file = path;
    return out;
}

bool isWriteError(const Error& error)
{
    return error.text == refused || error.text == full;
}

bool isDiskFull(const Error& error)
{
    return error.text == full;
}

Expected<void> makeFolder(const std::string& path)
{
    std::error_code problem;
    std::filesystem::create_directories(path, problem);
    if (!problem && std::filesystem::is_directory(path, problem))
        return {};
    if (problem == std::errc::no_space_on_device || problem.value() == EDQUOT)
        return fail(writeError(path, problem.value()));
    auto error = fail(ErrorCode::Io, RAMURE_NOOP("the folder cannot be made: %1"),
                      {std::generic_category().message(problem ? problem.value() : ENOTDIR)});
    error.value().file = path;
    return error;
}

FileCalls& fileCalls()
{
    static FileCalls calls{
        [](const char* path, int flags, mode_t mode) { return ::open(path, flags, mode); },
        ::fchmod,
        ::write,
        ::fsync,
        ::close,
        [](const char* from, const char* to, unsigned flags) {
            return ::renameat2(AT_FDCWD, from, AT_FDCWD, to, flags);
        },
    };
    return calls;
}

FileWriter::FileWriter(std::string path)
    : m_path(std::move(path))
    , m_target(linkTarget(m_path))
    , m_buffer(new char[bufferSize])
{
}

FileWriter::FileWriter(FileWriter&& other) noexcept
    : m_path(std::move(other.m_path))
    , m_target(std::move(other.m_target))
    , m_temporary(std::exchange(other.m_temporary, {}))
    , m_place(other.m_place)
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
    removeTemporary();
}

void FileWriter::removeTemporary()
{
    if (isRegular())
        ::unlink(m_temporary.c_str());
    m_temporary.clear();
}

Error FileWriter::error(int code) const
{
    return writeError(m_path, code);
}

Expected<FileWriter> FileWriter::open(const std::string& path)
{
    FileWriter out(path);
    struct stat old = {};
    const bool exists = ::stat(out.m_target.c_str(), &old) == 0;
    if (exists && S_ISDIR(old.st_mode))
        return fail(out.error(EISDIR));
    if (exists && ::access(out.m_target.c_str(), W_OK) != 0)
        return fail(out.error(errno)); // replacing it would go round its protection
    if (exists && !S_ISREG(old.st_mode)) {
        out.m_file = fileCalls().open(out.m_target.c_str(), O_WRONLY | O_CLOEXEC, 0);
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
    if (exists && fileCalls().chmod(out.m_file, old.st_mode & 07777) != 0)
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
        const ssize_t written = fileCalls().write(m_file, from, static_cast<std::size_t>(end - from));
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
    if (isRegular() && m_errno == 0)
        m_errno = syncOpen(m_file);
    // Some file systems say only now that the disk is full.
    if (fileCalls().close(std::exchange(m_file, -1)) != 0 && m_errno == 0)
        m_errno = errno;
    if (m_errno != 0)
        return fail(error(m_errno));
    return {};
}

int FileWriter::place()
{
    const auto rename = [this](unsigned flags) {
        return fileCalls().rename(m_temporary.c_str(), m_target.c_str(), flags) == 0 ? 0 : errno;
    };
    // The two change their names, so that the old file can come back. There may be none, and not every file
    // system knows the exchange; what a broken or full disk says is meant.
    const int code = rename(RENAME_EXCHANGE);
    if (code == 0)
        m_place = Place::Exchanged;
    if (code == 0 || code == EIO || code == ENOSPC || code == EDQUOT || code == EROFS)
        return code;
    if (const int plain = rename(0); plain != 0)
        return plain;
    m_place = code == ENOENT ? Place::First : Place::Final;
    m_temporary.clear();
    return 0;
}

void FileWriter::takeBack()
{
    if (m_place == Place::Exchanged)
        fileCalls().rename(m_temporary.c_str(), m_target.c_str(), RENAME_EXCHANGE);
    else if (m_place == Place::First)
        ::unlink(m_target.c_str());
    m_place = Place::Beside;
}

Expected<void> FileWriter::commit()
{
    return commitTogether({this});
}

Expected<void> FileWriter::commitTogether(std::initializer_list<FileWriter*> files)
{
    for (FileWriter* file : files)
        if (auto done = file->finish(); !done)
            return done;
    for (auto at = files.begin(); at != files.end(); ++at) {
        if (!(*at)->isRegular())
            continue;
        const bool isLastThere =
            at + 1 == files.end() || folderOf(at[1]->m_target) != folderOf((*at)->m_target);
        int code = (*at)->place();
        if (code == 0 && isLastThere)
            code = syncPath(folderOf((*at)->m_target));
        if (code == 0)
            continue;
        for (auto back = at + 1; back != files.begin();)
            (*--back)->takeBack();
        return fail((*at)->error(code));
    }
    for (FileWriter* file : files)
        file->removeTemporary(); // the old ones
    return {};
}

Expected<void> writeFile(const std::string& path, std::string_view bytes)
{
    auto out = FileWriter::open(path);
    RAMURE_TRY(out);
    out->append(bytes);
    return out->commit();
}

Expected<void> syncFile(const std::string& path)
{
    for (const std::string& synced : {path, folderOf(path)})
        if (const int code = syncPath(synced); code != 0)
            return fail(writeError(path, code));
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
