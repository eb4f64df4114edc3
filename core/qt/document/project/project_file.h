/// \file
/// `.ramure` files: JSON with format, version, sorted keys, shortest round-trip numbers; defaults omitted;
/// unknown keys kept and written back; saving is atomic.
///
/// A node may also have "tracks" (project_tracks.h), a "mesh" (project_mesh.h) and "joints" (project_arm.h).
///
/// Paths of pictures are relative to the folder of the file; within the program they are absolute.
///
/// The list of nodes is flat, depth-first, siblings in their order: moving a subtree changes few lines, and
/// no depth of a scene meets a parser's limit on nesting. Parents may also stand behind their children when
/// read. Texts of several lines are arrays of lines. Numbers are in the program's units (metres, radians).
#pragma once

#include "core/base/error.h"
#include "core/scene/scene.h"
#include <QByteArray>
#include <QString>

// clang-format off
// An example:
//     {
//       "format": "ramure",
//       "nodes": [
//         {
//           "branches": {"00c0ffee00c0ffee": {"roll": 0.5}},   per-branch values by Skeleton::name, in hex;
//                                                              "place": project_places.h
//           "edits": [{"op": "cut", ...}],                     of a tree: project_edits.h
//           "id": 2,                                           any whole number from 1, unique in the file
//           "kind": "tree",
//           "locked": true,                                    left out where false
//           "name": "Oak",
//           "params": {                                        defaults are left out
//             "grammar.rules": ["A -> AB", "B -> A", ""],
//             "turtle.alpha": 0.25
//           },
//           "parent": 1,                                       left out at the top level
//           "visible": false                                   left out where true
//         }
//       ],
//       "timeline": {"framesPerSecond": 30, "lastFrame": 120}, defaults are left out
//       "version": 5,
//       "views": {"1": {"distance": 4.5, ...}}                 bookmarks by digit: project_bookmarks.h
//     }
// clang-format on

namespace ramure {

/// The contents of a project file.
struct Project
{
    Scene scene;
    std::string extras; ///< unknown keys of the top level: one JSON object, or empty
};

inline constexpr int projectVersion = 5;
inline constexpr qint64 projectSizeLimit = 256 * 1024 * 1024; ///< bytes

/// Io, of the file. \param reason takes the place of %1
tl::unexpected<Error> ioError(const QString& path, const char* text, const QString& reason = {});

QByteArray writeProject(const Project& project);
/// Errors: Syntax (not JSON: line and column), Version (newer), Limit (size), Invalid or Unknown (path =
/// place inside, such as "nodes[2].params.sections.radialDivisions"). \p file is only for messages.
Expected<Project> readProject(const QByteArray& bytes, const QString& file = {});

/// Errors: Io (missing, unreadable), and those of readProject.
Expected<Project> loadProjectFile(const QString& path);
/// Errors: Io (folder missing, read-only, full disk ...), Limit (no one could open the file again). On any
/// error the old file is intact.
Expected<void> saveProjectFile(const Project& project, const QString& path);
/// Writes any bytes that way: a temporary file beside \p path, put in its place when complete.
Expected<void> saveAtomically(const QByteArray& bytes, const QString& path);

} // namespace ramure
