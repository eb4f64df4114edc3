/// \file
/// Files written so that an error leaves the old one intact, and that are on the disk when writing says so.
///
/// Every file of the program is written here: projects, recovery files, baked motion, meshes, pictures,
/// tables. File and folder are synced for each of them, in a sequence too: measured at 8 ms a file on an SSD,
/// where computing and drawing a frame takes ten times as long. So whatever a sequence has written stays,
/// however it ends.
#pragma once

#include "core/base/error.h"
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <sys/types.h>

namespace ramure {

/// The calls of the system that writing depends on; the reason of a failure is in errno. Tests put failing
/// ones in their place, while nothing is being written.
struct FileCalls
{
    int (*open)(const char* path, int flags, mode_t mode);
    int (*chmod)(int file, mode_t mode);
    ssize_t (*write)(int file, const void* bytes, std::size_t size);
    int (*sync)(int file);
    int (*close)(int file);
    int (*rename)(const char* from, const char* to, unsigned flags); ///< flags of renameat2
};
FileCalls& fileCalls();

/// Text or bytes into a temporary file beside the target; commit() puts it in the target's place. Everything
/// goes through one buffer that stays in the cache: fresh memory of a whole file's size would cost more than
/// the formatting.
///
/// A target that exists and is no regular file (a device, a pipe) is written directly. A symbolic link is
/// followed.
class FileWriter
{
public:
    /// Also clears away what earlier writings of the same file that were cut short left (see below). Errors:
    /// Io (missing or read-only folder, the target is a folder or read-only).
    static Expected<FileWriter> open(const std::string& path);
    FileWriter(FileWriter&& other) noexcept;
    FileWriter& operator=(FileWriter&&) = delete;
    ~FileWriter(); ///< removes the temporary file

    static constexpr std::size_t largestRoom = std::size_t(1) << 16;
    /// \p bytes (at most largestRoom) of room, to be claimed by advance().
    char* room(std::size_t bytes)
    {
        if (m_used + bytes > bufferSize)
            flush(m_used / pageSize * pageSize);
        return m_buffer.get() + m_used;
    }
    /// \p end lies in the room given last.
    void advance(const char* end) { m_used = static_cast<std::size_t>(end - m_buffer.get()); }
    void append(std::string_view text);

    /// False once writing has failed: commit() says why, and what follows is dropped.
    [[nodiscard]] bool isGood() const { return m_errno == 0; }
    [[nodiscard]] bool isRegular() const { return !m_temporary.empty(); }
    /// Writes the rest, then puts the new file on the disk in place of the target. Error: Io (a full disk
    /// too); the target stays as before.
    Expected<void> commit();
    /// Commits files that belong together: either all of them are replaced, or none. A loss of power between
    /// two may leave a new file beside an old one, both whole. The same can follow from an error on a file
    /// system that cannot exchange two names.
    static Expected<void> commitTogether(std::initializer_list<FileWriter*> files);

private:
    /// Stays in the second cache; a fraction of it, whole pages, is written at a time.
    static constexpr std::size_t bufferSize = std::size_t(1) << 18;
    static constexpr std::size_t pageSize = 4096;
    enum class Place { Beside, Exchanged, First, Final }; ///< where the written bytes are now, see place()

    explicit FileWriter(std::string path);
    /// Hands over the first \p bytes of the buffer and moves the rest to its front.
    void flush(std::size_t bytes);
    /// Writes the rest, syncs and closes the file, without touching the target.
    Expected<void> finish();
    [[nodiscard]] int place(); ///< puts the new file in the target's place; 0 or the reason why not
    void takeBack();           ///< undoes place()
    void removeTemporary();
    [[nodiscard]] Error error(int code) const;

    std::string m_path;      ///< the name as the caller wrote it, for messages
    std::string m_target;    ///< links followed
    std::string m_temporary; ///< empty for devices, and once it is gone
    Place m_place = Place::Beside;
    int m_file = -1;
    int m_errno = 0;
    std::size_t m_used = 0;
    std::unique_ptr<char[]> m_buffer;
};

/// The error of a file that the system refuses to write. \param code of errno
Error writeError(const std::string& path, int code);
/// Did writeError() make it?
bool isWriteError(const Error& error);
/// True if the error came from a full disk or a used-up quota. Further writing will fail, too.
bool isDiskFull(const Error& error);

/// Makes a folder and those above it that do not exist yet. Error: Io.
Expected<void> makeFolder(const std::string& path);

/// Writes a whole file at once. Errors: those of FileWriter.
Expected<void> writeFile(const std::string& path, std::string_view bytes);

/// Makes sure that a file written by somebody else (Qt writes the settings) is on the disk. Error: Io.
Expected<void> syncFile(const std::string& path);

/// Call once, when a program starts. A file that grows beyond the limit of its process (`ulimit -f`) is then
/// an error of the writing, EFBIG, and no longer the end of the program.
void makeFileLimitAnError();

/// Deletes the remains of interrupted writes of \p path (a crash, a kill): files named
/// "PATH.new-PROCESS-NUMBER" that have not been written to for ten seconds and whose process is gone, or for
/// an hour. No other name is ever touched. Never fails: files that cannot be deleted stay. Returns the number
/// of deleted files.
int removeAbandonedParts(const std::string& path);

} // namespace ramure
