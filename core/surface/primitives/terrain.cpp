#include "core/surface/primitives/terrain.h"

#include "core/math/random.h"
#include "core/math/reproducible.h"
#include "core/params/param_def.h"
#include "core/surface/mesh/normals.h"
#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <limits>

namespace ramure {
namespace {

constexpr int octaves = 8;
constexpr double hillsPerSide = 2.0; ///< of the first octave
constexpr double mostGradient = 1.4; ///< noise of one octave lies within about 0.7

double fade(double t)
{
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

constexpr double mostTopsoil = 0.3;   ///< m
constexpr double topsoilShare = 0.35; ///< of the depth, at most
constexpr glm::u8vec3 groundTone(255), topsoilTone(120, 104, 92), subsoilTone(196, 178, 158);

} // namespace

/// One octave of noise: a slope of length 1 for each corner of its lattice, made once.
class TerrainHeights::Octave
{
public:
    Octave(const TerrainParams& params, int number)
        : m_perMetre(std::ldexp(hillsPerSide, number) / params.size)
        , m_height(params.height * mostGradient * maths::pow(params.roughness, number))
        // Shifted, so that the lattices, where noise is zero, do not lie on each other.
        , m_shift(0.37 * number + 0.21)
    {
        const double half = std::ldexp(0.5 * hillsPerSide, number);
        m_first = static_cast<std::int64_t>(std::floor(m_shift - half)) - 1;
        m_side = static_cast<std::int64_t>(std::ceil(m_shift + half)) + 2 - m_first;
        m_slopes.reserve(static_cast<std::size_t>(m_side * m_side));
        Random random(static_cast<std::uint64_t>(params.seed), RandomStream::Terrain,
                      static_cast<std::uint64_t>(number));
        for (std::int64_t i = 0; i < m_side * m_side; ++i) {
            const auto [sine, cosine] = maths::sincos(random.range(-std::numbers::pi, std::numbers::pi));
            m_slopes.emplace_back(cosine, sine);
        }
    }
    /// \pre a place of the terrain
    [[nodiscard]] double at(double x, double z) const
    {
        const double a = x * m_perMetre + m_shift - double(m_first);
        const double b = z * m_perMetre + m_shift - double(m_first);
        const auto column = static_cast<std::int64_t>(a), row = static_cast<std::int64_t>(b);
        const double u = a - double(column), v = b - double(row);
        const auto corner = [&](std::int64_t i, std::int64_t k) {
            const glm::dvec2& slope = m_slopes[static_cast<std::size_t>((row + k) * m_side + column + i)];
            return slope.x * (u - double(i)) + slope.y * (v - double(k));
        };
        const double below = corner(0, 0) + fade(u) * (corner(1, 0) - corner(0, 0));
        const double above = corner(0, 1) + fade(u) * (corner(1, 1) - corner(0, 1));
        return m_height * (below + fade(v) * (above - below));
    }

private:
    double m_perMetre, m_height, m_shift;
    std::int64_t m_first = 0, m_side = 0;
    std::vector<glm::dvec2> m_slopes;
};

TerrainHeights::TerrainHeights(const TerrainParams& params)
    : m_half(0.5 * params.size)
{
    for (int number = 0; number < octaves; ++number)
        m_octaves.emplace_back(params, number);
    m_middle = sum(0.0, 0.0);
}

TerrainHeights::TerrainHeights(TerrainHeights&&) noexcept = default;
TerrainHeights::~TerrainHeights() = default;

Expected<TerrainHeights> TerrainHeights::of(const TerrainParams& params)
{
    RAMURE_TRY(checkPart(&NodeParams::terrain, params));
    return TerrainHeights(params);
}

double TerrainHeights::sum(double x, double z) const
{
    double sum = 0.0;
    for (const Octave& octave : m_octaves)
        sum += octave.at(x, z);
    return sum;
}

double TerrainHeights::at(double x, double z) const
{
    return sum(x, z) - m_middle;
}

bool TerrainHeights::isOn(double x, double z) const
{
    return std::abs(x) <= m_half && std::abs(z) <= m_half;
}

namespace {

Expected<TriangleMesh> terrainSheet(const TerrainParams& params)
{
    const auto heights = TerrainHeights::of(params);
    RAMURE_TRY(heights);
    TriangleMesh mesh;
    const auto cells = static_cast<Index>(params.divisions);
    mesh.uv.reserve(std::size_t(cells + 1) * (cells + 1));
    mesh.positions.reserve(std::size_t(cells + 1) * (cells + 1));
    for (Index row = 0; row <= cells; ++row)
        for (Index column = 0; column <= cells; ++column) {
            const double u = double(column) / cells, v = double(row) / cells;
            const double x = params.size * (u - 0.5), z = params.size * (v - 0.5);
            mesh.positions.emplace_back(x, heights->at(x, z), z);
            mesh.uv.emplace_back(u, v);
        }
    mesh.triangles.reserve(std::size_t(cells) * cells * 2);
    for (Index row = 0; row < cells; ++row)
        for (Index column = 0; column < cells; ++column) {
            const Index a = row * (cells + 1) + column, b = a + 1, c = a + cells + 1, d = c + 1;
            mesh.triangles.emplace_back(a, c, b);
            mesh.triangles.emplace_back(b, c, d);
        }
    return mesh;
}

/// The four sides and the bottom of a block.
class TerrainEarth
{
public:
    /// \param sharp vertices of edges once per face
    TerrainEarth(TriangleMesh& mesh, const TerrainParams& params, bool sharp)
        : m_mesh(mesh)
        , m_cells(static_cast<Index>(params.divisions))
        , m_sharp(sharp)
        , m_topsoil(std::min(mostTopsoil, topsoilShare * params.depth))
    {
        float lowest = std::numeric_limits<float>::max();
        for (const glm::vec3& p : mesh.positions)
            lowest = std::min(lowest, p.y);
        m_bottom = double(lowest) - params.depth;
        m_mesh.colours.assign(m_mesh.triangles.size(), groundTone);
    }
    void add()
    {
        std::vector<Index> ground = border();
        std::vector<Index> bottom;
        for (std::size_t side = 0; side < 4; ++side) {
            // Where edges are sharp each side has corners of its own.
            std::vector<Index> top(ground.begin() + std::ptrdiff_t(side) * m_cells,
                                   ground.begin() + std::ptrdiff_t(side + 1) * m_cells);
            top.push_back(ground[(side + 1) * m_cells % ground.size()]);
            if (m_sharp)
                top = lowered(top, [](double height) { return height; });
            addSide(top, side, bottom);
        }
        addBottom(bottom);
    }

private:
    /// The places around the grid, side by side, each beginning at a corner.
    [[nodiscard]] std::vector<Index> border() const
    {
        const auto at = [this](Index row, Index column) { return row * (m_cells + 1) + column; };
        std::vector<Index> out;
        for (Index i = 0; i < m_cells; ++i)
            out.push_back(at(0, i));
        for (Index i = 0; i < m_cells; ++i)
            out.push_back(at(i, m_cells));
        for (Index i = m_cells; i > 0; --i)
            out.push_back(at(m_cells, i));
        for (Index i = m_cells; i > 0; --i)
            out.push_back(at(i, 0));
        return out;
    }
    std::vector<Index> lowered(const std::vector<Index>& from, auto&& height)
    {
        std::vector<Index> out;
        for (const Index i : from) {
            const glm::vec3 p = m_mesh.positions[i];
            out.push_back(m_mesh.vertexCount());
            m_mesh.positions.emplace_back(p.x, float(height(double(p.y))), p.z);
            m_mesh.uv.push_back(glm::vec2(m_mesh.uv[i]));
        }
        return out;
    }
    /// Topsoil under the ground, and what lies below. \param bottom the border of the bottom so far
    void addSide(const std::vector<Index>& top, std::size_t side, std::vector<Index>& bottom)
    {
        std::vector<Index> wanted = top;
        if (!m_sharp) { // corners are shared with the sides before and after
            wanted.erase(wanted.begin(), wanted.begin() + (side > 0 ? 1 : 0));
            if (side == 3)
                wanted.pop_back();
        }
        std::vector<Index> soil = lowered(wanted, [this](double height) { return height - m_topsoil; });
        std::vector<Index> low = lowered(wanted, [this](double) { return m_bottom; });
        if (!m_sharp) {
            if (side > 0) {
                soil.insert(soil.begin(), m_lastSoil);
                low.insert(low.begin(), bottom.back());
            } else {
                m_firstSoil = soil.front();
            }
            if (side == 3) {
                soil.push_back(m_firstSoil);
                low.push_back(bottom.front());
            }
            m_lastSoil = soil.back();
        }
        addStrip(top, soil, topsoilTone);
        addStrip(soil, low, subsoilTone);
        bottom.insert(bottom.end(), low.begin() + (side > 0 ? 1 : 0), low.end());
    }
    void addStrip(const std::vector<Index>& upper, const std::vector<Index>& lower, const glm::u8vec3& colour)
    {
        for (std::size_t i = 0; i + 1 < upper.size(); ++i) {
            m_mesh.triangles.emplace_back(upper[i], upper[i + 1], lower[i + 1]);
            m_mesh.triangles.emplace_back(upper[i], lower[i + 1], lower[i]);
        }
        m_mesh.colours.resize(m_mesh.triangles.size(), colour);
    }
    /// \param border closed: its last place is its first
    void addBottom(std::vector<Index> border)
    {
        if (m_sharp)
            border = lowered(border, [this](double) { return m_bottom; });
        const Index middle = m_mesh.vertexCount();
        m_mesh.positions.emplace_back(0.0F, float(m_bottom), 0.0F);
        m_mesh.uv.emplace_back(0.5F, 0.5F);
        for (std::size_t i = 0; i + 1 < border.size(); ++i)
            m_mesh.triangles.emplace_back(border[i], border[i + 1], middle);
        m_mesh.colours.resize(m_mesh.triangles.size(), subsoilTone);
    }

    TriangleMesh& m_mesh;
    const Index m_cells;
    const bool m_sharp;
    const double m_topsoil;
    double m_bottom = 0.0;
    Index m_firstSoil = 0, m_lastSoil = 0;
};

Expected<TriangleMesh> terrainMesh(const TerrainParams& params, bool sharp)
{
    auto mesh = terrainSheet(params);
    RAMURE_TRY(mesh);
    if (params.depth > 0.0)
        TerrainEarth(*mesh, params, sharp).add();
    computeNormals(*mesh);
    return mesh;
}

} // namespace

Expected<TriangleMesh> buildTerrain(const TerrainParams& params)
{
    return terrainMesh(params, true);
}

Expected<TriangleMesh> terrainSolid(const TerrainParams& params)
{
    return terrainMesh(params, false);
}

} // namespace ramure
