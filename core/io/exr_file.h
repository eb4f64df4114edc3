/// \file
/// Numbers as OpenEXR files: textures that shaders compute with.
#pragma once

#include "core/base/error.h"
#include <glm/vec4.hpp>
#include <span>
#include <string>

namespace ramure {

/// Pixels row by row from the top, as channels R, G, B and A of 32 bits, compressed without loss. The same
/// pixels give the same bytes. \pre width * height pixels, at least one. Errors: Io (with file).
Expected<void> writeExr(const std::string& path, int width, int height, std::span<const glm::vec4> pixels);

} // namespace ramure
