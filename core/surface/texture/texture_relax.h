/// \file
/// Evens out texture coordinates: moves them until triangles keep their shape as well as they can.
/// Internal to the texture coordinates.
#pragma once

#include "core/surface/texture/texture_patch.h"
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace ramure {

/// A patch of triangles in the texture plane. The energy of a triangle whose map has the singular values s, t
/// is ((s/t + t/s) / 2)² plus a little for its density, s t + 1 / (s t): convex in each vertex, infinite
/// where it would fold. Vertices are moved one after the other to where it is least (Newton's method). A
/// patch where some triangles cannot keep their shape (long ones at a bend whose cross-sections are far
/// apart) is better off with few bad ones than with many that are nearly good: in the last rounds the worse a
/// triangle is the less it counts. One that is folded to begin with is unfolded by a softened energy
/// (Garanzha et al., "Foldover-free maps in 50 lines of code", 2021).
class TextureRelaxer
{
public:
    void clear();
    void addVertex(const glm::dvec2& uv, bool isFree);
    /// \param place in tiles. \param shift is added to each corner's u: it stands beyond the seam.
    void addTriangle(const std::array<Index, 3>& corner, const std::array<glm::dvec3, 3>& place,
                     const std::array<double, 3>& shift);
    [[nodiscard]] bool isFolded() const { return m_least <= 0.0; }
    /// Only vertices at triangles that are stretched are moved. \returns whether the patch is not folded now.
    bool run(int evenSweeps, int choosySweeps);
    [[nodiscard]] const glm::dvec2& uv(Index vertex) const { return m_uv[vertex]; }

private:
    struct Triangle
    {
        std::array<Index, 3> corner;
        std::array<double, 3> shift;
        std::array<glm::dvec2, 3> gradient; ///< of the corners' hat functions, in the triangle's plane
        double weight = 1.0;                ///< of its shape in the energy
    };
    /// Energy around a vertex with its first and second derivatives.
    struct Around
    {
        double energy = 0.0;
        glm::dvec2 slope{0.0};
        double xx = 0.0, xy = 0.0, yy = 0.0;
    };
    struct Jacobian
    {
        glm::dvec2 u{0.0}, v{0.0}; ///< gradients in the triangle's plane
    };
    [[nodiscard]] Jacobian jacobian(const Triangle& triangle) const;
    [[nodiscard]] double leastArea() const;
    [[nodiscard]] static double shapeOf(const Jacobian& map);
    void wake(const Triangle& triangle);
    void weigh();
    bool sweep();
    template <bool derivatives>
    void add(const TrianglesAround::Use& use, const glm::dvec2& moved, Around& sum) const;
    bool move(Index vertex);

    std::vector<glm::dvec2> m_uv;
    std::vector<std::uint8_t> m_free, m_awake;
    std::vector<Triangle> m_triangles;
    TrianglesAround m_around;
    double m_least = 1.0; ///< determinant
    double m_softness = 0.0;
    bool m_anyAwake = false;
};

} // namespace ramure
