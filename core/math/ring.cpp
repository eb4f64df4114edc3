#include "core/math/ring.h"

#include <cmath>
#include <numbers>

namespace ramure {

glm::dvec2 ringDirection(int k, int n)
{
    const double angle = 2.0 * std::numbers::pi * k / n;
    return {std::cos(angle), std::sin(angle)};
}

std::vector<glm::dvec2> unitCircle(int n)
{
    std::vector<glm::dvec2> circle;
    circle.reserve(static_cast<std::size_t>(n));
    for (int k = 0; k < n; ++k)
        circle.push_back(ringDirection(k, n));
    return circle;
}

} // namespace ramure
