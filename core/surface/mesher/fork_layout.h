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
    /// The child that the others, thin beside it, leave to their sides: each has a piece of the ring of its
    /// own width, and the wood of this one all around it. noIndex: there is none.
    Index stem = noIndex;
    /// Azimuths increase from the first point on, over less than one turn.
    std::vector<RingPoint> ring;
    /// Per hull edge: its point's number on the ring, increasing; the first is 0.
    std::vector<Index> splitPoint;
};

/// Of the parent's radius: a child that others leave to its side.
inline constexpr double leastStem = 0.745;

/// Makes layouts; keeps its buffers. Give it the children, then let it plan.
class ForkPlanner
{
public:
    /// \param maySlant limbs at a small angle leave the stem to its side as well: their feet are long.
    void begin(bool maySlant = false)
    {
        m_maySlant = maySlant;
        m_sites.clear();
        m_limbs.clear();
    }
    /// \param frame at the parent's end; \param direction unit, towards the child.
    void addChild(const Frame& frame, const glm::dvec3& direction);
    /// The same, of a child that may be a stem or leave one to its side. \param chord unit, towards its end;
    /// \param radius m, where it starts, of the parent's end.
    void addChild(const Frame& frame, const glm::dvec3& direction, const glm::dvec3& chord, double radius);
    /// The child that all others leave to its side; noIndex: there is none.
    [[nodiscard]] Index findStem() const;
    /// At least two children. \param regular the ring without a fork.
    void plan(std::span<const RingPoint> regular, ForkLayout& layout);

private:
    struct Limb
    {
        glm::dvec3 chord; ///< unit, in the frame: normal, binormal, tangent
        double radius;    ///< of the parent's end
    };
    void planStar(ForkLayout& layout);
    void splitHull(const ForkTriangulation& triangulation);
    [[nodiscard]] double gapAfter(std::size_t split) const;
    [[nodiscard]] double narrowestGap() const;
    void spread(double gap);
    void fillRing(std::span<const RingPoint> regular, ForkLayout& layout);

    bool m_maySlant = false;
    std::vector<glm::dvec2> m_sites;
    std::vector<Limb> m_limbs;    ///< of all children, or none: nothing is known of them
    std::vector<double> m_splits; ///< azimuths of the hull edges' outward normals, unwrapped
};

} // namespace ramure
