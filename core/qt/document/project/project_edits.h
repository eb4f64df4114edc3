/// \file
/// The edits of a tree in project files, and one by one in scripts.
///
/// A project has "edits" in a node: a list of {"id", "op", "target": {"id", "place" ...}} and the values of
/// the operation that are not the default; "name" where it has one, "enabled" where that is false. A script
/// names limbs by their addresses alone and has "angle" and "azimuth" in degrees; all else is the same:
/// points [x, y, z, radius], shapes {"sphere": [x, y, z, r]}, {"box": [x, y, z, X, Y, Z]},
/// {"cone": [x, y, z, r, height]}, {"profile": [x, y, z, r, height, r, height ...]} and {"mesh": {"points",
/// "triangles"}}.
#pragma once

#include "core/base/error.h"
#include "core/params/tree_edit.h"

#include <QJsonArray>
#include <QJsonObject>

namespace ramure::json {

QJsonObject writeShape(const EditShape& shape);
QJsonArray writeEdits(const std::vector<TreeEdit>& edits);
/// Errors: Invalid, Unknown (path inside, "[2].at").
Expected<std::vector<TreeEdit>> readEdits(const QJsonArray& array);

/// One line of a script: an edit for each of the limbs that "target" lists, or one. Their targets have no
/// places, and ids only where the line says so.
struct ScriptEdits
{
    std::vector<TreeEdit> edits;
    bool inTreeSpace = true; ///< else "frame" is "parent"
};
/// Reads values of a step from an object of keys; other values stay. Errors: Invalid, Unknown (no such key),
/// path = "values.KEY".
Expected<void> readStepValues(const QJsonObject& object, TreeEdit& step);
/// Errors: Invalid, Unknown (operation, key), path = the key.
Expected<ScriptEdits> readScriptEdits(const QJsonObject& line);

} // namespace ramure::json
