/// \file
/// What the scene panel does to several nodes at once, each as one undo step.
#pragma once

#include "core/qt/document/document.h"
#include <vector>

namespace ramure::edit {

/// Moves nodes one row up (\p step -1) or down (+1) among their siblings; a row of neighbours stays together,
/// and what stands at the end stays. Errors: Invalid (a node is locked); then nothing has moved.
Expected<void> shiftNodes(Document& document, const std::vector<NodeId>& nodes, int step);

/// Shows only these nodes, with what is below them and the groups they stand in. Where that is what is shown
/// already, everything is shown again. Locked nodes stay as they are.
Expected<void> isolateNodes(Document& document, const std::vector<NodeId>& nodes);

/// Makes every node visible that is not locked.
Expected<void> showAllNodes(Document& document);

} // namespace ramure::edit
