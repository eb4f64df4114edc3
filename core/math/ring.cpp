#include "core/math/ring.h"

#include "core/math/reproducible.h"
#include <numbers>

namespace ramure {

glm::dvec2 ringDirection(int k, int n)
{
    const auto [sine, cosine] = maths::sincos(2.0 * std::numbers::pi * k / n);
    return {cosine, sine};
}

} // namespace ramure
