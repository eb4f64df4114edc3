/// \file
/// The pictures of sprays: twigs drawn onto the cells of an atlas, from above and from the side. The same
/// atlas gives the same bytes on every machine.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/lod/leaf_sprays.h"
#include <glm/vec4.hpp>

namespace ramure {

/// Squares of the same size, rows from below, as sprayCards() has their coordinates.
struct SprayMaps
{
    int size = 0;                    ///< pixels a side
    std::vector<glm::u8vec4> colour; ///< sRGB of the tones' material, and how much of the pixel is covered
    std::vector<glm::u8vec3> normal; ///< tangent space, x to the right, y up, z to the eye; 128 = 0
    /// What is opaque where the opacity is at least this (0..1): chosen so that the pictures at half the
    /// size, a quarter and an eighth show as much leaf as the whole one does.
    float cutoff = 0.5F;
};

inline constexpr int leastSpraySize = 64, mostSpraySize = 4096;

/// Errors: Invalid (a size out of range), Cancelled.
Expected<SprayMaps> sprayMaps(const SprayAtlas& atlas, int size, const Progress& progress = {});

/// The share of the pixels of a picture that are opaque at a cutoff, for the picture itself and at half the
/// size, a quarter and so on, as many as asked for. \pre the size is a power of two.
std::vector<double> coverageOfMips(const SprayMaps& maps, float cutoff, int levels);

} // namespace ramure
