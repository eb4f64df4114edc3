#include "widgets/dialogs/export/mesh_faults.h"

#include "core/qt/session/export/scene_counts.h"
#include <QCoreApplication>

namespace ramure {
namespace {

/// The trees with the worst verdict so far, and what is wrong with all of them together.
struct Sums
{
    MeshVerdict verdict = MeshVerdict::Closed;
    NodeId first = noNode;
    QString name; ///< of the first
    int trees = 0;
    quint64 defects = 0, crossings = 0, collisions = 0;

    void add(const Node& node, MeshVerdict found, const MeshReport& report, const MeshAnalysis* findings);
};

void Sums::add(const Node& node, MeshVerdict found, const MeshReport& report, const MeshAnalysis* findings)
{
    if (found < MeshVerdict::Crossing || found < verdict)
        return;
    if (found > verdict)
        *this = {found, node.id, QString::fromStdString(node.name)};
    ++trees;
    for (int kind = 0; kind < defectKindCount; ++kind)
        defects += report.count(static_cast<DefectKind>(kind));
    if (findings) {
        crossings += findings->crossings.total();
        collisions += findings->collisions.size();
    }
}

/// The context under which the translators find these texts.
struct FaultTexts
{
    Q_DECLARE_TR_FUNCTIONS(FaultTexts)
public:
    static QString broken(const Sums& sums);
    static QString crossing(const Sums& sums);
};

QString FaultTexts::broken(const Sums& sums)
{
    const QString text = sums.defects > 0 ? tr("%Ln defect(s)", nullptr, static_cast<int>(sums.defects))
                                          : tr("not closed and outward");
    return sums.trees == 1 ? tr("The mesh of “%1” is broken: %2.").arg(sums.name, text)
                           : tr("The meshes of %Ln tree(s) are broken: %1.", nullptr, sums.trees).arg(text);
}

QString FaultTexts::crossing(const Sums& sums)
{
    QString text =
        tr("%Ln pair(s) of triangles run through each other", nullptr, static_cast<int>(sums.crossings));
    if (sums.collisions > 0)
        text += QStringLiteral(", ") +
                tr("%Ln pair(s) of branches collide", nullptr, static_cast<int>(sums.collisions));
    return sums.trees == 1
               ? tr("The mesh of “%1” is closed. %2: that matters for a print alone.").arg(sums.name, text)
               : tr("The meshes of %Ln tree(s) are closed. %1: that matters for a print alone.", nullptr,
                    sums.trees)
                     .arg(text);
}

} // namespace

MeshFaults meshFaults(const Document& document, const Analysis* analysis, const ExportOptions& options)
{
    if (options.model != ExportModel::Mesh || !(options.parts & exportBranches))
        return {};
    Sums sums;
    for (const Node& node : document.scene().nodes()) {
        const NodeResult* result = node.kind == NodeKind::Tree ? document.result(node.id) : nullptr;
        if (!result || !result->tree.report || !isExported(document.scene(), options, node))
            continue;
        const auto findings = analysis ? analysis->findings(node.id) : nullptr;
        const MeshReport& report = *result->tree.report;
        const MeshVerdict verdict = verdictOn(report, findings ? &findings->crossings : nullptr,
                                              result->tree.branches ? result->tree.branches->roots : 0);
        sums.add(node, verdict, report, findings.get());
    }
    if (sums.trees == 0)
        return {};
    return {sums.first, sums.verdict,
            sums.verdict == MeshVerdict::Broken ? FaultTexts::broken(sums) : FaultTexts::crossing(sums)};
}

} // namespace ramure
