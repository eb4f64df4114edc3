/// \file
/// Evens out texture coordinates where too many triangles are stretched. Internal to the texture coordinates.
#pragma once

#include "core/base/index.h"
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace ramure {

/// A patch of triangles in the texture plane as complex numbers z = u + iv. On a triangle the map is
/// a x + b conj(x) of its own plane, its stretch (1 + k) / (1 - k) with k = |b| / |a| (Lévy et al., "Least
/// squares conformal maps", 2002). Vertices are moved so that few triangles are stretched by more than a
/// bound, however much the rest is: only the excess of k over the bound counts, by Newton's method one vertex
/// after the other, and the greater it is the less it pulls (Geman and McClure), so that few triangles are
/// bad rather than many nearly good. Triangles that are folded to begin with do not count; no other gets
/// folded.
class TextureRelaxer
{
public:
    void clear();
    void addVertex(const glm::dvec2& uv, bool isFree);
    /// \param place in any unit. \param shift is added to each corner's u: it stands beyond the seam.
    void addTriangle(const std::array<Index, 3>& corner, const std::array<glm::dvec3, 3>& place,
                     const std::array<double, 3>& shift);
    /// Lets the triangles be where no more than a share \p enough of them is stretched by 1.25, or fewest of
    /// all that it came by in \p rounds. \returns whether anything has moved.
    bool run(int rounds, double enough);
    [[nodiscard]] glm::dvec2 uv(Index vertex) const { return {m_z[vertex].re, m_z[vertex].im}; }

private:
    struct Complex
    {
        double re = 0.0, im = 0.0;
    };
    struct Triangle
    {
        std::array<Index, 3> corner;
        double x1, x2, y2;     ///< in its own plane its corners are (0, 0), (x1, 0) and (x2, y2)
        double shift1, shift2; ///< of the second and third corner's u, against the first's
        double stretch;        ///< k²
        Complex inverse;       ///< of a, with the factor of the sums over edges
        // To first order since the last weighing:
        Complex value;                ///< b / a
        std::array<Complex, 3> slope; ///< of it by the corners' places
        double weight;
        double barrier; ///< weight of what it is stretched beyond farK
    };
    struct Use
    {
        Index triangle;
        Index place; ///< which of its corners
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
    [[nodiscard]] std::span<const Use> usesOf(Index vertex) const
    {
        return {m_uses.data() + m_first[vertex], m_first[vertex + 1] - m_first[vertex]};
    }
    [[nodiscard]] bool isAwake(const Triangle& t) const
    {
        return (m_awake[t.corner[0]] | m_awake[t.corner[1]] | m_awake[t.corner[2]]) != 0;
    }
    void link();
    void measure();
    inline void measure(Triangle& triangle) const;
    static inline void differentiate(Triangle& triangle);
    void weigh(double scale);
    void sweep();
    [[nodiscard]] inline Around around(Index vertex) const;
    inline void move(Index vertex, const Complex& step);
    void goOn(double share);

    std::vector<Complex> m_z, m_before, m_best; ///< now, a round ago, where fewest are bad
    std::vector<std::uint8_t> m_free, m_awake;
    std::vector<Triangle> m_triangles;
    std::vector<Index> m_first; ///< per vertex: where its uses begin
    std::vector<Use> m_uses;
    bool m_folded = false;
    Index m_bad = 0;
};

} // namespace ramure
