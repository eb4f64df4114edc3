/// \file
/// Do two triangles of a mesh run through each other? Exact for any finite float coordinates. Triangles are
/// closed (their border belongs to them) and must have an area: see viewOf in exact_predicates.h.
#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace ramure {

using Corners3 = std::array<glm::vec3, 3>;

/// Triangles without a common vertex: have they a point in common?
bool trianglesMeet(const Corners3& s, const Corners3& t);
/// Triangles whose first corners are one vertex: have they a point in common beside it?
bool trianglesMeetBeyondVertex(const Corners3& s, const Corners3& t);
/// Triangles on one edge, \p p and \p q their corners opposite to it: do they lie in one plane, on the same
/// side of the edge?
bool trianglesMeetBeyondEdge(const glm::vec3& a, const glm::vec3& b, const glm::vec3& p, const glm::vec3& q);

} // namespace ramure
