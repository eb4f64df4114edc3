/// \file
/// One tube of a branch mesh unrolled: its vertices with their coordinates, its triangles with their seam.
/// Internal to the texture coordinates.
#pragma once

#include "core/surface/texture/texture_relax.h"
#include "core/surface/texture/tube_unroll.h"
#include <cmath>
#include <glm/vec2.hpp>
#include <numbers>
#include <span>

namespace ramure {

/// How many tiles go around branches that begin anew: roots, and limbs beside a stem.
struct TileScale
{
    double tileSize = 1.0; ///< m, on wood of this radius:
    double radius = 1.0;   ///< m

    /// Tiles are as large as the root of the radius says: half as thick, 0.7 times as large. No whole number.
    [[nodiscard]] double around(double radiusThere) const
    {
        return 2.0 * std::numbers::pi * std::sqrt(radiusThere * radius) / tileSize;
    }
};

/// What a tube hands on to those that start from its last cross-section.
struct TubeTextureEnd
{
    glm::dvec3 normal{1.0, 1e-3, 2e-3}; ///< azimuths are counted from it
    glm::dvec3 bend{0.0};               ///< as UnrollAxis has it
    double around = 0.0;                ///< tiles around; 0: the child begins anew
    double radius = 0.0;                ///< m; 0: there is no parent
    double aged = 0.0;                  ///< m, of the wood whose bark its end has
};

/// A vertex of a tube.
struct TubeTextureVertex
{
    Index vertex = noIndex;  ///< of the mesh
    double along = 0.0;      ///< m, from the start of the tube
    double azimuth = 0.0;    ///< rad, from the middle of the tube's front: the seam is at +-pi
    double crowding = 0.0;   ///< rad, to be added to the azimuth where the tube bends
    double u = 0.0, v = 0.0; ///< tiles
    double radius = 0.0;     ///< m, of the wood whose bark it has: at its start a tube has its parent's
    bool onParent = false;   ///< on the parent's last cross-section: u and v are the parent's
    bool onWall = false;     ///< in the valley between siblings
    bool isPole = false;     ///< the middle of a flat end or of a tip
    /// On a trunk's foot: (ring * roots + root) * columns + column, of which a root has one more than points:
    /// the valleys on both sides are its own. Else noIndex.
    Index foot = noIndex;
    bool isSole = false;       ///< on the lowest ring of a foot
    bool isLastValley = false; ///< after the last root, below the highest ring
};

class TubeTexture
{
public:
    explicit TubeTexture(const TileScale& scale)
        : m_scale(scale)
    {
    }
    /// Refills the tube: vertices in the order in which its triangles name them.
    void begin();
    /// \param uv of a vertex on the parent's last cross-section; else of no meaning.
    Index addVertex(Index vertex, const glm::vec3& position, bool onParent, bool onWall, const glm::vec2& uv);
    /// The same on the foot of a trunk, where a vertex in a valley is added once for each of the roots
    /// beside. \param place see TubeTextureVertex::foot
    Index addFootVertex(Index vertex, const glm::vec3& position, Index place, const FootSize& foot);
    /// \param triangles of its vertices
    void unroll(const TubeAxis& axis, const TubeTextureEnd& parent, std::span<const glm::uvec3> triangles);

    [[nodiscard]] std::span<const TubeTextureVertex> vertices() const { return m_vertices; }
    [[nodiscard]] const TubeTextureEnd& end() const { return m_end; }
    /// Tiles around, the same from the front to the end: what u jumps by at the seam.
    [[nodiscard]] double around() const { return m_around; }
    /// Which corners of a triangle stand on the far side of the seam.
    [[nodiscard]] std::array<bool, 3> beyondSeam(const glm::uvec3& triangle) const
    {
        const double a = m_vertices[triangle.x].azimuth, b = m_vertices[triangle.y].azimuth,
                     c = m_vertices[triangle.z].azimuth;
        if (std::abs(a - b) <= pi && std::abs(b - c) <= pi && std::abs(c - a) <= pi)
            return {false, false, false};
        return {a < 0.0, b < 0.0, c < 0.0};
    }
    /// Is it part of a flat end or a tip, which are mapped as discs?
    [[nodiscard]] bool isCap(const glm::uvec3& triangle) const
    {
        const TubeTextureVertex &a = m_vertices[triangle.x], &b = m_vertices[triangle.y],
                                &c = m_vertices[triangle.z];
        return a.isPole || b.isPole || c.isPole || (a.isSole && b.isSole && c.isSole);
    }
    /// Coordinates of a triangle that would lie the wrong way round: its true shape, on a place of its own.
    [[nodiscard]] std::array<glm::dvec2, 3> apart(const glm::uvec3& triangle) const;
    /// Of a vertex of a cap, as part of that disc.
    [[nodiscard]] glm::dvec2 onDisc(const TubeTextureVertex& vertex, const glm::vec3& position) const;

private:
    void place();
    /// Returns the radius of the wood whose bark the end of the tube has.
    double age(double parentRadius);
    void markCut();
    void placeFoot();
    void layFoot();
    void stiffenFoot(std::span<const glm::uvec3> triangles);
    void chooseSeam();
    void chooseTiles(const TubeTextureEnd& parent);
    void measureAlong();
    [[nodiscard]] glm::dvec2 startOf() const;
    void assign();
    void even(std::span<const glm::uvec3> triangles);
    [[nodiscard]] double turnOf(const TubeTextureVertex& vertex) const;
    [[nodiscard]] double radiusBetween(std::size_t node) const;
    [[nodiscard]] double tilesAlong(double along) const;
    [[nodiscard]] double tileAt(double along) const;
    [[nodiscard]] glm::dvec3 position(Index local) const { return glm::dvec3(m_positions[local]); }

    static constexpr double pi = std::numbers::pi, turn = 2.0 * pi;
    static double shortWay(double angleRad) { return angleRad - turn * std::round(angleRad / turn); }

    TileScale m_scale;
    UnrollAxis m_axis;
    TextureRelaxer m_relaxer;
    TubeTextureEnd m_end;
    std::vector<TubeTextureVertex> m_vertices;
    std::vector<glm::vec3> m_positions;
    std::vector<glm::vec2> m_given; ///< per vertex: uv on the parent
    std::vector<double> m_sorted;
    FootSize m_foot;
    double m_seam = pi;              ///< rad, where there is no parent
    std::vector<Index> m_footPlaces; ///< in m_vertices, by TubeTextureVertex::foot
    double m_around = 1.0;
    double m_front = 0.0;      ///< rad: half of what the front shares with the parent
    double m_excess = 0.0;     ///< tiles around that the parent's have more
    double m_flareShare = 1.0; ///< what of a flare counts
    double m_handing = 1.0;    ///< m, within which that is made good
    std::array<double, UnrollAxis::steps + 1> m_tilesAt{};
    double m_chord = 1.0; ///< circumference of the cross-sections, as a share of the circle's
};

} // namespace ramure
