/// \file
/// What the writers of one number and of rows of numbers share. Internal to core/io.
///
/// Nearly every number of a mesh lies between 2^-16 and 2^23. Such a float, moved by a power of ten that only
/// its exponent decides, has at most nine digits before the point, and a double holds it, and the ends of the
/// interval of what rounds to it, without an error: the shortest digits come from a few exact operations.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace ramure::floats {

static_assert(std::endian::native == std::endian::little, "eight digits at a time: least address first");

/// The biased exponents of the floats from 2^-16 to 2^23.
inline constexpr int firstQuickExponent = 127 - 16;
inline constexpr int quickExponents = 39;

/// For all floats with one exponent: the power of ten that makes the distance between neighbours 1 or more,
/// below 10, and half that distance, scaled by it. Both are exact: 5^12 * (2^25 - 1) < 2^53.
struct Scales
{
    // One more: with the power 0, for whom the outcome is of no use.
    std::array<double, quickExponents + 1> power{};
    std::array<double, quickExponents + 1> halfGap{};
    std::array<std::int32_t, quickExponents + 1> decimals{}; ///< of the power: 1 to 12
};

consteval Scales makeScales()
{
    Scales out;
    for (std::size_t i = 0; i < quickExponents; ++i) {
        double gap = 1.0;
        for (std::size_t e = firstQuickExponent + i; e < 150; ++e)
            gap *= 0.5;
        out.power[i] = 1.0;
        for (; gap * out.power[i] < 1.0; ++out.decimals[i])
            out.power[i] *= 10.0;
        out.halfGap[i] = gap * out.power[i] * 0.5;
    }
    return out;
}
inline constexpr Scales scales = makeScales();

/// Number of the float's exponent among the quick ones; quickExponents and above for all other floats, and
/// for powers of two: their lower neighbour is at half the distance.
inline std::uint32_t quickExponent(std::uint32_t bits)
{
    const std::uint32_t quick = (bits >> 23 & 0xFFu) - firstQuickExponent;
    return (bits & 0x7FFFFFu) == 0 ? std::uint32_t(quickExponents) : quick;
}

/// Of all whole numbers that read back as the float when the point is moved back, the one with the most
/// trailing zeros, and of these the nearest to it. \p scaled: the float's size times the power of its
/// exponent. Below 2 * 10^8.
///
/// The interval is shorter than 10: it holds one multiple of 10 at most. Its ends are no whole numbers: they
/// are odd multiples of 1/2, 1/4 or less. Nobody can guess the outcome, so that nothing branches.
inline std::uint32_t shortestDigits(double scaled, double halfGap)
{
    const auto tens = static_cast<std::int32_t>(
        static_cast<std::uint32_t>(static_cast<std::int32_t>(scaled + halfGap)) / 10u * 10u);
    const auto nearest = static_cast<std::int32_t>(scaled + 0.5);
    return static_cast<std::uint32_t>(static_cast<double>(tens) > scaled - halfGap ? tens : nearest);
}

/// The four decimal digits of a number below 10^4 as text, found in pairs and in pairs of pairs at once.
inline std::uint32_t fourDigits(std::uint32_t value)
{
    const std::uint32_t hundreds = value * 10486u >> 20;
    const std::uint32_t twos = hundreds | (value - 100u * hundreds) << 16;
    const std::uint32_t tens = (twos * 103u >> 10) & 0x000F000Fu;
    return (tens | (twos - 10u * tens) << 8) | 0x30303030u;
}

/// Where the sixteen digits of a number (zeros in front) are cut to be its text.
struct Layout
{
    int begin;    ///< the first character that is written
    int whole;    ///< digits before the point, at least one
    int fraction; ///< digits behind it
};

/// \param digits their last \p decimals stand behind the point. \param eight the last eight as text. False
/// where an exponent would be shorter, and for numbers so round that they are not worth a case.
inline bool layOut(std::uint32_t digits, std::uint64_t eight, int decimals, Layout& out)
{
    const std::uint64_t bits = eight & 0x0F0F0F0F0F0F0F0Fu;
    if (bits == 0)
        return false;
    const int zerosBehind = std::countl_zero(bits) / 8;
    const int hasNinth = 0 - static_cast<int>(digits >= 100000000u); // a mask, not a branch
    const int eightCount = 8 - std::countr_zero(bits) / 8;
    const int count = eightCount + ((9 - eightCount) & hasNinth);
    const int point = count - decimals; // digits before the point, if positive
    out.whole = point > 1 ? point : 1;
    out.fraction = decimals - zerosBehind;
    out.begin = 16 - decimals - out.whole;
    const int exponentRoom = count - zerosBehind > 1 ? 5 : 4;
    return out.fraction >= 0 && 2 - point <= exponentRoom;
}

/// The first eight of the sixteen digits of a number below 2 * 10^8.
inline std::uint64_t firstEight(std::uint32_t digits)
{
    return 0x3030303030303030u | std::uint64_t(digits >= 100000000u ? 1u : 0u) << 56;
}

/// Those eight behind, as text.
inline std::uint64_t lastEight(std::uint32_t digits)
{
    const std::uint32_t rest = digits - (digits >= 100000000u ? 100000000u : 0u);
    const std::uint32_t high = rest / 10000u;
    return fourDigits(high) | std::uint64_t(fourDigits(rest - high * 10000u)) << 32;
}

/// Writes what \p layout cuts from \p sixteen digits, of which 32 bytes can be read; 32 bytes may be
/// overwritten.
inline char* appendCut(char* to, const char* sixteen, const Layout& layout)
{
    std::memcpy(to, sixteen + layout.begin, 16);
    to[layout.whole] = '.';
    std::memcpy(to + layout.whole + 1, sixteen + layout.begin + layout.whole, 15);
    return to + layout.whole + layout.fraction + (layout.fraction > 0 ? 1 : 0);
}

/// Powers of ten that a double holds exactly.
inline constexpr double exactPowers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                         1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                         1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

inline constexpr std::uint64_t exactPowers64[] = {1u,      10u,      100u,      1000u,     10000u,
                                                  100000u, 1000000u, 10000000u, 100000000u};

/// How many of the next eight bytes are digits before the first that is none.
inline int leadingDigits(std::uint64_t bytes)
{
    constexpr std::uint64_t high = 0xF0F0F0F0F0F0F0F0u;
    const std::uint64_t beyondNine = (((bytes & ~high) + 0x0606060606060606u) & high) >> 4;
    const std::uint64_t others = ((bytes & high) | beyondNine) ^ 0x3030303030303030u;
    return others == 0 ? 8 : std::countr_zero(others) / 8;
}

/// The number that eight digits make.
inline std::uint64_t eightDigitValue(std::uint64_t bytes)
{
    bytes &= 0x0F0F0F0F0F0F0F0Fu;
    bytes = bytes * 10u + (bytes >> 8); // pairs in every other byte
    constexpr std::uint64_t pairs = 0x000000FF000000FFu;
    return ((bytes & pairs) * (100u + (std::uint64_t(1000000u) << 32)) +
            (bytes >> 16 & pairs) * (1u + (std::uint64_t(10000u) << 32))) >>
           32;
}

inline std::uint64_t load8(const char* from)
{
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, from, sizeof bytes);
    return bytes;
}

/// Reads what nearly all numbers of mesh files look like: a minus or none, one or two digits, a point,
/// digits, no exponent. Nobody can guess signs and numbers of digits, so that these do not branch. The same
/// value as scanFloat; false, and nothing moved, for all other numbers. 24 bytes behind \p from must be
/// readable.
inline bool scanPlainFloat(const char*& from, float& value)
{
    const char* p = from;
    const std::uint32_t isNegative = *p == '-' ? 1u : 0u;
    p += isNegative;
    const auto digit = [](char c) { return static_cast<std::uint64_t>(static_cast<unsigned char>(c - '0')); };
    const std::uint64_t first = digit(p[0]), second = digit(p[1]);
    const bool hasSecond = second < 10;
    std::uint64_t mantissa = hasSecond ? first * 10u + second : first;
    p += 1 + (hasSecond ? 1 : 0);
    const std::uint64_t bytes = load8(p + 1);
    int decimals = leadingDigits(bytes);
    if (first > 9 || *p != '.' || decimals == 0)
        return false;
    mantissa = mantissa * exactPowers64[decimals] + eightDigitValue(bytes << (8 * (8 - decimals)));
    p += 1 + decimals;
    for (int more = 0; more < 2; ++more) {
        const std::uint64_t next = digit(*p);
        const bool isDigit = next < 10; // false behind fewer than eight
        mantissa = isDigit ? mantissa * 10u + next : mantissa;
        decimals += isDigit ? 1 : 0;
        p += isDigit ? 1 : 0;
    }
    for (; digit(*p) < 10 && decimals < 13; ++p, ++decimals)
        mantissa = mantissa * 10u + digit(*p);
    // Up to fifteen digits: the double is the nearest to the decimal, and so is the float unless the double
    // lies just between two floats.
    const double wide = static_cast<double>(static_cast<std::int64_t>(mantissa)) / exactPowers[decimals];
    constexpr std::uint64_t beyondFloat = (std::uint64_t(1) << 29) - 1;
    const bool isBetween = (std::bit_cast<std::uint64_t>(wide) & beyondFloat) == (beyondFloat + 1) / 2;
    if (isBetween || digit(*p) < 10 || (*p | 0x20) == 'e')
        return false;
    value = std::bit_cast<float>(std::bit_cast<std::uint32_t>(static_cast<float>(wide)) | isNegative << 31);
    from = p;
    return true;
}

} // namespace ramure::floats
