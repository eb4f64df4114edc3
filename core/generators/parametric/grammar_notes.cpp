#include "core/generators/parametric/grammar_notes.h"

#include "core/generators/grammar/grammar.h"
#include "core/generators/parametric/readable_text.h"
#include <utility>

namespace ramure {

GrammarNotes grammarNotes(const GrammarParams& params)
{
    GrammarNotes notes;
    if (params.dialect == GrammarDialect::Classic) {
        [[maybe_unused]] const auto grammar = parseGrammar(params.axiom, params.rules, &notes);
        return notes;
    }
    for (const auto& [path, text] :
         {std::pair("grammar.constants", &params.constants), std::pair("grammar.axiom", &params.axiom),
          std::pair("grammar.rules", &params.rules)})
        [[maybe_unused]] const auto readable = readableText(*text, path, &notes);
    return notes;
}

std::vector<Error> grammarWarnings(const NodeParams& params)
{
    std::vector<Error> warnings;
    if (params.generator.kind != EditOperation::Grammar || params.grammar.dialect != GrammarDialect::Classic)
        return warnings;
    for (GrammarNote& note : grammarNotes(params.grammar))
        warnings.push_back(std::move(note.what));
    return warnings;
}

} // namespace ramure
