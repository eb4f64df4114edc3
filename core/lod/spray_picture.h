/// \file
/// The pictures of cards: what each of them shows, drawn onto its place in one square. The same atlas gives
/// the same bytes on every machine.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/lod/card_atlas.h"
#include <glm/vec4.hpp>

namespace ramure {

/// Squares of the same size, rows from below.
struct SprayMaps
{
    int size = 0;                    ///< pixels a side
    std::vector<glm::u8vec4> colour; ///< sRGB of the tones' material; opacity: a half or more is opaque
    std::vector<glm::u8vec3> normal; ///< tangent space, x to the right, y up, z to the eye; 128 = 0
};

inline constexpr int leastSpraySize = 64, mostSpraySize = 4096;

/// The smaller versions of the opacity show as much leaf as the whole picture does (mip_coverage.h). Errors:
/// Invalid (a size that is out of range or no power of two), Cancelled.
Expected<SprayMaps> sprayMaps(const CardAtlas& atlas, int size, const Progress& progress = {});

} // namespace ramure
