/// \file
/// Which nodes an action means.
#pragma once

#include "core/qt/document/document.h"
#include <QString>
#include <vector>

namespace ramure {

struct ParamDef;

/// The selected nodes; else the tree whose branches are selected; else the only node of the scene, if it has
/// one.
std::vector<NodeId> targetNodes(const Document& document);
/// The trees among the targets and below them; else every tree of the scene.
std::vector<NodeId> targetTrees(const Document& document);
/// A node on which this parameter acts (core/params/param_relevance.h): targets come before the rest of the
/// scene, and nodes that can be changed before locked ones. noNode where there is none.
NodeId nodeWithParam(const Document& document, const ParamDef& def);
/// The switch without which \p def has no effect; null where none decides about it, or a number does.
const ParamDef* switchOf(const ParamDef& def);
/// Why nodeWithParam() finds none: "no effect while “Generator” is “Grammar”".
QString whyNoNode(const Document& document, const ParamDef& def);

} // namespace ramure
