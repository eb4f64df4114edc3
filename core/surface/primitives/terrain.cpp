#include "core/surface/primitives/terrain.h"

#include "core/math/random.h"
#include "core/math/reproducible.h"
#include "core/params/param_def.h"
#include "core/surface/mesh/normals.h"
#include <cmath>
#include <glm/vec2.hpp>

namespace ramure {
namespace {

constexpr int octaves = 8;
constexpr double hillsPerSide = 2.0; ///< of the first octave
constexpr double mostGradient = 1.4; ///< noise of one octave lies within about 0.7

double fade(double t)
{
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

/// One octave of noise: a slope of length 1 for each corner of its lattice, made once.
class Octave
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

} // namespace

Expected<TriangleMesh> buildTerrain(const TerrainParams& params)
{
    RAMURE_TRY(checkPart(&NodeParams::terrain, params));
    TriangleMesh mesh;
    const auto cells = static_cast<Index>(params.divisions);
    std::vector<Octave> all;
    for (int number = 0; number < octaves; ++number)
        all.emplace_back(params, number);
    const auto hills = [&](double x, double z) {
        double sum = 0.0;
        for (const Octave& octave : all)
            sum += octave.at(x, z);
        return sum;
    };
    const double middle = hills(0.0, 0.0);
    mesh.uv.reserve(std::size_t(cells + 1) * (cells + 1));
    mesh.positions.reserve(std::size_t(cells + 1) * (cells + 1));
    for (Index row = 0; row <= cells; ++row)
        for (Index column = 0; column <= cells; ++column) {
            const double u = double(column) / cells, v = double(row) / cells;
            const double x = params.size * (u - 0.5), z = params.size * (v - 0.5);
            mesh.positions.emplace_back(x, hills(x, z) - middle, z);
            mesh.uv.emplace_back(u, v);
        }
    mesh.triangles.reserve(std::size_t(cells) * cells * 2);
    for (Index row = 0; row < cells; ++row)
        for (Index column = 0; column < cells; ++column) {
            const Index a = row * (cells + 1) + column, b = a + 1, c = a + cells + 1, d = c + 1;
            mesh.triangles.emplace_back(a, c, b);
            mesh.triangles.emplace_back(b, c, d);
        }
    computeNormals(mesh);
    return mesh;
}

} // namespace ramure
