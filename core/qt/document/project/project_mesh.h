/// \file
/// The "mesh" of an imported object, or of an arm that wears one, in a project file. Imported meshes are
/// embedded: a project is one file that can be moved, sent and recovered, and nothing on the disk can change
/// it behind the program's back.
///
///     "mesh": {"colours": "...", "indices": "...", "normals": "...", "positions": "...", "uv": "...",
///              "uvIndices": "..."}
///
/// Each text is base64 of little-endian numbers of 32 bits: three floats per vertex (metres), three of its
/// normal, three whole numbers per triangle; two floats per texture coordinate and, where those are not one
/// per vertex, three whole numbers per triangle. Colours are three bytes per triangle (sRGB). What a mesh
/// does not have is left out.
#pragma once

#include "core/base/error.h"
#include "core/surface/mesh/triangle_mesh.h"
#include <QJsonObject>

namespace ramure::json {

QJsonObject writeMesh(const TriangleMesh& mesh);
/// Takes what it knows out of \p object. Errors: Invalid, path = the key inside.
Expected<TriangleMesh> readMesh(QJsonObject& object);

} // namespace ramure::json
