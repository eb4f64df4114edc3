#include "core/rig/tracks/easing.h"

#include "core/math/angle.h"
#include "core/math/reproducible.h"
#include <algorithm>
#include <array>
#include <cmath>

namespace ramure {
namespace {

double bounceOut(double x)
{
    constexpr double n = 7.5625, k = 2.75;
    if (x < 1.0 / k)
        return n * x * x;
    if (x < 2.0 / k)
        return n * (x - 1.5 / k) * (x - 1.5 / k) + 0.75;
    if (x < 2.5 / k)
        return n * (x - 2.25 / k) * (x - 2.25 / k) + 0.9375;
    return n * (x - 2.625 / k) * (x - 2.625 / k) + 0.984375;
}

/// The way in; the other easings are this one turned round.
double easeIn(KeyMode mode, double x, double back)
{
    switch (mode) {
    case KeyMode::Sine:
        return 1.0 - maths::cos(x * pi / 2.0);
    case KeyMode::Quad:
        return x * x;
    case KeyMode::CubicEase:
        return x * x * x;
    case KeyMode::Quart:
        return x * x * x * x;
    case KeyMode::Quint:
        return x * x * x * x * x;
    case KeyMode::Expo: {
        const double least = maths::exp2(-10.0);
        return (maths::exp2(10.0 * (x - 1.0)) - least) / (1.0 - least);
    }
    case KeyMode::Circ:
        return 1.0 - std::sqrt(std::max(0.0, 1.0 - x * x));
    case KeyMode::Back:
        return x * x * ((back + 1.0) * x - back);
    case KeyMode::Bounce:
        return 1.0 - bounceOut(1.0 - x);
    default:
        return x;
    }
}

/// A damped swing. \p tau runs from -1 to 0; \p half of an ease in and out.
double elastic(const KeyShape& shape, double tau, double duration, double change, bool rising, double half)
{
    const double period = shape.period != 0.0 ? shape.period : duration * (half == 1.0 ? 0.3 : 0.45);
    double size = shape.amplitude / change; // of the swing, as a share of the change
    double shift = period / 4.0, blend = 1.0;
    if (shape.amplitude == 0.0 || shape.amplitude < std::abs(change)) {
        blend *= shape.amplitude / std::abs(change);
        if (const double from = std::abs(tau * duration); from < std::abs(shift)) {
            const double share = from / std::abs(shift);
            blend = blend * share + 1.0 - share;
        }
        size = 1.0;
    } else {
        shift = period / (2.0 * pi) * maths::asin(change / shape.amplitude);
    }
    const double swing = half * blend * size * maths::exp2(10.0 * tau) *
                         maths::sin((tau * duration - shift) * 2.0 * pi / period);
    return rising ? -swing : 1.0 + swing;
}

double elasticShare(const KeyShape& shape, Easing easing, double x, double duration, double change)
{
    if (change == 0.0)
        return x; // nothing swings
    switch (easing) {
    case Easing::In:
        return elastic(shape, x - 1.0, duration, change, true, 1.0);
    case Easing::InOut: {
        const double tau = 2.0 * x - 1.0;
        return elastic(shape, -std::abs(tau), duration, change, tau < 0.0, 0.5);
    }
    default:
        return elastic(shape, -x, duration, change, false, 1.0);
    }
}

Easing automatic(KeyMode mode)
{
    return mode >= KeyMode::Back ? Easing::Out : Easing::In;
}

} // namespace

double easedShare(const KeyShape& shape, double x, double durationSeconds, double change)
{
    if (x <= 0.0)
        return 0.0;
    if (x >= 1.0)
        return 1.0;
    const Easing easing = shape.easing == Easing::Auto ? automatic(shape.mode) : shape.easing;
    if (shape.mode == KeyMode::Elastic)
        return elasticShare(shape, easing, x, durationSeconds, change);
    if (easing == Easing::In)
        return easeIn(shape.mode, x, shape.back);
    if (easing == Easing::Out)
        return 1.0 - easeIn(shape.mode, 1.0 - x, shape.back);
    const double back = shape.back * 1.525;
    return x < 0.5 ? 0.5 * easeIn(shape.mode, 2.0 * x, back)
                   : 1.0 - 0.5 * easeIn(shape.mode, 2.0 - 2.0 * x, back);
}

static constexpr std::array<const char*, keyModeCount> modeNames{
    "CONSTANT", "LINEAR", "BEZIER", "SPLINE", "SINE", "QUAD",   "CUBIC",
    "QUART",    "QUINT",  "EXPO",   "CIRC",   "BACK", "BOUNCE", "ELASTIC"};
static constexpr std::array<const char*, easingCount> easingNames{"AUTO", "EASE_IN", "EASE_OUT",
                                                                  "EASE_IN_OUT"};
static constexpr std::array<const char*, handleTypeCount> handleNames{"FREE", "ALIGNED", "VECTOR", "AUTO",
                                                                      "AUTO_CLAMPED"};

const char* keyModeName(KeyMode mode)
{
    return modeNames[static_cast<std::size_t>(mode)];
}

const char* easingName(Easing easing)
{
    return easingNames[static_cast<std::size_t>(easing)];
}

const char* handleTypeName(HandleType type)
{
    return handleNames[static_cast<std::size_t>(type)];
}

} // namespace ramure
