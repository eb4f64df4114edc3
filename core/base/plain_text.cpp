#include "core/base/plain_text.h"

#include <algorithm>
#include <cstring>

namespace ramure {
namespace {

constexpr std::string_view utf8Mark = "\xEF\xBB\xBF";

char lowerCase(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

void appendUtf8(std::string& to, char32_t c)
{
    const auto put = [&to](char32_t byte) { to += static_cast<char>(static_cast<unsigned char>(byte)); };
    if (c < 0x80) {
        put(c);
        return;
    }
    const int more = c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;
    constexpr char32_t heads[] = {0, 0xC0, 0xE0, 0xF0};
    put(heads[more] | c >> (6 * more));
    for (int i = more - 1; i >= 0; --i)
        put(0x80 | (c >> (6 * i) & 0x3F));
}

/// Halves of a pair that lost the other half become the replacement character.
std::string fromUtf16(std::string_view bytes)
{
    const bool isBig = bytes[0] == '\xFE';
    const auto unit = [&](std::size_t at) {
        const auto first = static_cast<unsigned char>(bytes[at]),
                   second = static_cast<unsigned char>(bytes[at + 1]);
        return static_cast<char32_t>(isBig ? first << 8 | second : second << 8 | first);
    };
    std::string out;
    for (std::size_t at = 2; at + 1 < bytes.size(); at += 2) {
        char32_t c = unit(at);
        const bool hasMore = at + 3 < bytes.size();
        if (c >= 0xD800 && c < 0xDC00 && hasMore && (unit(at + 2) & 0xFC00) == 0xDC00) {
            c = 0x10000 + ((c & 0x3FF) << 10) + (unit(at + 2) & 0x3FF);
            at += 2;
        } else if (c >= 0xD800 && c < 0xE000)
            c = 0xFFFD;
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
    return bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF");
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
        m_copy = fromUtf16(bytes);
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
