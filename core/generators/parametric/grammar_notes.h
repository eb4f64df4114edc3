/// \file
/// Remarks on the texts of a tree's grammar, for those who show them: window and command line.
#pragma once

#include "core/generators/grammar/grammar_note.h"
#include "core/params/node_params.h"

namespace ramure {

/// Of the classic language what parseGrammar remarks: the tree grows, but probably not as its author means.
/// Of the parametric one, the characters for which parseParametric refuses a text. In the order of the texts.
GrammarNotes grammarNotes(const GrammarParams& params);

/// What is to be told of a tree that grows all the same: the remarks on a classic grammar, where a grammar is
/// what the tree grows from.
std::vector<Error> grammarWarnings(const NodeParams& params);

} // namespace ramure
