/// \file
/// Image files that replace the generated pictures of a surface.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace ramure {

/// The order is that of the interface and of pictureFiles.
enum class PictureMap : std::uint8_t { Colour, Normal, Roughness, Height, Occlusion, Opacity };

/// Paths as the system has them; empty: no picture. Relative ones start at the working folder, in project
/// files at the folder of the project (core/qt/document/project/project_file.h).
struct PictureParams
{
    std::string colour;    ///< sRGB
    std::string normal;    ///< tangent space, green along the branch or to the tip
    std::string roughness; ///< white is dull
    std::string height;    ///< white stands out; used where there is no picture of normals
    std::string occlusion; ///< white is open
    std::string opacity;   ///< black is not there

    [[nodiscard]] bool isEmpty() const { return *this == PictureParams(); }
    bool operator==(const PictureParams&) const = default;
};

inline constexpr std::array pictureFiles{&PictureParams::colour,    &PictureParams::normal,
                                         &PictureParams::roughness, &PictureParams::height,
                                         &PictureParams::occlusion, &PictureParams::opacity};

} // namespace ramure
