/// \file
/// Reads pictures as one number a pixel: maps of density, heights of a ground.
#pragma once

#include "core/base/error.h"
#include <string>
#include <vector>

namespace ramure {

/// Rows from the top down.
struct GreyPicture
{
    int width = 0, height = 0;
    std::vector<float> values; ///< of a PNG 0 .. 1, as the file has them, of 8 or 16 bits; of an EXR the red

    /// Between the middles of the pixels, straight. \param u, v 0 .. 1 from the left and from the top;
    /// beyond, the nearest pixel
    [[nodiscard]] double at(double u, double v) const;
};

/// The file's first bytes say of which kind it is, PNG or OpenEXR. Errors, with the file: Io (not there),
/// Unknown (another kind), Invalid (damaged, or a pixel that is no finite number), Limit (over 16384 pixels a
/// side), those of readExrRows.
Expected<GreyPicture> readGreyPicture(const std::string& path);

} // namespace ramure
