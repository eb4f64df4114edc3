/// \file
/// Files of older versions, brought up one version at a time before anything else looks at them.
#pragma once

#include "core/base/error.h"

#include <QJsonObject>
#include <span>

namespace ramure {

/// Changes the top-level object of a file of version n into one of version n + 1; "version" is set by the
/// caller.
using ProjectMigration = Expected<void> (*)(QJsonObject& root);

/// Element n - 1 takes version n to n + 1.
std::span<const ProjectMigration> projectMigrations();

/// Runs the steps from the root's version up to one past the last step. Errors: Invalid (format or version
/// missing or wrong; path), Version (newer), those of a step.
Expected<void> migrateProject(QJsonObject& root,
                              std::span<const ProjectMigration> steps = projectMigrations());

} // namespace ramure
