/// \file
/// Pictures as PNG files.
#pragma once

#include "core/base/error.h"
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace ramure {

/// Pixels of a byte a channel, row by row from the lowest one up.
struct PictureBytes
{
    int width = 0, height = 0;
    int channels = 3;       ///< 1: grey, 3: red, green, blue, 4: and alpha
    bool areColours = true; ///< true: sRGB colours; false: plain numbers that must not be converted
    std::span<const std::uint8_t> bytes;
};

/// The bytes of the file. Error: Io.
Expected<std::string> pngOf(const PictureBytes& picture);
/// A picture whose alpha is the brightness of another one, which is stretched to its size. \param colour the
/// bytes of a PNG file; empty: white, as large as the other one. Error: Invalid, one is no PNG.
Expected<std::string> maskedPng(std::string_view colour, std::string_view opacity);
/// One channel of a PNG file, from 0 (red) to 3 (alpha), as a grey picture. Errors: Invalid, no PNG, or no
/// alpha; Limit, over 16384 pixels a side.
Expected<std::string> channelPng(std::string_view picture, int channel);

} // namespace ramure
