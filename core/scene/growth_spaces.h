/// \file
/// Which solids of a scene its trees fill and grow around, and which trees shade each other.
#pragma once

#include "core/params/growth_space.h"
#include "core/scene/scene.h"
#include <map>
#include <span>

namespace ramure {

/// Returns a new link for each tree whose stored link is out of date. Links ignore animation; hidden solids
/// count. A tree that grows in another way has no link. \param only the trees to look at; none: all
std::map<NodeId, GrowthSpaceLink> staleGrowthSpaces(const Scene& scene, std::span<const NodeId> only = {});
void setGrowthSpace(NodeParams& params, const GrowthSpaceLink& link);
/// Gives them to the trees, and the ground that they stand on (standing_ground.h). To call after a scene was
/// read; the document does it after every change.
void linkGrowthSpaces(Scene& scene);

} // namespace ramure
