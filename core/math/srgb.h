/// \file
/// Colours as bytes of sRGB and as linear light, 0..1 (IEC 61966-2-1).
#pragma once

#include <cstdint>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec3.hpp>

namespace ramure {

double linearOf(std::uint8_t channel);
glm::vec3 linearOf(const glm::u8vec3& colour);
/// The nearest byte.
std::uint8_t srgbOf(double linear);
glm::u8vec3 srgbOf(const glm::vec3& linear);

} // namespace ramure
