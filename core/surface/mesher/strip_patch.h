/// \file
/// The strip between two closed rows of vertices around a tube, triangulated in the tube's unrolled plane
/// (x: azimuth, y: distance along the axis), with more vertices inserted between the rows.
#pragma once

#include "core/surface/mesher/mesh_sink.h"
#include <array>
#include <vector>

namespace ramure {

/// A vertex in the unrolled plane.
struct UnrolledVertex
{
    double azimuth; ///< rad
    double along;   ///< m
    Index vertex;   ///< of the mesh
    /// Whose strips share it too: an edge between two vertices that both belong to another strip could be in
    /// both strips.
    std::array<Index, 2> shared{noIndex, noIndex};
};

/// What a strip's plane is measured by.
struct TubeScale
{
    double radius; ///< m, of the tube: the scale of the azimuth
    /// Distances along the tube count so much of those around it: tubes bend around, not along, and their
    /// triangles may be long.
    double stretch = 1.0;
};

/// Whatever the coordinates: the strip is an annulus, each of its edges exists once, and no edge joins two
/// vertices of one row apart from the rows' own edges; so strips that share a row never share another edge.
class StripPatch
{
public:
    /// Of the angle between neighbours, one of which lies back on the other.
    static constexpr float foldedCosine = -0.3F;

    /// Starts a strip. Rows are closed, at least three vertices each, azimuths increasing over one turn in
    /// all.
    void zip(const std::vector<UnrolledVertex>& lower, const std::vector<UnrolledVertex>& upper,
             const TubeScale& tube);
    /// Inserts a vertex between the rows and makes the edges around it Delaunay. False where no triangle of
    /// the strip holds the place well inside: then nothing happened.
    bool insert(const UnrolledVertex& vertex);
    /// Makes all edges Delaunay that may be exchanged; now two vertices of the lower row may be joined where
    /// no other strip could join them.
    void relax();
    /// Was the strip hard to zip? Then it should be relaxed before vertices are inserted.
    [[nodiscard]] bool isCrooked() const { return m_crooked; }
    void write(MeshSink& sink) const;
    /// Appends the triangles' unit normals, once all vertices are in the sink. Returns whether two neighbours
    /// lie back on each other.
    bool measureNormals(const MeshSink& sink, std::vector<glm::vec3>& normals) const;

private:
    struct Triangle
    {
        std::array<Index, 3> corner;    ///< local
        std::array<Index, 3> neighbour; ///< across corner[i] -> corner[i + 1]
    };
    struct Local
    {
        double x, y; ///< m, x = azimuth times radius
        Index vertex;
        std::array<Index, 2> shared{noIndex, noIndex};
    };
    void arrange(const std::vector<UnrolledVertex>& lower, const std::vector<UnrolledVertex>& upper,
                 const TubeScale& tube);
    double chooseStepsQuickly();
    void chooseStepsByCost(double most);
    [[nodiscard]] double stepCost(std::size_t i, std::size_t j, bool lower) const;
    void breakSingleRun();
    void fillPits();
    void buildTriangles();
    [[nodiscard]] std::size_t lowerLeft() const { return m_lowerRow.size() - 1; }
    [[nodiscard]] bool preferLower(std::size_t i, std::size_t j) const;
    [[nodiscard]] const Local& lowerAt(std::size_t i) const { return m_lowerRow[i]; }
    [[nodiscard]] const Local& upperAt(std::size_t j) const { return m_upperRow[j]; }
    [[nodiscard]] double deltaX(Index from, Index to) const
    {
        const double d = m_vertices[to].x - m_vertices[from].x, half = 0.5 * m_circumference;
        return d > half ? d - m_circumference : (d < -half ? d + m_circumference : d);
    }
    [[nodiscard]] int holds(const Triangle& triangle, Index vertex) const;
    [[nodiscard]] bool seesBeyond(const Triangle& triangle, std::size_t edge, Index vertex) const;
    void split(Index triangle, Index vertex);
    [[nodiscard]] Index walkTo(Index vertex) const;
    Index candidate(Index number, Index vertex);
    void legalise(Index vertex);
    void exchange(Index triangle, Index vertex);
    [[nodiscard]] bool isIllegal(Index triangle, Index vertex) const;
    [[nodiscard]] bool joined(Index vertex, Index other, Index triangle) const;
    void relink(Index triangle, Index old, Index now);
    [[nodiscard]] bool mayJoin(Index a, Index b) const;
    [[nodiscard]] bool isEdge(Index a, Index b, Index triangle) const;
    bool relaxEdge(Index triangle, std::size_t edge);
    void unsettle(Index triangle)
    {
        if (triangle < m_settled.size())
            m_settled[triangle] = 0;
    }

    double m_zero = 0.0; ///< azimuth at x = 0
    double m_circumference = 1.0, m_radius = 1.0, m_least = 0.0, m_stretch = 1.0;
    std::size_t m_lowerCount = 0, m_upperCount = 0;
    std::vector<Local> m_lowerRow,
        m_upperRow; ///< rotated to begin at the highest lower vertex, the first again at the end
    struct Active
    {
        Index corner; ///< of the lower row
        Index below;  ///< the triangle below the edge to the next one
    };
    std::vector<Active> m_active;      ///< what is left of the lower row, the first again at the end
    std::vector<std::uint8_t> m_steps; ///< 1: the lower row advances
    std::vector<double> m_costs;       ///< per number of steps taken in the lower and in the upper row
    std::vector<std::uint8_t> m_cameByLower;
    std::vector<Local> m_vertices;
    Index m_last = 0, m_first = 0; ///< triangles: where a vertex was inserted last, where to look first
    std::vector<Triangle> m_triangles;
    static constexpr Index noEdge = 3;
    struct Suspect
    {
        Index triangle;
        Index newEdge; ///< that an exchange made, or noEdge
    };
    std::vector<Suspect> m_suspects;
    std::vector<std::uint8_t> m_settled; ///< per triangle: has not changed since its edges were relaxed
    bool m_refinable = false, m_crooked = false;
};

} // namespace ramure
