#include "core/surface/mesh/duplicate_positions.h"

#include "core/base/large_buffer.h"
#include "core/base/wide_clone.h"
#include <algorithm>
#include <bit>
#include <utility>

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

/// Positions whose hashes are computed together.
constexpr std::size_t blockSize = 256;

/// Multiplication mixes upwards only, and floats differ in their high bits, round ones in no others: these
/// are folded down first.
RAMURE_WIDEST_CLONE void hashBlock(const float* positions, std::size_t count, std::uint32_t* hashes)
{
    const auto folded = [](float coordinate) {
        const auto bits = std::bit_cast<std::uint32_t>(coordinate + 0.0f); // one zero instead of two
        return bits ^ bits >> 16;
    };
    for (std::size_t i = 0; i < count; ++i) {
        std::uint32_t h = folded(positions[3 * i]) * 0x9E3779B1u +
                          folded(positions[3 * i + 1]) * 0x85EBCA77u +
                          folded(positions[3 * i + 2]) * 0xC2B2AE3Du;
        h ^= h >> 15;
        hashes[i] = h * 0x27D4EB2Fu;
    }
}

/// One bit per slot.
class BitSet
{
public:
    explicit BitSet(std::size_t slots)
        : m_words(slots / 64 + 1)
    {
        clear();
    }
    void clear() { std::fill_n(m_words.data(), m_words.size(), std::uint64_t(0)); }
    [[nodiscard]] bool test(std::uint32_t slot) const { return (m_words[slot / 64] >> slot % 64 & 1u) != 0; }
    /// True where it was set.
    bool set(std::uint32_t slot)
    {
        std::uint64_t& word = m_words[slot / 64];
        const std::uint64_t old = word;
        word = old | std::uint64_t(1) << slot % 64;
        return (old >> slot % 64 & 1u) != 0;
    }

private:
    LargeBuffer<std::uint64_t> m_words;
};

struct Hashed
{
    std::uint32_t hash;
    Index vertex;
};

/// All positions in buckets by the highest bits of their hashes; in a bucket by ascending vertex.
struct Buckets
{
    int bits = 0; ///< 2^bits buckets
    LargeBuffer<Hashed> entries;
    std::vector<std::size_t> begin; ///< of each bucket, and the end of the last
};

Buckets bucketsOf(std::span<const glm::vec3> positions)
{
    constexpr int perBucketBits = 18, mostBits = 8;
    Buckets out;
    out.bits = std::clamp(static_cast<int>(std::bit_width(positions.size() >> perBucketBits)), 0, mostBits);
    LargeBuffer<std::uint32_t> hashes(positions.size() + blockSize);
    for (std::size_t from = 0; from < positions.size(); from += blockSize)
        hashBlock(&positions[from].x, std::min(blockSize, positions.size() - from), &hashes[from]);
    out.entries = LargeBuffer<Hashed>(positions.size());
    const std::size_t buckets = std::size_t(1) << out.bits;
    const auto bucketOf = [bits = out.bits](std::uint32_t hash) { return std::uint64_t(hash) << bits >> 32; };
    out.begin.assign(buckets + 1, 0);
    out.begin.back() = positions.size();
    for (std::size_t v = 0; v < positions.size() && buckets == 1; ++v)
        out.entries[v] = {hashes[v], static_cast<Index>(v)};
    if (buckets == 1)
        return out;
    for (std::size_t v = 0; v < positions.size(); ++v)
        ++out.begin[bucketOf(hashes[v])];
    for (std::size_t bucket = 0, sum = 0; bucket < buckets; ++bucket)
        sum += std::exchange(out.begin[bucket], sum);
    std::vector<std::size_t> next(out.begin);
    for (std::size_t v = 0; v < positions.size(); ++v)
        out.entries[next[bucketOf(hashes[v])]++] = {hashes[v], static_cast<Index>(v)};
    return out;
}

/// A table of all vertices would not stay in the cache. A bit per hash does: in a clean mesh few vertices
/// find theirs set, and only they, and those who share their bits, are compared.
class BucketSearch
{
public:
    BucketSearch(std::span<const glm::vec3> positions, const Buckets& buckets,
                 std::vector<DuplicatePosition>& found)
        : m_positions(positions)
        , m_buckets(buckets)
        , m_found(found)
    {
        std::size_t largest = 0;
        for (std::size_t i = 0; i + 1 < buckets.begin.size(); ++i)
            largest = std::max(largest, buckets.begin[i + 1] - buckets.begin[i]);
        m_slotBits = std::min(bitsFor(largest * 16), 32 - buckets.bits); // sixteen to 32 for a vertex
        m_seen = BitSet(std::size_t(1) << m_slotBits);
        m_crowded = BitSet(std::size_t(1) << m_slotBits);
    }
    void run(std::size_t bucket)
    {
        const std::size_t begin = m_buckets.begin[bucket], end = m_buckets.begin[bucket + 1];
        if (bucket > 0)
            m_seen.clear();
        std::size_t crowdedTimes = 0;
        for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t slot = slotOf(m_buckets.entries[i].hash);
            if (!m_seen.set(slot))
                continue;
            m_crowded.set(slot);
            ++crowdedTimes;
        }
        if (crowdedTimes == 0)
            return;
        // At most twice as many vertices share crowded bits as were added to a set one: the table is half
        // empty or more.
        m_tableBits = bitsFor(crowdedTimes * 4);
        m_table.assign(std::size_t(1) << m_tableBits, {0, noIndex});
        for (std::size_t i = begin; i < end; ++i)
            if (m_crowded.test(slotOf(m_buckets.entries[i].hash)))
                compare(m_buckets.entries[i]);
        m_crowded.clear();
    }

private:
    [[nodiscard]] std::uint32_t slotOf(std::uint32_t hash) const
    {
        return hash << m_buckets.bits >> (32 - m_slotBits);
    }
    static int bitsFor(std::size_t slots) { return std::max(6, static_cast<int>(std::bit_width(slots - 1))); }
    void compare(const Hashed& own)
    {
        const auto isSame = [&](const Hashed& other) {
            return other.hash == own.hash &&
                   bitsOf(m_positions[other.vertex]) == bitsOf(m_positions[own.vertex]);
        };
        const std::size_t mask = m_table.size() - 1;
        // Mostly other bits than the filter's: those are alike here.
        auto at = static_cast<std::size_t>(own.hash * 0x9E3779B97F4A7C15u >> (64 - m_tableBits));
        while (m_table[at].vertex != noIndex && !isSame(m_table[at]))
            at = (at + 1) & mask;
        if (m_table[at].vertex == noIndex)
            m_table[at] = own;
        else
            m_found.push_back({own.vertex, m_table[at].vertex});
    }

    std::span<const glm::vec3> m_positions;
    const Buckets& m_buckets;
    std::vector<DuplicatePosition>& m_found;
    int m_slotBits = 0, m_tableBits = 0;
    BitSet m_seen{0}, m_crowded{0};
    std::vector<Hashed> m_table;
};

} // namespace

std::vector<DuplicatePosition> findDuplicatePositions(std::span<const glm::vec3> positions)
{
    std::vector<DuplicatePosition> found;
    if (positions.empty())
        return found;
    const Buckets buckets = bucketsOf(positions);
    BucketSearch search(positions, buckets, found);
    for (std::size_t bucket = 0; bucket + 1 < buckets.begin.size(); ++bucket)
        search.run(bucket);
    std::sort(found.begin(), found.end(),
              [](const DuplicatePosition& a, const DuplicatePosition& b) { return a.vertex < b.vertex; });
    return found;
}

} // namespace ramure
