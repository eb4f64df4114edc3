/// \file
/// The trees of an open document as an export gets them.
#pragma once

#include "core/evaluate/evaluator.h"

namespace ramure {

class Document;

/// The results the document has. Error Invalid: a tree's result is missing, a draft, older than its
/// parameters, or its parameters gave an error (that error).
TreeSource documentSource(const Document& document);

} // namespace ramure
