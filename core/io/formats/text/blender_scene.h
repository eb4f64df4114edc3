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
    glm::dvec3 origin{0.0};              ///< as ReadMesh has it
    std::optional<glm::dmat4> transform; ///< in its parent; none where the file says none
    std::string parent;                  ///< of a comment `# parent=NAME`
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
    std::optional<FileSpace> space; ///< of the vertices; none: what each file says, else Y up and metres
};

struct BlenderImport
{
    /// One subtree, the top first, ids from 1 on: the object, or a group of all objects.
    std::vector<Node> nodes;
    /// Frames that show all keys; default where nothing moves. The rate is what the files say, or the one of
    /// the usual rates that puts all keys on frames.
    TimelineSettings timeline;
    std::vector<Note> notes;
    std::size_t keyCount = 0;
};

/// Anything that can be imported: a folder as importBlender has it, a file of a format of the table
/// (file_format.h). Errors: Unknown (another ending), those of the format.
Expected<BlenderImport> importObjects(const std::string& path, const ImportOptions& options = {},
                                      const Progress& progress = {});

/// \param path a file of meshes, an .animation (each with the other beside it, where there is one) or a
/// folder with any number of .obj and .animation. All objects of a file are one node. The colours of its
/// materials stay with its triangles; where there is one alone, it is the node's. A file .animation alone
/// becomes a group that moves. An object with keys stands where its keys say, its TRANSFORM is that of one
/// frame; one without keys where its TRANSFORM says. What no translation, rotation and scale can say (shear,
/// mirroring, flatness) is put into the vertices of objects without keys. Errors: Io, Invalid (a space asked
/// for where there are keys), and those of the files; nothing is returned in part.
///
/// A mesh far from the origin is moved near it. Where the file says how the object stands, its own position
/// holds it where it was. All others are moved alike, so that they stand to each other as before; a note says
/// by how much.
Expected<BlenderImport> importBlender(const std::string& path, const ImportOptions& options = {},
                                      const Progress& progress = {});

struct BlenderExport
{
    std::vector<std::string> files; ///< that were written
    std::vector<Note> notes;        ///< what was sampled or left out
};

/// Writes every primitive, terrain and imported mesh of \p scene as NAME.obj and, where it moves,
/// NAME.animation into a folder that exists; groups that move as NAME.animation alone, groups that do not as
/// NAME.obj without triangles. Names are those of the nodes, made fit for files and unique. What the format
/// cannot say is sampled at the scene's frame rate: local tracks are left out. Errors: Io, Invalid (nothing
/// to write), those of objectSolid.
Expected<BlenderExport> exportBlender(const Scene& scene, const std::string& folder,
                                      const Progress& progress = {});

} // namespace ramure
