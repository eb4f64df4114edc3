#include "core/qt/document/project/own_presets.h"

#include "core/qt/document/project/project_file.h"
#include "core/scene/preset_scene.h"
#include <QCollator>
#include <QDir>
#include <QFile>
#include <QLocale>
#include <QStandardPaths>
#include <algorithm>
#include <utility>

namespace ramure {
namespace {

const QString ending = QStringLiteral(".ramure");

/// Also of the systems that a file is shared with.
Expected<void> checkName(const QString& name)
{
    static const QString forbidden = QStringLiteral("/\\:*?\"<>|");
    const bool fits =
        !name.isEmpty() && name.size() <= OwnPresets::longestName && !name.startsWith(u'.') &&
        name == name.trimmed() &&
        std::ranges::all_of(name, [](QChar c) { return c.isPrint() && !forbidden.contains(c); });
    if (!fits)
        return fail(
            ErrorCode::Invalid,
            RAMURE_NOOP("\"%1\": a name of 1 to %2 characters expected, without / \\ : * ? \" < > | and "
                        "without a dot in front"),
            {name.toStdString(), std::to_string(OwnPresets::longestName)});
    return {};
}

} // namespace

OwnPresets::OwnPresets()
    : OwnPresets(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
                 QStringLiteral("/presets"))
{
}

OwnPresets::OwnPresets(QString folder)
    : m_folder(std::move(folder))
{
}

QString OwnPresets::file(const QString& name) const
{
    return m_folder + u'/' + name + ending;
}

QString OwnPresets::pictureFile(const QString& name) const
{
    return m_folder + u'/' + name + QStringLiteral(".png");
}

QStringList OwnPresets::names() const
{
    QStringList names = QDir(m_folder).entryList({u'*' + ending}, QDir::Files | QDir::Readable);
    for (QString& name : names)
        name.chop(ending.size());
    QCollator order{QLocale(QLocale::English)}; // that of C knows no numbers
    order.setNumericMode(true);
    std::ranges::sort(names,
                      [&order](const QString& a, const QString& b) { return order.compare(a, b) < 0; });
    return names;
}

QString OwnPresets::freeName(const QString& wanted) const
{
    QString name = wanted;
    for (int i = 2; QFile::exists(file(name)); ++i)
        name = wanted + u' ' + QString::number(i);
    return name;
}

Expected<void> OwnPresets::checkFree(const QString& name) const
{
    if (auto fits = checkName(name); !fits)
        return fits;
    if (QFile::exists(file(name)))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\": there is a preset of this name already"),
                    {name.toStdString()});
    return {};
}

Expected<Node> OwnPresets::load(const QString& name) const
{
    auto project = loadProjectFile(file(name));
    RAMURE_TRY(project);
    const auto& nodes = project->scene.nodes();
    const auto tree = std::ranges::find(nodes, NodeKind::Tree, &Node::kind);
    if (tree == nodes.end())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("%1: there is no tree in it"),
                    {file(name).toStdString()});
    Node found = *tree;
    found.id = found.parent = noNode;
    found.name = name.toStdString();
    return found;
}

Expected<void> OwnPresets::save(const QString& name, const Node& tree) const
{
    if (auto free = checkFree(name); !free)
        return free;
    if (!QDir().mkpath(m_folder))
        return fail(ErrorCode::Io, RAMURE_NOOP("cannot make the folder %1"), {m_folder.toStdString()});
    Node kept = tree;
    kept.id = 1;
    kept.parent = noNode;
    kept.name = name.toStdString();
    kept.visible = true;
    kept.locked = false;
    kept.animation = {};
    kept.params.tree = {};
    auto scene = Scene::fromNodes({std::move(kept)});
    RAMURE_TRY(scene);
    return saveProjectFile({std::move(*scene), {}}, file(name));
}

Expected<void> OwnPresets::rename(const QString& name, const QString& other) const
{
    if (name == other)
        return {};
    if (auto free = checkFree(other); !free)
        return free;
    QFile own(file(name));
    if (!own.rename(file(other)))
        return fail(ErrorCode::Io, RAMURE_NOOP("%1: cannot be renamed: %2"),
                    {file(name).toStdString(), own.errorString().toStdString()});
    QFile::rename(pictureFile(name), pictureFile(other));
    return {};
}

Expected<void> OwnPresets::remove(const QString& name) const
{
    QFile own(file(name));
    if (!own.moveToTrash())
        return fail(ErrorCode::Io, RAMURE_NOOP("%1: cannot be moved to the trash: %2"),
                    {file(name).toStdString(), own.errorString().toStdString()});
    QFile::remove(pictureFile(name));
    return {};
}

Expected<Node> namedTree(const QString& preset)
{
    const QString mark = QLatin1String(OwnPresets::mark);
    return preset.startsWith(mark) ? OwnPresets().load(preset.mid(mark.size()))
                                   : presetTree(preset.toStdString());
}

} // namespace ramure
