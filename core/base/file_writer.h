/// \file
/// Files written so that an error leaves the old one intact.
#pragma once

#include "core/base/error.h"
#include <memory>
#include <string>
#include <string_view>

namespace ramure {

/// What a new file survives once commit() is done.
enum class Durability {
    Program, ///< the end of the program: for what can be made again, such as exports
    Power, ///< a loss of power too: the disk holds the new file before the old one goes. Takes a disk's time.
};

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
    static Expected<FileWriter> open(const std::string& path, Durability durability = Durability::Program);
    FileWriter(FileWriter&& other) noexcept;
    FileWriter& operator=(FileWriter&&) = delete;
    ~FileWriter(); ///< removes the temporary file where there was no commit

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

    /// False once writing has failed: finish() says why, and what follows is dropped.
    [[nodiscard]] bool isGood() const { return m_errno == 0; }
    [[nodiscard]] bool isRegular() const { return !m_temporary.empty(); }
    /// Writes what is left and closes the file, without touching the target. Error: Io (a full disk too).
    Expected<void> finish();
    /// After finish(): the target becomes the new file. Error: Io.
    Expected<void> commit();

private:
    /// Stays in the second cache; a fraction of it, whole pages, is written at a time.
    static constexpr std::size_t bufferSize = std::size_t(1) << 18;
    static constexpr std::size_t pageSize = 4096;

    FileWriter(std::string path, Durability durability);
    /// Hands over the first \p bytes of the buffer and moves the rest to its front.
    void flush(std::size_t bytes);
    [[nodiscard]] Error error(int code) const;

    Durability m_durability;
    std::string m_path;      ///< as the caller wrote it, for messages
    std::string m_target;    ///< links followed
    std::string m_temporary; ///< empty for devices, and once it is gone
    int m_file = -1;
    int m_errno = 0;
    std::size_t m_used = 0;
    std::unique_ptr<char[]> m_buffer;
};

/// Call once, when a program starts. A file that grows beyond the limit of its process (`ulimit -f`) is then
/// an error of the writing, EFBIG, and no longer the end of the program.
void makeFileLimitAnError();

/// Deletes what writings of \p path that were cut short (a crash, a kill) left beside it: files named
/// "PATH.new-PROCESS-NUMBER" that nobody has written to for ten seconds and whose process is gone, or for an
/// hour. No other name is ever touched. Never fails: what cannot be deleted stays. Returns how many went.
int removeAbandonedParts(const std::string& path);

} // namespace ramure
