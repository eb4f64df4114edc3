/// \file
/// Branches that lie far from each other in the tree and yet run through each other (SPEC A9): where, and how
/// deep.
#pragma once

#include "core/skeleton/sections.h"
#include "core/skeleton/skeleton.h"
#include "core/surface/check/self_intersections.h"
#include <array>
#include <span>
#include <vector>

namespace ramure {

struct Collision
{
    Index first = 0, second = 0; ///< branches of the skeleton, the lower one first
    std::uint64_t facePairs = 0; ///< triangles of theirs that cross
    glm::dvec3 place{0.0};       ///< tree space, m
    double depth = 0.0;          ///< m by which they would have to move apart: an estimate, see tubeContact
    bool operator==(const Collision&) const = default;
};

/// A branch as a few truncated cones around its curve (SPEC A4).
struct BranchTube
{
    static constexpr std::size_t pieces = 8;
    std::array<glm::dvec3, pieces + 1> points;
    std::array<double, pieces + 1> radii;
};
BranchTube branchTube(const BranchCurve& curve, double a0, double a1);

/// The place at which two tubes are closest in relation to their radii.
struct TubeContact
{
    double depth = 0.0; ///< the sum of the radii less the distance of the axes: negative where they are apart
    glm::dvec3 onFirst{0.0}, onSecond{0.0}; ///< points of the axes
    double radiusFirst = 0.0, radiusSecond = 0.0;
};
TubeContact tubeContact(const BranchTube& first, const BranchTube& second);

/// The deepest first, then by branches. The depth is at least 0: triangles cross, whatever the estimate says.
std::vector<Collision> findCollisions(const Skeleton& skeleton, std::span<const CrossingBranches> crossings);

} // namespace ramure
