#include "core/math/box_pairs.h"

#include <algorithm>
#include <glm/common.hpp>

namespace ramure {
namespace {

constexpr double codeCells = 2'097'151.0; ///< per axis: three times 21 bits

/// The 21 bits of a number, two zeros between each and the next.
std::uint64_t spread(std::uint64_t bits)
{
    bits = (bits | bits << 32) & 0x001F00000000FFFFull;
    bits = (bits | bits << 16) & 0x001F0000FF0000FFull;
    bits = (bits | bits << 8) & 0x100F00F00F00F00Full;
    bits = (bits | bits << 4) & 0x10C30C30C30C30C3ull;
    return (bits | bits << 2) & 0x1249249249249249ull;
}

glm::dvec3 twiceMiddle(const PrimitiveBounds& box)
{
    return glm::dvec3(box.min) + glm::dvec3(box.max);
}

struct Coded
{
    std::uint64_t code;
    Index place;
    auto operator<=>(const Coded&) const = default;
};

} // namespace

BoxPairs::BoxPairs(std::vector<PrimitiveBounds> boxes)
{
    if (boxes.empty())
        return;
    sort(boxes);
    build(boxes);
}

void BoxPairs::sort(std::vector<PrimitiveBounds>& boxes)
{
    glm::dvec3 low = twiceMiddle(boxes.front()), high = low;
    for (const PrimitiveBounds& box : boxes) {
        low = glm::min(low, twiceMiddle(box));
        high = glm::max(high, twiceMiddle(box));
    }
    const double extent = std::max({high.x - low.x, high.y - low.y, high.z - low.z, 1e-300});
    std::vector<Coded> order;
    order.reserve(boxes.size());
    for (const PrimitiveBounds& box : boxes) {
        const glm::dvec3 cell = (twiceMiddle(box) - low) / extent * codeCells;
        const auto bits = [](double c) { return spread(static_cast<std::uint64_t>(c)); };
        order.push_back(
            {bits(cell.x) | bits(cell.y) << 1 | bits(cell.z) << 2, static_cast<Index>(&box - boxes.data())});
    }
    std::sort(order.begin(), order.end());
    std::vector<PrimitiveBounds> sorted;
    sorted.reserve(boxes.size());
    m_order.reserve(boxes.size());
    for (const Coded& entry : order) {
        sorted.push_back(boxes[entry.place]);
        m_order.push_back(sorted.back().primitive);
    }
    boxes.swap(sorted);
}

void BoxPairs::build(const std::vector<PrimitiveBounds>& boxes)
{
    Level bottom((boxes.size() + 7) / 8);
    for (std::size_t i = 0; i < boxes.size(); ++i)
        bottom[i / 8].set(static_cast<unsigned>(i % 8), boxes[i].min, boxes[i].max);
    m_levels.push_back(std::move(bottom));
    // The box around a bottom node is read from the level above it: there are always two levels.
    do {
        const Level& lower = m_levels.back();
        Level upper((lower.size() + 7) / 8);
        for (std::size_t i = 0; i < lower.size(); ++i) {
            glm::vec3 low(EightBoxes::most), high(-EightBoxes::most);
            for (unsigned k = 0; k < 8; ++k) {
                low = glm::min(low, lower[i].low(k));
                high = glm::max(high, lower[i].high(k));
            }
            upper[i / 8].set(static_cast<unsigned>(i % 8), low, high);
        }
        m_levels.push_back(std::move(upper));
    } while (m_levels.back().size() > 1);
}

std::size_t BoxPairs::chunkCount() const
{
    return m_levels.empty() ? 0 : (m_levels.front().size() + nodesPerChunk - 1) / nodesPerChunk;
}

} // namespace ramure
