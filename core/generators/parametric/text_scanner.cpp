#include "core/generators/parametric/text_scanner.h"

#include <charconv>

namespace ramure {
namespace {

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

/// Letters of Greek too, which begin with one of two bytes.
bool startsName(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '\xCE' || c == '\xCF';
}

bool goesOnInName(char c)
{
    return startsName(c) || isDigit(c) || (static_cast<unsigned char>(c) & 0xC0u) == 0x80u;
}

} // namespace

tl::unexpected<Error> failAt(const TextPlace& place, ErrorCode code, const char* text,
                             std::vector<std::string> args)
{
    auto error = fail(code, text, std::move(args));
    error.value().path = place.path;
    error.value().line = place.line;
    error.value().column = place.column;
    return error;
}

TextScanner::TextScanner(std::string_view text, const char* path, int line, bool multiline)
    : m_text(text)
    , m_path(path)
    , m_line(line)
    , m_multiline(multiline)
{
    skipBlanks();
}

void TextScanner::skipBlanks()
{
    for (; m_at < m_text.size(); ++m_at) {
        const char c = m_text[m_at];
        if (c == '\n' && m_multiline) {
            ++m_line;
            m_lineStart = m_at + 1;
        } else if (c != ' ' && c != '\t' && c != '\r')
            return;
    }
}

char TextScanner::peek(std::size_t ahead) const
{
    return m_at + ahead < m_text.size() ? m_text[m_at + ahead] : '\0';
}

bool TextScanner::atNumber() const
{
    return isDigit(peek()) || (peek() == '.' && isDigit(peek(1)));
}

std::size_t TextScanner::digits() const
{
    std::size_t count = 0;
    while (isDigit(peek(count)))
        ++count;
    return count;
}

bool TextScanner::atName() const
{
    return startsName(peek());
}

TextPlace TextScanner::place() const
{
    return {m_path, m_line, static_cast<int>(m_at - m_lineStart) + 1};
}

char TextScanner::next()
{
    const char c = peek();
    if (!atEnd())
        ++m_at;
    skipBlanks();
    return c;
}

bool TextScanner::take(std::string_view token)
{
    if (!startsWith(token))
        return false;
    m_at += token.size();
    skipBlanks();
    return true;
}

std::string_view TextScanner::takeName()
{
    const std::size_t from = m_at;
    if (atName())
        while (goesOnInName(peek()))
            ++m_at;
    const std::string_view name = m_text.substr(from, m_at - from);
    skipBlanks();
    return name;
}

Expected<double> TextScanner::takeNumber()
{
    const TextPlace from = place();
    const char* const start = m_text.data() + m_at;
    double value = 0.0;
    const auto [end, status] = std::from_chars(start, m_text.data() + m_text.size(), value);
    const auto length = static_cast<std::size_t>(end - start);
    const bool isTooSmall = std::string_view(start, length).find("e-") != std::string_view::npos ||
                            std::string_view(start, length).find("E-") != std::string_view::npos;
    if (status != std::errc() && !isTooSmall)
        return failAt(from, ErrorCode::Invalid, RAMURE_NOOP("the number %1 is out of all range"),
                      {std::string(start, length)});
    m_at += length;
    skipBlanks();
    return value;
}

} // namespace ramure
