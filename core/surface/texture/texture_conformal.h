/// \file
/// Evens out texture coordinates quickly: moves them until angles are kept as well as they can.
/// Internal to the texture coordinates.
#pragma once

#include "core/surface/texture/texture_patch.h"
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace ramure {

/// A patch of triangles in the texture plane as complex numbers z = u + iv. On a triangle the map is
/// a x + b conj(x) of its own plane, its stretch (1 + k) / (1 - k) with k = |b| / |a|. Vertices are moved one
/// after the other, at first to where the weighted sum of |b|² around them is least, a linear matter (Lévy et
/// al., "Least squares conformal maps", 2002). Then as few triangles as possible shall be stretched by more
/// than a bound, however much they are below it: only the excess of k over the bound counts, by Newton's
/// method, and the greater it is the less it pulls (Geman and McClure), so that few triangles are bad rather
/// than many nearly good. Nothing keeps triangles from folding: look at isFolded().
class ConformalRelaxer
{
public:
    static constexpr double goodK = 1.0 / 9.0; ///< of a triangle stretched by 1.25

    void clear();
    void addVertex(const glm::dvec2& uv, bool isFree);
    /// \param place in tiles. \param shift is added to each corner's u: it stands beyond the seam.
    void addTriangle(const std::array<Index, 3>& corner, const std::array<glm::dvec3, 3>& place,
                     const std::array<double, 3>& shift);
    /// All triangles count: what is folded unfolds, as a rule. Vertices at triangles that are hardly
    /// stretched stay.
    /// \param rounds of new weights, with \p sweeps over the vertices in each.
    void relax(int rounds, int sweeps);
    /// After relax(): lets the triangles be where no more than \p enough are bad, or fewest of all that it
    /// came by in \p rounds. What is folded does not count as such.
    void fit(int rounds, Index enough);
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
        double barrier; ///< weight of what it is stretched beyond farK
    };
    /// The energy around a vertex: its slope, and its second derivatives.
    struct Around
    {
        Complex slope;
        double xx = 0.0, xy = 0.0, yy = 0.0;
    };
    static Complex times(const Complex& a, const Complex& b)
    {
        return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
    }
    [[nodiscard]] bool isAwake(const Triangle& t) const
    {
        return (m_awake[t.corner[0]] | m_awake[t.corner[1]] | m_awake[t.corner[2]]) != 0;
    }
    void measure(bool all, double calm);
    inline void measure(Triangle& triangle) const;
    static inline void differentiate(Triangle& triangle);
    void weigh();
    void weighExcess(double scale);
    void sweep();
    void sweepExcess();
    [[nodiscard]] inline Around around(Index vertex) const;
    inline void move(Index vertex, const Complex& step);
    void goOn(double share);

    std::vector<Complex> m_z, m_before, m_best; ///< now, a round ago, where fewest are bad
    std::vector<std::uint8_t> m_free, m_awake, m_moved;
    std::vector<Triangle> m_triangles;
    TrianglesAround m_around;
    bool m_folded = false, m_stretched = false;
    Index m_bad = 0;
};

} // namespace ramure
