#include "core/surface/season/climate.h"

#include "core/math/angle.h"
#include "core/math/reproducible.h"
#include <algorithm>

namespace ramure {
namespace {

using Months = std::array<double, 12>;
constexpr Months rennes{6, 6.5, 9, 11.5, 14.5, 17.5, 19.5, 19.5, 17, 13.5, 9.5, 6.5};
constexpr Months cracow{-1.5, 0, 4, 9.5, 14.5, 18, 20, 19, 14.5, 9, 4, 0};
constexpr Months jyvaskyla{-8, -8, -3.5, 2, 9, 14, 16.5, 14.5, 9.5, 4, -1, -5.5};
/// Days from the beginning of the year to the middle of each month.
constexpr Months middles{15.5, 45, 74.5, 105, 135.5, 166, 196.5, 227.5, 258, 288.5, 319, 349.5};

int wrapped(int month)
{
    return (month + 12) % 12;
}
double middleOf(int month)
{
    return middles[std::size_t(wrapped(month))] + (month < 0 ? -daysOfYear : month > 11 ? daysOfYear : 0);
}

/// A cubic through the middles of the months, whose slopes are those between their neighbours.
Climate yearOf(double latitude, const Months& months)
{
    const auto value = [&](int month) { return months[std::size_t(wrapped(month))]; };
    const auto slope = [&](int month) {
        return (value(month + 1) - value(month - 1)) / (middleOf(month + 1) - middleOf(month - 1));
    };
    Climate out{latitude, {}};
    for (int day = 0; day < daysOfYear; ++day) {
        const double at = day + 0.5;
        const int month = int(std::ranges::upper_bound(middles, at) - middles.begin()) - 1;
        const double length = middleOf(month + 1) - middleOf(month), t = (at - middleOf(month)) / length;
        const double u = 1.0 - t;
        out.mean[std::size_t(day)] =
            u * u * ((1.0 + 2.0 * t) * value(month) + t * length * slope(month)) +
            t * t * ((1.0 + 2.0 * u) * value(month + 1) - u * length * slope(month + 1));
    }
    return out;
}

} // namespace

const Climate& climateOf(SeasonClimate climate)
{
    static const std::array years{yearOf(48.1, rennes), yearOf(50.1, cracow), yearOf(62.2, jyvaskyla)};
    return years[static_cast<std::size_t>(climate)];
}

double dayLength(double latitude, int day)
{
    const double tilt = -23.44 * oneDegree * maths::cos(2.0 * pi * (day + 10) / daysOfYear);
    const double north = latitude * oneDegree;
    // The upper rim of the sun, lifted by the air, stands at the horizon.
    const double noon = (maths::sin(-0.833 * oneDegree) - maths::sin(north) * maths::sin(tilt)) /
                        (maths::cos(north) * maths::cos(tilt));
    return 24.0 / pi * maths::acos(std::clamp(noon, -1.0, 1.0));
}

} // namespace ramure
