/// \file
/// What of a scene the line around the selection goes around.
#pragma once

#include "widgets/view/render/scene_builder.h"
#include "widgets/view/render/scene_part_cache.h"

namespace ramure {

/// As keys of the cache have them.
inline std::vector<double> asNumbers(const std::vector<Index>& indices)
{
    return {indices.begin(), indices.end()};
}

/// The selected branches, else the selected nodes with all below them.
void outlineSelected(RenderScene& built, ScenePartCache& cache, const Scene& scene,
                     const SceneBuilder::ResultOf& resultOf, const SceneView& view);

} // namespace ramure
