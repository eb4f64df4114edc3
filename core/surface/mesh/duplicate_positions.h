/// \file
/// Which vertices of a mesh lie at the position of another one: the mesher moves them apart, the validation
/// reports them.
#pragma once

#include "core/base/index.h"
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace ramure {

struct DuplicatePosition
{
    Index vertex;
    Index earlier; ///< the first vertex at that position
};

/// Every vertex at the position of an earlier one (bits compared, -0 = 0), in order.
std::vector<DuplicatePosition> findDuplicatePositions(std::span<const glm::vec3> positions);

} // namespace ramure
