/// \file
/// What hands do to a scatter: one undo step each.
#pragma once

#include "core/qt/document/document.h"

namespace ramure::edit {

/// Inserts a scatter before the first of the nodes, which it copies from then on: they move below it. None:
/// at the end of the top level. Returns its id; it becomes selected. Errors: Unknown, Invalid (locked; a
/// terrain, a camera, a group or another scatter is nothing to copy).
Expected<NodeId> addScatter(Document& document, Node scatter, const std::vector<NodeId>& nodes);
/// A copy of a scatter becomes a node beside the scatter, at its place and with all that the prototype has;
/// the scatter leaves it out. Returns the node's id; it becomes selected. \param key of the copy
/// (ScatterPlace::key) Errors: Unknown (no scatter, no such copy), Invalid (locked), those of scatterPlaces()
/// and of decomposePlacement().
Expected<NodeId> makeReal(Document& document, NodeId scatter, std::uint32_t key);
/// The scatter leaves these copies out. Errors: Unknown (no scatter), Invalid (locked).
Expected<void> removeCopies(Document& document, NodeId scatter, const std::vector<std::uint32_t>& keys);

} // namespace ramure::edit
