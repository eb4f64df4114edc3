/// \file
/// The leaves of a tree that grows as one mesh (growth_mesh.h): a mesh for each of its ages, whose leaves
/// open from the places where they stand and close again.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/params/node_params.h"
#include "core/surface/foliage/foliage.h"
#include "core/surface/mesh/triangle_mesh.h"
#include <memory>
#include <span>
#include <vector>

namespace ramure {

struct GrowthLeaves
{
    std::shared_ptr<const TriangleMesh> mesh;
    std::vector<glm::vec3> closed;          ///< by vertex: where it is while its leaf is closed
    std::shared_ptr<const Foliage> foliage; ///< that the mesh shows
};

/// By age; an age at which the tree is bare has no mesh. Where a tree has more leaves than the triangles
/// allow, they are fewer and larger, as on levels of detail. \param texture with texture coordinates Errors:
/// those of TreePipeline and treeLevels(); Cancelled.
Expected<std::vector<GrowthLeaves>> growthLeaves(const NodeParams& params, std::span<const double> ages,
                                                 std::int64_t triangles, bool texture,
                                                 const Progress& progress = {});

} // namespace ramure
