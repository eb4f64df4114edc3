#include "core/math/ring.h"

#include "core/math/reproducible.h"
#include <numbers>

namespace ramure {

glm::dvec2 ringDirection(int k, int n)
{
    const auto [sine, cosine] = maths::sincos(2.0 * std::numbers::pi * k / n);
    return {cosine, sine};
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
