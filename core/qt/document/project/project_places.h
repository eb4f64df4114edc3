/// \file
/// The places of edited branches in project files: the address and the looks of their axes.
#pragma once

#include "core/base/error.h"
#include "core/scene/scene.h"

#include <QJsonObject>

namespace ramure::json {

/// "tree" and each axis' "id" have 16 digits of hex; "way" goes from a root to the branch's own axis.
QJsonObject writePlace(const BranchPlace& place);
/// Undefined: no place. Errors: Invalid (path inside).
Expected<BranchPlace> readPlace(const QJsonValue& value);
/// Files before version 3 knew branches by their keys alone: grows the tree once and takes the places from
/// there. What has no branch, or no tree that can be grown, keeps its key.
void findOldEdits(Node& node);

} // namespace ramure::json
