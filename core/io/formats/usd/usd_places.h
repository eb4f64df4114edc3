/// \file
/// Where prims of a USD layer stand, and copies. Internal to the formats.
#pragma once

#include "core/io/formats/usd/usd_layer.h"
#include <glm/mat4x4.hpp>

namespace ramure::usd {

/// The place of a prim as seen from the one above it, of one that moves its first. \param notes get the
/// operations that are not known. Error: Invalid, with the line.
Expected<glm::dmat4> placeOf(const Prim& prim, std::vector<std::string>& notes);

struct Copy
{
    std::size_t prototype = 0;
    glm::dmat4 place{1.0};
};
/// Of a PointInstancer. Errors: Invalid (lists that do not fit, an index out of range), Limit.
Expected<std::vector<Copy>> copiesOf(const Prim& prim);

} // namespace ramure::usd
