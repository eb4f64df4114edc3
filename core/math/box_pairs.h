/// \file
/// Which of many boxes overlap? Boxes in the order of a curve that fills space (Morton), eight to a node of
/// an implicit tree: built in a sort, without any choice that could depend on threads.
#pragma once

#include "core/base/float4.h"
#include "core/base/index.h"
#include "core/math/bvh.h"
#include <array>
#include <bit>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

namespace ramure {

/// Eight boxes side by side; an unused place has a box that nothing overlaps.
struct alignas(32) EightBoxes
{
    static constexpr float most = std::numeric_limits<float>::infinity();

    std::array<std::array<float, 8>, 3> min, max;

    EightBoxes()
    {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            min[axis].fill(most);
            max[axis].fill(-most);
        }
    }
    void set(unsigned place, const glm::vec3& low, const glm::vec3& high)
    {
        for (int axis = 0; axis < 3; ++axis) {
            min[std::size_t(axis)][place] = low[axis];
            max[std::size_t(axis)][place] = high[axis];
        }
    }
    [[nodiscard]] glm::vec3 low(unsigned place) const
    {
        return {min[0][place], min[1][place], min[2][place]};
    }
    [[nodiscard]] glm::vec3 high(unsigned place) const
    {
        return {max[0][place], max[1][place], max[2][place]};
    }
    /// Bit i: box i has a point in common with this one.
    [[nodiscard]] unsigned overlaps(const glm::vec3& otherLow, const glm::vec3& otherHigh) const
    {
        return half(0, otherLow, otherHigh) | half(4, otherLow, otherHigh) << 4;
    }

private:
    [[nodiscard]] unsigned half(std::size_t first, const glm::vec3& otherLow,
                                const glm::vec3& otherHigh) const
    {
        auto hit = (loadFloat4(&min[0][first]) <= otherHigh.x) & (loadFloat4(&max[0][first]) >= otherLow.x);
        hit &= (loadFloat4(&min[1][first]) <= otherHigh.y) & (loadFloat4(&max[1][first]) >= otherLow.y);
        hit &= (loadFloat4(&min[2][first]) <= otherHigh.z) & (loadFloat4(&max[2][first]) >= otherLow.z);
#ifdef __SSE2__
        return static_cast<unsigned>(__builtin_ia32_movmskps(std::bit_cast<Float4>(hit)));
#else
        return (hit[0] & 1u) | (hit[1] & 2u) | (hit[2] & 4u) | (hit[3] & 8u);
#endif
    }
};

class BoxPairs
{
public:
    /// Boxes of finite numbers, min <= max.
    explicit BoxPairs(std::vector<PrimitiveBounds> boxes);

    /// The pairs fall into chunks, each of which can be looked at alone, on any thread.
    [[nodiscard]] std::size_t chunkCount() const;
    /// Calls \p found(one, other) for the pairs of primitives of the chunk whose closed boxes overlap, each
    /// pair of all chunks once, in an order that depends on the boxes only.
    template <class Found> void inChunk(std::size_t chunk, Found&& found) const;

private:
    static constexpr std::size_t nodesPerChunk = 256;
    using Level = std::vector<EightBoxes>;

    void sort(std::vector<PrimitiveBounds>& boxes);
    void build(const std::vector<PrimitiveBounds>& boxes);
    template <class Found>
    void below(std::size_t level, std::size_t node, std::size_t own, Found& found) const;
    template <class Found> void between(std::size_t own, std::size_t other, Found& found) const;

    std::vector<Level> m_levels; ///< the primitives' boxes first, then those of each eight below, up to one
    std::vector<Index> m_order;  ///< the primitives
};

template <class Found> void BoxPairs::inChunk(std::size_t chunk, Found&& found) const
{
    const std::size_t end = std::min((chunk + 1) * nodesPerChunk, m_levels.front().size());
    for (std::size_t own = chunk * nodesPerChunk; own < end; ++own)
        below(m_levels.size() - 1, 0, own, found);
}

/// All boxes under the eight of \p node that overlap the whole of the bottom node \p own and do not lie
/// before it.
template <class Found>
void BoxPairs::below(std::size_t level, std::size_t node, std::size_t own, Found& found) const
{
    if (level == 0)
        return between(own, node, found);
    // The box around the whole of `own` stands one level up.
    const EightBoxes& up = m_levels[1][own / 8];
    const auto place = static_cast<unsigned>(own % 8);
    unsigned hits = m_levels[level][node].overlaps(up.low(place), up.high(place));
    for (; hits != 0; hits &= hits - 1) {
        const std::size_t child = node * 8 + static_cast<std::size_t>(std::countr_zero(hits));
        const std::size_t lastBottom = ((child + 1) << (3 * (level - 1))) - 1;
        if (lastBottom >= own)
            below(level - 1, child, own, found);
    }
}

template <class Found> void BoxPairs::between(std::size_t own, std::size_t other, Found& found) const
{
    const EightBoxes &mine = m_levels.front()[own], &theirs = m_levels.front()[other];
    const std::size_t count = std::min<std::size_t>(8, m_order.size() - own * 8);
    for (unsigned i = 0; i < count; ++i) {
        unsigned hits = theirs.overlaps(mine.low(i), mine.high(i));
        if (other == own)
            hits &= ~0u << (i + 1);
        for (; hits != 0; hits &= hits - 1)
            found(m_order[own * 8 + i],
                  m_order[other * 8 + static_cast<std::size_t>(std::countr_zero(hits))]);
    }
}

} // namespace ramure
