#include "core/io/float_rows.h"
#include "core/base/wide_clone.h"
#include "core/io/float_text_parts.h"
#include <algorithm>
#include <cmath>

namespace ramure {

namespace {

/// Numbers solved together; a multiple of every number of columns.
constexpr std::size_t blockSize = 192;
static_assert(blockSize % 2 == 0 && blockSize % 3 == 0 && blockSize % maxColumns == 0);

struct Sixteen
{
    std::uint64_t first, last;
};

struct Block
{
    std::array<float, blockSize> numbers;
    std::array<std::uint32_t, blockSize> exponents; ///< of the quick ones
    std::array<std::uint32_t, blockSize> digits;
    std::array<Sixteen, blockSize + 1> text; ///< one more: 32 bytes are read from each
};

/// Numbers that are not quick get some digits, which nobody uses.
RAMURE_WIDE_CLONE void solve(Block& b)
{
    for (std::size_t i = 0; i < blockSize; ++i) {
        const std::uint32_t exponent = floats::quickExponent(std::bit_cast<std::uint32_t>(b.numbers[i]));
        b.exponents[i] = std::min(exponent, std::uint32_t(floats::quickExponents));
    }
    for (std::size_t i = 0; i < blockSize; ++i) {
        const std::uint32_t exponent = b.exponents[i];
        b.digits[i] = floats::shortestDigits(static_cast<double>(std::abs(b.numbers[i])) *
                                                 floats::scales.power[exponent],
                                             floats::scales.halfGap[exponent]);
    }
    for (std::size_t i = 0; i < blockSize; ++i)
        b.text[i] = {floats::firstEight(b.digits[i]), floats::lastEight(b.digits[i])};
}

inline char* appendSolved(char* to, const Block& b, std::size_t i)
{
    const std::uint32_t exponent = b.exponents[i];
    floats::Layout layout{};
    if (exponent >= floats::quickExponents ||
        !floats::layOut(b.digits[i], b.text[i].last, floats::scales.decimals[exponent], layout))
        return appendFloat(to, b.numbers[i]);
    *to = '-';
    to += std::bit_cast<std::uint32_t>(b.numbers[i]) >> 31;
    return floats::appendCut(to, reinterpret_cast<const char*>(&b.text[i]), layout);
}

} // namespace

char* appendRows(char* to, std::string_view head, const float* numbers, std::size_t columns, std::size_t rows)
{
    char headBytes[16] = {};
    head.copy(headBytes, sizeof headBytes);
    Block block{};
    const std::size_t rowsPerBlock = blockSize / columns;
    for (std::size_t row = 0; row < rows; row += rowsPerBlock) {
        const std::size_t count = std::min(rowsPerBlock, rows - row) * columns;
        std::copy_n(numbers + row * columns, count, block.numbers.begin());
        solve(block);
        for (std::size_t i = 0; i < count; i += columns) {
            std::memcpy(to, headBytes, sizeof headBytes);
            to += head.size();
            for (std::size_t k = 0; k < columns; ++k) {
                to = appendSolved(to, block, i + k);
                *to++ = ' ';
            }
            to[-1] = '\n';
        }
    }
    return to;
}

} // namespace ramure
