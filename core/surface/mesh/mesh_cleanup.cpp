#include "core/surface/mesh/mesh_cleanup.h"

#include "core/math/random.h"
#include "core/surface/mesh/near_positions.h"
#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace ramure {

namespace {

constexpr double leastAreaShare = 2e-14; ///< of the squared diagonal; twice what the validation asks for
constexpr double nudgeShare = 2e-6;      ///< of the diagonal
constexpr double gapShare = 4e-7;        ///< of the diagonal
constexpr double leastWayShare = 1e-3;   ///< of the gap: nearer vertices do not tell which way to move them
constexpr int mostRounds = 80;

/// How small is too small, and how far is a step: from the box of all positions.
struct Measures
{
    double leastSquared; ///< of a triangle's doubled area
    double step, gap;

    Measures(const std::vector<glm::vec3>& positions, double leastGap);
    [[nodiscard]] bool isFlat(const std::vector<glm::vec3>& positions, const glm::uvec3& triangle) const
    {
        const glm::dvec3 a(positions[triangle.x]);
        const glm::dvec3 normal =
            glm::cross(glm::dvec3(positions[triangle.y]) - a, glm::dvec3(positions[triangle.z]) - a);
        return glm::dot(normal, normal) <= leastSquared;
    }
};

Measures::Measures(const std::vector<glm::vec3>& positions, double leastGap)
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
    gap = std::max(gapShare * diagonal, leastGap);
}

class Separator
{
public:
    Separator(std::vector<glm::vec3>& positions, const CleanupInput& mesh)
        : m_positions(positions)
        , m_mesh(mesh)
        , m_measures(positions, mesh.leastGap)
    {
    }
    Index run(const Progress& progress);

private:
    Index partNear(int round);
    Index openFlat(const std::vector<Index>* suspects, int round);
    bool openFlat(const glm::uvec3& triangle, int round);
    void nudge(Index vertex, const glm::dvec3& direction, double length);
    [[nodiscard]] double step(int round) const { return m_measures.step * (1.0 + 0.25 * round); }
    [[nodiscard]] glm::dvec3 anyDirection(Index vertex, int round) const;

    std::vector<glm::vec3>& m_positions;
    const CleanupInput& m_mesh;
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

void Separator::nudge(Index vertex, const glm::dvec3& direction, double length)
{
    m_positions[vertex] = glm::vec3(glm::dvec3(m_positions[vertex]) + length * direction);
}

/// Every vertex that is near to an earlier one moves away from it. Returns how often.
Index Separator::partNear(int round)
{
    const double gap = m_measures.gap, growth = 0.25 * round * gap; // so that heaps of vertices spread
    const std::vector<NearPair> pairs = findNearVertices(m_positions, gap);
    for (const NearPair& pair : pairs) {
        const glm::dvec3 way = glm::dvec3(m_positions[pair.vertex]) - glm::dvec3(m_positions[pair.earlier]);
        const double apart = glm::length(way);
        if (apart > gap) // since another pair was moved
            continue;
        if (apart > leastWayShare * gap)
            nudge(pair.vertex, way / apart, gap - apart + growth + m_measures.step);
        else
            nudge(pair.vertex, anyDirection(pair.vertex, round), std::max(gap + growth, step(round)));
    }
    return static_cast<Index>(pairs.size());
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
    nudge(apex, direction, step(round));
    return true;
}

Index Separator::openFlat(const std::vector<Index>* suspects, int round)
{
    Index moved = 0;
    if (suspects) {
        for (const Index triangle : *suspects)
            moved += openFlat(m_mesh.triangles[triangle], round) ? 1 : 0;
        return moved;
    }
    for (const glm::uvec3& triangle : m_mesh.triangles)
        moved += openFlat(triangle, round) ? 1 : 0;
    return moved;
}

Index Separator::run(const Progress& progress)
{
    Index total = 0;
    for (int round = 0; round < mostRounds && !progress.cancelled(); ++round) {
        const Index moved = partNear(round) + openFlat(total == 0 ? m_mesh.suspects : nullptr, round);
        total += moved;
        if (moved == 0)
            break;
    }
    return total;
}

bool hasFlat(const std::vector<glm::vec3>& positions, const CleanupInput& mesh, const Measures& measures)
{
    const auto isFlat = [&](const glm::uvec3& t) { return measures.isFlat(positions, t); };
    return mesh.suspects
               ? std::ranges::any_of(*mesh.suspects, [&](Index t) { return isFlat(mesh.triangles[t]); })
               : std::ranges::any_of(mesh.triangles, isFlat);
}

} // namespace

Index separateVertices(std::vector<glm::vec3>& positions, const CleanupInput& mesh, const Progress& progress)
{
    return positions.empty() ? 0 : Separator(positions, mesh).run(progress);
}

bool areSeparate(const std::vector<glm::vec3>& positions, const CleanupInput& mesh)
{
    if (positions.empty())
        return true;
    const Measures measures(positions, mesh.leastGap);
    return !hasFlat(positions, mesh, measures) && findNearPositions(positions, measures.gap, 1).empty();
}

} // namespace ramure
