#include "widgets/export/mesh_faults.h"

#include <QCoreApplication>
#include <algorithm>

namespace ramure {
namespace {

/// The context under which the translators find these texts.
struct FaultTexts
{
    Q_DECLARE_TR_FUNCTIONS(FaultTexts)
public:
    static QString sentence(const MeshFaults& faults);
    static MeshFaults ofTree(const Node& node, const NodeResult& result, const MeshAnalysis* findings);
};

QString FaultTexts::sentence(const MeshFaults& faults)
{
    if (faults.faults.isEmpty())
        return tr("The mesh of “%1” is closed, but %2.")
            .arg(faults.name, faults.notes.join(QStringLiteral(", ")));
    return tr("The mesh of “%1” is not clean: %2.")
        .arg(faults.name, (faults.faults + faults.notes).join(QStringLiteral(", ")));
}

MeshFaults FaultTexts::ofTree(const Node& node, const NodeResult& result, const MeshAnalysis* findings)
{
    MeshFaults out{node.id, QString::fromStdString(node.name), {}, {}};
    if (const auto& report = result.tree.report; report && !report->valid) {
        quint64 defects = 0;
        for (int kind = 0; kind < defectKindCount; ++kind)
            defects += report->count(static_cast<DefectKind>(kind));
        out.faults += defects > 0 ? tr("%Ln defect(s)", nullptr, static_cast<int>(defects))
                                  : tr("not closed and outward");
    }
    if (!findings)
        return out;
    if (const quint64 forks = findings->crossings.aroundForks(); forks > 0)
        out.faults += tr("%Ln pair(s) of triangles cross at forks", nullptr, static_cast<int>(forks));
    if (!findings->collisions.empty())
        out.notes +=
            tr("%Ln pair(s) of branches collide", nullptr, static_cast<int>(findings->collisions.size()));
    return out;
}

bool isChosen(const Scene& scene, const ExportOptions& options, const Node& node)
{
    if (node.kind != NodeKind::Tree || (!options.hidden && !scene.isShown(node.id)))
        return false;
    return options.nodes.empty() || std::any_of(options.nodes.begin(), options.nodes.end(), [&](NodeId id) {
               return id == node.id || scene.isAncestor(id, node.id);
           });
}

} // namespace

QString MeshFaults::text() const
{
    return isEmpty() ? QString() : FaultTexts::sentence(*this);
}

MeshFaults meshFaults(const Document& document, const Analysis* analysis, const ExportOptions& options)
{
    MeshFaults first;
    if (options.model != ExportModel::Mesh || !(options.parts & exportBranches))
        return first;
    for (const Node& node : document.scene().nodes()) {
        const NodeResult* result = document.result(node.id);
        if (!result || !isChosen(document.scene(), options, node))
            continue;
        const auto findings = analysis ? analysis->findings(node.id) : nullptr;
        MeshFaults here = FaultTexts::ofTree(node, *result, findings.get());
        if (here.isEmpty() || (!first.isEmpty() && here.faults.isEmpty()))
            continue;
        const bool hasFaults = !here.faults.isEmpty();
        first = std::move(here);
        if (hasFaults)
            break;
    }
    return first;
}

} // namespace ramure
