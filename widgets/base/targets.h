/// \file
/// Which nodes an action means.
#pragma once

#include "core/qt/document/document.h"
#include <vector>

namespace ramure {

struct ParamDef;

/// The selected nodes; else the tree whose branches are selected; else the only node of the scene, if it has
/// one.
std::vector<NodeId> targetNodes(const Document& document);
/// The trees among the targets and below them; else every tree of the scene.
std::vector<NodeId> targetTrees(const Document& document);
/// A node that has this parameter: of those where it has an effect and that can be changed the first, targets
/// before the rest of the scene; else the first of all; noNode where none has it.
NodeId nodeWithParam(const Document& document, const ParamDef& def);

} // namespace ramure
