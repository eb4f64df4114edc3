/// \file
/// A mesh report in sentences: for the panel's head and for the clipboard.
#pragma once

#include "core/qt/document/document.h"
#include "core/surface/check/mesh_analysis.h"
#include "core/surface/check/verdict.h"
#include "widgets/panels/validation/report_model.h"
#include "widgets/panels/validation/status_badge.h"
#include <QCoreApplication>
#include <QStringList>

namespace ramure {

/// What a mesh is held to: as many pieces as roots; closed; or an open surface.
enum class CheckedShape : std::uint8_t { Tree, Solid, Open };

/// The state of one mesh in two lines.
struct ReportSummary
{
    StatusBadge::Status status = StatusBadge::Status::Unknown;
    QString headline; ///< "Closed and free of crossings", "12 defects" ...
    QString details;  ///< counts, volume, Euler characteristic, OpenMesh's opinion; or why there is no mesh
    std::optional<MeshVerdict> verdict; ///< none where there is no mesh
};

class ReportTexts
{
    Q_DECLARE_TR_FUNCTIONS(ReportTexts)
public:
    /// \param result null where nothing was computed yet.
    /// \param analysis null where there is none yet: then freedom from crossings is not claimed.
    static ReportSummary summary(const NodeResult* result, const MeshAnalysis* analysis = nullptr,
                                 CheckedShape shape = CheckedShape::Tree);
    /// What runs through what, in a sentence or two.
    static QString crossings(const MeshAnalysis& analysis);
    /// Smallest angle and largest aspect ratio.
    static QString quality(const MeshQuality& quality);
    /// Everything as plain text: state, counts of every kind, each listed defect and repair with branch and
    /// place.
    static QString whole(const QString& nodeName, const NodeResult* result,
                         const MeshAnalysis* analysis = nullptr, CheckedShape shape = CheckedShape::Tree);

private:
    static QString counts(const MeshReport& report, CheckedShape shape);
    static QString openMesh(const MeshReport& report, bool draft);
    static QString fault(const MeshReport& report, Index roots);
    static ReportSummary judge(const MeshReport& report, Index roots, const MeshAnalysis* analysis,
                               CheckedShape shape);
    static QStringList findingLines(const MeshAnalysis& analysis);
    static QStringList defectLines(const TreeResult& tree);
    static QStringList repairLines(const TreeResult& tree);
};

} // namespace ramure
