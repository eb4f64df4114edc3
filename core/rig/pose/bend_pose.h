/// \file
/// The pose of a tree whose branches are bent otherwise: shown at once, while the mesh of the other bends is
/// still to be made.
#pragma once

#include "core/rig/pose/pose.h"
#include "core/skeleton/skeleton.h"
#include <span>

namespace ramure {

/// Returns how each branch moves if the branches of \p skeleton, made with \p fromRad, are turned by \p toRad
/// instead. \param fromRad, toRad bends, one per branch, see core/skeleton/bend.h
std::vector<RigidTransform> bendPose(const Skeleton& skeleton, std::span<const glm::dvec3> fromRad,
                                     std::span<const glm::dvec3> toRad);

} // namespace ramure
