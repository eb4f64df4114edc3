/// \file
/// Which vertices of a mesh lie so close together that a program that merges by distance would make them one:
/// the mesher moves them apart, the checks count them.
#pragma once

#include "core/base/index.h"
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <vector>

namespace ramure {

struct NearPair
{
    Index vertex;
    Index earlier;
    bool operator==(const NearPair&) const = default;
};

/// Every pair of positions at most \p distance (m, above 0) apart, sorted by vertex, then by the earlier one.
/// Positions that are not finite are near nothing. \param most the search ends when it has found so many
/// pairs, because a mesh that is smaller than the distance has as many as its vertices squared.
std::vector<NearPair> findNearPositions(std::span<const glm::vec3> positions, double distance,
                                        std::size_t most = std::numeric_limits<std::size_t>::max());

/// Every vertex that is near to an earlier one, with one to eight of these: quick also where thousands of
/// vertices lie in one place. Sorted likewise.
std::vector<NearPair> findNearVertices(std::span<const glm::vec3> positions, double distance);

} // namespace ramure
