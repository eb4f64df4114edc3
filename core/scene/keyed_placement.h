/// \file
/// The placement of a node that keys move: the values that fields show at a time, and the keys that follow
/// from an edit of them. Pure.
///
/// A node stands at its global track times its placement (SPEC B2). The placement is taken over into the
/// first key of the track unless something speaks against it. Keys then have the values of the fields, and
/// the node turns about its own origin, not about its parent's.
#pragma once

#include "core/scene/node_transform.h"

namespace ramure {

enum class PlacementPart : std::uint8_t { Translation, Rotation, Scale };

/// Returns track times placement, as translation, angles and scale. The translation is exact; angles and
/// scale are the products of the factors (no shear). \param angles false: the rotation is not needed and
/// takes no time; it stays that of the placement
PlacementParams placementAt(const NodeTransform& values, double seconds, bool angles = true);
/// Keys at the time in all channels of the part that have none there, with the values there are: nothing
/// moves at this time. Turns and scales about another place than the own origin are keyed together with that
/// place. \param mode of keys without one before. Error Invalid: a number that is not finite.
Expected<NodeTransform> withPlacementKeys(const NodeTransform& values, Ticks time, PlacementPart part,
                                          KeyMode mode = KeyMode::Bezier);
/// Keys at the time by which the part of the placement becomes \p wanted (angles in rad); of translation and
/// scale only one \p component where one is named. Error Invalid: a number that is not finite, a scale that
/// cannot be reached because the placement's own is 0.
Expected<NodeTransform> withPlacementSet(const NodeTransform& values, Ticks time, PlacementPart part,
                                         const glm::dvec3& wanted, std::optional<int> component);

} // namespace ramure
