/// \file
/// What trees of a scene stand on: terrains, and solids that are obstacles, such as rocks.
#pragma once

#include "core/params/ground_plane.h"
#include "core/scene/scene.h"
#include <map>
#include <span>

namespace ramure {

/// Returns the ground of each tree with roots whose stored one is out of date: the plane of the surface
/// nearest to its foot, or nothing where none is near. Ignores animation; hidden solids count. \param only
/// the trees to look at; none: all
std::map<NodeId, StandingGround> staleGrounds(const Scene& scene, std::span<const NodeId> only = {});

} // namespace ramure
