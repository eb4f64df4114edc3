#include "core/generators/growth/shadow_grid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ramure {
namespace {

constexpr std::array<double, ShadowGrid::depth + 1> falloff()
{
    std::array<double, ShadowGrid::depth + 1> of{};
    double power = 1.25 / 16.0; // of the weights
    for (int q = 0; q <= ShadowGrid::depth; ++q) {
        const double share = double(q) / double(ShadowGrid::depth + 1);
        of[std::size_t(q)] = power * (1.0 - share * share); // a shadow that ended at once would leave bands
        power /= 1.5;
    }
    return of;
}
constexpr auto falloffs = falloff();

} // namespace

bool ShadowGrid::reset(const glm::dvec3& min, const glm::dvec3& max, double voxel)
{
    const glm::dvec3 count = (max - min) / voxel + 3.0;
    if (!(count.x * count.y * count.z <= double(maxVoxels)))
        return false;
    m_scale = 1.0 / voxel;
    m_min = min - voxel;
    m_x = int(count.x) + 1;
    m_y = int(count.y) + 1;
    m_z = int(count.z) + 1;
    const std::size_t voxels = std::size_t(m_x) * std::size_t(m_y) * std::size_t(m_z);
    m_sums.assign(voxels, 0);
    m_isKnown.assign(voxels / 64 + 1, 0);
    if (m_known.size() < voxels)
        m_known.resize(voxels);
    return true;
}

void ShadowGrid::add(const glm::dvec3& at, std::int32_t weight)
{
    const glm::dvec3 p = (at - m_min) * m_scale;
    const auto row = std::size_t(int(p.y)) * std::size_t(m_z) + std::size_t(int(p.z));
    m_sums[row * std::size_t(m_x) + std::size_t(int(p.x))] += weight;
}

void ShadowGrid::sum()
{
    const auto width = std::size_t(m_x);
    for (int y = 0; y < m_y; ++y)
        for (int z = 1; z < m_z; ++z) {
            std::int32_t* row = m_sums.data() + (std::size_t(y) * std::size_t(m_z) + std::size_t(z)) * width;
            const std::int32_t* before = row - width;
            std::int32_t along = 0;
            for (std::size_t x = 1; x < width; ++x) {
                along += std::min(row[x], densest);
                row[x] = along + before[x];
            }
        }
}

double ShadowGrid::shadow(int x, int y, int z)
{
    if (x < 0 || x >= m_x || y < 0 || y >= m_y || z < 0 || z >= m_z)
        return sumOver(x, y, z);
    const std::size_t voxel =
        (std::size_t(y) * std::size_t(m_z) + std::size_t(z)) * std::size_t(m_x) + std::size_t(x);
    std::uint64_t& bits = m_isKnown[voxel / 64];
    const std::uint64_t bit = std::uint64_t(1) << voxel % 64;
    if ((bits & bit) == 0) {
        bits |= bit;
        m_known[voxel] = sumOver(x, y, z);
    }
    return m_known[voxel];
}

double ShadowGrid::sumOver(int x, int y, int z) const
{
    double sum = 0.0;
    const auto width = std::size_t(m_x);
    for (int q = 0; q <= depth && y + q < m_y; ++q) {
        if (y + q < 0)
            continue;
        const int wide = std::max(q, 1); // neighbours of the same height crowd a bud
        const int x0 = std::clamp(x - wide - 1, 0, m_x - 1), x1 = std::clamp(x + wide, 0, m_x - 1);
        const int z0 = std::clamp(z - wide - 1, 0, m_z - 1), z1 = std::clamp(z + wide, 0, m_z - 1);
        const std::int32_t* layer = m_sums.data() + std::size_t(y + q) * std::size_t(m_z) * width;
        const std::int32_t *low = layer + std::size_t(z0) * width, *high = layer + std::size_t(z1) * width;
        sum += falloffs[std::size_t(q)] * double(high[x1] - high[x0] - low[x1] + low[x0]);
    }
    return sum;
}

double ShadowGrid::shadowAt(const glm::dvec3& at, double a)
{
    const glm::dvec3 p = (at - m_min) * m_scale;
    return a * shadow(int(std::floor(p.x)), int(std::floor(p.y)), int(std::floor(p.z)));
}

glm::dvec3 ShadowGrid::lighter(const glm::dvec3& at, double a)
{
    const glm::dvec3 p = (at - m_min) * m_scale;
    const int x = int(std::floor(p.x)), y = int(std::floor(p.y)), z = int(std::floor(p.z));
    const auto along = [&](int dx, int dy, int dz) {
        return shadow(x - dx, y - dy, z - dz) - shadow(x + dx, y + dy, z + dz);
    };
    return 0.5 * a * glm::dvec3(along(1, 0, 0), along(0, 1, 0), along(0, 0, 1));
}

} // namespace ramure
