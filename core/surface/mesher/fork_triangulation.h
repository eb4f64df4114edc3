/// \file
/// Delaunay triangulation of the children's directions at a fork, on an integer grid with exact predicates,
/// so that no rounding ever decides the topology of a mesh.
#pragma once

#include "core/base/index.h"
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace ramure {

class ForkTriangulation
{
public:
    struct Triangle
    {
        std::array<Index, 3> site;      ///< counter-clockwise
        std::array<Index, 3> neighbour; ///< across the edge site[i] -> site[i + 1], noIndex outside
    };
    /// A directed edge of the hull, the sites on its left.
    struct HullEdge
    {
        Index from, to;
        Index triangle;          ///< noIndex: the wall of the edge ends on the ring again,
        Index partner = noIndex; ///< where this edge of the hull, the other way round, has its point
    };

    /// Triangulates \p points, one per child, |coordinate| < 16; equal ones are moved to free places of the
    /// grid. At least two points. Sites on one line give no triangles and a hull that visits the inner ones
    /// twice.
    void build(std::span<const glm::dvec2> points);

    /// No triangles: every site is a neighbour of \p centre alone. The hull goes from there to each of the
    /// others and back, by their azimuths.
    void buildStar(std::span<const glm::dvec2> points, Index centre);

    /// Takes flat triangles off the sides of the hull, where their third site is inside: it gets a place on
    /// the hull, which is no longer convex there. \param mostCosine of the angle at that site.
    void openFlatSides(double mostCosine);

    [[nodiscard]] const std::vector<Triangle>& triangles() const { return m_triangles; }
    [[nodiscard]] const std::vector<HullEdge>& hull() const { return m_hull; } ///< counter-clockwise
    /// A site's place after the snap to the grid, in the units of the points.
    [[nodiscard]] glm::dvec2 place(Index site) const;

private:
    struct Site
    {
        std::int64_t x, y;
    };
    void snap(std::span<const glm::dvec2> points);
    void sweep();
    void startFan(Index apex, std::size_t chain);
    void addPoint(Index point, Index last);
    void addTriangle(Index a, Index b, Index c);
    void linkNeighbours();
    void legalise();
    bool flipIfIllegal(Index triangle, int edge);
    void collectHull();
    void setNeighbour(Index triangle, Index from, Index neighbour);
    void removeTriangle(Index triangle);
    [[nodiscard]] std::int64_t orient(Index a, Index b, Index c) const;
    [[nodiscard]] bool inCircle(Index a, Index b, Index c, Index d) const;
    void replaceNeighbour(Index triangle, Index old, Index now);

    std::vector<Site> m_sites;
    std::vector<Index> m_order; ///< sites from left to right, bottom to top
    std::vector<Triangle> m_triangles;
    std::vector<HullEdge> m_hull;
    std::vector<Index> m_next, m_previous; ///< the hull during the sweep
    std::vector<Index> m_outside;          ///< per site: triangle left of its outgoing hull edge
    struct EdgeOfTriangle
    {
        Index triangle;
        int edge;
    };
    std::vector<EdgeOfTriangle> m_stack;
    struct SortedEdge
    {
        Index low, high, triangle;
        int edge;
    };
    std::vector<SortedEdge> m_edges;
};

} // namespace ramure
