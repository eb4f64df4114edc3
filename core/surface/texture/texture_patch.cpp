#include "core/surface/texture/texture_patch.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ramure {

bool layFlat(const std::array<glm::dvec3, 3>& place, FlatCorners& flat)
{
    const glm::dvec3 first = place[1] - place[0], second = place[2] - place[0];
    const double square = glm::dot(first, first), part = glm::dot(first, second);
    const double doubled = std::sqrt(std::max(square * glm::dot(second, second) - part * part, 0.0));
    if (!(doubled > 1e-9 * square))
        return false;
    const double x1 = std::sqrt(square);
    flat = {x1, part / x1, doubled / x1};
    return true;
}

} // namespace ramure
