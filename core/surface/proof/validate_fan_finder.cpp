#include "core/base/wide_clone.h"
#include "core/surface/proof/validate_parts.h"
#include <bit>
#include <cstring>

namespace ramure::validation {

namespace {

/// Fans of up to so many faces fit one word: eight sets of up to eight elements, one a byte.
constexpr Index wordDegree = 8;

/// The bits that say something about the first \p degree faces.
constexpr std::array<std::uint64_t, wordDegree + 1> usedBits = [] {
    std::array<std::uint64_t, wordDegree + 1> out{};
    for (unsigned degree = 0; degree <= wordDegree; ++degree)
        for (unsigned i = 0; i < degree; ++i)
            for (unsigned j = 0; j < degree; ++j)
                out[degree] |= std::uint64_t(1) << (8 * i + j);
    return out;
}();

/// True where \p sets of the faces that may follow each of \p degree faces (3..8) say one closed fan.
bool areClosedFan(std::uint64_t sets, Index degree)
{
    Index seen = 0, face = 0;
    if (std::popcount(sets) != static_cast<int>(degree))
        return false;
    for (Index step = 0; step < degree; ++step) {
        const std::uint64_t following = sets >> 8 * face & 0xFFu;
        if (following == 0)
            return false;
        face = static_cast<Index>(std::countr_zero(following));
        seen |= 1u << face;
    }
    return seen == (1u << degree) - 1u;
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
using Bytes [[gnu::vector_size(32)]] = unsigned char;

} // namespace

RAMURE_WIDE_CLONE void FanFinder::find(const Corners& corners, Index from, Index to, Index* lowest)
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
        sets |= ~usedBits[degree]; // the same sets with another degree are another arrangement
        Sets& known = m_known[slotOf(sets)];
        if (known != sets && areClosedFan(sets & usedBits[degree], degree))
            known = sets;
        *lowest++ = known == sets ? lowestNext(at, degree) : noIndex;
    }
}

} // namespace ramure::validation
