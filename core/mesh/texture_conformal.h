/// \file
/// Evens out texture coordinates quickly: moves them until angles are kept as well as they can.
/// Internal to the texture coordinates.
#pragma once

#include "core/mesh/texture_patch.h"
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace ramure {

/// A patch of triangles in the texture plane as complex numbers z = u + iv. On a triangle the map is
/// a x + b conj(x) of its own plane, its stretch (1 + k) / (1 - k) with k = |b| / |a|. Vertices are moved one
/// after the other to where the weighted sum of |b|² around them is least, a linear matter (Lévy et al.,
/// "Least squares conformal maps", 2002); the weights follow |a| and, so that few triangles are bad rather
/// than many nearly good, k. Nothing keeps triangles from folding: look at isFolded().
class ConformalRelaxer
{
public:
    /// Rounds of new weights, and sweeps over the vertices in each.
    struct Effort
    {
        int evenRounds, evenSweeps;     ///< all triangles count: what is folded unfolds, as a rule
        int choosyRounds, choosySweeps; ///< then the worse a triangle is the less it counts
    };
    static constexpr double goodK = 1.0 / 9.0; ///< of a triangle stretched by 1.25

    void clear();
    void addVertex(const glm::dvec2& uv, bool isFree);
    /// \param place in tiles. \param shift is added to each corner's u: it stands beyond the seam.
    void addTriangle(const std::array<Index, 3>& corner, const std::array<glm::dvec3, 3>& place,
                     const std::array<double, 3>& shift);
    /// Vertices at triangles that are hardly stretched stay.
    void run(const Effort& effort);
    /// Is a triangle turned over, or next to it?
    [[nodiscard]] bool isFolded() const { return m_folded; }
    [[nodiscard]] Index badTriangles() const { return m_bad; }
    [[nodiscard]] glm::dvec2 uv(Index vertex) const { return {m_z[vertex].re, m_z[vertex].im}; }

private:
    struct Complex
    {
        double re = 0.0, im = 0.0;
    };
    struct Triangle
    {
        std::array<Index, 3> corner;
        FlatCorners flat;
        double shift1, shift2; ///< of the second and third corner's u, against the first's
        double stretch;        ///< k²
        Complex inverse;       ///< of a, with the factor of the sums over edges
        // To first order since the last weighing:
        Complex value;                ///< b / a
        std::array<Complex, 3> slope; ///< of it by the corners' places
        double weight;
    };
    static Complex times(const Complex& a, const Complex& b)
    {
        return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
    }
    void measure(bool all);
    inline void measure(Triangle& triangle) const;
    void weigh(bool choosy);
    void sweep();

    std::vector<Complex> m_z;
    std::vector<std::uint8_t> m_free, m_awake, m_moved;
    std::vector<Triangle> m_triangles;
    TrianglesAround m_around;
    bool m_folded = false, m_stretched = false;
    Index m_bad = 0;
};

} // namespace ramure
