/// \file
/// Reads a text in the language of expressions character by character and knows the place of each. Internal
/// to parsers.
#pragma once

#include "core/base/error.h"
#include <string>
#include <string_view>
#include <vector>

namespace ramure {

/// A place in the user's text.
struct TextPlace
{
    const char* path = ""; ///< key of the parameter that holds the text
    int line = 1;          ///< 1-based
    int column = 1;        ///< 1-based, counted in bytes
};

tl::unexpected<Error> failAt(const TextPlace& place, ErrorCode code, const char* text,
                             std::vector<std::string> args = {});

/// Blanks count nowhere; of line feeds, the caller decides.
class TextScanner
{
public:
    /// \param text must outlive the scanner; \param multiline line feeds are blanks
    TextScanner(std::string_view text, const char* path, int line, bool multiline);

    /// The next character that counts, 0 at the end; \p ahead: so many bytes after it, blanks included.
    [[nodiscard]] char peek(std::size_t ahead = 0) const;
    [[nodiscard]] bool atEnd() const { return m_at == m_text.size(); }
    [[nodiscard]] bool startsWith(std::string_view token) const
    {
        return m_text.substr(m_at).starts_with(token);
    }
    [[nodiscard]] bool atArrow() const { return startsWith("->") || startsWith("-->"); }
    bool takeArrow() { return take("->") || take("-->"); }
    [[nodiscard]] bool atNumber() const;
    /// How many digits stand there.
    [[nodiscard]] std::size_t digits() const;
    [[nodiscard]] bool atName() const;
    [[nodiscard]] TextPlace place() const;
    /// The functions below first skip blanks and comments.
    char next();
    bool take(std::string_view token);
    /// A letter, Latin or Greek, or _, then letters, digits and _. Empty where none stands.
    std::string_view takeName();
    /// Returns 0 for a number that is too small. Error: Invalid if it is too large.
    Expected<double> takeNumber();

private:
    void skipBlanks();

    std::string_view m_text;
    const char* m_path;
    int m_line;
    bool m_multiline;
    std::size_t m_at = 0, m_lineStart = 0;
};

} // namespace ramure
