/// \file
/// An axis-aligned box. A default-made one is empty and grows to contain added points.
#pragma once

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace ramure {

struct Box
{
    glm::dvec3 min{std::numeric_limits<double>::infinity()};
    glm::dvec3 max{-std::numeric_limits<double>::infinity()};

    [[nodiscard]] bool empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
    [[nodiscard]] glm::dvec3 centre() const { return empty() ? glm::dvec3(0.0) : 0.5 * (min + max); }
    [[nodiscard]] glm::dvec3 size() const { return empty() ? glm::dvec3(0.0) : max - min; }
    /// Half the diagonal: the radius of the sphere around the box.
    [[nodiscard]] double radius() const { return 0.5 * glm::length(size()); }
    void add(const glm::dvec3& point)
    {
        min = glm::min(min, point);
        max = glm::max(max, point);
    }
    void add(const Box& other)
    {
        min = glm::min(min, other.min);
        max = glm::max(max, other.max);
    }
    /// The box moved out by \p margin on every side; an empty one stays empty.
    [[nodiscard]] Box grown(double margin) const
    {
        return empty() ? *this : Box{min - glm::dvec3(margin), max + glm::dvec3(margin)};
    }
    [[nodiscard]] glm::dvec3 corner(int i) const
    {
        return {(i & 1) != 0 ? max.x : min.x, (i & 2) != 0 ? max.y : min.y, (i & 4) != 0 ? max.z : min.z};
    }
    /// The box around the eight moved corners.
    [[nodiscard]] Box transformed(const glm::dmat4& matrix) const
    {
        Box result;
        for (int i = 0; i < 8 && !empty(); ++i)
            result.add(glm::dvec3(matrix * glm::dvec4(corner(i), 1.0)));
        return result;
    }
    bool operator==(const Box&) const = default;
};

} // namespace ramure
