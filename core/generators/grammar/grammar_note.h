/// \file
/// A remark about one place in the text of a grammar: the text can be read, but probably does not mean what
/// its author thinks.
#pragma once

#include "core/base/error.h"
#include <optional>
#include <string>
#include <vector>

namespace ramure {

struct GrammarNote
{
    Error what;                             ///< with path, line and column
    std::size_t size = 1;                   ///< bytes of the text that it is about, from the column on
    char symbol = '\0';                     ///< first byte of the symbol that the note is about, if any
    std::optional<std::string> replacement; ///< the text that should replace it, if known
};
using GrammarNotes = std::vector<GrammarNote>;

/// A character that looks like \p plain in ASCII; empty: one that has no meaning there. For texts that cannot
/// be read with it. \param shown the character, or the name of one that cannot be seen
Error lookalikeError(const std::string& shown, const std::string& plain);
/// Returns the character that begins at byte \p at, as messages show it: the character with its code point,
/// or the code point alone if the character is invisible.
std::string shownCharacter(std::string_view text, std::size_t at);

/// The text with all replacements of the notes whose path is \p path. \pre the notes are about this text, in
/// its order
std::string withReplacements(std::string text, std::string_view path, const GrammarNotes& notes);

} // namespace ramure
