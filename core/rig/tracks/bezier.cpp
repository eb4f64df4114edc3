#include "core/rig/tracks/bezier.h"

#include <algorithm>
#include <cmath>

namespace ramure {

static Handle shortened(const Handle& handle, double duration)
{
    const double length = std::abs(handle.dt);
    if (length <= duration)
        return handle;
    return {handle.dt * duration / length, handle.dv * duration / length};
}

/// The parameter at which a rising cubic in x, with control points 0, x1, x2, 1, takes the value \p x:
/// Newton's steps, kept inside a bracket that bisection narrows.
static double parameterAt(double x1, double x2, double x)
{
    const double c = 3.0 * x1, b = 3.0 * (x2 - x1) - c, a = 1.0 - c - b;
    double low = 0.0, high = 1.0, u = x;
    for (int i = 0; i < 64; ++i) {
        const double miss = ((a * u + b) * u + c) * u - x;
        (miss < 0.0 ? low : high) = u;
        const double slope = (3.0 * a * u + 2.0 * b) * u + c;
        double next = u - miss / slope;
        if (!(next > low && next < high))
            next = 0.5 * (low + high);
        if (std::abs(next - u) <= 1e-15)
            return next;
        u = next;
    }
    return u;
}

double bezierValue(double duration, double v0, const Handle& out, const Handle& in, double v1, double seconds)
{
    const double x = seconds / duration;
    if (x <= 0.0)
        return v0;
    if (x >= 1.0)
        return v1;
    const Handle first = shortened(out, duration), last = shortened(in, duration);
    const double x1 = std::max(first.dt, 0.0) / duration, x2 = 1.0 + std::min(last.dt, 0.0) / duration;
    constexpr double third = 1.0 / 3.0, close = 1e-12;
    const bool even = std::abs(x1 - third) < close && std::abs(x2 - 2.0 * third) < close;
    const double u = even ? x : parameterAt(x1, x2, x), w = 1.0 - u;
    return w * w * w * v0 + 3.0 * u * w * (w * (v0 + first.dv) + u * (v1 + last.dv)) + u * u * u * v1;
}

} // namespace ramure
