#include "core/surface/season/crown_place.h"

#include "core/base/parallel.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace ramure {

CrownPlace::CrownPlace(const Foliage& foliage)
{
    if (foliage.leaves.empty())
        return;
    m_low = m_high = foliage.leaves.front().position;
    for (const FoliageItem& leaf : foliage.leaves) {
        m_low = glm::min(m_low, leaf.position);
        m_high = glm::max(m_high, leaf.position);
    }
    const glm::dvec3 size = m_high - m_low;
    const double radius = 0.25 * (size.x + size.z);
    const auto inverse = [](double length) { return length > 1e-9 ? float(1.0 / length) : 0.0F; };
    m_perMetre = inverse(size.y);
    m_perRadius = inverse(radius);
    m_perCell = inverse(0.35 * radius);
}

float CrownPlace::light(const FoliageItem& item) const
{
    const glm::dvec3 middle = 0.5 * (m_low + m_high);
    const auto x = float(item.position.x - middle.x), z = float(item.position.z - middle.z);
    const float height = m_perMetre * float(item.position.y - m_low.y);
    const float out = std::min(m_perRadius * std::sqrt(x * x + z * z), 1.0F);
    // On a ball the top is as much outside as the rim.
    return std::clamp(std::max(0.55F * height + 0.45F * out, height * height), 0.0F, 1.0F);
}

/// Smooth noise on a lattice.
float CrownPlace::patch(const glm::vec3& at) const
{
    const glm::vec3 cell = glm::floor(at), f = at - cell, s = f * f * (3.0F - 2.0F * f);
    const auto corner = [&cell](int x, int y, int z) {
        const auto n = [](float v) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(v)); };
        const std::uint64_t bits = mixBits((n(cell.x) + std::uint64_t(x)) * 0x8DA6B343ULL +
                                           (n(cell.y) + std::uint64_t(y)) * 0xD8163841ULL +
                                           (n(cell.z) + std::uint64_t(z)) * 0x27D4EB2FULL);
        return float(bits >> 40) * 0x1p-24F;
    };
    float sides[2];
    for (int z = 0; z < 2; ++z)
        sides[z] = glm::mix(glm::mix(corner(0, 0, z), corner(1, 0, z), s.x),
                            glm::mix(corner(0, 1, z), corner(1, 1, z), s.x), s.y);
    return glm::mix(sides[0], sides[1], s.z);
}

float CrownPlace::phase(const FoliageItem& item, float light, const Lots& lots) const
{
    const float near = patch(m_perCell * glm::vec3(item.position - m_low));
    // The middle of three numbers is met too often: drawn apart.
    const float mixed = 0.4F * near + 0.35F * (1.0F - light) + 0.25F * lots[0];
    return std::clamp(0.5F + 1.6F * (mixed - 0.5F), 0.0F, 1.0F);
}

std::vector<LeafPhase> phasesOf(const Foliage& foliage, const Skeleton& skeleton)
{
    const CrownPlace crown(foliage);
    std::vector<LeafPhase> phases(foliage.leaves.size());
    parallelFor(phases.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const FoliageItem& leaf = foliage.leaves[i];
            const Lots lots = CrownPlace::lotsOf(skeleton, leaf);
            const float light = crown.light(leaf);
            phases[i] = {light, crown.phase(leaf, light, lots), lots.bits()};
        }
    });
    return phases;
}

} // namespace ramure
