#include "core/io/read_parts.h"
#include "core/base/plain_text.h"
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace ramure::reading {

namespace {

tl::unexpected<Error> readError(const std::string& path, int code)
{
    auto error =
        fail(ErrorCode::Io, RAMURE_NOOP("cannot be read: %1"), {std::generic_category().message(code)});
    error.value().file = path;
    return error;
}

/// Pipes and devices do not say how long they are.
constexpr std::size_t largestStream = std::size_t(1) << 30;

bool isContinued(const char* begin, const char* feed)
{
    if (feed > begin && feed[-1] == '\r')
        --feed;
    return feed > begin && feed[-1] == '\\';
}

} // namespace

InputFile::InputFile(int file, std::string path)
    : m_file(file)
    , m_path(std::move(path))
{
}

InputFile::InputFile(InputFile&& other) noexcept
    : m_file(std::exchange(other.m_file, -1))
    , m_path(std::move(other.m_path))
    , m_isRegular(other.m_isRegular)
    , m_size(other.m_size)
{
}

InputFile::~InputFile()
{
    if (m_file >= 0)
        ::close(m_file);
}

Expected<InputFile> InputFile::open(const std::string& path)
{
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0)
        return readError(path, errno);
    InputFile out(file, path);
    struct stat status = {};
    if (::fstat(file, &status) != 0)
        return readError(path, errno);
    out.m_isRegular = S_ISREG(status.st_mode);
    out.m_size = out.m_isRegular ? static_cast<std::size_t>(status.st_size) : 0;
    return out;
}

Expected<std::size_t> InputFile::read(char* to, std::size_t room)
{
    std::size_t done = 0;
    while (done < room) {
        const ssize_t got = ::read(m_file, to + done, room - done);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            return readError(m_path, errno);
        if (got == 0)
            break;
        done += static_cast<std::size_t>(got);
    }
    return done;
}

void InputFile::rewind()
{
    ::lseek(m_file, 0, SEEK_SET); // reading tells what is wrong, if anything is
}

Expected<std::string> loadFile(InputFile& file)
{
    const std::size_t block = file.isRegular() ? file.size() : std::size_t(1) << 20;
    std::string out;
    for (;;) {
        const std::size_t before = out.size();
        out.resize(before + block);
        const auto got = file.read(out.data() + before, block);
        RAMURE_TRY(got);
        out.resize(before + *got);
        if (*got < block || file.isRegular())
            return out;
        if (out.size() < largestStream)
            continue;
        auto error = fail(ErrorCode::Limit, RAMURE_NOOP("more than 1 GiB from a pipe or device"));
        error.value().file = file.path();
        return error;
    }
}

Expected<std::string> loadFile(const std::string& path)
{
    auto file = InputFile::open(path);
    RAMURE_TRY(file);
    return loadFile(*file);
}

/// Behind the last line feed that is not taken back by a backslash before it, or 0.
std::size_t LineBlocks::lastLineEnd() const
{
    const char* const begin = m_buffer.data();
    std::string_view text(begin, m_used);
    for (;;) {
        const std::size_t feed = text.rfind('\n');
        if (feed == std::string_view::npos)
            return 0;
        if (!isContinued(begin, begin + feed))
            return feed + 1;
        text = text.substr(0, feed);
    }
}

Expected<std::string_view> LineBlocks::next()
{
    if (m_isAtEnd)
        return std::string_view();
    m_used -= m_given;
    std::memmove(m_buffer.data(), m_buffer.data() + m_given, m_used);
    for (;;) {
        const std::size_t room = m_buffer.size() - 1 - m_used;
        const auto got = m_file.read(m_buffer.data() + m_used, room);
        RAMURE_TRY(got);
        m_used += *got;
        m_isAtEnd = *got < room;
        if (m_isAtEnd) {
            m_padding = paddingOf({m_buffer.data(), m_used});
            m_used -= m_padding;
            m_given = m_used + 1;
            m_buffer[m_used] = '\n';
            break;
        }
        m_given = lastLineEnd();
        if (m_given > 0)
            break;
        m_buffer.resize(2 * m_buffer.size()); // for a line that is longer
    }
    mendLineEnds(m_buffer.data(), m_given - 1);
    return std::string_view(m_buffer.data(), m_given);
}

std::string stem(const std::string& path)
{
    return std::filesystem::path(path).stem().string();
}

std::string excerpt(std::string_view text)
{
    constexpr std::size_t longest = 40;
    std::string out(text.substr(0, longest));
    for (char& c : out)
        if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7F)
            c = '?';
    return text.size() > longest ? out + "..." : out;
}

} // namespace ramure::reading
