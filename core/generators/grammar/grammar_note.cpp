#include "core/generators/grammar/grammar_note.h"

#include "core/generators/grammar/lookalikes.h"

namespace ramure {

Error lookalikeError(const std::string& shown, const std::string& plain)
{
    if (plain.empty() || plain == " ")
        return fail(ErrorCode::Syntax, RAMURE_NOOP("%1 has no meaning here: remove it"), {shown}).value();
    return fail(ErrorCode::Syntax, RAMURE_NOOP("%1 is not \"%2\": write \"%2\""), {shown, plain}).value();
}

std::string shownCharacter(std::string_view text, std::size_t at)
{
    const auto known = lookalikeAt(text, at);
    const std::size_t size = characterSize(text, at);
    const bool isSeen = !known || !known->isNotation || (!known->plain.empty() && known->plain != " ");
    const std::string shown = isSeen ? '"' + std::string(text.substr(at, size)) + '"' : std::string();
    if (size == 1)
        return shown;
    return isSeen ? shown + " (" + codePointName(text, at) + ')' : codePointName(text, at);
}

std::string withReplacements(std::string text, std::string_view path, const GrammarNotes& notes)
{
    for (auto note = notes.rbegin(); note != notes.rend();
         ++note) { // what comes last first, so that columns stay true
        if (note->what.path != path || !note->replacement)
            continue;
        std::size_t start = 0;
        for (int line = 1; line < note->what.line; ++line)
            start = text.find('\n', start) + 1;
        text.replace(start + static_cast<std::size_t>(note->what.column) - 1, note->size, *note->replacement);
    }
    return text;
}

} // namespace ramure
