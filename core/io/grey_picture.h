/// \file
/// Reads pictures as one number a pixel: maps of density, heights of a ground.
#pragma once

#include "core/base/error.h"
#include <cstdint>
#include <string>
#include <vector>

namespace ramure {

/// Rows from the top down.
struct GreyPicture
{
    enum class Kind : std::uint8_t {
        Shares,  ///< 0 .. 1, of a PNG of 8 or 16 bits, as the file has them
        Numbers, ///< any, of an EXR: its red
    };
    int width = 0, height = 0;
    std::vector<float> values;
    Kind kind = Kind::Shares;

    /// Between the middles of the pixels, straight. \param u, v 0 .. 1 from the left and from the top;
    /// beyond, the nearest pixel
    [[nodiscard]] double at(double u, double v) const;
};

/// The file's first bytes say of which kind it is, PNG or OpenEXR. Errors, with the file: Io (not there),
/// Unknown (another kind), Syntax and Invalid (damaged, or a pixel that is no finite number), Limit (over
/// 16384 pixels a side).
Expected<GreyPicture> readGreyPicture(const std::string& path);

/// Internal: the channel R of an EXR file, else Y, else its first.
Expected<GreyPicture> readExrNumbers(const std::string& path);
Expected<void> checkGreySize(int width, int height);

} // namespace ramure
