/// \file
/// How much of the sky the places in a crown see: inner leaves and branches are darker, and a crown is lit as
/// one round shape. Made once for all leaves, on a coarse grid.
#pragma once

#include "core/surface/foliage/foliage.h"
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace ramure {

struct CrownLight
{
    glm::ivec3 cells{0};
    glm::dmat4 place{1.0}; ///< from the tree's space to 0..1 over the grid
    std::vector<glm::u8vec4>
        light; ///< per cell, X fastest: the mean way out, -1..1 as bytes; share of the sky
};

/// Nothing (no cells) where there are no leaves.
CrownLight crownLight(const Foliage& foliage, double alpha);

} // namespace ramure
