/// \file
/// The axes and the unit of a mesh file. The program itself has Y up and metres.
#pragma once

#include "core/base/error.h"
#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace ramure {

enum class UpAxis : std::uint8_t { Y, Z };

/// The unit of lengths in a file.
struct LengthUnit
{
    const char* name; ///< the name in files and on the command line: "cm"
    double metres;
};
inline constexpr LengthUnit lengthUnits[] = {{"m", 1.0},  {"cm", 0.01},   {"mm", 0.001},
                                             {"km", 1e3}, {"in", 0.0254}, {"ft", 0.3048}};

/// How a file says where things are: numbers are lengths in a unit, and may be enlarged besides.
struct FileSpace
{
    static constexpr double leastScale = 1e-6, mostScale = 1e6;

    UpAxis up = UpAxis::Y;
    std::size_t unit = 0; ///< index into lengthUnits
    double scale = 1.0;   ///< leastScale..mostScale

    /// Nothing to do: the file's numbers are the program's.
    [[nodiscard]] bool isOwn() const { return *this == FileSpace(); }
    /// From the program's space into the file's: a rotation and a scale that is the same all around.
    [[nodiscard]] glm::dmat4 matrix() const;
    /// "up z, unit cm, scale 2" for the head of the file; empty where nothing is to be said.
    [[nodiscard]] std::string comment() const;
    bool operator==(const FileSpace&) const = default;
};

/// Each by its name. Errors: Unknown (with the names there are), Invalid (not above 0, or too large).
Expected<UpAxis> upAxisNamed(const std::string& name);
Expected<std::size_t> lengthUnitNamed(const std::string& name);
Expected<double> fileScaleOf(double number);

/// Returns the space that FileSpace::comment wrote into the first lines of an OBJ or PLY file, if any.
std::optional<FileSpace> fileSpaceIn(std::string_view head);
/// The same, of a file on the disk. Nothing where it cannot be read.
std::optional<FileSpace> fileSpaceOf(const std::string& path);

} // namespace ramure
