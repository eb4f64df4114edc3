/// \file
/// Many numbers as text at once, side by side in vector instructions: most of the time that writing a mesh
/// file takes.
#pragma once

#include "core/io/float_text.h"
#include <string_view>

namespace ramure {

/// Most numbers of one row.
inline constexpr std::size_t maxColumns = 4;
/// Room that appendRows needs for a row whose head has so many characters.
constexpr std::size_t rowRoom(std::size_t head, std::size_t columns)
{
    return head + columns * (maxFloatText + 1) + 16;
}

/// Writes \p rows lines: \p head, then \p columns numbers as appendFloat writes them with a space between
/// two, and a line feed. \p head has at most 16 characters and ends in a space. The numbers are finite.
/// Returns the end of the text.
char* appendRows(char* to, std::string_view head, const float* numbers, std::size_t columns,
                 std::size_t rows);

} // namespace ramure
