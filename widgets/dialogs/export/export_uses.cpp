#include "widgets/dialogs/export/export_uses.h"

#include "core/io/formats/file_format.h"
#include "widgets/view/render/passes/film_file.h"
#include <QCoreApplication>
#include <algorithm>

namespace ramure {
namespace {

struct UseRow
{
    const char* key;
    const char* title;
    const char* tip;
    QStringList formats;
};

const UseRow& rowOf(ExportUse use)
{
    static const UseRow rows[] = {
        {"blender",
         QT_TRANSLATE_NOOP("ExportUses", "For Blender"),
         QT_TRANSLATE_NOOP("ExportUses",
                           "For Blender and other modelling programs: every format of meshes, models and "
                           "axes"),
         {}},
        {"game",
         QT_TRANSLATE_NOOP("ExportUses", "For a game"),
         QT_TRANSLATE_NOOP("ExportUses", "Levels of detail by budgets of triangles, a skin, a loop of wind"),
         {QStringLiteral("glb"), QStringLiteral("usda"), QStringLiteral("usdz"), QStringLiteral("obj")}},
        {"print",
         QT_TRANSLATE_NOOP("ExportUses", "For print"),
         QT_TRANSLATE_NOOP("ExportUses",
                           "For a 3D printer: one closed surface, thick enough, in millimetres"),
         {QStringLiteral("3mf"), QStringLiteral("stl")}},
        {"web",
         QT_TRANSLATE_NOOP("ExportUses", "For the web"),
         QT_TRANSLATE_NOOP("ExportUses", "One small file with its pictures, which can move without end"),
         {QStringLiteral("glb")}},
        {"pictures", QT_TRANSLATE_NOOP("ExportUses", "Pictures"),
         QT_TRANSLATE_NOOP("ExportUses",
                           "PNG pictures of the view: one, a sequence, or from all sides; or a film"),
         viewFormats()},
    };
    return rows[static_cast<std::size_t>(use)];
}

} // namespace

const QStringList& viewFormats()
{
    static const QStringList formats = [] {
        QStringList all{pictureFormat};
        for (const char* film : filmEndings)
            all += QString::fromLatin1(film);
        return all;
    }();
    return formats;
}

QStringList formatsOf(ExportUse use)
{
    QStringList formats;
    if (use != ExportUse::Blender) {
        for (const QString& id : rowOf(use).formats)
            if (viewFormats().contains(id) ||
                std::ranges::any_of(
                    fileFormats(), [&](const FileFormat* format) { return id == QLatin1String(format->id); }))
                formats += id;
        return formats;
    }
    const QStringList prints = rowOf(ExportUse::Print).formats;
    for (const FileFormat* format : fileFormats())
        if (const QString id = QString::fromLatin1(format->id);
            isFor(*format, FormatUse::Write) && !prints.contains(id))
            formats += id;
    // Materials, skin and motion come along in a GLB.
    if (const auto glb = formats.indexOf(QStringLiteral("glb")); glb > 0)
        formats.move(glb, 0);
    return formats;
}

QString titleOf(ExportUse use)
{
    return QCoreApplication::translate("ExportUses", rowOf(use).title);
}

QString tipOf(ExportUse use)
{
    return QCoreApplication::translate("ExportUses", rowOf(use).tip);
}

QString keyOf(ExportUse use)
{
    return QString::fromLatin1(rowOf(use).key);
}

} // namespace ramure
