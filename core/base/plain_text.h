/// \file
/// The text of a file, whichever system and program wrote it, and its lines. All readers of text files begin
/// here.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ramure {

/// True where the bytes begin with the byte order mark of UTF-16. Without one, a zero byte beside the first
/// letter tells, unless two more follow it: those are padding.
bool isUtf16(std::string_view bytes);

/// Turns each carriage return that no line feed follows into a line feed. \p bytes[\p size] must be readable.
void mendLineEnds(char* bytes, std::size_t size);

/// How many zero bytes and DOS end marks (Ctrl+Z) stand at the end of the text. They belong to no line:
/// file systems and programs that work in blocks leave them behind.
std::size_t paddingOf(std::string_view text);

/// "a" for "A", and every other byte as it is.
std::string lowered(std::string_view text);
/// Compares words without regard to capitals. \p lower has none.
bool isWord(std::string_view text, std::string_view lower);

/// The bytes of a file as UTF-8 with a line feed at the end of each line. UTF-16 is converted, and half a
/// character becomes U+FFFD; the byte order mark and padding at the end are left out; lone carriage returns
/// become line feeds, and a carriage return before a line feed stays. Whatever is not to be changed is not copied:
/// \p bytes must outlive the object.
class PlainText
{
public:
    explicit PlainText(std::string_view bytes);
    PlainText(const PlainText&) = delete;
    PlainText& operator=(const PlainText&) = delete;

    [[nodiscard]] std::string_view view() const { return m_view; }
    /// False where the text is UTF-16 and some character of it is not whole.
    [[nodiscard]] bool isWhole() const { return m_isWhole; }
    /// Bytes of padding that were left out.
    [[nodiscard]] std::size_t padding() const { return m_padding; }

private:
    std::string m_copy;
    std::string_view m_view;
    std::size_t m_padding = 0;
    bool m_isWhole = true;
};

/// Walks over the lines of a plain text: `while (lines.next()) use(lines.line(), lines.number());`
class TextLines
{
public:
    explicit TextLines(std::string_view text)
        : m_rest(text)
        , m_isAtEnd(text.empty())
    {
    }
    /// False behind the last line. A line feed at the end of the text begins no line of its own.
    bool next();
    /// Without its end, and without blanks at both ends.
    [[nodiscard]] std::string_view line() const { return m_line; }
    [[nodiscard]] int number() const { return m_number; } ///< from 1 on

private:
    std::string_view m_rest, m_line;
    int m_number = 0;
    bool m_isAtEnd;
};

} // namespace ramure
