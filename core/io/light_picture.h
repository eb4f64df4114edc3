/// \file
/// Reads pictures of light, whose numbers are linear and may exceed 1: Radiance HDR (RGBE; Ward, "Real
/// Pixels", Graphics Gems II, 1991) and OpenEXR. Row by row, since they may be larger than what is kept of
/// them.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <string>

namespace ramure {

/// What takes a picture. An error of either function ends the reading with it.
struct LightRows
{
    std::function<Expected<void>(int width, int height)> begin;
    /// From the top; every number is finite and at least 0.
    std::function<Expected<void>(int y, std::span<const glm::vec3> row)> add;
};

/// The file's first bytes say of which kind it is. Numbers beyond the largest of 16 bits, the sun's above
/// all, become that; negative ones become 0. Errors, with the file: Io (not there), Syntax (no such picture,
/// or damaged), Invalid (not a number, with its row and column), those of rows.begin, Cancelled.
Expected<void> readLightPicture(const std::string& path, const LightRows& rows,
                                const Progress& progress = {});

/// Internal: the two kinds, whose rows are as the file has them. An EXR file's library throws no further.
Expected<void> readRadianceRows(const std::string& path, const LightRows& rows);
Expected<void> readExrRows(const std::string& path, const LightRows& rows);

} // namespace ramure
