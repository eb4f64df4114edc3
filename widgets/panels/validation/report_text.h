/// \file
/// A mesh report in sentences: for the panel's head and for the clipboard.
#pragma once

#include "core/qt/document/document.h"
#include "core/surface/check/mesh_analysis.h"
#include "core/surface/check/verdict.h"
#include "widgets/panels/validation/report_model.h"
#include "widgets/panels/validation/status_badge.h"
#include <QString>

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

/// \param result null where nothing was computed yet.
/// \param analysis null where there is none yet: then freedom from crossings is not claimed.
ReportSummary summarise(const NodeResult* result, const MeshAnalysis* analysis = nullptr,
                        CheckedShape shape = CheckedShape::Tree);
/// What runs through what, in a sentence or two.
QString crossingsText(const MeshAnalysis& analysis);
/// Smallest angle and largest aspect ratio.
QString qualityText(const MeshQuality& quality);

/// Everything as plain text: state, counts of every kind, each listed defect and repair with branch and
/// place.
QString reportText(const QString& nodeName, const NodeResult* result, const MeshAnalysis* analysis = nullptr,
                   CheckedShape shape = CheckedShape::Tree);

} // namespace ramure
