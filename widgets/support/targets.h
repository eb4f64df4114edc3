/// \file
/// Which nodes an action means.
#pragma once

#include "core/document/document.h"
#include <vector>

namespace ramure {

/// The selected nodes; else the tree whose branches are selected; else the only node of the scene, if it has
/// one.
std::vector<NodeId> targetNodes(const Document& document);
/// The trees among the targets and below them; else every tree of the scene.
std::vector<NodeId> targetTrees(const Document& document);

} // namespace ramure
