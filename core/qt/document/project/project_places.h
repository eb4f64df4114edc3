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

} // namespace ramure::json
