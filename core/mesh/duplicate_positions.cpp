#include "core/mesh/duplicate_positions.h"

#include "core/base/large_buffer.h"
#include <algorithm>
#include <bit>

namespace ramure {

namespace {

/// The bits of a position, with one zero instead of two.
struct PositionBits
{
    std::uint64_t xy;
    std::uint32_t z;
    bool operator==(const PositionBits&) const = default;
};

PositionBits bitsOf(const glm::vec3& p)
{
    const auto bits = [](float f) { return std::bit_cast<std::uint32_t>(f + 0.0f); };
    return {std::uint64_t(bits(p.x)) << 32 | bits(p.y), bits(p.z)};
}

/// Multiplication mixes upwards only, and floats differ in their high bits: fold once in between.
std::uint64_t hashOf(const PositionBits& p)
{
    std::uint64_t h = p.xy * 0x9E3779B97F4A7C15u + p.z * 0xC2B2AE3D27D4EB4Fu;
    h ^= h >> 29;
    return h * 0xBF58476D1CE4E5B9u;
}

/// One bit per slot; the slot is the top of the hash, scaled.
class BitSet
{
public:
    explicit BitSet(std::size_t slots)
        : m_slots(slots)
        , m_words(slots / 64 + 1)
    {
        std::fill_n(m_words.data(), m_words.size(), std::uint64_t(0));
    }
    [[nodiscard]] bool test(std::uint64_t hash) const
    {
        const std::uint64_t s = slot(hash);
        return (m_words[s / 64] >> s % 64 & 1u) != 0;
    }
    void set(std::uint64_t hash) { testAndSet(hash); }
    bool testAndSet(std::uint64_t hash)
    {
        const std::uint64_t s = slot(hash);
        std::uint64_t& word = m_words[s / 64];
        const std::uint64_t old = word;
        word = old | std::uint64_t(1) << s % 64;
        return (old >> s % 64 & 1u) != 0;
    }

private:
    [[nodiscard]] std::uint64_t slot(std::uint64_t hash) const { return (hash >> 32) * m_slots >> 32; }
    std::uint64_t m_slots; ///< below 2^32
    LargeBuffer<std::uint64_t> m_words;
};

int bitsFor(std::size_t slots)
{
    return std::max(6, static_cast<int>(std::bit_width(slots - 1)));
}

} // namespace

// A table of all vertices would not stay in the cache. A bit per hash does: in a clean mesh few vertices find
// theirs set, and only they, and those who share their bits, are compared.
std::vector<DuplicatePosition> findDuplicatePositions(std::span<const glm::vec3> positions)
{
    std::vector<DuplicatePosition> found;
    if (positions.empty())
        return found;
    const std::size_t slots = std::min(positions.size() * 12, (std::size_t(1) << 32) - 1);
    BitSet seen(slots);
    BitSet crowded(slots);
    std::size_t crowdedTimes = 0;
    for (const glm::vec3& p : positions) {
        const std::uint64_t hash = hashOf(bitsOf(p));
        if (seen.testAndSet(hash)) {
            crowded.set(hash);
            ++crowdedTimes;
        }
    }
    if (crowdedTimes == 0)
        return found;
    // At most twice as many vertices share crowded bits as were added to a set one: the table is half empty
    // or more.
    const int tableBits = bitsFor(crowdedTimes * 4);
    const std::size_t mask = (std::size_t(1) << tableBits) - 1;
    std::vector<Index> table(mask + 1, noIndex);
    for (Index v = 0; v < positions.size(); ++v) {
        const PositionBits bits = bitsOf(positions[v]);
        const std::uint64_t hash = hashOf(bits);
        if (!crowded.test(hash))
            continue;
        std::size_t slot = hash >> 16 & mask; // mostly other bits than the filter's: those are alike here
        while (table[slot] != noIndex && bitsOf(positions[table[slot]]) != bits)
            slot = (slot + 1) & mask;
        if (table[slot] == noIndex)
            table[slot] = v;
        else
            found.push_back({v, table[slot]});
    }
    return found;
}

} // namespace ramure
