/// \file
/// Where a fork divides its parent's end ring, and which children are neighbours there.
#pragma once

#include "core/math/frame.h"
#include "core/surface/mesher/fork_triangulation.h"
#include <span>
#include <vector>

namespace ramure {

/// A point of a ring, seen from its centre in its frame.
struct RingPoint
{
    double azimuth;       ///< rad
    glm::dvec2 direction; ///< (cos, sin) of the azimuth
};

/// The regular ring of \p count points.
std::vector<RingPoint> regularRing(int count);

/// The disc inside the end ring is cut into one cell per child; the cells' neighbourhoods are the dual of the
/// triangulation of the children's directions. Every hull edge owns one point of the ring, where its wall
/// begins.
struct ForkLayout
{
    ForkTriangulation triangulation;
    /// Azimuths increase from the first point on, over less than one turn.
    std::vector<RingPoint> ring;
    /// Per hull edge: its point's number on the ring, increasing; the first is 0.
    std::vector<Index> splitPoint;
};

/// Makes layouts; keeps its buffers. Give it the children, then let it plan.
class ForkPlanner
{
public:
    void begin() { m_sites.clear(); }
    /// \param frame at the parent's end; \param direction unit, towards the child's end.
    void addChild(const Frame& frame, const glm::dvec3& direction);
    /// At least two children. \param regular the ring without a fork.
    void plan(std::span<const RingPoint> regular, ForkLayout& layout);

private:
    void spread(double gap);
    void fillRing(std::span<const RingPoint> regular, ForkLayout& layout);

    std::vector<glm::dvec2> m_sites;
    std::vector<double> m_splits; ///< azimuths of the hull edges' outward normals, unwrapped
};

} // namespace ramure
