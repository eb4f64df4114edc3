/// \file
/// Where a fork divides its parent's end ring, and which children are neighbours there.
#pragma once

#include "core/geometry/frame.h"
#include "core/mesh/fork_triangulation.h"
#include <span>
#include <vector>

namespace ramure {

/// The disc inside the end ring is cut into one cell per child; the cells' neighbourhoods are the dual of the
/// triangulation of the children's directions. Every hull edge owns one point of the ring, where its wall
/// begins.
struct ForkLayout
{
    ForkTriangulation triangulation;
    std::vector<double>
        azimuths; ///< of the ring's points, increasing from azimuths[0] over less than one turn
    std::vector<Index>
        splitPoint; ///< per hull edge: its point's number on the ring, increasing; the first is 0
};

/// Makes layouts; keeps its buffers.
class ForkPlanner
{
public:
    /// \param frame at the parent's end; \param directions unit, towards the children's ends, at least two.
    void plan(const Frame& frame, std::span<const glm::dvec3> directions, int radialDivisions,
              ForkLayout& layout);

private:
    void spread(double gap);
    void fillRing(int radialDivisions, ForkLayout& layout);

    std::vector<glm::dvec2> m_sites;
    std::vector<double> m_splits; ///< azimuths of the hull edges' outward normals, unwrapped
};

} // namespace ramure
