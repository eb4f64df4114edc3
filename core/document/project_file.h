/// \file
/// `.ramure` files: JSON with format, version, sorted keys, shortest round-trip numbers; defaults omitted;
/// unknown keys kept and written back; saving is atomic.
#pragma once

#include "core/base/error.h"
#include "core/scene/scene.h"
#include <QByteArray>
#include <QString>

namespace ramure {

/// What a file holds besides the scene.
struct Project
{
    Scene scene;
    std::string extras; ///< unknown keys of the top level: one JSON object, or empty
};

inline constexpr int projectVersion = 1;

QByteArray writeProject(const Project& project);
/// Errors: Syntax (not JSON: line and column), Version (newer), Invalid (path = place inside, such as
/// "nodes[2].params.sections.radialDivisions"). \p file is only for messages.
Expected<Project> readProject(const QByteArray& bytes, const QString& file = {});

Expected<Project> loadProjectFile(const QString& path);
/// QSaveFile: on any error the old file is intact.
Expected<void> saveProjectFile(const Project& project, const QString& path);

} // namespace ramure
