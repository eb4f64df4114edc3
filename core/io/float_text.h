/// \file
/// Single-precision numbers as text: the shortest decimal that reads back as the same float, and reading
/// back.
///
/// Both give the same as std::to_chars and std::from_chars, three times as fast: numbers are most of the time
/// that a mesh file takes. Locale-free.
#pragma once

#include "core/base/index.h"
#include <cstddef>
#include <cstdint>

namespace ramure {

/// Room that appendFloat needs.
inline constexpr std::size_t maxFloatText = 40;
/// Room that appendIndex needs.
inline constexpr std::size_t maxIndexText = 10;

/// Writes the shortest decimal text of a finite \p value at \p to (maxFloatText bytes of room; bytes after
/// the text may be overwritten). Returns the end of the text.
///
/// The method is Schubfach: R. Giulietti, "The Schubfach way to render doubles", 2020, with the sizes of a
/// float.
char* appendFloat(char* to, float value);

/// Decimal digits of \p value at \p to. Returns the end of the text.
char* appendIndex(char* to, Index value);

enum class FloatScan {
    Ok,
    NoNumber,  ///< nothing that begins like a number
    NotFinite, ///< "nan", "inf", or too large for a float
};
/// Reads a decimal number at \p from, correctly rounded; numbers too small become 0. A leading + is allowed.
/// On Ok \p from is moved behind the number. The text must end in a byte that cannot belong to a number, and
/// 8 bytes behind it must be readable.
FloatScan scanFloat(const char*& from, float& value);

/// Numbers that scanDigits finds too large become this one.
inline constexpr std::uint64_t largestScanned = 1'000'000'000'000'000u;
/// Reads decimal digits at \p from and moves it behind them; false where there is none. The same must hold of
/// the text.
bool scanDigits(const char*& from, std::uint64_t& value);

} // namespace ramure
