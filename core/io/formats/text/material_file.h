/// \file
/// Materials of mesh files: their colours from an .mtl, and names for colours that have none.
#pragma once

#include "core/io/mesh_file.h"
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace ramure {

/// "surface_8b5a2b": whatever has this colour.
Material surfaceMaterial(const glm::u8vec3& colour);

/// The diffuse colours of an .mtl by the names of its materials, sRGB bytes.
struct MaterialColours
{
    std::map<std::string, glm::u8vec3, std::less<>> colours;
    std::vector<std::string> notes; ///< notes on statements left out, with line numbers
};

/// Never fails: lines that say no colour are passed over, a Kd that is not one or three finite numbers is
/// noted. Numbers below 0 and above 1 are taken as 0 and 1; of a name that stands twice the last counts.
/// \param file for the notes
MaterialColours parseMaterials(std::string_view text, const std::string& file);

} // namespace ramure
