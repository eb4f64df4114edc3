/// \file
/// An artist's own sky: a picture all around (equirectangular, linear, twice as wide as high, the zenith
/// above), with what it lights a tree with.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

namespace ramure {

struct PictureSky
{
    static constexpr int leastWidth = 16, mostWidth = 16384, mostKept = 8192;

    std::string file;
    int width = 0, height = 0;         ///< wider ones than mostKept are averaged to half of it
    std::vector<std::uint32_t> pixels; ///< from the top, as GL_RGB9_E5 has them
    glm::dvec3 sun{0.0, 1.0, 0.0};     ///< unit, towards the brightest spot, at least 2 degrees high
    glm::dvec3 sunlight{0.0};          ///< of that spot on a surface that faces it; 0: there is no sun
    int restWidth = 0;
    std::vector<glm::dvec3> rest; ///< the picture small and without its sun, for the light of all the rest

    /// Radiance of the rest. \param direction unit
    [[nodiscard]] glm::dvec3 restAt(const glm::dvec3& direction) const;
};

/// Returns where in a picture a direction is seen, 0..1 from the upper left corner. The east (X) is in the
/// middle, the south (Z) to its right.
glm::dvec2 placeInPicture(const glm::dvec3& direction);
glm::dvec3 directionInPicture(const glm::dvec2& place);

/// Reads a picture and looks for its sun: a spot of at most 3 degrees about the brightest place above the
/// horizon whose light makes a shadow. Errors: those of readLightPicture; Invalid (not twice as wide as high,
/// or black); Limit (its size).
Expected<std::shared_ptr<const PictureSky>> readPictureSky(const std::string& path,
                                                           const Progress& progress = {});

} // namespace ramure
