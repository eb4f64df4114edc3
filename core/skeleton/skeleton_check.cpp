#include "core/skeleton/skeleton_check.h"

#include "core/math/finite.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <string>

namespace ramure {

/// Coordinates beyond these are refused: their squares and areas must stay inside the range of floats.
static constexpr double largestCoordinate = 1e12;

Expected<void> checkForMesh(const Skeleton& skeleton)
{
    const auto refuse = [](const char* text, Index i) {
        return fail(ErrorCode::Invalid, text, {std::to_string(i)});
    };
    for (Index i = 0; i < skeleton.size(); ++i) {
        if (!isFinite(skeleton.p0[i]) || !isFinite(skeleton.p1[i]) || !std::isfinite(skeleton.a0[i]) ||
            !std::isfinite(skeleton.a1[i]))
            return refuse(RAMURE_NOOP("Branch %1 has a coordinate or a radius that is not finite"), i);
        if (skeleton.a0[i] < 0.0 || skeleton.a1[i] < 0.0)
            return refuse(RAMURE_NOOP("Branch %1 has a negative radius"), i);
        if (skeleton.parent[i] != noIndex && skeleton.parent[i] >= i)
            return refuse(RAMURE_NOOP("Branch %1 comes before its parent"), i);
        const glm::dvec3 reach = glm::max(glm::abs(skeleton.p0[i]), glm::abs(skeleton.p1[i]));
        if (std::max({reach.x, reach.y, reach.z, skeleton.a0[i], skeleton.a1[i]}) > largestCoordinate)
            return refuse(RAMURE_NOOP("Branch %1 is too large for a mesh"), i);
    }
    return {};
}

} // namespace ramure
