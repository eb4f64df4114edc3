/// \file
/// The "views" of a project file: by their digit "1" to "9" target ([x, y, z], m), distance (m), yaw, pitch
/// and fov (rad), and orthographic, left out where false.
#pragma once

#include "core/base/error.h"
#include "core/scene/view_bookmarks.h"
#include <QJsonObject>

namespace ramure::json {

/// Empty where there is none.
QJsonObject writeBookmarks(const ViewBookmarks& bookmarks);
/// Takes what it knows out of \p object. Errors: Invalid, path = the place inside ("3.distance").
Expected<ViewBookmarks> readBookmarks(QJsonObject& object);

} // namespace ramure::json
