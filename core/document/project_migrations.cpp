#include "core/document/project_migrations.h"

#include "core/document/project_file.h"
#include "core/document/project_json.h"

namespace ramure {

using json::failAt;

static_assert(projectVersion == 1, "a new version needs its step in projectMigrations()");

std::span<const ProjectMigration> projectMigrations()
{
    return {};
}

Expected<void> migrateProject(QJsonObject& root, std::span<const ProjectMigration> steps)
{
    const QString formatKey = QStringLiteral("format"), versionKey = QStringLiteral("version");
    if (root.value(formatKey).toString() != QLatin1String("ramure"))
        return failAt("format", ErrorCode::Invalid,
                      RAMURE_NOOP("this is no Ramure project: \"ramure\" is expected here"));
    const qint64 present = static_cast<qint64>(steps.size()) + 1;
    const qint64 version = root.value(versionKey).toInteger(0);
    if (version < 1)
        return failAt("version", ErrorCode::Invalid, RAMURE_NOOP("a whole number from 1 is expected here"));
    if (version > present)
        return failAt(
            "version", ErrorCode::Version,
            RAMURE_NOOP(
                "the file has version %1, this program reads versions up to %2; a newer Ramure is needed"),
            {std::to_string(version), std::to_string(present)});
    for (qint64 at = version; at < present; ++at) {
        if (const auto done = steps[static_cast<std::size_t>(at - 1)](root); !done)
            return done;
        root.insert(versionKey, at + 1);
    }
    return {};
}

} // namespace ramure
