/// \file
/// All that is asked of a finished mesh besides its topology: what crosses, what collides, how well shaped
/// the triangles are, and its hash. Takes about a second for a million triangles.
#pragma once

#include "core/surface/check/collisions.h"
#include "core/surface/check/mesh_quality.h"
#include "core/surface/check/self_intersections.h"
#include "core/surface/mesh/mesh_hash.h"

namespace ramure {

struct MeshAnalysis
{
    MeshHash hash;
    MeshQuality quality;
    SelfIntersections crossings;
    std::vector<Collision> collisions; ///< the deepest first; none where the mesh has no branches
    double seconds = 0.0;              ///< time that the analysis took

    /// The same findings, however long they took.
    [[nodiscard]] bool sameFindings(const MeshAnalysis& other) const
    {
        return hash == other.hash && quality == other.quality && crossings == other.crossings &&
               collisions == other.collisions;
    }
};

/// \param skeleton the one that the mesh was built from.
/// \param threads 0 = as many as the machine has; the findings are the same for any number.
/// Errors: those of findSelfIntersections and measureQuality.
Expected<MeshAnalysis> analyseMesh(const BranchMesh& branches, const Skeleton& skeleton, unsigned threads = 0,
                                   const Progress& progress = {});
/// Computes hash and quality alone, in about 30 ms for a million triangles. Errors: those of measureQuality.
Expected<MeshAnalysis> analyseShape(const TriangleMesh& mesh, unsigned threads = 0,
                                    const Progress& progress = {});
/// Analyses a mesh from a file, whose branches are unknown.
Expected<MeshAnalysis> analyseMesh(const TriangleMesh& mesh, unsigned threads = 0,
                                   const Progress& progress = {});

} // namespace ramure
