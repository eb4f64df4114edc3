#include "widgets/base/fields/number_scale.h"

#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr double logarithmicFrom = 100.0; ///< maximum / minimum
constexpr double cubeFrom = 400.0;        ///< steps
constexpr double lowest = 1e-9;           ///< of the minimum: further down no logarithm leads

} // namespace

NumberScale::NumberScale(double minimum, double maximum, double step, bool whole)
    : m_minimum(minimum)
    , m_maximum(std::max(maximum, minimum))
    , m_step(step)
    , m_whole(whole)
{
    if (minimum > 0.0 && maximum / minimum >= logarithmicFrom)
        m_shape = Shape::Logarithm;
    else if (minimum == 0.0 && maximum / step >= cubeFrom)
        m_shape = Shape::Cube;
}

double NumberScale::positionOf(double value) const
{
    if (m_maximum <= m_minimum)
        return 0.0;
    switch (m_shape) {
    case Shape::Logarithm:
        return std::log(std::max(value / m_minimum, lowest)) / std::log(m_maximum / m_minimum);
    case Shape::Cube:
        return std::cbrt(value / m_maximum);
    case Shape::Linear:
        break;
    }
    return (value - m_minimum) / (m_maximum - m_minimum);
}

double NumberScale::valueAt(double position) const
{
    switch (m_shape) {
    case Shape::Logarithm:
        return m_minimum * std::pow(m_maximum / m_minimum, position);
    case Shape::Cube:
        return m_maximum * position * position * position;
    case Shape::Linear:
        break;
    }
    return m_minimum + position * (m_maximum - m_minimum);
}

double NumberScale::numberAt(double position, double precision, double factor) const
{
    const double value = valueAt(position);
    if (m_whole)
        return std::round(value);
    const double next = valueAt(position + (position < 0.0 ? -precision : precision));
    const double told = std::abs(next - value) * std::abs(factor);
    if (!(told > 0.0) || !std::isfinite(told))
        return value;
    // Divided by a power of ten, so that 0.3 is the number that is read from "0.3".
    const int digits = -static_cast<int>(std::floor(std::log10(told)));
    const double power = std::pow(10.0, std::abs(digits));
    const double shown = value * factor;
    const double round = digits >= 0 ? std::round(shown * power) / power : std::round(shown / power) * power;
    return round / factor;
}

} // namespace ramure
