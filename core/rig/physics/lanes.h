/// \file
/// Vectors and quaternions as plain components, for loops that the compiler turns into vector instructions.
/// Only additions, products, divisions and square roots: the same bits with any width of vectors.
#pragma once

#include <cmath>
#include <numbers>

// One copy of a function for processors with AVX2, one for all: the results are the same, contraction being
// off. Sanitizers cannot live with the way the copy is chosen.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(RAMURE_SANITIZED)
#define RAMURE_VECTOR_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define RAMURE_VECTOR_CLONES
#endif

// The rounds of the loop that follows share no memory.
#if defined(__GNUC__) && !defined(__clang__)
#define RAMURE_INDEPENDENT_ROUNDS _Pragma("GCC ivdep")
#else
#define RAMURE_INDEPENDENT_ROUNDS
#endif

namespace ramure::lanes {

struct Vec
{
    double x, y, z;
};
struct Quat
{
    double w, x, y, z;
};

inline Vec operator+(Vec a, Vec b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec operator-(Vec a, Vec b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec operator*(double s, Vec a)
{
    return {s * a.x, s * a.y, s * a.z};
}
inline double dot(Vec a, Vec b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec cross(Vec a, Vec b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Quat operator*(Quat a, Quat b)
{
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
inline Quat conjugate(Quat q)
{
    return {q.w, -q.x, -q.y, -q.z};
}
inline Vec turned(Quat q, Vec v)
{
    const Vec axis{q.x, q.y, q.z};
    const Vec t = 2.0 * cross(axis, v);
    return v + q.w * t + cross(axis, t);
}
/// A quaternion that is a unit but for rounding, without a square root.
inline Quat renormalised(Quat q)
{
    const double s = 1.5 - 0.5 * (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    return {s * q.w, s * q.x, s * q.y, s * q.z};
}

/// atan2(y, x) for y >= 0, not both zero: 0 .. pi. Error at most 2 units in the last place. The rational
/// function is that of Cephes (S. L. Moshier).
inline double angleOf(double y, double x)
{
    constexpr double tanOfEighth = 0.41421356237309504880;
    const double ax = std::abs(x);
    const double low = y < ax ? y : ax, high = y < ax ? ax : y;
    const bool middle = low > tanOfEighth * high;
    const double r = (middle ? low - high : low) / (middle ? low + high : high);
    const double z = r * r;
    const double p =
        ((((-8.750608600031904122785E-1 * z - 1.615753718733365076637E1) * z - 7.500855792314704667340E1) *
              z -
          1.228866684490136173410E2) *
             z -
         6.485021904942025371773E1) *
        z;
    const double q =
        ((((z + 2.485846490142306297962E1) * z + 1.650270098316988542046E2) * z + 4.328810604912902668951E2) *
             z +
         4.853903996359136964868E2) *
            z +
        1.945506571482613964425E2;
    const double small = r + r * (p / q) + (middle ? 0.25 * std::numbers::pi : 0.0);
    const double toAxis = y < ax ? small : 0.5 * std::numbers::pi - small;
    return x < 0.0 ? std::numbers::pi - toAxis : toAxis;
}

} // namespace ramure::lanes
