/// \file
/// Image files of a surface, and generated pictures in place of missing ones.
#pragma once

#include "core/base/error.h"
#include "core/scene/material.h"
#include <QImage>
#include <cstdint>
#include <glm/vec4.hpp>
#include <memory>
#include <vector>

namespace ramure {

/// Pixels a side of the largest image file that is read.
inline constexpr int mostPictureSide = 8192;

/// Reads PNG and JPEG. \param most a larger picture is shrunk to this size; 0: it is not shrunk. Errors, all
/// with file: Io (missing, unreadable, no file), Syntax (broken, or of another format), Limit (the sides).
Expected<QImage> readPicture(const std::string& path, int most = 0);

/// Returns the problems of a surface's pictures, one error per file. It looks only at their headers, so a
/// truncated picture passes.
std::vector<Error> pictureProblems(const PictureParams& pictures);

/// Squares of the same size, rows from the foot up.
struct SurfaceImages
{
    int size = 0;
    std::vector<glm::u8vec4> colour; ///< sRGB times occlusion; opacity
    std::vector<glm::u8vec4> normal; ///< tangent space, 128 = 0; roughness, 128 is the material's
    glm::u8vec3 base{255};           ///< sRGB: the colour that the pictures have in place of the material's
    bool isCut = false;              ///< some of it is not there
    bool isAged = false;             ///< for bark: it fades out on thin branches
    std::vector<Error> problems;     ///< there are magenta checks then, in place of all pictures
};

/// \pre the material has pictures, or sprays.
SurfaceImages surfaceImages(const Material& material);

/// Returns the picture at half the size, a quarter and so on, down to one pixel. Each level has the same
/// share of opaque pixels (opacity of a half or more) as the whole, so from afar a leaf gets neither thin nor
/// solid. Castano, "Computing alpha mipmaps", 2010. \param pixels size * size of them
std::vector<std::vector<glm::u8vec4>> smallerPictures(int size, const std::vector<glm::u8vec4>& pixels);

/// A number for the files as they are now: another one where one of them was written again.
std::uint64_t pictureStamp(const PictureParams& pictures);

} // namespace ramure
