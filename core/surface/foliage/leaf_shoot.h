/// \file
/// A short shoot of several leaves that is placed, and swings, as one: the end shoots of a tree, too many and
/// too fine to be branches of its mesh.
#pragma once

#include "core/surface/foliage/leaf_shapes.h"

namespace ramure {

/// Puts \p form.perShoot copies of a leaf on a stem of wood. Its unit is the length of a leaf; its foot lies
/// at the origin, the stem runs along +Y and the leaves turn their upper sides towards +Z. They follow each
/// other as form.arrangement says, the smaller ones at both ends, and the last one ends the stem. A shoot of
/// one leaf is that leaf. \param leaf made for the same plant, with one leaf: its mesh, or its card. \pre the
/// shape is not Faithful.
TriangleMesh shootOf(const TriangleMesh& leaf, const LeafForm& form);

/// Returns the area of what is green in a leaf or shoot for a leaf that is 1 long: one side of blades, half
/// of the surface of needles. \pre the shape is not Faithful.
double bladeArea(const LeafForm& form);

} // namespace ramure
