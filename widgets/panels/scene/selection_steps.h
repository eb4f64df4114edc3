/// \file
/// From one selection to the next: up to the parents, down to the children, all of an order. Where branches
/// are selected the steps go from branch to branch, otherwise from node to node.
#pragma once

#include "core/qt/document/document.h"

namespace ramure {

enum class SelectionStep {
    Parent,   ///< of each; what has none stays
    Children, ///< of each; what has none stays
    Siblings, ///< all with the same parent, itself included
    Subtree,  ///< with all below it
    Order,    ///< all as deep as one of them: depth of brackets for branches, depth in the scene for nodes
};

/// The document's selection, one step further. Nodes that are selected beside branches stay.
Selection afterStep(const Document& document, SelectionStep step);

} // namespace ramure
