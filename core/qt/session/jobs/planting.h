/// \file
/// What is added to a scene stands where there is room.
#pragma once

#include "core/qt/document/document.h"
#include <optional>

namespace ramure {

/// m: about how far to the side a tree of these numbers reaches, before it has grown.
double usualReach(const NodeParams& params);

/// On the ground, to the right (+X) of everything that is shown, with room for what reaches so far; the
/// origin where there is nothing. World. Trees without a result, and what has no shape, count as a point.
glm::dvec3 freePlace(const Document& document, double reach);

namespace edit {
/// One step of undo; the node, which needs no id, is selected. \param parent noNode: at the top \param place
/// world; nothing: a free one. Errors: those of insertNodes.
Expected<NodeId> plantNode(Document& document, Node node, NodeId parent = noNode,
                           const std::optional<glm::dvec3>& place = {});
/// Where the boxes of these nodes and what is below them run into those of the others, moves them along +X
/// until they stand beside all of them: one step of undo of its own. \returns by how many m in the world; 0:
/// they stay, because there is room or because keys move them. Errors: those of setParam.
Expected<double> moveBeside(Document& document, const std::vector<NodeId>& tops);
/// These trees get the numbers that make \p like what it is; where they stand, what holds them and what was
/// done to their branches stays. They are of its preset then, and get its name where they had that of their
/// old one. One step of undo, with this text. Errors: those of setParams.
Expected<void> makeTreesLike(Document& document, const std::vector<NodeId>& trees, const Node& like,
                             const QString& step);
} // namespace edit

} // namespace ramure
