#include "core/generators/parametric/readable_text.h"

#include "core/generators/grammar/lookalikes.h"
#include "core/generators/parametric/text_scanner.h"
#include <algorithm>
#include <array>

namespace ramure {
namespace {

bool isDirective(std::string_view text)
{
    constexpr std::array<std::string_view, 4> words{"#define", "#ignore", "#consider", "#include"};
    return std::ranges::any_of(words, [&](std::string_view word) {
        const char after = text.size() > word.size() ? text[word.size()] : '\0';
        const bool goesOn = (after >= 'a' && after <= 'z') || (after >= 'A' && after <= 'Z') || after == '_';
        return text.starts_with(word) && !goesOn;
    });
}

/// Line feeds stay.
void blank(std::string& text, std::size_t from, std::size_t to)
{
    for (std::size_t i = from; i < to; ++i)
        if (text[i] != '\n')
            text[i] = ' ';
}

TextPlace placeOf(std::string_view text, const char* path, std::size_t at)
{
    const std::string_view before = text.substr(0, at);
    return {path, 1 + static_cast<int>(std::ranges::count(before, '\n')),
            static_cast<int>(before.size() - (before.rfind('\n') + 1)) + 1};
}

} // namespace

Expected<std::string> readableText(std::string_view text, const char* path, GrammarNotes* notes)
{
    std::string out = plainNotation(text);
    bool startsLine = true;
    for (std::size_t at = 0; at < out.size();) {
        const std::string_view rest = std::string_view(out).substr(at);
        std::size_t end = at + 1;
        if (rest[0] == '#' && !(startsLine && isDirective(rest))) {
            end = std::min(out.find('\n', at), out.size());
            blank(out, at, end);
        } else if (rest.starts_with("/*")) {
            end = out.find("*/", at + 2);
            if (end == std::string::npos)
                return failAt(placeOf(text, path, at), ErrorCode::Syntax,
                              RAMURE_NOOP("this comment is never closed: \"*/\" is missing"));
            blank(out, at, end += 2);
        } else if (const auto found = lookalikeAt(out, at)) {
            const TextPlace place = placeOf(text, path, at);
            Error error = lookalikeError(shownCharacter(out, at), found->plain);
            if (!notes)
                return failAt(place, error.code, error.text, std::move(error.args));
            error.path = path;
            error.line = place.line;
            error.column = place.column;
            GrammarNote& note = notes->emplace_back();
            note.what = std::move(error);
            note.size = found->size;
            note.replacement = found->plain;
            end = at + found->size;
        }
        startsLine = rest[0] == '\n' || (startsLine && (rest[0] == ' ' || rest[0] == '\t'));
        at = end;
    }
    return out;
}

} // namespace ramure
