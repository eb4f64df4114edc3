/// \file
/// What the relaxers of texture coordinates share. Internal to the texture coordinates.
#pragma once

#include "core/base/index.h"
#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace ramure {

/// A triangle in its own plane: corners at (0, 0), (x1, 0) and (x2, y2).
struct FlatCorners
{
    double x1 = 0.0, x2 = 0.0, y2 = 0.0;
};

/// \returns false for a triangle with next to no area, which has no shape to keep.
bool layFlat(const std::array<glm::dvec3, 3>& place, FlatCorners& flat);

/// The triangles around each vertex of a patch, in compressed rows.
class TrianglesAround
{
public:
    struct Use
    {
        Index triangle;
        Index place; ///< which of its corners
    };
    void clear() { m_first.clear(); }
    [[nodiscard]] bool isLinked(std::size_t vertices) const { return m_first.size() == vertices + 1; }
    /// \param triangles have an array of three vertices named corner
    template <class Triangle> void link(std::span<const Triangle> triangles, std::size_t vertices)
    {
        m_first.assign(vertices + 1, 0);
        for (const Triangle& triangle : triangles)
            for (const Index corner : triangle.corner)
                ++m_first[corner];
        Index sum = 0;
        for (Index& first : m_first)
            first = sum += first;
        m_uses.resize(sum);
        for (Index t = static_cast<Index>(triangles.size()); t-- > 0;)
            for (Index c = 3; c-- > 0;)
                m_uses[--m_first[triangles[t].corner[c]]] = {t, c};
    }
    [[nodiscard]] std::span<const Use> of(Index vertex) const
    {
        return {m_uses.data() + m_first[vertex], m_first[vertex + 1] - m_first[vertex]};
    }

private:
    std::vector<Index> m_first;
    std::vector<Use> m_uses;
};

} // namespace ramure
