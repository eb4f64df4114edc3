/// \file
/// A bounding volume hierarchy over objects with boxes. It answers "what does this ray meet first" and "what
/// lies in this frustum" without looking at every object. Built once, then read from any thread.
#pragma once

#include "core/base/index.h"
#include "core/math/intersect.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <span>
#include <stop_token>
#include <vector>

namespace ramure {

/// The box of one primitive.
struct PrimitiveBounds
{
    glm::vec3 min;
    glm::vec3 max;
    Index primitive = 0;
};

class Bvh
{
public:
    Bvh() = default;
    /// Binned surface area heuristic (Wald 2007); same input, same tree. A stopped build gives an empty one.
    explicit Bvh(std::vector<PrimitiveBounds> primitives, const std::stop_token& stop = {});

    [[nodiscard]] bool empty() const { return m_nodes.empty(); }
    [[nodiscard]] std::size_t nodeCount() const { return m_nodes.size(); }

    /// Calls \p test(primitive, tMax) for every primitive whose box the ray enters before \p tMax, near boxes
    /// first; test lowers tMax where it finds a hit.
    template <class Test> void alongRay(const Ray& ray, double tMax, Test&& test) const;

    /// Calls \p test(primitive) for every primitive whose box, grown by \p growth(min, max) on every side,
    /// meets the ray. The growth may shrink while the search goes on.
    template <class Growth, class Test> void nearRay(const Ray& ray, Growth&& growth, Test&& test) const;

    /// Calls \p test(primitive, certain) for every primitive whose box is not wholly outside one of the
    /// planes; certain: the box is inside all of them.
    template <class Test> void inPlanes(std::span<const CutPlane> planes, Test&& test) const;

private:
    struct Node
    {
        glm::vec3 min{0.0f};
        Index first = 0; ///< first primitive of a leaf, or the first of two children
        glm::vec3 max{0.0f};
        Index count = 0; ///< number of primitives; 0 = not a leaf
    };
    /// Depth of the tree is limited while building; each level leaves at most one node on the stack.
    static constexpr Index maxDepth = 62;
    using Stack = std::array<Index, maxDepth + 2>;

    struct Slabs
    {
        explicit Slabs(const Ray& ray);
        /// Returns the distance at which the ray enters the box, or infinity.
        [[nodiscard]] double entry(const Node& node, double growth, double tMax) const;
        glm::dvec3 origin, inverse;
    };
    void split(std::vector<PrimitiveBounds>& primitives, const std::stop_token& stop);

    std::vector<Node> m_nodes;
    std::vector<Index> m_order; ///< primitives, those of one leaf in a row
};

inline Bvh::Slabs::Slabs(const Ray& ray)
    : origin(ray.origin)
{
    // A direction of zero gets a huge inverse rather than infinity: zero times infinity would be no number.
    for (int i = 0; i < 3; ++i)
        inverse[i] = std::abs(ray.direction[i]) > 1e-290 ? 1.0 / ray.direction[i] : 1e290;
}

inline double Bvh::Slabs::entry(const Node& node, double growth, double tMax) const
{
    // The speck keeps a parallel ray inside a box on whose side it runs.
    const double reach = growth + 1e-200;
    const glm::dvec3 low = (glm::dvec3(node.min) - origin - reach) * inverse;
    const glm::dvec3 high = (glm::dvec3(node.max) - origin + reach) * inverse;
    const glm::dvec3 near = glm::min(low, high);
    const glm::dvec3 far = glm::max(low, high);
    const double from = std::max({near.x, near.y, near.z, 0.0});
    // Rounding must not lose a box that is only touched.
    const double to = std::min({far.x, far.y, far.z}) * (1.0 + 1e-14) + 1e-300;
    return from <= to && from <= tMax ? from : std::numeric_limits<double>::infinity();
}

template <class Test> void Bvh::alongRay(const Ray& ray, double tMax, Test&& test) const
{
    const Slabs slabs(ray);
    Stack stack;
    std::size_t depth = 0;
    if (!empty() && std::isfinite(slabs.entry(m_nodes[0], 0.0, tMax)))
        stack[depth++] = 0;
    while (depth > 0) {
        const Node& node = m_nodes[stack[--depth]];
        if (!std::isfinite(slabs.entry(node, 0.0, tMax)))
            continue;
        for (Index i = 0; i < node.count; ++i)
            test(m_order[node.first + i], tMax);
        if (node.count > 0)
            continue;
        const double a = slabs.entry(m_nodes[node.first], 0.0, tMax);
        const double b = slabs.entry(m_nodes[node.first + 1], 0.0, tMax);
        const Index nearest = a <= b ? 0 : 1;
        if (std::isfinite(std::max(a, b)))
            stack[depth++] = node.first + (1 - nearest);
        if (std::isfinite(std::min(a, b)))
            stack[depth++] = node.first + nearest;
    }
}

template <class Growth, class Test> void Bvh::nearRay(const Ray& ray, Growth&& growth, Test&& test) const
{
    const Slabs slabs(ray);
    const double endless = std::numeric_limits<double>::max();
    Stack stack;
    std::size_t depth = 0;
    if (!empty())
        stack[depth++] = 0;
    while (depth > 0) {
        const Node& node = m_nodes[stack[--depth]];
        if (!std::isfinite(slabs.entry(node, growth(glm::dvec3(node.min), glm::dvec3(node.max)), endless)))
            continue;
        for (Index i = 0; i < node.count; ++i)
            test(m_order[node.first + i]);
        if (node.count == 0) {
            stack[depth++] = node.first + 1;
            stack[depth++] = node.first;
        }
    }
}

template <class Test> void Bvh::inPlanes(std::span<const CutPlane> planes, Test&& test) const
{
    Stack stack;
    std::size_t depth = 0;
    if (!empty())
        stack[depth++] = 0;
    while (depth > 0) {
        const Node& node = m_nodes[stack[--depth]];
        bool certain = true;
        bool outside = false;
        const glm::dvec3 centre = 0.5 * (glm::dvec3(node.min) + glm::dvec3(node.max));
        const glm::dvec3 half = 0.5 * (glm::dvec3(node.max) - glm::dvec3(node.min));
        for (const CutPlane& plane : planes) {
            const double reach = glm::dot(glm::abs(glm::dvec3(plane)), half);
            const double at = glm::dot(glm::dvec3(plane), centre) + plane.w;
            outside = outside || at + reach < 0.0;
            certain = certain && at - reach >= 0.0;
        }
        if (outside)
            continue;
        for (Index i = 0; i < node.count; ++i)
            test(m_order[node.first + i], certain);
        if (node.count == 0) {
            stack[depth++] = node.first + 1;
            stack[depth++] = node.first;
        }
    }
}

} // namespace ramure
