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

/// A picture of which each pixel is the mean of some: colours as light adds up, of what is covered; the depth
/// is the median of theirs. \pre both sides are multiples of \p each, 1 or more
BillboardPicture shrunk(const BillboardPicture& large, int each);
/// \pre it fits
void paste(BillboardPicture& onto, const BillboardPicture& what, int x, int y);
/// What is not covered at all gets the colour, normal and depth of what is nearby, so that smaller versions
/// of the picture have no fringe; alpha of the colour stays 0 there, what is covered stays as it is. Nothing
/// happens where nothing is covered. By averages over larger and larger squares (pull-push: Gortler,
/// Grzeszczuk, Szeliski, Cohen, "The Lumigraph", 1996). \pre the rectangle lies in the picture
void bleed(BillboardPicture& picture, const PixelRect& within);
/// Normals turned into other axes: those of a card, which pictures in tangent space have.
/// \pre the rectangle lies in the picture
void turnNormals(BillboardPicture& picture, const PixelRect& within, const ViewFrame& axes);

/// What is covered, in pixels; a width of 0: nothing is.
PixelRect coveredRect(const BillboardPicture& picture);

} // namespace ramure
