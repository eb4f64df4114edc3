/// \file
/// How steep the ground is that roots hold on to.
#pragma once

#include "core/params/ground_plane.h"
#include <glm/geometric.hpp>

namespace ramure {

/// No steeper than about 63 degrees.
inline GroundPlane eased(const GroundPlane& ground)
{
    constexpr double most = 2.0;
    const double steep = glm::length(ground.grade);
    return steep > most ? GroundPlane{ground.height, most / steep * ground.grade} : ground;
}

} // namespace ramure
