/// \file
/// Between the plain structs of the core and JSON; what reading and writing of projects share.
#pragma once

#include "core/base/error.h"
#include "core/params/param_def.h"
#include "core/scene/scene.h"

#include <QJsonObject>
#include <QJsonValue>

namespace ramure::json {

/// The name of the node's kind in files, also of a kind that this version does not know.
QString kindName(const Node& node);

/// Texts of several lines become arrays of lines.
QJsonValue fromParam(const ParamValue& value);
/// Error: Invalid where the JSON is of another type; the range is left to checkValue.
Expected<ParamValue> toParam(const ParamDef& def, const QJsonValue& value);

/// 16 hexadecimal digits.
QString branchKey(std::uint64_t key);
/// Error: Invalid.
Expected<std::uint64_t> branchKeyFromText(const QString& text);

QJsonObject writeNode(const Node& node);
/// The node without a check of its relations to others. Errors have a path relative to the node.
Expected<Node> readNode(const QJsonObject& object);

/// Adds what \p extras (one JSON object, or empty) holds and \p known does not, objects within objects
/// likewise.
QJsonObject merged(QJsonObject known, const std::string& extras);
/// One compact JSON object, or empty for an empty one.
std::string extrasText(const QJsonObject& extras);

/// "[3]".
std::string indexPlace(qsizetype index);
tl::unexpected<Error> failAt(std::string path, ErrorCode code, const char* text,
                             std::vector<std::string> args = {});
/// The same error, deeper inside: \p outer, then the error's path.
tl::unexpected<Error> failInside(const std::string& outer, Error error);

} // namespace ramure::json
