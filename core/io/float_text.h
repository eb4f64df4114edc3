/// \file
/// Numbers as text, and text as numbers: the shortest decimal that reads back as the same number.
/// Locale-free.
#pragma once

#include "core/base/index.h"
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace ramure {

/// Room that appendFloat needs.
inline constexpr std::size_t maxFloatText = 16;
/// Room that appendIndex needs.
inline constexpr std::size_t maxIndexText = 10;

/// Writes the shortest decimal text of a finite \p value at \p to. Returns the end of the text.
inline char* appendFloat(char* to, float value)
{
    return std::to_chars(to, to + maxFloatText, value).ptr;
}

/// Writes the decimal digits of \p value at \p to. Returns the end of the text.
inline char* appendIndex(char* to, Index value)
{
    return std::to_chars(to, to + maxIndexText, value).ptr;
}

/// The standard library reads no plus: the place behind it, where a digit or a point may follow.
inline const char* behindPlus(const char* from, const char* end)
{
    return end - from > 1 && *from == '+' && from[1] != '-' ? from + 1 : from;
}
/// True if a number that is out of the range of its type is too small for it, and not too large.
bool isTooSmall(std::string_view number);

enum class FloatScan {
    Ok,
    NoNumber,  ///< nothing that begins like a number
    NotFinite, ///< "nan", "inf", or too large for the type
};
/// Reads a decimal number between \p from and \p end, correctly rounded; numbers too small become 0. A
/// leading
/// + is allowed. On Ok \p from is moved behind the number.
template <std::floating_point T> FloatScan scanFloat(const char*& from, const char* end, T& value)
{
    const char* const begin = behindPlus(from, end);
    const auto [stop, problem] = std::from_chars(begin, end, value);
    if (problem == std::errc::invalid_argument)
        return FloatScan::NoNumber;
    if (problem == std::errc::result_out_of_range) {
        if (!isTooSmall({begin, static_cast<std::size_t>(stop - begin)}))
            return FloatScan::NotFinite;
        value = *begin == '-' ? T(-0.0) : T(0.0);
    }
    if (!std::isfinite(value))
        return FloatScan::NotFinite;
    from = stop;
    return FloatScan::Ok;
}

/// Whole numbers that are too large become this one, with their sign.
inline constexpr std::int64_t largestScanned = 1'000'000'000'000'000;
/// Reads a whole number with or without a sign and moves \p from behind it; false where there is none.
inline bool scanWhole(const char*& from, const char* end, std::int64_t& value)
{
    const char* const begin = behindPlus(from, end);
    const auto [stop, problem] = std::from_chars(begin, end, value);
    if (problem == std::errc::invalid_argument)
        return false;
    if (problem == std::errc::result_out_of_range || value > largestScanned || value < -largestScanned)
        value = *begin == '-' ? -largestScanned : largestScanned;
    from = stop;
    return true;
}

} // namespace ramure
