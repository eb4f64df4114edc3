/// \file
/// Reading objects: any OBJ or PLY file, and scenes as a script for Blender writes them (SPEC B4): for each
/// object NAME.obj, with a line `TRANSFORM` and 16 numbers (row-major, Y up; on one line or on several)
/// behind the geometry, and NAME.animation.
#pragma once

#include "core/base/progress.h"
#include "core/io/file_space.h"
#include "core/io/formats/text/animation_file.h"
#include "core/io/mesh_file.h"
#include "core/scene/scene.h"
#include <optional>

namespace ramure {

/// One NAME.obj.
struct BlenderObject
{
    TriangleMesh mesh;                   ///< all objects of the file together
    glm::dvec3 origin{0.0};              ///< see ReadMesh::origin
    std::optional<glm::dmat4> transform; ///< in its parent; none where the file says none
    std::string parent;                  ///< name in a comment `# parent=NAME`
    std::vector<Note> notes;
};

/// Reads OBJ as parseObj does, and the TRANSFORM. Noted: what the reader skipped, TRANSFORM twice (the last
/// counts). Errors, with file and line: those of parseObj; Syntax (fewer than 16 numbers, not a number),
/// Invalid (not finite, a projection).
/// \param materials as for parseObj
Expected<BlenderObject> parseBlenderObject(std::string_view text, const std::string& file,
                                           const Progress& progress = {},
                                           const MaterialSource& materials = {});

struct ImportOptions
{
    CubicMeaning cubic = CubicMeaning::Automatic;
    std::optional<FileSpace> space; ///< space of the vertices; unset: each file says it, else Y up and metres
};

struct BlenderImport
{
    /// One subtree, the top first, ids from 1 on: the object, or a group of all objects.
    std::vector<Node> nodes;
    /// A range of frames that shows all keys; default if nothing moves. The rate comes from the files, or is
    /// the usual rate that puts all keys on frames.
    TimelineSettings timeline;
    std::vector<Note> notes;
    std::size_t keyCount = 0;
};

/// Imports objects from a folder (see importBlender) or a file of a format of the table (file_format.h).
/// Errors: Unknown (another ending), those of the format.
Expected<BlenderImport> importObjects(const std::string& path, const ImportOptions& options = {},
                                      const Progress& progress = {});

/// Imports a scene that Blender wrote as text.
/// \param path a file of meshes, an .animation (each with the other beside it, if there is one) or a folder
/// with any number of .obj and .animation.
///
/// All objects of a file become one node. The colours of its materials stay with its triangles; if there is
/// one material alone, its colour is the node's. A lone .animation becomes a group that moves. An object with
/// keys stands where its keys say, because its TRANSFORM describes a single frame. An object without keys
/// stands where its TRANSFORM says; a part of it that is no translation, rotation and scale (shear,
/// mirroring, flatness) goes into the vertices. Errors: Io, Invalid (a space is asked for although there are
/// keys), and those of the files; nothing is returned in part.
///
/// A mesh far from the origin is moved near it. If the file says how the object stands, its own position
/// holds it where it was. All others are moved alike, so that they keep their distances, and a note says by
/// how much.
Expected<BlenderImport> importBlender(const std::string& path, const ImportOptions& options = {},
                                      const Progress& progress = {});

struct BlenderExport
{
    std::vector<std::string> files; ///< the written files
    std::vector<Note> notes;        ///< notes on things sampled or left out
};

/// Writes every primitive, terrain and imported mesh of \p scene as NAME.obj and, if it moves, NAME.animation
/// into an existing folder. A group that moves becomes NAME.animation alone, a group at rest NAME.obj without
/// triangles. NAME is the node's name, made unique and fit for files. Motion that the format cannot express
/// is sampled at the scene's frame rate; local tracks are left out. Errors: Io, Invalid (nothing to write),
/// those of objectSolid.
Expected<BlenderExport> exportBlender(const Scene& scene, const std::string& folder,
                                      const Progress& progress = {});

} // namespace ramure
