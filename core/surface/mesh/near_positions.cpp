#include "core/surface/mesh/near_positions.h"

#include "core/base/large_buffer.h"
#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/ext/vector_int3_sized.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace ramure {

namespace {

/// Width of a cell in distances: wide enough that few vertices lie near its walls, narrow enough that few
/// vertices share a cell.
constexpr double cellWidth = 32.0;
constexpr int axisBits = 21; ///< three of them make a key
constexpr double mostCells = double((1 << axisBits) - 4);

struct InCell
{
    std::uint64_t cell;
    Index vertex;
};

/// Cells of a grid. A vertex belongs to all cells that the ball of half the distance around it touches: two
/// that are near share a cell, and most vertices have only one.
class NearGrid
{
public:
    NearGrid(std::span<const glm::vec3> positions, double distance)
    {
        glm::vec3 low(std::numeric_limits<float>::max()), high = -low;
        for (const glm::vec3& p : positions) {
            if (!isUsable(p))
                continue;
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
        m_low = glm::dvec3(low);
        const glm::dvec3 size = glm::dvec3(high) - m_low;
        const double width = std::max(cellWidth * distance, std::max({size.x, size.y, size.z}) / mostCells);
        m_cellsPerMetre = 1.0 / width;
        // A little more, so that rounding loses no pair.
        m_reach = 0.5 * distance * m_cellsPerMetre + 1e-9;
    }
    /// True where the vertex has but one cell, or, not being finite, none.
    bool forCells(const glm::vec3& position, const auto& take) const
    {
        if (!isUsable(position))
            return true;
        const glm::dvec3 at = (glm::dvec3(position) - m_low) * m_cellsPerMetre + 1.0;
        const glm::i64vec3 from(at - m_reach), to(at + m_reach);
        take(keyOf(from.x, from.y, from.z));
        if (from == to)
            return true;
        for (std::int64_t x = from.x; x <= to.x; ++x)
            for (std::int64_t y = from.y; y <= to.y; ++y)
                for (std::int64_t z = from.z; z <= to.z; ++z)
                    if (x != from.x || y != from.y || z != from.z)
                        take(keyOf(x, y, z));
        return false;
    }
    /// The lowest of the cells that two near positions share.
    [[nodiscard]] std::uint64_t firstShared(const glm::vec3& a, const glm::vec3& b) const
    {
        const glm::dvec3 at = (glm::dvec3(glm::max(a, b)) - m_low) * m_cellsPerMetre + 1.0;
        const glm::i64vec3 lowest(at - m_reach);
        return keyOf(lowest.x, lowest.y, lowest.z);
    }

private:
    static std::uint64_t keyOf(std::int64_t x, std::int64_t y, std::int64_t z)
    {
        return static_cast<std::uint64_t>(x << 2 * axisBits | y << axisBits | z);
    }
    static bool isUsable(const glm::vec3& p)
    {
        return std::abs(double(p.x) + double(p.y) + double(p.z)) <=
               3.0 * double(std::numeric_limits<float>::max());
    }

    glm::dvec3 m_low;
    double m_cellsPerMetre, m_reach;
};

/// One bit per slot of the cells' hashes: whether it was taken, and whether more than once.
class CellSlots
{
public:
    explicit CellSlots(std::size_t vertices)
        : m_shift(64 - std::clamp(static_cast<int>(std::bit_width(vertices * 16)), 6, 31))
        , m_taken((std::size_t(1) << (64 - m_shift)) / 64)
        , m_shared(m_taken.size())
    {
        std::fill_n(m_taken.data(), m_taken.size(), std::uint64_t(0));
        std::fill_n(m_shared.data(), m_shared.size(), std::uint64_t(0));
    }
    [[nodiscard]] Index slotOf(std::uint64_t cell) const
    {
        return static_cast<Index>((cell ^ cell >> 32) * 0x9E3779B97F4A7C15u >> m_shift);
    }
    /// True where the slot was taken before.
    bool take(Index slot)
    {
        const std::uint64_t bit = std::uint64_t(1) << slot % 64;
        std::uint64_t& word = m_taken[slot / 64];
        const bool before = (word & bit) != 0;
        word |= bit;
        if (before)
            m_shared[slot / 64] |= bit;
        return before;
    }
    [[nodiscard]] bool isShared(Index slot) const { return (m_shared[slot / 64] >> slot % 64 & 1u) != 0; }

private:
    int m_shift;
    LargeBuffer<std::uint64_t> m_taken, m_shared;
};

/// The vertices of the cells that several may share, cell by cell.
std::vector<InCell> crowdOf(std::span<const glm::vec3> positions, const NearGrid& grid)
{
    CellSlots slots(positions.size());
    LargeBuffer<Index> only(positions.size()); // slot of a vertex, unless it has several
    bool isAnyShared = false;
    for (std::size_t v = 0; v < positions.size(); ++v) {
        Index slot = 0;
        const bool isOne = grid.forCells(positions[v], [&](std::uint64_t cell) {
            slot = slots.slotOf(cell);
            isAnyShared |= slots.take(slot);
        });
        only[v] = isOne ? slot : noIndex;
    }
    std::vector<InCell> crowd;
    for (std::size_t v = 0; v < positions.size() && isAnyShared; ++v)
        if (only[v] == noIndex || slots.isShared(only[v]))
            grid.forCells(positions[v], [&](std::uint64_t cell) {
                if (slots.isShared(slots.slotOf(cell)))
                    crowd.push_back({cell, static_cast<Index>(v)});
            });
    std::ranges::sort(crowd, {}, [](const InCell& e) { return std::pair(e.cell, e.vertex); });
    return crowd;
}

enum class Search : std::uint8_t { SameVertex, NextVertex, Done };

/// \param take gets a vertex in a cell and an earlier one in it that is near, and says where to go on.
template <class Take>
void forCrowd(std::span<const glm::vec3> positions, const NearGrid& grid, double distance, const Take& take)
{
    const std::vector<InCell> crowd = crowdOf(positions, grid);
    for (std::size_t i = 0, first = 0; i < crowd.size(); ++i) {
        if (crowd[i].cell != crowd[first].cell)
            first = i;
        const glm::dvec3 own(positions[crowd[i].vertex]);
        Search next = Search::SameVertex;
        for (std::size_t j = first; j < i && next == Search::SameVertex; ++j) {
            const glm::dvec3 way = own - glm::dvec3(positions[crowd[j].vertex]);
            if (glm::dot(way, way) <= distance * distance)
                next = take(crowd[i], crowd[j].vertex);
        }
        if (next == Search::Done)
            return;
    }
}

void sort(std::vector<NearPair>& pairs)
{
    std::ranges::sort(pairs, {}, [](const NearPair& pair) { return std::pair(pair.vertex, pair.earlier); });
}

} // namespace

std::vector<NearPair> findNearPositions(std::span<const glm::vec3> positions, double distance,
                                        std::size_t most)
{
    std::vector<NearPair> found;
    const NearGrid grid(positions, distance);
    forCrowd(positions, grid, distance, [&](const InCell& own, Index earlier) {
        if (grid.firstShared(positions[own.vertex], positions[earlier]) == own.cell)
            found.push_back({own.vertex, earlier});
        return found.size() >= most ? Search::Done : Search::SameVertex;
    });
    sort(found);
    return found;
}

std::vector<NearPair> findNearVertices(std::span<const glm::vec3> positions, double distance)
{
    std::vector<NearPair> found;
    forCrowd(positions, NearGrid(positions, distance), distance, [&](const InCell& own, Index earlier) {
        found.push_back({own.vertex, earlier});
        return Search::NextVertex;
    });
    sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

} // namespace ramure
