/// \file
/// Finds free ground for nodes that are added to a scene.
#pragma once

#include "core/qt/document/document.h"
#include <optional>

namespace ramure {

/// On the ground, to the right (+X) of everything that is shown, with room for what reaches so far; the
/// origin where there is nothing. World. Trees without a result, and what has no shape, count as a point.
glm::dvec3 freePlace(const Document& document, double reach);

namespace edit {
/// Inserts a node and selects it, as one step of undo; the node needs no id. \param parent noNode: at the top
/// \param place world; unset: a free place. Errors: those of insertNodes.
Expected<NodeId> plantNode(Document& document, Node node, NodeId parent = noNode,
                           const std::optional<glm::dvec3>& place = {});
/// If the boxes of these nodes and their children overlap those of the others, moves them along +X until they
/// stand beside all of them, as one step of undo. Returns the distance in m in the world; 0 means that they
/// stay, because there is room or because keys move them. Errors: those of setParam.
Expected<double> moveBeside(Document& document, const std::vector<NodeId>& tops);
/// Gives trees the parameters of \p like. Their places, parents and branch edits stay. They take its preset
/// and, if they had the name of their old preset, its name. One step of undo, with this text. Errors: those
/// of setParams.
Expected<void> makeTreesLike(Document& document, const std::vector<NodeId>& trees, const Node& like,
                             const QString& step);
} // namespace edit

} // namespace ramure
