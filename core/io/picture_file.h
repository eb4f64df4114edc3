/// \file
/// Pictures as PNG files.
#pragma once

#include "core/base/error.h"
#include <cstdint>
#include <span>
#include <string>

namespace ramure {

/// Pixels of a byte a channel, row by row from the lowest one up.
struct PictureBytes
{
    int width = 0, height = 0;
    int channels = 3;       ///< 1: grey, 3: red, green, blue
    bool areColours = true; ///< sRGB; else numbers, which nobody may convert
    std::span<const std::uint8_t> bytes;
};

/// Error: Io (with file).
Expected<void> writePng(const std::string& path, const PictureBytes& picture);

} // namespace ramure
