/// \file
/// A tree that grows as one mesh: the same vertices and triangles at every age, for files that keep a shape
/// as key shapes, such as the morph targets of glTF. It is the bark of all wood that the tree has ever had.
/// What is not born yet is a needle a few tenths of a millimetre thick where it will come out, and what was
/// shed has shrunk into its scar.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/params/node_params.h"
#include "core/surface/mesh/triangle_mesh.h"
#include <memory>
#include <vector>

namespace ramure {

inline constexpr int mostGrowthKeys = 32;
struct GrowthMeshOptions
{
    double from = 1.0;               ///< years, of the first key; the last is the tree's age
    int keys = 12;                   ///< most key shapes, 2 to mostGrowthKeys
    std::int64_t triangles = 60'000; ///< of the mesh, about
    bool texture = false;            ///< with texture coordinates, which are those of the last age
};

/// The mesh at one age.
struct GrowthKey
{
    double age = 0.0;                 ///< years
    std::vector<glm::vec3> positions; ///< m, tree space, as many as the mesh has
    std::vector<glm::vec3> normals;   ///< unit, as many
};

struct GrowthMesh
{
    std::shared_ptr<const TriangleMesh> bark; ///< as it is at the last age, closed and manifold
    std::vector<GrowthKey> keys;              ///< by rising age, the last is the mesh itself
    /// m: how far the end of a living branch is at most from where it would be, at whole years between keys,
    /// if vertices move from one key to the next in straight lines.
    double error = 0.0;
};

/// The ages of the keys are chosen so that the error is small. The same parameters give the same bytes.
/// Errors: Invalid (path "generator.kind": the tree does not grow by years, or is a palm; path "edits": a
/// step that is not part of its life, such as a modifier; path "growth.age": it is not older than the first
/// key; options out of range); those of growHistory() and treeLevels(); Cancelled.
Expected<GrowthMesh> growthMesh(const NodeParams& params, const GrowthMeshOptions& options,
                                const Progress& progress = {});

} // namespace ramure
