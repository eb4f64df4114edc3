/// \file
/// First half of reading an OBJ file: its lines become arrays. Internal to core/io.
#pragma once

#include "core/io/read_parts.h"
#include <map>
#include <optional>

namespace ramure::reading {

inline constexpr glm::vec3 noColour{-1.0F}; ///< of a vertex that says none

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
    std::vector<glm::vec3> normals; ///< zero where the file has no numbers
    std::vector<glm::vec3> colours; ///< of the vertices, from 0 to 1 or to 255, or noColour; or empty
    std::vector<glm::uvec3> triangles;
    /// Per vertex the first normal that a face gave it, or noIndex; may be shorter.
    std::vector<Index> normalOf;
    std::vector<std::pair<Index, Index>> otherNormals; ///< vertex and a further normal
    std::vector<glm::vec2> texture;
    /// Per triangle its corners' places in texture, noIndex where a corner has none; may be shorter.
    std::vector<glm::uvec3> textureTriangles;
    std::vector<ObjMark> objects, groups;
    std::vector<ObjMark> materials;                     ///< of lines usemtl
    std::vector<std::pair<int, std::string>> libraries; ///< of lines mtllib: line, and what it names
    std::vector<std::string> notes;
    std::size_t cornersWithoutNormal = 0;

    /// Whether any corner has a normal.
    [[nodiscard]] bool givesNormals() const { return !normalOf.empty() || !otherNormals.empty(); }
};

/// \param origin is subtracted from positions, which are then read in double precision unless it is 0
Expected<ObjLists> scanObj(std::string_view text, const std::string& file, const Progress& progress,
                           const glm::dvec3& origin = glm::dvec3(0.0));
/// The same from a file, \p blockSize bytes at a time.
Expected<ObjLists> scanObj(InputFile& input, const std::string& file, const Progress& progress,
                           std::size_t blockSize = lineBlockSize, const glm::dvec3& origin = glm::dvec3(0.0));

} // namespace ramure::reading
