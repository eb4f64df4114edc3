/// \file
/// Four floats in one vector: one instruction instead of four. Arithmetic operators work on all four, and
/// with a plain float on one side. The results equal those of plain floats.
#pragma once

#include <cstring>

namespace ramure {

using Float4 [[gnu::vector_size(16)]] = float;

/// From any address, aligned or not.
inline Float4 loadFloat4(const float* from)
{
    Float4 out;
    std::memcpy(&out, from, sizeof out);
    return out;
}
/// Three floats and a zero; nothing behind them is read.
inline Float4 loadFloat3(const float* from)
{
    Float4 out{};
    std::memcpy(&out, from, 3 * sizeof(float));
    return out;
}
/// Rows become columns: a[1] and b[0] change places, and so on.
inline void transpose(Float4& a, Float4& b, Float4& c, Float4& d)
{
    const Float4 ab01 = __builtin_shufflevector(a, b, 0, 4, 1, 5),
                 ab23 = __builtin_shufflevector(a, b, 2, 6, 3, 7);
    const Float4 cd01 = __builtin_shufflevector(c, d, 0, 4, 1, 5),
                 cd23 = __builtin_shufflevector(c, d, 2, 6, 3, 7);
    a = __builtin_shufflevector(ab01, cd01, 0, 1, 4, 5);
    b = __builtin_shufflevector(ab01, cd01, 2, 3, 6, 7);
    c = __builtin_shufflevector(ab23, cd23, 0, 1, 4, 5);
    d = __builtin_shufflevector(ab23, cd23, 2, 3, 6, 7);
}
inline void storeFloat4(float* to, Float4 value)
{
    std::memcpy(to, &value, sizeof value);
}

} // namespace ramure
