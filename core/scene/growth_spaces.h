/// \file
/// Which solids of a scene its trees fill and grow around.
#pragma once

#include "core/params/growth_space.h"
#include "core/scene/scene.h"
#include <map>

namespace ramure {

/// Of the trees whose link is no longer that of the scene: as it is now, at rest, tracks aside. Hidden solids
/// count too. A tree that grows otherwise has no link.
std::map<NodeId, GrowthSpaceLink> staleGrowthSpaces(const Scene& scene);
/// Gives them to the trees. To call after a scene was read; the document does it after every change.
void linkGrowthSpaces(Scene& scene);

} // namespace ramure
