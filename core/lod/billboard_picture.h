/// \file
/// The two pictures of a billboard: colour with coverage, normal with depth.
#pragma once

#include "core/lod/billboard.h"
#include <cstdint>
#include <functional>
#include <glm/gtc/type_precision.hpp>

namespace ramure {

/// Rows from the top.
struct BillboardPicture
{
    int width = 0, height = 0;
    std::vector<glm::u8vec4> colour; ///< sRGB; alpha: how much of the pixel is covered
    std::vector<glm::u8vec4> normal; ///< 0..255 for -1..1; alpha: depth, 1 the farthest, 255 the nearest;
                                     ///< where nothing is and nothing was bled, all is 0

    BillboardPicture() = default;
    BillboardPicture(int w, int h)
        : width(w)
        , height(h)
        , colour(std::size_t(w) * std::size_t(h), glm::u8vec4(0))
        , normal(colour)
    {
    }
    [[nodiscard]] std::size_t at(int x, int y) const
    {
        return std::size_t(y) * std::size_t(width) + std::size_t(x);
    }
};

/// Shrinks a picture. Each pixel becomes the mean of \p each x \p each pixels: colours add up as light,
/// covered pixels only; the depth is their median. \pre both sides are multiples of \p each, 1 or more
BillboardPicture shrunk(const BillboardPicture& large, int each);
/// \pre it fits
void paste(BillboardPicture& onto, const BillboardPicture& what, int x, int y);
/// Fills uncovered pixels with the colour, normal and depth of their nearest covered neighbours, so that
/// smaller versions of the picture have no fringe. Their alpha stays 0, and covered pixels stay as they are.
/// A picture without covered pixels is not changed. The method averages over larger and larger squares
/// (pull-push: Gortler, Grzeszczuk, Szeliski, Cohen, "The Lumigraph", 1996). \pre the rectangle lies in the
/// picture
void bleed(BillboardPicture& picture, const PixelRect& within);
/// Turns normals into the axes of a card, as pictures in tangent space need them. \pre the rectangle lies in
/// the picture
void turnNormals(BillboardPicture& picture, const PixelRect& within, const ViewFrame& axes);

/// Returns the smallest rectangle around the covered pixels. Zero width means that nothing is covered.
PixelRect coveredRect(const BillboardPicture& picture);

} // namespace ramure
