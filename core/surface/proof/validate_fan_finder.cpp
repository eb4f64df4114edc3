#include "core/base/wide_clone.h"
#include "core/surface/proof/validate_parts.h"
#include <bit>
#include <cstring>
#ifdef RAMURE_WIDE
#include <immintrin.h>
#endif

namespace ramure::validation {

namespace {

/// Fans of up to so many faces fit one word: eight sets of up to eight elements, one a byte.
constexpr Index wordDegree = 8;

/// In which of 64 bits it says that face j may follow face i.
using BitOf = unsigned (*)(unsigned i, unsigned j);

/// The bits that say something about the first \p degree faces.
constexpr std::array<std::uint64_t, wordDegree + 1> usedBits(BitOf bitOf)
{
    std::array<std::uint64_t, wordDegree + 1> out{};
    for (unsigned degree = 0; degree <= wordDegree; ++degree)
        for (unsigned i = 0; i < degree; ++i)
            for (unsigned j = 0; j < degree; ++j)
                out[degree] |= std::uint64_t(1) << bitOf(i, j);
    return out;
}

/// True where \p sets of the faces that may follow each of \p degree faces (3..8) say one closed fan.
bool areClosedFan(std::uint64_t sets, Index degree, BitOf bitOf)
{
    Index seen = 0;
    bool isOne = std::popcount(sets) == static_cast<int>(degree);
    unsigned face = 0;
    for (Index step = 0; step < degree && isOne; ++step) {
        unsigned next = 0;
        while (next < degree && (sets >> bitOf(face, next) & 1u) == 0)
            ++next;
        isOne = next < degree;
        face = next;
        seen |= 1u << next;
    }
    return isOne && seen == (1u << degree) - 1u;
}

/// The same for up to nearDegree faces, from the corners. Nobody can guess the order: compared all with all.
bool isLargeClosedFan(const Corner* corners, Index degree)
{
    std::array<Index, nearDegree> next, previous, found{};
    for (std::size_t i = 0; i < nearDegree; ++i)
        next[i] = corners[i].next, previous[i] = corners[i].previous;
    // Above: how many follow. Below: the sum of their numbers, which for one is its number.
    constexpr Index one = 256;
    for (Index j = 0; j < degree; ++j)
        for (std::size_t i = 0; i < nearDegree; ++i)
            found[i] += previous[i] == next[j] ? one + j : 0;
    Index seen = 0, several = 0, face = 0;
    for (Index step = 0; step < degree; ++step) {
        const Index at = found[face];
        several |= at ^ one;
        face = at % nearDegree;
        seen |= 1u << face;
    }
    return several < nearDegree && seen == (1u << degree) - 1u;
}

Index lowestNext(const Corner* corners, Index degree)
{
    Index lowest = noIndex;
    for (Index i = 0; i < degree; ++i)
        lowest = std::min(lowest, corners[i].next);
    return lowest;
}

using Lanes [[gnu::vector_size(32)]] = Index;

constexpr unsigned plainBit(unsigned i, unsigned j)
{
    return 8 * i + j;
}
constexpr auto plainBits = usedBits(plainBit);

} // namespace

void FanFinder::findPlain(const Corners& corners, Index from, Index to, Index* lowest)
{
    using Bytes [[gnu::vector_size(32)]] = unsigned char;
    Index begin = corners.begin(from);
    for (Index v = from; v < to; ++v) {
        const Index end = corners.end[v], degree = end - begin;
        const Corner* const at = &corners.at[begin];
        begin = end;
        if (degree < 3 || degree > wordDegree) {
            const bool isLarge = degree > wordDegree && degree <= nearDegree;
            *lowest++ = isLarge && isLargeClosedFan(at, degree) ? lowestNext(at, degree) : noIndex;
            continue;
        }
        Lanes low, high, found{};
        std::memcpy(&low, at, sizeof low);
        std::memcpy(&high, at + 4, sizeof high);
        const Lanes previous = __builtin_shufflevector(low, high, 1, 3, 5, 7, 9, 11, 13, 15);
        for (unsigned j = wordDegree; j-- > 0;) // doubled, and 1 more where the lane's face may come before
            found = found + found - Lanes(previous == (Lanes{} + at[j].next));
        const Bytes bytes = reinterpret_cast<const Bytes&>(found);
        const auto packed = __builtin_shufflevector(bytes, bytes, 0, 4, 8, 12, 16, 20, 24, 28);
        Sets sets;
        std::memcpy(&sets, &packed, sizeof sets);
        sets |= ~plainBits[degree]; // the same sets with another degree are another arrangement
        Sets& known = m_known[slotOf(sets)];
        if (known != sets && areClosedFan(sets & plainBits[degree], degree, plainBit))
            known = sets;
        *lowest++ = known == sets ? lowestNext(at, degree) : noIndex;
    }
}

#ifdef RAMURE_WIDE
namespace {

/// Lanes 0 to 7 hold faces 0, 1, 4, 5, 2, 3, 6, 7: so they come out of pairs with one instruction.
constexpr unsigned laneOf(unsigned i)
{
    return i % 2 + 2 * (i / 4) + 4 * (i / 2 % 2);
}
/// Packing the comparisons with faces 0 to 7 leaves them in this order.
constexpr unsigned wideBit(unsigned i, unsigned j)
{
    return 32 * (j / 4) + 16 * (laneOf(i) / 4) + 4 * (j % 4) + laneOf(i) % 4;
}
constexpr auto wideBits = usedBits(wideBit);

/// All ones in the lanes of the faces from \p degree on.
constexpr std::array<std::array<Index, wordDegree>, wordDegree + 1> beyondDegree = [] {
    std::array<std::array<Index, wordDegree>, wordDegree + 1> out{};
    for (unsigned degree = 0; degree <= wordDegree; ++degree)
        for (unsigned i = degree; i < wordDegree; ++i)
            out[degree][laneOf(i)] = noIndex;
    return out;
}();

RAMURE_WIDE [[gnu::always_inline]] inline __m256i same(const __m256i& indices, Index with)
{
    return _mm256_cmpeq_epi32(indices, _mm256_set1_epi32(static_cast<int>(with)));
}

/// Which of the faces that hold \p previous may be followed by four faces, 32 bits.
RAMURE_WIDE [[gnu::always_inline]] inline std::uint64_t followed(const __m256i& previous, const Corner* by)
{
    const __m256i low = _mm256_packs_epi32(same(previous, by[0].next), same(previous, by[1].next));
    const __m256i high = _mm256_packs_epi32(same(previous, by[2].next), same(previous, by[3].next));
    return static_cast<std::uint32_t>(_mm256_movemask_epi8(_mm256_packs_epi16(low, high)));
}

/// The previous vertices of eight faces.
RAMURE_WIDE [[gnu::always_inline]] inline __m256i previousOf(const Corner* at)
{
    const __m256 low = _mm256_loadu_ps(reinterpret_cast<const float*>(at));
    const __m256 high = _mm256_loadu_ps(reinterpret_cast<const float*>(at + 4));
    return _mm256_permute4x64_epi64(_mm256_castps_si256(_mm256_shuffle_ps(low, high, 0xDD)), 0xD8);
}

/// Sixteen numbers below 256.
RAMURE_WIDE [[gnu::always_inline]] inline __m128i asBytes(const __m256i& words)
{
    return _mm_packus_epi16(_mm256_castsi256_si128(words), _mm256_extracti128_si256(words, 1));
}

/// As isLargeClosedFan().
RAMURE_WIDE bool isLargeClosedFanWide(const Corner* at, Index degree)
{
    const __m256i low = previousOf(at), high = previousOf(at + 8);
    // For each face how many follow it, times 256, and the sum of their numbers, which for one is its number.
    __m256i foundLow = _mm256_setzero_si256(), foundHigh = foundLow, number = _mm256_set1_epi32(256);
    for (Index j = 0; j < degree; ++j) {
        foundLow = _mm256_add_epi32(foundLow, _mm256_and_si256(same(low, at[j].next), number));
        foundHigh = _mm256_add_epi32(foundHigh, _mm256_and_si256(same(high, at[j].next), number));
        number = _mm256_add_epi32(number, _mm256_set1_epi32(1));
    }
    const __m256i words = _mm256_permute4x64_epi64(_mm256_packs_epi32(foundLow, foundHigh), 0xD8);
    const __m128i counts = asBytes(_mm256_srli_epi16(words, 8));
    __m128i follower = asBytes(_mm256_and_si256(words, _mm256_set1_epi16(0xFF)));
    const unsigned all = (1u << degree) - 1u;
    const auto ones = static_cast<unsigned>(_mm_movemask_epi8(_mm_cmpeq_epi8(counts, _mm_set1_epi8(1))));
    const auto firsts =
        static_cast<unsigned>(_mm_movemask_epi8(_mm_cmpeq_epi8(follower, _mm_setzero_si128())));
    // The faces that one passes from each: one, then two, four, eight and sixteen of them, as bits.
    __m128i seenLow = _mm_setr_epi8(1, 2, 4, 8, 16, 32, 64, -128, 0, 0, 0, 0, 0, 0, 0, 0);
    __m128i seenHigh = _mm_setr_epi8(0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 4, 8, 16, 32, 64, -128);
    for (int step = 0; step < 4; ++step) {
        seenLow = _mm_or_si128(seenLow, _mm_shuffle_epi8(seenLow, follower));
        seenHigh = _mm_or_si128(seenHigh, _mm_shuffle_epi8(seenHigh, follower));
        follower = _mm_shuffle_epi8(follower, follower);
    }
    const unsigned seen = (static_cast<unsigned>(_mm_cvtsi128_si32(seenLow)) & 0xFFu) |
                          (static_cast<unsigned>(_mm_cvtsi128_si32(seenHigh)) & 0xFFu) << 8;
    return (ones & all) == all && (firsts & all) != 0 && seen == all;
}

} // namespace

RAMURE_WIDE void FanFinder::findWide(const Corners& corners, Index from, Index to, Index* lowest)
{
    const Index* const ends = corners.end.data(); // what is written could be them, for all that is known
    const Corner* const first = corners.at.data();
    Index begin = corners.begin(from);
    for (Index v = from; v < to; ++v) {
        const Index end = ends[v], degree = end - begin;
        const Corner* const at = first + begin;
        begin = end;
        if (degree < 3 || degree > wordDegree) {
            const bool isLarge = degree > wordDegree && degree <= nearDegree;
            *lowest++ = isLarge && isLargeClosedFanWide(at, degree) ? lowestNext(at, degree) : noIndex;
            continue;
        }
        const __m256 low = _mm256_loadu_ps(reinterpret_cast<const float*>(at));
        const __m256 high = _mm256_loadu_ps(reinterpret_cast<const float*>(at + 4));
        const __m256i previous = _mm256_castps_si256(_mm256_shuffle_ps(low, high, 0xDD));
        const Sets sets = followed(previous, at) | followed(previous, at + 4) << 32 | ~wideBits[degree];
        Sets& known = m_known[slotOf(sets)];
        if (known != sets) {
            if (!areClosedFan(sets & wideBits[degree], degree, wideBit)) {
                *lowest++ = noIndex;
                continue;
            }
            known = sets;
        }
        const __m256i next = _mm256_or_si256(
            _mm256_castps_si256(_mm256_shuffle_ps(low, high, 0x88)),
            _mm256_loadu_si256(reinterpret_cast<const __m256i*>(beyondDegree[degree].data())));
        __m128i least = _mm_min_epu32(_mm256_castsi256_si128(next), _mm256_extracti128_si256(next, 1));
        least = _mm_min_epu32(least, _mm_shuffle_epi32(least, 0x4E));
        least = _mm_min_epu32(least, _mm_shuffle_epi32(least, 0xB1));
        *lowest++ = static_cast<Index>(_mm_cvtsi128_si32(least));
    }
}
#endif

void FanFinder::find(const Corners& corners, Index from, Index to, Index* lowest)
{
#ifdef RAMURE_WIDE
    if (hasWideVectors())
        return findWide(corners, from, to, lowest);
#endif
    findPlain(corners, from, to, lowest);
}

} // namespace ramure::validation
