#include "core/qt/session/export/packing.h"

#include "core/qt/document/commands.h"
#include "core/qt/document/document_command.h"
#include "core/qt/document/project/project_file.h"
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <map>

namespace ramure {
namespace {

Expected<QByteArray> bytesOf(const QString& path)
{
    QFile file(path);
    if (!QFileInfo(path).isFile() || !file.open(QIODevice::ReadOnly))
        return ioError(path, RAMURE_NOOP("the file cannot be read"));
    QByteArray bytes = file.readAll();
    if (file.error() != QFileDevice::NoError)
        return ioError(path, RAMURE_NOOP("the file cannot be read"));
    return bytes;
}

/// One picture that a node wears.
struct Worn
{
    NodeId node;
    const ParamDef* def;
    QString path; ///< absolute
};

std::vector<Worn> wornOutside(const Scene& scene, const QDir& folder)
{
    std::vector<Worn> out;
    for (const Node& node : scene.nodes())
        for (const ParamDef& def : paramTable()) {
            if ((def.flags & paramPicture) == 0 || !hasParam(node.kind, def))
                continue;
            const std::string path = std::get<std::string>(def.get(node.params));
            const QString absolute = QFileInfo(QFile::decodeName(path.c_str())).absoluteFilePath();
            if (!path.empty() && folder.relativeFilePath(absolute).startsWith(QLatin1String("..")))
                out.push_back({node.id, &def, absolute});
        }
    return out;
}

/// \returns where the copy lies.
Expected<QString> copied(const QString& from, const QDir& into)
{
    const auto bytes = bytesOf(from);
    RAMURE_TRY(bytes);
    const QFileInfo info(from);
    for (int number = 1;; ++number) {
        const QString name =
            number == 1
                ? info.fileName()
                : QStringLiteral("%1-%2.%3").arg(info.completeBaseName()).arg(number).arg(info.suffix());
        const QString path = into.filePath(name);
        if (QFileInfo::exists(path)) {
            if (bytesOf(path).value_or(QByteArray()) == *bytes)
                return path;
            continue;
        }
        QSaveFile file(path);
        if (!file.open(QIODevice::WriteOnly) || file.write(*bytes) != bytes->size() || !file.commit())
            return ioError(path, RAMURE_NOOP("the file cannot be written: %1"), file.errorString());
        return path;
    }
}

} // namespace

QString packedFolder(const QString& projectPath)
{
    const QFileInfo info(projectPath);
    return info.absoluteDir().filePath(info.completeBaseName() + QStringLiteral(" pictures"));
}

Expected<std::size_t> edit::packPictures(Document& document)
{
    if (document.filePath().isEmpty())
        return fail(
            ErrorCode::Invalid,
            RAMURE_NOOP("the scene has no file yet: save it first, its pictures are copied beside it"));
    const std::vector<Worn> all = wornOutside(document.scene(), QFileInfo(document.filePath()).absoluteDir());
    for (const Worn& worn : all)
        if (document.scene().isLocked(worn.node))
            return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" is locked"),
                        {document.scene().find(worn.node)->name});
    if (all.empty())
        return 0;
    const QDir folder(packedFolder(document.filePath()));
    if (!QDir().mkpath(folder.path()))
        return ioError(folder.path(), RAMURE_NOOP("the folder cannot be made"));
    std::map<QString, QString> copies;
    for (const Worn& worn : all) {
        if (copies.contains(worn.path))
            continue;
        auto copy = copied(worn.path, folder);
        RAMURE_TRY(copy);
        copies.emplace(worn.path, *copy);
    }
    const OneStep step(document, DocumentCommand::tr("Pack pictures"));
    Expected<void> done;
    for (const Worn& worn : all)
        if (done)
            done = setParam(document, {worn.node}, *worn.def,
                            QFile::encodeName(copies.at(worn.path)).toStdString());
    RAMURE_TRY(done);
    return copies.size();
}

} // namespace ramure
