/// \file
/// Four floats that are computed with at once: one vector instruction instead of four. Arithmetic operators
/// work on all four, and with a plain float on one side; the results are those of plain floats.
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
inline void storeFloat4(float* to, Float4 value)
{
    std::memcpy(to, &value, sizeof value);
}

} // namespace ramure
