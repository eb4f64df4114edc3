/// \file
/// Numbers of a GLB file made small by meshoptimizer, as EXT_meshopt_compression has them (Arseny Kapoulkine,
/// Khronos Group 2020). What is rounded is told; all else comes back bit for bit. Internal to glb_format.cpp.
#pragma once

#include "core/io/formats/glb/glb_parts.h"
#include <glm/gtc/quaternion.hpp>
#include <span>

namespace ramure::glb {

/// Any values. \param stride bytes of each: a multiple of 4, up to 256
Packed packed(std::string_view values, std::size_t stride);
/// \param values become those that a reader gets: numbers of \p bits with one exponent for the components of
/// each, so that the largest is right to 2^(1 - bits) of itself. \param components of each, 1 to 4
Packed packedFloats(std::span<float> values, std::size_t components, int bits);
/// Packs directions of unit length within about a degree; w is 1 or -1. Each takes four normalised bytes.
/// \param isFine packs within a hundredth of a degree; each takes four short numbers
Packed packedDirections(std::span<const glm::vec4> directions, bool isFine = false);
/// Packs quaternions of unit length. Each takes four normalised short numbers.
Packed packedTurns(std::span<const glm::vec4> quaternions);
/// Sorts vertices and triangles so that they become small. The triangles are the same, but one may begin at
/// another of its corners; what is merged is where it was.
Packed packedTriangles(Vertices& vertices);

} // namespace ramure::glb
