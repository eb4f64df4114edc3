/// \file
/// What the families of the skeleton zoo are made with: a skeleton in the making and the draws they share.
#pragma once

#include "core/math/random.h"
#include "core/skeleton/skeleton.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace ramure::test {

class Grower
{
public:
    Grower(std::uint64_t family, std::uint64_t seed)
        : m_random(seed, RandomStream::Test, family)
    {
    }

    Random& random() { return m_random; }
    Skeleton& skeleton() { return m_skeleton; }
    double range(double from, double to) { return m_random.range(from, to); }
    /// Evenly spread over the orders of magnitude.
    double logRange(double from, double to) { return from * std::pow(to / from, m_random.unit()); }
    int between(int from, int to)
    {
        return from + static_cast<int>(m_random.below(static_cast<std::uint32_t>(to - from + 1)));
    }
    bool chance(double probability) { return m_random.unit() < probability; }

    glm::dvec3 direction()
    {
        const double y = range(-1.0, 1.0), azimuth = range(0.0, 2.0 * std::numbers::pi),
                     r = std::sqrt(1.0 - y * y);
        return {r * std::cos(azimuth), y, r * std::sin(azimuth)};
    }
    /// A direction at \p angle from \p axis, at any azimuth.
    glm::dvec3 tilted(const glm::dvec3& axis, double angle)
    {
        glm::dvec3 side = glm::cross(axis, direction());
        if (glm::length(side) < 1e-3)
            side = glm::cross(axis, glm::abs(axis.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
        return std::cos(angle) * axis + std::sin(angle) * glm::normalize(side);
    }
    [[nodiscard]] glm::dvec3 axis(Index branch) const
    {
        const glm::dvec3 d = m_skeleton.p1[branch] - m_skeleton.p0[branch];
        return glm::length(d) > 0.0 ? glm::normalize(d) : glm::dvec3(0, 1, 0);
    }
    double radius() { return logRange(0.01, 0.15); }

    Index root(const glm::dvec3& from, const glm::dvec3& offset, double a0, double a1)
    {
        return m_skeleton.add(noIndex, from, from + offset, a0, a1, 0);
    }
    Index root() { return root(glm::dvec3(0.0), {0.0, range(0.5, 1.5), 0.0}, 0.1, 0.08); }
    Index child(Index parent, const glm::dvec3& offset, double a0, double a1)
    {
        const glm::dvec3 from = m_skeleton.p1[parent];
        return m_skeleton.add(parent, from, from + offset, a0, a1, m_skeleton.level[parent] + 1);
    }
    /// Continues the parent's radius.
    Index child(Index parent, const glm::dvec3& offset)
    {
        const double a0 = m_skeleton.a1[parent];
        return child(parent, offset, a0, a0 * range(0.6, 1.0));
    }
    Index randomChild(Index parent) { return child(parent, direction() * logRange(0.1, 1.5)); }

    /// Grows random children on random branches until there are \p count, at most \p perBranch on one.
    void growTo(Index count, Index perBranch)
    {
        std::vector<Index> children(m_skeleton.size(), 0);
        for (const Index p : m_skeleton.parent)
            if (p != noIndex)
                ++children[p];
        while (m_skeleton.size() < count) {
            const Index parent = m_random.below(m_skeleton.size());
            if (children[parent]++ < perBranch) {
                randomChild(parent);
                children.push_back(0);
            }
        }
    }

private:
    Random m_random;
    Skeleton m_skeleton;
};

/// ZooFamily::Grammar: a random grammar, rewritten and drawn until it has at most 400 branches.
void growGrammar(Grower& g);

} // namespace ramure::test
