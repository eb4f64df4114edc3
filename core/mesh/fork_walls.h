/// \file
/// The walls of a fork: the vertices in the valleys between its tubes, and the closed boundary of each
/// child's cell.
#pragma once

#include "core/mesh/branch_axis.h"
#include "core/mesh/fork_layout.h"
#include "core/mesh/mesh_sink.h"
#include <optional>

namespace ramure {

/// A child at a fork.
struct ForkChild
{
    Index branch = noIndex; ///< of the NormalSkeleton
    Index source = noIndex; ///< of the input
    std::vector<AxisSection> sections;
    AxisTable table;
};

/// The end ring all children start from.
struct ForkRing
{
    glm::dvec3 centre{0.0};
    Frame frame;
    double radius = 0.0;
    Index firstVertex = 0;
    Index source = noIndex;         ///< the parent, of the input
    std::vector<glm::dvec3> points; ///< one per azimuth of the layout
};

/// A vertex on a cell's boundary.
struct CellVertex
{
    Index vertex; ///< of the mesh
    glm::dvec3 position;
    double lifted = 0.0;  ///< arc length at which the tubes separate there
    double azimuth = 0.0; ///< on the ring, in the parent's end frame; of no meaning elsewhere
    bool onRing = false;
};

/// Lifts corners and walls to the height where the tubes come apart, and strings the cells' boundaries
/// together.
class ForkWalls
{
public:
    /// Adds all wall vertices to \p sink.
    void build(const ForkLayout& layout, const ForkRing& ring, std::span<const ForkChild> children,
               int radialDivisions, MeshSink& sink);
    /// The boundary of a child's cell, counter-clockwise seen from the child's tip; at least three vertices.
    /// A run on the ring, if there is one, comes first.
    void cell(Index child, std::vector<CellVertex>& boundary) const;
    /// Wall vertices that found no place outside all tubes.
    [[nodiscard]] Index withoutExit() const { return m_withoutExit; }

private:
    /// What a wall vertex lies between: two or three children with weights.
    struct Between
    {
        std::array<Index, 3> child;
        std::array<double, 3> weight;
        std::size_t count;
    };
    /// Vertices of m_vertices on a wall, from its hull edge's ring point on.
    struct Wall
    {
        Index first = 0, count = 0;
    };
    void makeCorners();
    void makeHullWalls();
    void makeInnerWalls();
    CellVertex lift(const Between& between, const glm::dvec3& offset, double& guess);
    Index add(CellVertex vertex, const Between& between);
    [[nodiscard]] glm::dvec3 onPath(const Between& between, const glm::dvec3& offset, double along) const;
    enum class Tubes { Between, All };
    [[nodiscard]] double room(const Between& between, const glm::dvec3& offset, double along,
                              Tubes tubes) const;
    std::optional<double> exitHeight(const Between& between, const glm::dvec3& offset, double reach,
                                     double guess, Tubes tubes) const;
    [[nodiscard]] Between pair(Index u, Index v) const { return {{u, v, noIndex}, {0.5, 0.5, 0.0}, 2}; }
    [[nodiscard]] glm::dvec3 outward(Index from, Index to) const;
    [[nodiscard]] double pairRadius(Index u, Index v) const;
    void appendArc(std::size_t edge, std::vector<CellVertex>& boundary) const;
    void appendWall(std::size_t edge, bool inwards, std::vector<CellVertex>& boundary) const;
    void appendRing(Index point, std::vector<CellVertex>& boundary) const;
    std::size_t appendAround(Index child, std::size_t edge, std::vector<CellVertex>& boundary) const;

    const ForkLayout* m_layout = nullptr;
    const ForkRing* m_ring = nullptr;
    std::span<const ForkChild> m_children;
    MeshSink* m_sink = nullptr;
    std::size_t m_midsPerWall = 2;
    Index m_withoutExit = 0;
    std::vector<CellVertex> m_vertices; ///< corners first, then the walls
    std::vector<double> m_guesses;      ///< per mid of a hull wall: the height found last
    std::vector<Wall> m_hullWall;
    std::vector<std::array<Index, 3>> m_innerWall; ///< per triangle and edge: its mid
    std::vector<Index> m_hullFrom, m_hullTo; ///< per child: a hull edge that leaves it, one that reaches it
    std::vector<Index> m_triangleOf;         ///< per child: a triangle at it
};

} // namespace ramure
