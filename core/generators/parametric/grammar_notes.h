/// \file
/// Remarks on the texts of a tree's grammar, for those who show them: window and command line.
#pragma once

#include "core/generators/grammar/grammar_note.h"
#include "core/params/node_params.h"

namespace ramure {

/// Returns notes on the texts of a grammar, in their order. For the classic language these are the remarks of
/// parseGrammar: the tree grows, but probably not as its author means. For the parametric one these are the
/// characters for which parseParametric refuses a text.
GrammarNotes grammarNotes(const GrammarParams& params);

/// Returns the warnings for a tree that does grow: the remarks on its classic grammar, if it grows from one.
std::vector<Error> grammarWarnings(const NodeParams& params);

} // namespace ramure
