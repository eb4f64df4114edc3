/// \file
/// The walls of a fork: the vertices in the valleys between its tubes, and the closed boundary of each
/// child's cell.
#pragma once

#include "core/surface/mesher/fork_layout.h"
#include "core/surface/mesher/fork_softening.h"
#include "core/surface/mesher/mesh_sink.h"

namespace ramure {

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
    Index vertex = noIndex; ///< of the mesh
    glm::dvec3 position{0.0};
    double lifted = 0.0;  ///< arc length at which the tubes separate there
    double azimuth = 0.0; ///< on the ring, in the parent's end frame; of no meaning elsewhere
    bool onRing = false;
    std::array<Index, 3> cells{noIndex, noIndex, noIndex}; ///< the children whose boundaries it is on
};

/// Lifts corners and walls to the height where the tubes come apart, and strings the cells' boundaries
/// together.
class ForkWalls
{
public:
    /// Adds all wall vertices to \p sink. \param radialDivisions of the tubes, or fewer for coarser walls.
    void build(const ForkLayout& layout, const ForkRing& ring, std::span<const ForkChild> children,
               ForkSoftener& softener, int radialDivisions, MeshSink& sink);
    /// Do tubes stay in one until far up the shortest of them? There many walls stand close together.
    [[nodiscard]] bool isLate() const { return m_isLate; }
    /// The boundary of a child's cell, counter-clockwise seen from the child's tip; at least three vertices.
    /// A run on the ring, if there is one, comes first.
    void cell(Index child, std::vector<CellVertex>& boundary) const;

private:
    /// Vertices of m_vertices on a wall, from its first end to its second.
    struct Wall
    {
        Index first = 0, count = 0;
    };
    struct WallSample
    {
        double angle; ///< rad, see cornerOf
        ForkLift::Lifted at;
    };
    struct WallPlan
    {
        WallPath path;          ///< between the two children
        double reach = 0.0;     ///< m, how far aside the wall is at angle 0
        double step = 0.0;      ///< m, in height between neighbours
        double leansUpTo = 0.0; ///< m
        double from = 0.0;      ///< m, along a limb: where its last line left the stem
        bool beginsOnRing = false, endsOnRing = false;
        glm::dvec3 nearRing{0.0}, farRing{0.0}; ///< unit, from the centre to the points of the ring
    };
    struct Corner
    {
        WallPath path;
        ForkLift::Lifted at;
    };
    void makeCorners();
    [[nodiscard]] bool standsLate() const;
    bool partCorners();
    void makeHullWalls();
    [[nodiscard]] WallPlan planArch(std::size_t edge) const;
    void makeInnerWalls();
    void soften(ForkSoftener& softener);
    [[nodiscard]] WallPlan planWall(Index from, Index to) const;
    void leanToRing(WallPlan& plan, std::size_t edge, bool far) const;
    [[nodiscard]] WallSample cornerOf(const WallPlan& plan, Index corner) const;
    [[nodiscard]] static WallPath pathAt(const WallPlan& plan, double angle);
    [[nodiscard]] ForkLift::Lifted liftAt(const WallPlan& plan, double angle, double most) const;
    [[nodiscard]] std::optional<WallSample> sampleBetween(const WallPlan& plan, const WallSample& from,
                                                          const WallSample& to) const;
    Wall makeWall(WallPlan plan, const WallSample& from, const WallSample& to);
    Index add(const ForkLift::Lifted& lifted, const WallPath& path);
    [[nodiscard]] glm::dvec3 outward(Index from, Index to) const;
    void appendArc(std::size_t edge, std::vector<CellVertex>& boundary) const;
    void appendWall(std::size_t edge, bool inwards, std::vector<CellVertex>& boundary) const;
    void appendRing(Index point, std::vector<CellVertex>& boundary) const;
    void appendInner(Index triangle, std::size_t edge, std::vector<CellVertex>& boundary) const;
    static void leaveRing(std::vector<CellVertex>& boundary);
    std::size_t appendAround(Index child, std::size_t edge, std::vector<CellVertex>& boundary) const;

    const ForkLayout* m_layout = nullptr;
    const ForkRing* m_ring = nullptr;
    std::span<const ForkChild> m_children;
    MeshSink* m_sink = nullptr;
    int m_radialDivisions = 8;
    int m_midsPerQuarter = 2; ///< vertices of a wall over a quarter of a turn
    bool m_isLate = false;
    ForkLift m_lift;
    ValleyGuess m_guess;
    std::vector<WallSample> m_samples;
    std::vector<Corner> m_corners;      ///< one per triangle
    std::vector<CellVertex> m_vertices; ///< corners first, then the walls
    std::vector<Wall> m_hullWall;
    /// Per triangle and edge; from the corner of the triangle with the higher number.
    std::vector<std::array<Wall, 3>> m_innerWall;
    std::vector<std::array<Index, 3>> m_ringCells; ///< per point of the ring; noIndex thrice within a cell
    std::vector<Index> m_hullFrom, m_hullTo; ///< per child: a hull edge that leaves it, one that reaches it
    std::vector<Index> m_triangleOf;         ///< per child: a triangle at it
};

} // namespace ramure
