/// \file
/// Do two triangles of a mesh run through each other? Exact for any finite float coordinates. Triangles are
/// closed (their border belongs to them) and must have an area: see viewOf in exact_predicates.h.
#pragma once

#include "core/base/index.h"
#include <array>
#include <glm/vec3.hpp>
#include <span>

namespace ramure {

using Corners3 = std::array<glm::vec3, 3>;

/// Triangles without a common vertex: have they a point in common?
bool trianglesMeet(const Corners3& s, const Corners3& t);
/// Triangles whose first corners are one vertex: have they a point in common beside it?
bool trianglesMeetBeyondVertex(const Corners3& s, const Corners3& t);
/// Triangles on one edge, \p p and \p q their corners opposite to it: do they lie in one plane, on the same
/// side of the edge?
bool trianglesMeetBeyondEdge(const glm::vec3& a, const glm::vec3& b, const glm::vec3& p, const glm::vec3& q);
/// Two different triangles of one mesh, by their vertices' numbers: do they run through each other? What they
/// have in common as neighbours does not count; three common vertices always do.
bool facesMeet(std::span<const glm::vec3> positions, const glm::uvec3& s, const glm::uvec3& t);

} // namespace ramure
