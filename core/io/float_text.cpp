#include "core/io/float_text.h"
#include "core/io/float_text_parts.h"
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <limits>

namespace ramure {

namespace {

// --- writing
// ---------------------------------------------------------------------------------------------------------

constexpr std::uint32_t powersOfTen[] = {1u,      10u,      100u,      1000u,      10000u,
                                         100000u, 1000000u, 10000000u, 100000000u, 1000000000u};

int digitCount(std::uint32_t value)
{
    const int guess = static_cast<int>(std::bit_width(value | 1u)) * 1233 >> 12; // 1233 / 4096 is log10 2
    return guess + (value >= powersOfTen[guess] ? 1 : 0) + (value == 0 ? 1 : 0);
}

/// The eight decimal digits of a number below 10^8 as text, found in pairs and in pairs of pairs at once.
std::uint64_t eightDigits(std::uint32_t value)
{
    const std::uint64_t fours = value / 10000u | std::uint64_t(value % 10000u) << 32;
    const std::uint64_t hundreds = (fours * 10486u >> 20) & 0x0000007F0000007Fu;
    const std::uint64_t twos = hundreds | (fours - 100u * hundreds) << 16;
    const std::uint64_t tens = (twos * 103u >> 10) & 0x000F000F000F000Fu;
    return (tens | (twos - 10u * tens) << 8) | 0x3030303030303030u;
}

void store8(char* to, std::uint64_t text)
{
    std::memcpy(to, &text, sizeof text);
}

} // namespace

char* appendFloat(char* to, float value)
{
    const auto bits = std::bit_cast<std::uint32_t>(value);
    const std::uint32_t quick = floats::quickExponent(bits);
    if (quick < floats::quickExponents) {
        const double size = static_cast<double>(std::bit_cast<float>(bits & 0x7FFFFFFFu));
        const std::uint32_t digits =
            floats::shortestDigits(size * floats::scales.power[quick], floats::scales.halfGap[quick]);
        const std::uint64_t text[4] = {floats::firstEight(digits), floats::lastEight(digits)};
        floats::Layout layout{};
        if (floats::layOut(digits, text[1], floats::scales.decimals[quick], layout)) {
            *to = '-';
            return floats::appendCut(to + (bits >> 31), reinterpret_cast<const char*>(text), layout);
        }
    }
    return std::to_chars(to, to + maxFloatText, value).ptr;
}

char* appendIndex(char* to, Index value)
{
    const int count = digitCount(value);
    if (count <= 8) {
        store8(to, eightDigits(value) >> (8 * (8 - count)));
        return to + count;
    }
    char* const end = to + count;
    const std::uint32_t first = value / 100000000u;
    if (first >= 10u)
        *to++ = static_cast<char>('0' + first / 10u);
    *to++ = static_cast<char>('0' + first % 10u);
    store8(to, eightDigits(value % 100000000u));
    return end;
}

// --- reading
// ---------------------------------------------------------------------------------------------------------

namespace {

/// A decimal number as it stands in the text.
struct DecimalText
{
    std::uint64_t mantissa = 0;
    int digits = 0;   ///< of the mantissa, leading zeros included; more than 19 may not have fitted
    int exponent = 0; ///< of ten
};

bool isDigit(char c)
{
    return static_cast<unsigned char>(c - '0') < 10;
}

void takeDigit(const char*& p, DecimalText& text)
{
    text.mantissa = text.mantissa * 10u + static_cast<unsigned>(*p - '0');
    ++text.digits;
    ++p;
}

/// Digits before the point: few, and as many as in the number before.
const char* takeWhole(const char* p, DecimalText& text)
{
    while (isDigit(*p))
        takeDigit(p, text);
    return p;
}

/// Digits behind the point: up to nine without a branch, since nobody can guess their number.
const char* takeFraction(const char* p, DecimalText& text)
{
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, p, sizeof bytes);
    const int count = floats::leadingDigits(bytes);
    if (count == 0)
        return p;
    // Shifted to the end, with zero digits before.
    text.mantissa =
        text.mantissa * floats::exactPowers64[count] + floats::eightDigitValue(bytes << (8 * (8 - count)));
    const auto next = static_cast<unsigned char>(p[count] - '0');
    const bool isNinth = next < 10;
    text.mantissa = isNinth ? text.mantissa * 10u + next : text.mantissa;
    text.digits += count + isNinth;
    p += count + isNinth;
    return takeWhole(p, text);
}

/// e and a number: without a digit it is no exponent.
const char* takeExponent(const char* p, DecimalText& text)
{
    if (*p != 'e' && *p != 'E')
        return p;
    const char* q = p + 1;
    const bool isNegative = *q == '-';
    if (*q == '-' || *q == '+')
        ++q;
    if (!isDigit(*q))
        return p;
    int exponent = 0;
    for (; isDigit(*q); ++q)
        exponent = exponent < 100000 ? exponent * 10 + (*q - '0') : exponent;
    text.exponent += isNegative ? -exponent : exponent;
    return q;
}

/// Right by the rounding rules of double, except where the double lies just between two floats.
bool scanQuickly(const DecimalText& text, bool isNegative, float& value)
{
    if (text.digits > 19 || text.mantissa > (std::uint64_t(1) << 53) || text.exponent < -22 ||
        text.exponent > 22)
        return false;
    double wide = static_cast<double>(text.mantissa);
    wide = text.exponent < 0 ? wide / floats::exactPowers[-text.exponent]
                             : wide * floats::exactPowers[text.exponent];
    constexpr std::uint64_t beyondFloat = (std::uint64_t(1) << 29) - 1;
    const bool isBetween = (std::bit_cast<std::uint64_t>(wide) & beyondFloat) == (beyondFloat + 1) / 2;
    const bool isNormal = wide >= static_cast<double>(std::numeric_limits<float>::min()) &&
                          wide <= static_cast<double>(std::numeric_limits<float>::max());
    if (text.mantissa != 0 && (isBetween || !isNormal))
        return false;
    value = static_cast<float>(isNegative ? -wide : wide);
    return true;
}

bool isWordForNotFinite(const char* p)
{
    const auto is = [p](const char* word) {
        for (int i = 0; i < 3; ++i)
            if ((p[i] | 0x20) != word[i])
                return false;
        return true;
    };
    return is("nan") || is("inf");
}

} // namespace

bool scanDigits(const char*& from, std::uint64_t& value)
{
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, from, sizeof bytes);
    const int count = floats::leadingDigits(bytes);
    if (count == 0)
        return false;
    value = floats::eightDigitValue(bytes << (8 * (8 - count)));
    from += count;
    if (count == 8)
        for (; isDigit(*from); ++from)
            value = value < largestScanned / 10u ? value * 10u + static_cast<unsigned>(*from - '0')
                                                 : largestScanned;
    return true;
}

FloatScan scanFloat(const char*& from, float& value)
{
    const char* p = from;
    const bool isNegative = *p == '-';
    if (isNegative || *p == '+')
        ++p;
    const char* const begin = p;
    DecimalText text;
    p = takeWhole(p, text);
    if (*p == '.') {
        const int whole = text.digits;
        p = takeFraction(p + 1, text);
        text.exponent = whole - text.digits;
    }
    if (text.digits == 0)
        return isWordForNotFinite(begin) ? FloatScan::NotFinite : FloatScan::NoNumber;
    p = takeExponent(p, text);
    if (!scanQuickly(text, isNegative, value)) {
        const auto [end, error] = std::from_chars(begin, p, value);
        if (error != std::errc()) {
            if (text.digits + text.exponent > 20) // far from both ends: zeros in front count as digits
                return FloatScan::NotFinite;
            value = 0.0f;
        }
        value = isNegative ? -value : value;
    }
    from = p;
    return FloatScan::Ok;
}

} // namespace ramure
