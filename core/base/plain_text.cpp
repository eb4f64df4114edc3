#include "core/base/plain_text.h"

#include "core/base/utf8.h"
#include <algorithm>
#include <cstring>

namespace ramure {
namespace {

constexpr std::string_view utf8Mark = "\xEF\xBB\xBF";
constexpr std::string_view bigMark = "\xFE\xFF", littleMark = "\xFF\xFE";

char lowerCase(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// UTF-16 as UTF-8. Halves of a pair that lost the other half become U+FFFD, and \p isWhole false.
std::string fromUtf16(std::string_view bytes, bool isBig, bool& isWhole)
{
    const auto unit = [&](std::size_t at) -> char32_t {
        const auto first = static_cast<unsigned char>(bytes[at]),
                   second = static_cast<unsigned char>(bytes[at + 1]);
        return isBig ? first << 8U | second : second << 8U | first;
    };
    isWhole = bytes.size() % 2 == 0;
    std::string out;
    for (std::size_t at = 0; at + 1 < bytes.size(); at += 2) {
        char32_t c = unit(at);
        const bool hasMore = at + 3 < bytes.size();
        if (c >= 0xD800 && c < 0xDC00 && hasMore && (unit(at + 2) & 0xFC00) == 0xDC00) {
            c = 0x10000 + ((c & 0x3FF) << 10) + (unit(at + 2) & 0x3FF);
            at += 2;
        } else if (c >= 0xD800 && c < 0xE000) {
            c = 0xFFFD;
            isWhole = false;
        }
        appendUtf8(out, c);
    }
    return out;
}

bool hasLoneReturn(std::string_view text)
{
    for (std::size_t at = text.find('\r'); at != std::string_view::npos; at = text.find('\r', at + 1))
        if (at + 1 == text.size() || text[at + 1] != '\n')
            return true;
    return false;
}

} // namespace

bool isUtf16(std::string_view bytes)
{
    return bytes.starts_with(littleMark) || bytes.starts_with(bigMark) ||
           (bytes.size() > 3 && (bytes[0] == '\0') != (bytes[1] == '\0') &&
            (bytes[2] != '\0' || bytes[3] != '\0'));
}

void mendLineEnds(char* bytes, std::size_t size)
{
    if (!std::memchr(bytes, '\r', size))
        return;
    for (std::size_t i = 0; i < size; ++i)
        bytes[i] = bytes[i] == '\r' && bytes[i + 1] != '\n' ? '\n' : bytes[i];
}

std::size_t paddingOf(std::string_view text)
{
    const std::size_t last = text.find_last_not_of(std::string_view("\0\x1A", 2));
    return last == std::string_view::npos ? text.size() : text.size() - last - 1;
}

std::string lowered(std::string_view text)
{
    std::string out(text);
    std::ranges::transform(out, out.begin(), &lowerCase);
    return out;
}

bool isWord(std::string_view text, std::string_view lowerWord)
{
    return text.size() == lowerWord.size() &&
           std::ranges::equal(text, lowerWord, [](char a, char b) { return lowerCase(a) == b; });
}

PlainText::PlainText(std::string_view bytes)
    : m_view(bytes)
{
    if (isUtf16(bytes)) {
        const bool isBig = bytes.starts_with(bigMark) || bytes[0] == '\0';
        m_copy = fromUtf16(bytes, isBig, m_isWhole);
        m_view = m_copy;
    }
    if (m_view.starts_with(utf8Mark))
        m_view.remove_prefix(utf8Mark.size());
    m_padding = paddingOf(m_view);
    m_view.remove_suffix(m_padding);
    if (!hasLoneReturn(m_view))
        return;
    std::string mended(m_view);
    mendLineEnds(mended.data(), mended.size());
    m_copy = std::move(mended);
    m_view = m_copy;
}

bool TextLines::next()
{
    if (m_isAtEnd)
        return false;
    const std::size_t end = m_rest.find('\n');
    std::string_view line = m_rest.substr(0, end);
    m_rest = end == std::string_view::npos ? std::string_view() : m_rest.substr(end + 1);
    m_isAtEnd = m_rest.empty();
    constexpr std::string_view blanks = " \t\r";
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    line.remove_suffix(line.size() - std::min(line.find_last_not_of(blanks) + 1, line.size()));
    m_line = line;
    ++m_number;
    return true;
}

} // namespace ramure
