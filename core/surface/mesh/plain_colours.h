/// \file
/// The colours (sRGB) of surfaces that wear no picture: those of the coursework (SPEC A3).
#pragma once

#include <glm/gtc/type_precision.hpp>

namespace ramure {

inline constexpr glm::u8vec3 plainBark{0x8B, 0x5A, 0x2B}, plainLeaf{0x3A, 0x5F, 0x0B},
    plainFruit{0x5F, 0x0B, 0x0B};

} // namespace ramure
