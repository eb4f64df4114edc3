/// \file
/// A scatter as a crowd of the scene: its prototypes in their forms, and where they stand.
#pragma once

#include "widgets/view/render/scene_builder.h"

namespace ramure {

class ScenePartCache;
class ScatterMemory;

/// What the crowd of one scatter is made of.
struct CrowdSource
{
    const Scene& scene;
    const Node& scatter;
    glm::dmat4 world{1.0};
    const SceneBuilder::ResultOf& resultOf;
    const SceneView& view;
    /// Returns a prototype as it is drawn alone. \param at how its geometry stands
    std::function<std::vector<MeshItem>(const Node& prototype, const glm::dmat4& at)> alone;
};

/// Appends the crowd, and a frame around it where the scatter is selected. Nothing where the rules of the
/// scatter are wrong, or none of its prototypes can be shown.
void addCrowd(RenderScene& built, ScenePartCache& cache, ScatterMemory& memory, const CrowdSource& source);

} // namespace ramure
