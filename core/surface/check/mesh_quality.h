/// \file
/// How well shaped are the triangles of a mesh? Slivers shade badly, simulate badly and unwrap badly.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/surface/mesh/triangle_mesh.h"
#include <array>
#include <cstdint>
#include <vector>

namespace ramure {

/// A triangle of bad shape.
struct WorstFace
{
    Index face = 0;
    double smallestAngleRad = 0.0;
    double aspect = 0.0;
    bool operator==(const WorstFace&) const = default;
};

struct MeshQuality
{
    static constexpr int angleBins = 12; ///< of 5 degrees: a smallest angle is at most 60
    /// Lower ends of the bins of the aspect; the last one is open.
    static constexpr std::array<double, 9> aspectBins{1.0, 1.5, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0, 100.0};
    static constexpr std::size_t worstListed = 100;
    static constexpr double nearDistance =
        1e-4; ///< m: within it Blender merges vertices, unless told otherwise
    static constexpr std::size_t mostNearPairs = 1'000'000; ///< no more are counted

    double smallestAngleRad = 0.0; ///< of all triangles that have an area; 0 where there is none
    Index smallestAngleFace = noIndex;
    double largestAspect = 0.0; ///< longest side against what it would be in an equilateral triangle with
                                ///< the same inscribed circle: 1 at best
    Index largestAspectFace = noIndex;
    std::array<Index, angleBins> angles{};          ///< triangles by their smallest angle
    std::array<Index, aspectBins.size()> aspects{}; ///< triangles by their aspect
    Index withoutArea = 0;                          ///< in no bin: no area, or not finite
    /// Pairs of vertices at most nearDistance apart: merging would close holes or pinch the surface there.
    Index nearPairs = 0;
    std::vector<WorstFace> worst; ///< by smallest angle, the worst first; at most worstListed
    bool operator==(const MeshQuality&) const = default;
};

/// \param threads 0 = as many as the machine has; the result is the same for any number.
/// Errors: Invalid (an index out of range), Cancelled.
Expected<MeshQuality> measureQuality(const TriangleMesh& mesh, unsigned threads = 0,
                                     const Progress& progress = {});

} // namespace ramure
