#include "core/qt/document/project/project_file.h"

#include "core/base/file_writer.h"
#include "core/qt/base/system_path.h"
#include "core/qt/document/project/old_branches.h"
#include "core/qt/document/project/project_bookmarks.h"
#include "core/qt/document/project/project_json.h"
#include "core/qt/document/project/project_migrations.h"
#include "core/qt/document/project/project_timeline.h"
#include "core/scene/growth_spaces.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <filesystem>
#include <map>

namespace ramure {

using json::failAt;
using json::failInside;

QByteArray writeProject(const Project& project)
{
    QJsonArray nodes;
    for (const Node& node : project.scene.nodes())
        nodes.append(json::writeNode(node));
    QJsonObject root{
        {QStringLiteral("format"), QStringLiteral("ramure")},
        {QStringLiteral("nodes"), nodes},
        {QStringLiteral("version"), projectVersion},
    };
    if (const QJsonObject timeline = json::writeTimeline(project.scene.timeline()); !timeline.isEmpty())
        root.insert(QLatin1String("timeline"), timeline);
    if (const QJsonObject views = json::writeBookmarks(project.scene.bookmarks()); !views.isEmpty())
        root.insert(QLatin1String("views"), views);
    return QJsonDocument(json::merged(root, project.extras)).toJson(QJsonDocument::Indented);
}

static Expected<QJsonObject> parseJson(const QByteArray& bytes)
{
    if (bytes.size() > projectSizeLimit)
        return fail(ErrorCode::Limit, RAMURE_NOOP("the file is larger than %1 MiB"),
                    {std::to_string(projectSizeLimit >> 20)});
    QJsonParseError problem;
    const QJsonDocument document = QJsonDocument::fromJson(bytes, &problem);
    if (problem.error != QJsonParseError::NoError) {
        // The parser stands behind the byte that it could not take.
        const auto offset = std::clamp<qsizetype>(problem.offset - 1, 0, bytes.size());
        const QByteArrayView before = QByteArrayView(bytes).first(offset);
        auto error = fail(ErrorCode::Syntax, RAMURE_NOOP("not readable as JSON: %1"),
                          {problem.errorString().toStdString()});
        error.value().line = static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1;
        error.value().column = static_cast<int>(offset - before.lastIndexOf('\n'));
        return error;
    }
    if (!document.isObject())
        return failAt({}, ErrorCode::Invalid,
                      RAMURE_NOOP("this is no Ramure project: an object is expected"));
    return document.object();
}

/// \param old gets the rolls and bends of branches that an older file has beside the recipes
static Expected<std::vector<Node>> readNodes(const QJsonValue& value,
                                             std::map<NodeId, json::OldBranches>& old)
{
    if (!value.isArray())
        return failAt("nodes", ErrorCode::Invalid, RAMURE_NOOP("an array is expected here"));
    const QJsonArray array = value.toArray();
    std::vector<Node> nodes;
    nodes.reserve(static_cast<std::size_t>(array.size()));
    for (qsizetype i = 0; i < array.size(); ++i) {
        const std::string place = std::string("nodes").append(json::indexPlace(i));
        if (!array[i].isObject())
            return failAt(place, ErrorCode::Invalid, RAMURE_NOOP("an object is expected here"));
        QJsonObject object = array[i].toObject();
        const bool isTree = object.value(QLatin1String("kind")) == QLatin1String("tree");
        auto branches = json::readOldBranches(isTree ? object.take(QLatin1String("branches"))
                                                     : QJsonValue(QJsonValue::Undefined));
        if (!branches)
            return failInside(place, std::move(branches.error()));
        auto node = json::readNode(object);
        if (!node)
            return failInside(place, std::move(node.error()));
        old.emplace(node->id, std::move(*branches));
        nodes.push_back(std::move(*node));
    }
    return nodes;
}

/// Reads one object of the top level, where it is there, with \p read, which takes out what it knows. Keys
/// that are not known stay where they are.
template <class T, class Read> static Expected<T> readPart(QJsonObject& root, const char* name, Read&& read)
{
    const QLatin1String key(name);
    const QJsonValue value = root.take(key);
    if (value.isUndefined())
        return T{};
    if (!value.isObject())
        return failAt(name, ErrorCode::Invalid, RAMURE_NOOP("an object is expected here"));
    QJsonObject object = value.toObject();
    Expected<T> part = read(object);
    if (!part)
        return failInside(name, std::move(part.error()));
    if (!object.isEmpty())
        root.insert(key, object);
    return part;
}

static Expected<Project> readParsed(QJsonObject root)
{
    RAMURE_TRY(migrateProject(root));
    std::map<NodeId, json::OldBranches> old;
    auto nodes = readNodes(root.take(QLatin1String("nodes")), old);
    RAMURE_TRY(nodes);
    auto scene = Scene::fromNodes(std::move(*nodes));
    if (!scene)
        return failInside("nodes", std::move(scene.error()));
    const auto timeline = readPart<TimelineSettings>(root, "timeline", json::readTimeline);
    RAMURE_TRY(timeline);
    scene->setTimeline(*timeline);
    const auto bookmarks = readPart<ViewBookmarks>(root, "views", json::readBookmarks);
    RAMURE_TRY(bookmarks);
    scene->setBookmarks(*bookmarks);
    linkGrowthSpaces(*scene);
    for (const auto& [id, branches] : old)
        json::addOldBranches(*scene->find(id), branches);
    root.remove(QLatin1String("format"));
    root.remove(QLatin1String("version"));
    return Project{std::move(*scene), json::extrasText(root)};
}

Expected<Project> readProject(const QByteArray& bytes, const QString& file)
{
    auto root = parseJson(bytes);
    Expected<Project> project = root ? readParsed(std::move(*root)) : fail(std::move(root.error()));
    if (!project)
        project.error().file = systemPath(file);
    return project;
}

/// Paths of pictures, relative to the folder of the file there, to the working folder here.
static void movePictures(Scene& scene, const QString& file, bool isRead)
{
    const QFileInfo info(file);
    const QDir folder(info.isSymLink() ? QFileInfo(info.canonicalFilePath()).absolutePath()
                                       : info.absolutePath());
    for (const Node& listed : scene.nodes())
        for (const ParamDef& def : paramTable()) {
            if ((def.flags & paramPicture) == 0 || !hasParam(listed.kind, def))
                continue;
            const std::string path = std::get<std::string>(def.get(listed.params));
            if (path.empty())
                continue;
            const QString given = pathText(path);
            const QString moved = isRead ? QDir::cleanPath(folder.absoluteFilePath(given))
                                         : folder.relativeFilePath(QFileInfo(given).absoluteFilePath());
            def.assign(scene.find(listed.id)->params, systemPath(moved));
        }
}

tl::unexpected<Error> ioError(const QString& path, const char* text, const QString& reason)
{
    auto error = fail(ErrorCode::Io, text, {reason.toStdString()});
    error.value().file = systemPath(path);
    return error;
}

Expected<Project> loadProjectFile(const QString& path)
{
    QFile file;
    if (path.isEmpty())
        return ioError(path, RAMURE_NOOP("cannot be opened: %1"), QStringLiteral("the name is empty"));
    RAMURE_TRY(openToRead(file, path));
    // One byte more than allowed tells too large a file, also where the system knows no size (a pipe).
    const QByteArray bytes = file.read(projectSizeLimit + 1);
    if (file.error() != QFileDevice::NoError)
        return ioError(path, RAMURE_NOOP("cannot be read: %1"), file.errorString());
    auto project = readProject(bytes, path);
    if (project)
        movePictures(project->scene, path, true);
    return project;
}

Expected<void> saveProjectFile(const Project& project, const QString& path)
{
    Project saved = project;
    movePictures(saved.scene, path, false);
    const QByteArray bytes = writeProject(saved);
    if (bytes.size() > projectSizeLimit) {
        auto error = fail(ErrorCode::Limit, RAMURE_NOOP("the project would be larger than %1 MiB"),
                          {std::to_string(projectSizeLimit >> 20)});
        error.value().file = path.toStdString();
        return error;
    }
    return saveAtomically(bytes, path);
}

Expected<void> saveAtomically(const QByteArray& bytes, const QString& path)
{
    // No project is a stream: a device takes it and keeps nothing.
    namespace fs = std::filesystem;
    const std::string name = systemPath(path);
    std::error_code unknown; // where nothing is known of it, writing will tell
    const fs::file_type kind = fs::status(name, unknown).type();
    if (kind != fs::file_type::not_found && kind != fs::file_type::none && kind != fs::file_type::regular &&
        kind != fs::file_type::directory)
        return ioError(path, RAMURE_NOOP("cannot be written: %1"),
                       QCoreApplication::translate("core", RAMURE_NOOP("it is a device, not a file")));
    if (path.isEmpty())
        return ioError(path, RAMURE_NOOP("cannot be written: %1"), QStringLiteral("the name is empty"));
    return writeFile(name, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

} // namespace ramure
