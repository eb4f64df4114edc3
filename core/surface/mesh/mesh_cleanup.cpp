#include "core/surface/mesh/mesh_cleanup.h"

#include "core/math/random.h"
#include "core/surface/mesh/duplicate_positions.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace ramure {

namespace {

constexpr double leastAreaShare = 2e-14; ///< of the squared diagonal; twice what the validation asks for
constexpr double nudgeShare = 2e-6;      ///< of the diagonal
constexpr int mostRounds = 80;

/// How small is too small, and how far is a step: from the box of all positions.
struct Measures
{
    double leastSquared; ///< of a triangle's doubled area
    double step;

    explicit Measures(const std::vector<glm::vec3>& positions);
    [[nodiscard]] bool isFlat(const std::vector<glm::vec3>& positions, const glm::uvec3& triangle) const
    {
        const glm::dvec3 a(positions[triangle.x]);
        const glm::dvec3 normal =
            glm::cross(glm::dvec3(positions[triangle.y]) - a, glm::dvec3(positions[triangle.z]) - a);
        return glm::dot(normal, normal) <= leastSquared;
    }
};

Measures::Measures(const std::vector<glm::vec3>& positions)
{
    glm::vec3 low = positions[0], high = low;
    for (const glm::vec3& p : positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const double diagonal = glm::length(glm::dvec3(high) - glm::dvec3(low));
    const double least = 2.0 * leastAreaShare * diagonal * diagonal;
    leastSquared = least * least;
    const glm::vec3 reach = glm::max(glm::abs(low), glm::abs(high));
    // A nudge must be felt by the floats.
    step = std::max(nudgeShare * diagonal, 4.0 * 0x1.0p-23 * double(std::max({reach.x, reach.y, reach.z})));
}

class Separator
{
public:
    Separator(std::vector<glm::vec3>& positions, const std::vector<glm::uvec3>& triangles)
        : m_positions(positions)
        , m_triangles(triangles)
        , m_measures(positions)
    {
    }
    Index run(const std::vector<Index>* suspects, const Progress& progress);

private:
    Index moveTwins(int round);
    Index openFlat(const std::vector<Index>* suspects, int round);
    bool openFlat(const glm::uvec3& triangle, int round);
    void nudge(Index vertex, const glm::dvec3& direction, int round);
    [[nodiscard]] glm::dvec3 anyDirection(Index vertex, int round) const;

    std::vector<glm::vec3>& m_positions;
    const std::vector<glm::uvec3>& m_triangles;
    const Measures m_measures;
};

glm::dvec3 Separator::anyDirection(Index vertex, int round) const
{
    Random random(static_cast<std::uint64_t>(round), RandomStream::Nudge, vertex);
    glm::dvec3 direction;
    do
        direction = {random.range(-1.0, 1.0), random.range(-1.0, 1.0), random.range(-1.0, 1.0)};
    while (glm::dot(direction, direction) > 1.0 || glm::dot(direction, direction) < 0.1);
    return glm::normalize(direction);
}

void Separator::nudge(Index vertex, const glm::dvec3& direction, int round)
{
    const double length = m_measures.step * (1.0 + 0.25 * round);
    m_positions[vertex] = glm::vec3(glm::dvec3(m_positions[vertex]) + length * direction);
}

/// Every vertex at the place of an earlier one moves. Returns how many.
Index Separator::moveTwins(int round)
{
    const std::vector<DuplicatePosition> twins = findDuplicatePositions(m_positions);
    for (const DuplicatePosition& twin : twins)
        nudge(twin.vertex, anyDirection(twin.vertex, round), round);
    return static_cast<Index>(twins.size());
}

/// A triangle without area: the vertex opposite the longest edge moves away from that edge.
bool Separator::openFlat(const glm::uvec3& triangle, int round)
{
    if (!m_measures.isFlat(m_positions, triangle))
        return false;
    const glm::dvec3 a(m_positions[triangle.x]), b(m_positions[triangle.y]), c(m_positions[triangle.z]);
    const double ab = glm::length(b - a), bc = glm::length(c - b), ca = glm::length(a - c);
    const glm::dvec3 base = ab >= bc && ab >= ca ? b - a : (bc >= ca ? c - b : a - c);
    const Index apex = ab >= bc && ab >= ca ? triangle.z : (bc >= ca ? triangle.x : triangle.y);
    glm::dvec3 direction = anyDirection(apex, round);
    const double square = glm::dot(base, base);
    if (square > 0.0) {
        const glm::dvec3 across = direction - base * (glm::dot(direction, base) / square);
        if (glm::dot(across, across) > 1e-4)
            direction = glm::normalize(across);
    }
    nudge(apex, direction, round);
    return true;
}

Index Separator::openFlat(const std::vector<Index>* suspects, int round)
{
    Index moved = 0;
    if (suspects) {
        for (const Index triangle : *suspects)
            moved += openFlat(m_triangles[triangle], round) ? 1 : 0;
        return moved;
    }
    for (const glm::uvec3& triangle : m_triangles)
        moved += openFlat(triangle, round) ? 1 : 0;
    return moved;
}

Index Separator::run(const std::vector<Index>* suspects, const Progress& progress)
{
    Index total = 0;
    for (int round = 0; round < mostRounds && !progress.cancelled(); ++round) {
        const Index moved = moveTwins(round) + openFlat(total == 0 ? suspects : nullptr, round);
        total += moved;
        if (moved == 0)
            break;
    }
    return total;
}

} // namespace

Index separateVertices(std::vector<glm::vec3>& positions, const std::vector<glm::uvec3>& triangles,
                       const Progress& progress, const std::vector<Index>* suspects)
{
    return positions.empty() ? 0 : Separator(positions, triangles).run(suspects, progress);
}

bool hasFlat(const std::vector<glm::vec3>& positions, const std::vector<glm::uvec3>& triangles,
             const std::vector<Index>* suspects)
{
    if (positions.empty() || (suspects && suspects->empty()))
        return false;
    const Measures measures(positions);
    const auto isFlat = [&](const glm::uvec3& t) { return measures.isFlat(positions, t); };
    return suspects ? std::any_of(suspects->begin(), suspects->end(),
                                  [&](Index t) { return isFlat(triangles[t]); })
                    : std::any_of(triangles.begin(), triangles.end(), isFlat);
}

bool areSeparate(const std::vector<glm::vec3>& positions, const std::vector<glm::uvec3>& triangles,
                 const std::vector<Index>* suspects)
{
    return !hasFlat(positions, triangles, suspects) && findDuplicatePositions(positions).empty();
}

} // namespace ramure
