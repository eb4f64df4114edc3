/// \file
/// What a leaf's time depends on: its light, its neighbourhood and its address.
#pragma once

#include "core/math/random.h"
#include "core/skeleton/skeleton.h"
#include "core/surface/foliage/foliage.h"
#include <array>

namespace ramure {

/// Four random numbers 0..1 of one leaf or fruit, of 16 bits each: reading them is quick.
class Lots
{
public:
    explicit Lots(std::uint64_t bits)
        : m_bits(bits)
    {
    }
    [[nodiscard]] std::uint64_t bits() const { return m_bits; }
    float operator[](int which) const { return float((m_bits >> (16 * which)) & 0xFFFFU) / 65536.0F; }

private:
    std::uint64_t m_bits;
};

class CrownPlace
{
public:
    explicit CrownPlace(const Foliage& foliage);

    [[nodiscard]] static Lots lotsOf(const Skeleton& skeleton, const FoliageItem& item)
    {
        return Lots(
            mixBits(mixBits(skeleton.key[item.branch]) + 0x9E3779B97F4A7C15ULL * (item.number + 1ULL)));
    }
    /// 0 deep inside .. 1 on the crown's top and outside.
    [[nodiscard]] float light(const FoliageItem& item) const;
    /// 0 turns first .. 1 turns last, in patches about a limb wide. \param light of the leaf
    [[nodiscard]] float phase(const FoliageItem& item, float light, const Lots& lots) const;

private:
    [[nodiscard]] float patch(const glm::vec3& at) const;

    glm::dvec3 m_low{0.0}, m_high{0.0};
    float m_perMetre = 0.0F, m_perRadius = 0.0F, m_perCell = 0.0F;
};

/// Returns what the time of each leaf depends on, in the order of the leaves.
std::vector<LeafPhase> phasesOf(const Foliage& foliage, const Skeleton& skeleton);

} // namespace ramure
