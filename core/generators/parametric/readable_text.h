/// \file
/// What of a user's text the parser of parametric grammars reads: without comments, signs of formulas in
/// ASCII. Internal to the parser.
#pragma once

#include "core/generators/grammar/grammar_note.h"

namespace ramure {

/// Comments (# to the end of a line, and /* ... */) become blanks, and signs of formulas the ones that the
/// language has, so that every other character keeps its place. A line that begins with #define, #ignore,
/// #consider or #include is no comment.
/// Errors, path = \p path, with line and column: Syntax (a comment that is never closed; a character that
/// looks like one of the language). \param notes where not null, gets all such characters, and they are no
/// error
Expected<std::string> readableText(std::string_view text, const char* path, GrammarNotes* notes = nullptr);

} // namespace ramure
