/// \file
/// The "mesh" of an imported object in a project file. Imported meshes are embedded: a project is one file
/// that can be moved, sent and recovered, and nothing on the disk can change it behind the program's back.
///
///     "mesh": {"indices": "...", "normals": "...", "positions": "..."}
///
/// Each text is base64 of little-endian numbers of 32 bits: three floats per vertex (metres), three of its
/// normal (left out where there are none), three whole numbers per triangle.
#pragma once

#include "core/base/error.h"
#include "core/mesh/triangle_mesh.h"
#include <QJsonObject>

namespace ramure::json {

QJsonObject writeMesh(const TriangleMesh& mesh);
/// Takes what it knows out of \p object. Errors: Invalid, path = the key inside.
Expected<TriangleMesh> readMesh(QJsonObject& object);

} // namespace ramure::json
