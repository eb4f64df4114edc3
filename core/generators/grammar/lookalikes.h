/// \file
/// Characters outside ASCII that look like characters of the language of grammars and of number fields, as
/// web pages, word processors and books print them: the typographic minus, arrows, full-width letters, blanks
/// that do not break.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace ramure {

struct Lookalike
{
    std::size_t size = 0; ///< bytes that the character takes
    std::string plain;    ///< the ASCII text it looks like: a blank, or empty if it is invisible
    /// A mathematical sign or a blank that means the same as its plain form wherever it stands in a formula.
    bool isNotation = false;
};

/// Returns the character of \p text that begins at byte \p at; nothing if it is ASCII, not valid UTF-8, or
/// resembles no character of the language.
std::optional<Lookalike> lookalikeAt(std::string_view text, std::size_t at);

/// Bytes of the UTF-8 character that begins there; 1 where the bytes are no valid UTF-8.
std::size_t characterSize(std::string_view text, std::size_t at);

/// "U+2212" for the UTF-8 character that begins at byte \p at.
std::string codePointName(std::string_view text, std::size_t at);

/// The text with the plain form of every sign of formulas, filled up with blanks so that all other characters
/// keep their places.
std::string plainNotation(std::string_view text);

} // namespace ramure
