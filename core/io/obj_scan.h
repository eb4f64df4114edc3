/// \file
/// First half of reading an OBJ file: its lines become arrays. Internal to core/io.
#pragma once

#include "core/io/read_parts.h"
#include <map>
#include <optional>

namespace ramure::reading {

/// A line `o` or `g`: what follows belongs to it.
struct ObjMark
{
    std::string name;
    Index firstVertex;
    Index firstTriangle;
};

/// The file's lists as they are, before they are split into objects.
struct ObjLists
{
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::uvec3> triangles;
    std::vector<Index>
        normalOf; ///< per vertex the first normal that a face gave it, or noIndex; may be shorter
    std::vector<std::pair<Index, Index>> otherNormals; ///< vertex and a further normal
    std::vector<ObjMark> objects, groups;
    std::vector<std::string> notes;
    std::size_t cornersWithoutNormal = 0;
};

Expected<ObjLists> scanObj(std::string_view text, const std::string& file, const Progress& progress);

} // namespace ramure::reading
