/// \file
/// Mesh files: OBJ and PLY, written through one buffer with shortest round-trip numbers, and read.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/scene/material.h"
#include "core/surface/mesh/triangle_mesh.h"
#include <functional>
#include <glm/mat4x4.hpp>
#include <span>
#include <string>
#include <vector>

namespace ramure {

/// One object of a file. The mesh is not owned and must outlive the call.
struct MeshPart
{
    std::string name;                   ///< "branches", "leaves", "apples", or as read
    const TriangleMesh* mesh = nullptr; ///< without normals: none are written
    Material material;
};

/// A skeleton as a file of line segments.
struct LinePart
{
    std::string name;
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec2> lines;
};

struct WriteOptions
{
    bool ascii = false;      ///< write the text form of a format that has a binary one, too
    std::string comment{};   ///< one line in the head of the file, after the program's name; empty: none
    int mapSize = 1024;      ///< pixels a side of the pictures of materials; 0: none
    bool compressed = false; ///< a smaller file, if the format can: numbers are rounded to visible precision
    int joints = 256;        ///< most joints of a tree in a clip; 0: one per branch
    /// Gets notes on things left out or simplified; may be empty.
    std::function<void(const Error& note)> tell{};
};

/// Writes PATH and, beside it, the .mtl with the same stem, and the pictures of barks whose meshes have
/// texture coordinates (core/io/material_maps.h). Files are written under a temporary name and renamed, so
/// that an error or a cancel leaves the old ones intact. Devices and pipes are written directly, without an
/// .mtl. Texture coordinates stand in vt lines: they are split there, positions never. Errors: Io (with
/// file), Invalid (a number is not finite), Cancelled.
Expected<void> writeObj(const std::string& path, std::span<const MeshPart> parts,
                        const Progress& progress = {}, const WriteOptions& options = {});
Expected<void> writeObjLines(const std::string& path, const LinePart& lines, const Progress& progress = {},
                             const std::string& comment = {});
/// The parts joined into one vertex list with properties x y z nx ny nz red green blue branch level; normals
/// where all parts have them, texture coordinates as well (six floats per face, property list texcoord, as
/// MeshLab has it), branch and level where one has (noIndex, as an int -1, in the others).
Expected<void> writePly(const std::string& path, std::span<const MeshPart> parts, const WriteOptions& options,
                        const Progress& progress = {});
Expected<void> writePlyLines(const std::string& path, const LinePart& lines, const WriteOptions& options);

/// One object as read: polygons are cut into triangles, positions are shared as in the file.
struct ReadObject
{
    std::string name;
    TriangleMesh mesh;
    /// Per vertex its number in the file, where objects share vertices; else empty.
    std::vector<Index> fileVertex;
};
struct ReadMesh
{
    std::vector<ReadObject> objects; ///< at least one
    std::vector<std::string> notes;  ///< notes on things skipped or guessed, with line numbers
    /// Offset subtracted from the file's positions: 0 unless the file is so far from the origin that single
    /// precision would lose its shape.
    glm::dvec3 origin{0.0};
    /// All objects as one mesh, for validation: vertices that objects share in the file are one again.
    [[nodiscard]] TriangleMesh joined() const;
};

/// The text of the material file that an OBJ names. Error: Io.
using MaterialSource = std::function<Expected<std::string>(const std::string& name)>;
/// Looks beside the OBJ at \p path.
MaterialSource materialsBeside(const std::string& path);

/// Reads a mesh file; its ending picks the format (core/io/formats/file_format.h). Unknown PLY properties are
/// skipped. Texture coordinates are kept if every corner of an object has them. Colours of vertices, faces
/// and materials are kept per triangle; without any, the mesh has no colours. A material file that is missing
/// or broken, an invalid normal and an unreadable picture become notes. Indices may be negative. Errors with
/// file and line (or byte offset): Io, Syntax, Invalid (index out of range, non-finite position, points
/// without faces), Unknown (ending), Cancelled.
Expected<ReadMesh> readMeshFile(const std::string& path, const Progress& progress = {});
/// \param materials what mtllib is read from; none: it is skipped
Expected<ReadMesh> parseObj(std::string_view text, const std::string& file, const Progress& progress = {},
                            const MaterialSource& materials = {});
Expected<ReadMesh> parsePly(std::string_view bytes, const std::string& file, const Progress& progress = {});

} // namespace ramure
