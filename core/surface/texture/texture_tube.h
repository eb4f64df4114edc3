/// \file
/// One tube of a branch mesh unrolled: its vertices with their coordinates, its triangles with their seam.
/// Internal to the texture coordinates.
#pragma once

#include "core/surface/texture/texture_conformal.h"
#include "core/surface/texture/texture_relax.h"
#include "core/surface/texture/tube_unroll.h"
#include <cmath>
#include <glm/vec2.hpp>
#include <numbers>
#include <span>

namespace ramure {

/// What a tube hands on to those that start from its last cross-section.
struct TubeTextureEnd
{
    glm::dvec3 normal{1.0, 1e-3, 2e-3}; ///< azimuths are counted from it
    double around = 0.0;                ///< tiles around; 0 = there is no parent
};

/// A vertex of a tube.
struct TubeTextureVertex
{
    Index vertex = noIndex;  ///< of the mesh
    double along = 0.0;      ///< m, from the start of the tube
    double azimuth = 0.0;    ///< rad, from the middle of the tube's front: the seam is at +-pi
    double u = 0.0, v = 0.0; ///< tiles
    double around = 1.0;     ///< tiles around at its height: what u jumps by at the seam
    bool onParent = false;   ///< on the parent's last cross-section: u and v are the parent's
    bool onWall = false;     ///< in the valley between siblings
    bool isPole = false;     ///< the middle of a flat end or of a tip
};

class TubeTexture
{
public:
    struct Options
    {
        double tileSize = 1.0;   ///< m
        bool seamsAround = true; ///< seams may open around bends
    };
    /// What is spent on tubes that are stretched.
    struct Care
    {
        int rounds = 15; ///< of moves
        int ways = 0;    ///< of opening the seam that get them, after a trial of all; 0: one after the other
    };
    explicit TubeTexture(const Options& options)
        : m_options(options)
        , m_tile(options.tileSize)
    {
    }
    /// Refills the tube: vertices in the order in which its triangles name them.
    void begin();
    /// \param uv of a vertex on the parent's last cross-section; else of no meaning.
    Index addVertex(Index vertex, const glm::vec3& position, bool onParent, bool onWall, const glm::vec2& uv);
    void setCare(const Care& care) { m_care = care; }
    void addTriangle(const glm::uvec3& corners) { m_triangles.push_back(corners); }
    void unroll(const TubeAxis& axis, const TubeTextureEnd& parent);

    /// More than were added where the seam is open: copies follow at the end.
    [[nodiscard]] std::span<const TubeTextureVertex> vertices() const { return m_vertices; }
    /// In the order in which they were added; their corners are those of vertices().
    [[nodiscard]] std::span<const glm::uvec3> triangles() const { return m_triangles; }
    [[nodiscard]] const TubeTextureEnd& end() const { return m_end; }
    /// Are the two sides of the seam apart at the tube's bend?
    [[nodiscard]] bool isOpen() const { return m_isOpen; }
    [[nodiscard]] Index stretchedTriangles() const { return m_stretched; }
    /// Which corners of a triangle stand on the far side of the seam: their u is larger by their around.
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
        return m_vertices[triangle.x].isPole || m_vertices[triangle.y].isPole ||
               m_vertices[triangle.z].isPole;
    }
    /// Coordinates of a triangle that lies the wrong way round whatever was tried: its true shape, on a place
    /// of its own.
    [[nodiscard]] std::array<glm::dvec2, 3> apart(const glm::uvec3& triangle) const;
    /// Of a vertex of a cap, as part of that disc.
    [[nodiscard]] glm::dvec2 onDisc(const TubeTextureVertex& vertex, const glm::vec3& position) const;

private:
    /// A tube laid out, to come back to.
    struct Layout
    {
        std::vector<TubeTextureVertex> vertices;
        std::vector<glm::vec3> positions;
        std::vector<glm::uvec3> triangles;
        bool isOpen = false;
    };
    struct Effort
    {
        int relaxRounds, sweeps; ///< at first, with so many sweeps each
        int rounds;              ///< then
        double hopeless;         ///< unless a greater share of the triangles is stretched
    };
    static const Effort firstEffort, trialEffort; ///< before the seam is opened; to see which way is best
    struct Knot
    {
        double along, around;
    };
    void place();
    void markCut();
    void smoothFront();
    void chooseSeam();
    void findSections();
    void chooseTiles(double before);
    void measureAlong();
    [[nodiscard]] glm::dvec2 startOf(const TubeTextureEnd& parent) const;
    void assign(const TubeTextureEnd& parent);
    bool even(const TubeTextureEnd& parent);
    bool layOut(std::size_t sections, const TubeTextureEnd& parent);
    bool isBetter();
    void keep(Layout& layout) const;
    void take(const Layout& layout);
    bool settle(const Effort& effort);
    void unfold(const TubeTextureEnd& parent);
    void keepEnd(const TubeTextureEnd& parent);
    [[nodiscard]] Index shareOf(double share) const;
    [[nodiscard]] double openHeight(std::size_t sections) const;
    bool openSeam(std::size_t sections);
    void copyCorner(Index& corner, std::vector<Index>& copies);
    template <class Relaxer> void fill(Relaxer& relaxer) const;
    template <class Relaxer> void read(const Relaxer& relaxer);
    [[nodiscard]] double fitting(double radius) const;
    [[nodiscard]] double aroundAt(double along) const;
    [[nodiscard]] double tilesAlong(double along) const;
    [[nodiscard]] double radiusAt(double along) const;
    [[nodiscard]] glm::dvec3 position(Index local) const { return glm::dvec3(m_positions[local]); }

    static constexpr double pi = std::numbers::pi, turn = 2.0 * pi;
    static constexpr double sameSection = 1e-3; ///< of the tube: cross-sections closer than that are one
    static double shortWay(double angleRad) { return angleRad - turn * std::round(angleRad / turn); }

    Options m_options;
    Care m_care;
    double m_tile;
    UnrollAxis m_axis;
    ConformalRelaxer m_conformal;
    TextureRelaxer m_relaxer;
    TubeTextureEnd m_end;
    std::vector<TubeTextureVertex> m_vertices;
    std::vector<glm::vec3> m_positions;
    std::vector<glm::vec2> m_given; ///< per vertex: uv on the parent
    std::vector<glm::uvec3> m_triangles;
    Layout m_whole, m_best;    ///< before the seam is opened, and as well as it was tried
    std::vector<Knot> m_knots; ///< tiles around by height
    std::vector<double> m_sorted, m_sections;
    std::vector<Index> m_next, m_front;
    bool m_goesOn = false; ///< the front is the parent's whole last cross-section, or nearly
    bool m_isOpen = false, m_endStays = false;
    bool m_folds = false; ///< the best so far
    Index m_stretched = 0;
    std::array<double, UnrollAxis::steps + 1> m_tilesAt{};
    double m_chord = 1.0;       ///< circumference of the cross-sections, as a share of the circle's
    double m_highestWall = 0.0; ///< m
};

} // namespace ramure
