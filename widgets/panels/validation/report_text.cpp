#include "widgets/panels/validation/report_text.h"

#include "core/surface/mesher/build_branch_mesh.h"
#include "widgets/base/defect_place.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/texts/fact_text.h"
#include "widgets/panels/validation/kind_texts.h"
#include <QLocale>

namespace ramure {
namespace {

constexpr int placeDecimals = 4;

qulonglong defectTotal(const MeshReport& report)
{
    qulonglong total = 0;
    for (int kind = 0; kind < defectKindCount; ++kind)
        total += report.count(static_cast<DefectKind>(kind));
    return total;
}

} // namespace

QString ReportTexts::counts(const MeshReport& report, CheckedShape shape)
{
    const QLocale locale;
    if (shape == CheckedShape::Open) // encloses nothing
        return tr("%1 vertices, %2 faces, Euler characteristic %3, %Ln piece(s)", nullptr,
                  static_cast<int>(report.components))
            .arg(locale.toString(report.vertices), locale.toString(report.faces),
                 locale.toString(static_cast<qlonglong>(report.eulerCharacteristic)));
    NumberFormat volume;
    volume.decimals = 4;
    volume.suffix = QStringLiteral("\u00a0m³");
    return tr("%1 vertices, %2 faces, volume %3, Euler characteristic %4, %Ln piece(s)", nullptr,
              static_cast<int>(report.components))
        .arg(locale.toString(report.vertices), locale.toString(report.faces), volume.text(report.volume),
             locale.toString(static_cast<qlonglong>(report.eulerCharacteristic)));
}

QString ReportTexts::openMesh(const MeshReport& report, bool draft)
{
    if (report.openMeshChecked)
        return report.openMeshAgrees ? tr("Confirmed by OpenMesh.") : tr("OpenMesh refuses the mesh.");
    return draft ? tr("A draft: the full mesh follows.") : tr("OpenMesh has not been asked yet.");
}

/// Of a broken mesh.
QString ReportTexts::fault(const MeshReport& report, Index roots)
{
    if (const qulonglong defects = defectTotal(report))
        return tr("%Ln defect(s)", nullptr, static_cast<int>(defects));
    if (report.faces == 0)
        return tr("The mesh has no faces");
    if (report.openMeshChecked && !report.openMeshAgrees)
        return tr("The two checks do not agree");
    if (!report.valid)
        return tr("Closed, but inside out");
    return tr("More or fewer pieces than roots (%1)").arg(roots);
}

ReportSummary ReportTexts::judge(const MeshReport& report, Index roots, const MeshAnalysis* analysis,
                                 CheckedShape shape)
{
    using Status = StatusBadge::Status;
    const bool open = shape == CheckedShape::Open;
    const MeshVerdict verdict =
        verdictOn(report, analysis ? &analysis->crossings : nullptr, shape == CheckedShape::Tree ? roots : 0);
    switch (verdict) {
    case MeshVerdict::Clean:
        return {Status::Good,
                open ? tr("An open surface, manifold and oriented, free of crossings")
                     : tr("Closed and free of crossings"),
                {},
                verdict};
    case MeshVerdict::Closed:
        return {Status::Unknown,
                open ? tr("An open surface, manifold and oriented; crossings not looked for yet")
                     : tr("Closed; crossings not looked for yet"),
                {},
                verdict};
    case MeshVerdict::Crossing: {
        const int pairs = static_cast<int>(analysis->crossings.total());
        return {Status::Warning,
                open ? tr("Oriented, but %Ln pair(s) of triangles run through each other", nullptr, pairs)
                     : tr("Closed, but %Ln pair(s) of triangles run through each other", nullptr, pairs),
                {},
                verdict};
    }
    case MeshVerdict::Broken:
        break;
    }
    return {Status::Bad, fault(report, roots), {}, verdict};
}

ReportSummary ReportTexts::summary(const NodeResult* result, const MeshAnalysis* analysis, CheckedShape shape)
{
    using Status = StatusBadge::Status;
    if (!result)
        return {Status::Unknown, tr("Not checked yet"), tr("The mesh is being made."), {}};
    if (result->error)
        return {Status::Warning, tr("No mesh to check"), errorText(*result->error), {}};
    if (!result->tree.report || !result->tree.branches)
        return {Status::Unknown, tr("Not checked yet"), tr("The mesh is being made."), {}};
    const MeshReport& report = *result->tree.report;
    ReportSummary summary = judge(report, result->tree.branches->roots, analysis, shape);
    summary.details = counts(report, shape) + QLatin1Char('.');
    if (shape != CheckedShape::Open) // OpenMesh is asked for a closed mesh
        summary.details += QLatin1Char(' ') + openMesh(report, result->draft);
    if (const QString note = coreText(budgetText(result->tree.branches->budget)); !note.isEmpty())
        summary.details += QLatin1Char(' ') + note + QLatin1Char('.');
    return summary;
}

QString ReportTexts::crossings(const MeshAnalysis& analysis)
{
    const QLocale locale;
    QStringList sentences;
    if (analysis.crossings.total() == 0)
        return tr("No triangle runs through another.");
    const quint64 forks = analysis.crossings.aroundForks();
    if (!analysis.crossings.kindsKnown)
        return tr("%Ln pair(s) of triangles run through each other.", nullptr,
                  static_cast<int>(analysis.crossings.total()));
    if (forks == 0)
        sentences += tr("No triangles cross at forks.");
    else
        sentences += tr("%Ln pair(s) of triangles cross at forks.", nullptr, static_cast<int>(forks));
    if (!analysis.collisions.empty())
        sentences += tr("%Ln pair(s) of branches collide (%1 pairs of triangles).", nullptr,
                        static_cast<int>(analysis.collisions.size()))
                         .arg(locale.toString(qulonglong(analysis.crossings.count(PairKind::Far))));
    return sentences.join(QLatin1Char(' '));
}

QString ReportTexts::quality(const MeshQuality& quality)
{
    NumberFormat aspect;
    aspect.decimals = 1;
    const QString shape = tr("Smallest angle %1, largest aspect ratio %2")
                              .arg(facttext::angle(quality.smallestAngleRad, AngleUnit::Degrees),
                                   aspect.text(quality.largestAspect));
    NumberFormat millimetres;
    millimetres.decimals = 1;
    millimetres.suffix = QStringLiteral("\u00a0mm");
    const QString near =
        tr("%Ln pair(s) of vertices within %1 of each other", nullptr, static_cast<int>(quality.nearPairs))
            .arg(millimetres.text(1000.0 * MeshQuality::nearDistance));
    return shape + QLatin1Char('\n') + near;
}

QStringList ReportTexts::findingLines(const MeshAnalysis& analysis)
{
    QStringList lines{crossings(analysis)};
    for (int k = 0; k < (analysis.crossings.kindsKnown ? pairKindCount : 1); ++k) {
        const auto kind = static_cast<PairKind>(k);
        lines += QStringLiteral("%1: %2")
                     .arg(KindTexts::ofCrossing(kind, analysis).name)
                     .arg(analysis.crossings.count(kind));
        if (kind == PairKind::Far)
            continue;
        for (const FacePair& pair : analysis.crossings.pairs)
            if (pair.kind == kind)
                lines += QStringLiteral("    ") + crossingName(pair);
    }
    if (analysis.crossings.kindsKnown)
        lines += QStringLiteral("%1: %2")
                     .arg(KindTexts::of(FindingKind::Collision).name)
                     .arg(analysis.collisions.size());
    for (const Collision& collision : analysis.collisions)
        lines += QStringLiteral("    %1, %2")
                     .arg(collisionName(collision),
                          tr("at %1").arg(facttext::vector(collision.place, placeDecimals)));
    lines += QString();
    lines += quality(analysis.quality);
    lines += tr("Hash %1").arg(QString::fromStdString(analysis.hash.text()));
    return lines;
}

QStringList ReportTexts::defectLines(const TreeResult& tree)
{
    QStringList lines;
    for (int k = 0; k < defectKindCount; ++k) {
        const auto kind = static_cast<DefectKind>(k);
        lines += QStringLiteral("%1: %2").arg(KindTexts::of(kind).name).arg(tree.report->count(kind));
        for (const Defect& defect : tree.report->defects) {
            if (defect.kind != kind)
                continue;
            QStringList parts{defectName(defect)};
            if (const Index branch = defectBranch(tree.branches->mesh, defect); branch != noIndex)
                parts += tr("branch %1").arg(branch);
            if (const auto place = defectMiddle(tree.branches->mesh, defect))
                parts += tr("at %1").arg(facttext::vector(*place, placeDecimals));
            lines += QStringLiteral("    ") + parts.join(QStringLiteral(", "));
        }
    }
    return lines;
}

QStringList ReportTexts::repairLines(const TreeResult& tree)
{
    QStringList lines;
    for (int k = 0; k < repairKindCount; ++k) {
        const auto kind = static_cast<SkeletonRepair>(k);
        QStringList notes;
        for (const RepairNote& note : tree.branches->repairs)
            if (note.kind == kind)
                notes += QStringLiteral("    ") + repairName(note);
        if (!notes.empty())
            lines += QStringLiteral("%1: %2").arg(KindTexts::of(kind).name).arg(notes.size());
        lines += notes;
    }
    if (lines.empty())
        lines += tr("none");
    return lines;
}

QString ReportTexts::whole(const QString& nodeName, const NodeResult* result, const MeshAnalysis* analysis,
                           CheckedShape shape)
{
    const ReportSummary state = summary(result, analysis, shape);
    QStringList lines{tr("Check of the mesh of \"%1\"").arg(nodeName), state.headline, state.details};
    if (result && !result->error && result->tree.report && result->tree.branches) {
        lines += QString();
        lines += defectLines(result->tree);
        if (shape == CheckedShape::Tree) {
            lines += QString();
            lines += tr("Repairs of the mesher:");
            lines += repairLines(result->tree);
        }
    }
    if (analysis) {
        lines += QString();
        lines += findingLines(*analysis);
    }
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

} // namespace ramure
