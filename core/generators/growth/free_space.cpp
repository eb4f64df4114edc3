#include "core/generators/growth/free_space.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

namespace ramure {
namespace {

constexpr double unlooked = std::numeric_limits<double>::infinity();
constexpr double cone = 0.5; // cosine of the largest angle at which a bud sees

} // namespace

FreeSpace::FreeSpace(std::vector<glm::dvec3> points, double reach)
    : m_reach(reach)
    , m_cell(reach)
    , m_gone(points.size(), false)
    , m_nearest(points.size(), unlooked)
    , m_bud(points.size(), noIndex)
    , m_from(points.size())
{
    glm::dvec3 max = m_min = points.empty() ? glm::dvec3(0.0) : points.front();
    for (const glm::dvec3& p : points) {
        m_min = glm::min(m_min, p);
        max = glm::max(max, p);
    }
    const glm::dvec3 size = max - m_min;
    m_cell = std::max(reach, std::max({size.x, size.y, size.z}) / 96.0);
    m_x = int(size.x / m_cell) + 1;
    m_y = int(size.y / m_cell) + 1;
    m_z = int(size.z / m_cell) + 1;
    m_first.assign(std::size_t(m_x) * std::size_t(m_y) * std::size_t(m_z) + 1, 0);
    const auto cellOf = [&](const glm::dvec3& p) {
        const glm::dvec3 at = (p - m_min) / m_cell;
        return (std::size_t(int(at.y)) * std::size_t(m_z) + std::size_t(int(at.z))) * std::size_t(m_x) +
               std::size_t(int(at.x));
    };
    for (const glm::dvec3& p : points)
        ++m_first[cellOf(p) + 1];
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    std::vector<Index> next(m_first.begin(), m_first.end() - 1);
    m_points.resize(points.size());
    for (const glm::dvec3& p : points)
        m_points[next[cellOf(p)]++] = p;
}

template <class Visit> void FreeSpace::around(const glm::dvec3& at, double radius, bool gone, Visit&& visit)
{
    const auto cell = [&](double offset, double low, int count) {
        return int(std::clamp((offset - low) / m_cell, 0.0, double(count - 1)));
    };
    const int x0 = cell(at.x - radius, m_min.x, m_x), x1 = cell(at.x + radius, m_min.x, m_x);
    const int z0 = cell(at.z - radius, m_min.z, m_z), z1 = cell(at.z + radius, m_min.z, m_z);
    const int y0 = cell(at.y - radius, m_min.y, m_y), y1 = cell(at.y + radius, m_min.y, m_y);
    for (int y = y0; y <= y1; ++y)
        for (int z = z0; z <= z1; ++z) {
            const auto row = (std::size_t(y) * std::size_t(m_z) + std::size_t(z)) * std::size_t(m_x);
            const Index end = m_first[row + std::size_t(x1) + 1];
            for (Index k = m_first[row + std::size_t(x0)]; k < end; ++k)
                if (m_gone[k] == gone) {
                    const glm::dvec3 to = m_points[k] - at;
                    if (const double apart = glm::dot(to, to); apart <= radius * radius)
                        visit(k, to, apart);
                }
        }
}

void FreeSpace::occupy(const glm::dvec3& at, double radius)
{
    around(at, radius, false, [&](Index k, const glm::dvec3&, double) { m_gone[k] = true; });
}

void FreeSpace::release(const glm::dvec3& at, double radius)
{
    around(at, radius, true, [&](Index k, const glm::dvec3&, double) { m_gone[k] = false; });
}

void FreeSpace::look(Index bud, const glm::dvec3& at, const glm::dvec3& direction)
{
    around(at, m_reach, false, [&](Index k, const glm::dvec3& to, double apart) {
        const double along = glm::dot(to, direction);
        if (apart >= m_nearest[k] || along <= 0.0 || along * along < cone * cone * apart)
            return;
        m_nearest[k] = apart;
        m_bud[k] = bud;
        m_from[k] = at;
    });
}

Index FreeSpace::sum(std::vector<glm::dvec3>& towards)
{
    Index seen = 0;
    for (std::size_t k = 0; k < m_points.size(); ++k) {
        if (m_bud[k] == noIndex)
            continue;
        const glm::dvec3 to = m_points[k] - m_from[k];
        towards[m_bud[k]] += to / std::max(glm::length(to), 1e-9);
        m_bud[k] = noIndex;
        m_nearest[k] = unlooked;
        ++seen;
    }
    for (glm::dvec3& sum : towards)
        if (const double length = glm::length(sum); length > 0.0)
            sum /= length;
    return seen;
}

} // namespace ramure
