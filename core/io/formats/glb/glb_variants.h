/// \file
/// What meshes look like at other times of the year: KHR_materials_variants (Khronos Group 2020), and
/// _SEASON, the number by which shaders know when a leaf turns.
#pragma once

#include "core/io/formats/glb/glb_parts.h"

namespace ramure::glb {

class Variants
{
public:
    /// Tells a primitive which materials it has. \param materials per variant of the seasons its number
    void tell(Json& primitive, const ExportSeasons& seasons, const std::vector<std::size_t>& materials);
    /// The names, and the extension, if there are some.
    void addTo(Json& root) const;

private:
    std::size_t numberOf(const std::string& name);

    std::vector<std::string> m_names;
};

/// Per vertex the number of its piece. \param from per vertex its vertex in a mesh with so many vertices,
/// which are parted evenly among the pieces.
std::vector<glm::vec1> phasesOf(const ExportSeasons& seasons, const std::vector<Index>& from,
                                std::size_t vertices);

} // namespace ramure::glb
