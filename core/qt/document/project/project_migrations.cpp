#include "core/qt/document/project/project_migrations.h"

#include "core/qt/document/project/project_file.h"
#include "core/qt/document/project/project_json.h"

#include <QJsonArray>
#include <array>

namespace ramure {

using json::failAt;

/// What a tree's parameters must hold so that it looks and moves as it did in version 1.
static void keepTree(QJsonObject& params)
{
    const QLatin1String settledKey("physics.settled"); // trees started unloaded
    if (!params.contains(settledKey))
        params.insert(settledKey, false);
    if (!params.value(QLatin1String("grammar.stochastic")).toBool())
        return;
    for (const char* key : {"variation.angle", "variation.length", "variation.radius"})
        if (!params.contains(QLatin1String(key)))
            params.insert(QLatin1String(key), 0.0); // chance did not vary the branches
}

/// Version 1 called a terrain "relief".
static void renameTerrain(QJsonObject& node)
{
    node.insert(QLatin1String("kind"), QLatin1String("terrain"));
    for (const QLatin1String part : {QLatin1String("params"), QLatin1String("tracks")}) {
        if (!node.value(part).isObject())
            continue;
        QJsonObject renamed;
        const QJsonObject old = node.value(part).toObject();
        for (auto it = old.begin(); it != old.end(); ++it) {
            const bool isShape = it.key().startsWith(QLatin1String("relief."));
            renamed.insert(isShape ? QLatin1String("terrain.") + it.key().mid(7) : it.key(), it.value());
        }
        node.insert(part, renamed);
    }
}

/// Lets \p change the nodes of a file. What has not the shape of a project is left to the reader, which says
/// so.
static void changeNodes(QJsonObject& root, void (*change)(QJsonObject& node))
{
    const QLatin1String nodesKey("nodes");
    QJsonArray nodes = root.value(nodesKey).toArray();
    for (auto&& entry : nodes) {
        QJsonObject node = entry.toObject();
        if (!entry.isObject())
            continue;
        change(node);
        entry = node;
    }
    if (!nodes.isEmpty())
        root.insert(nodesKey, nodes);
}

static void changeTree(QJsonObject& node, void (*change)(QJsonObject& params))
{
    const QLatin1String paramsKey("params");
    const bool hasOther = node.contains(paramsKey) && !node.value(paramsKey).isObject();
    if (node.value(QLatin1String("kind")) != QLatin1String("tree") || hasOther)
        return;
    QJsonObject params = node.value(paramsKey).toObject();
    change(params);
    node.insert(paramsKey, params);
}

static Expected<void> toVersion2(QJsonObject& root)
{
    changeNodes(root, [](QJsonObject& node) {
        if (node.value(QLatin1String("kind")) == QLatin1String("relief"))
            renameTerrain(node);
        changeTree(node, keepTree);
    });
    return {};
}

/// The values of branches get their places from the tree, once it is read: see old_branches.h.
static Expected<void> toVersion3(QJsonObject& /*root*/)
{
    return {};
}

/// Twigs were as thin as they had grown, and branches left forks with their own radius: the same file gives
/// the same mesh.
static Expected<void> toVersion4(QJsonObject& root)
{
    changeNodes(root, [](QJsonObject& node) {
        changeTree(node, [](QJsonObject& params) {
            for (const QLatin1String key :
                 {QLatin1String("mesh.leastRadius"), QLatin1String("mesh.forkLength")})
                if (!params.contains(key))
                    params.insert(key, 0.0);
        });
    });
    return {};
}

/// "edits" may hold modifiers and sources too: older files have none.
static Expected<void> toVersion5(QJsonObject& /*root*/)
{
    return {};
}

static constexpr std::array<ProjectMigration, 4> allSteps{toVersion2, toVersion3, toVersion4, toVersion5};
static_assert(projectVersion == allSteps.size() + 1, "a new version needs its step");

std::span<const ProjectMigration> projectMigrations()
{
    return allSteps;
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
