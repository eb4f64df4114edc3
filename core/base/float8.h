/// \file
/// Eight floats in one vector, and eight points as three such vectors. Each operation is one instruction
/// inside RAMURE_WIDE_CLONE on processors with wide vectors, two elsewhere. The results equal those of plain
/// floats. Pass them by reference: passing vectors by value would ask for wide registers.
#pragma once

#include "core/base/float4.h"

namespace ramure {

using Float8 [[gnu::vector_size(32)]] = float;

/// Eight points; each component is a vector with one lane per point.
struct EightPoints
{
    Float8 x, y, z;

    /// \param from 24 floats, aligned or not: x, y, z of one point after the other
    [[gnu::always_inline]] inline void load(const float* from)
    {
        // The first four points in the lower halves, the others in the upper ones: no lane leaves its half.
        Float8 a, b, c;
        halves(from, from + 12, a);
        halves(from + 4, from + 16, b);
        halves(from + 8, from + 20, c);
        const Float8 xy = __builtin_shufflevector(b, c, 2, 3, 9, 10, 6, 7, 13, 14);
        const Float8 yz = __builtin_shufflevector(a, b, 1, 2, 8, 9, 5, 6, 12, 13);
        x = __builtin_shufflevector(a, xy, 0, 3, 8, 10, 4, 7, 12, 14);
        y = __builtin_shufflevector(yz, xy, 0, 2, 9, 11, 4, 6, 13, 15);
        z = __builtin_shufflevector(yz, c, 1, 3, 8, 11, 5, 7, 12, 15);
    }
    [[gnu::always_inline]] inline void store(float* to) const
    {
        const Float8 xy = __builtin_shufflevector(x, y, 0, 2, 8, 10, 4, 6, 12, 14);
        const Float8 yz = __builtin_shufflevector(y, z, 1, 3, 9, 11, 5, 7, 13, 15);
        const Float8 zx = __builtin_shufflevector(z, x, 0, 2, 9, 11, 4, 6, 13, 15);
        storeHalves(__builtin_shufflevector(xy, zx, 0, 2, 8, 10, 4, 6, 12, 14), to, to + 12);
        storeHalves(__builtin_shufflevector(yz, xy, 0, 2, 9, 11, 4, 6, 13, 15), to + 4, to + 16);
        storeHalves(__builtin_shufflevector(zx, yz, 1, 3, 9, 11, 5, 7, 13, 15), to + 8, to + 20);
    }

private:
    [[gnu::always_inline]] static inline void halves(const float* lower, const float* upper, Float8& out)
    {
        out = __builtin_shufflevector(loadFloat4(lower), loadFloat4(upper), 0, 1, 2, 3, 4, 5, 6, 7);
    }
    [[gnu::always_inline]] static inline void storeHalves(const Float8& value, float* lower, float* upper)
    {
        std::memcpy(lower, &value, sizeof(Float4));
        std::memcpy(upper, reinterpret_cast<const float*>(&value) + 4, sizeof(Float4));
    }
};

} // namespace ramure
