/// \file
/// A mesh report in sentences: for the panel's head and for the clipboard.
#pragma once

#include "core/document/document.h"
#include "widgets/validation/report_model.h"
#include "widgets/validation/status_badge.h"
#include <QString>

namespace ramure {

/// The state of one tree's mesh in two lines.
struct ReportSummary
{
    StatusBadge::Status status = StatusBadge::Status::Unknown;
    QString headline; ///< "Closed, manifold, oriented", "12 defects" ...
    QString details;  ///< counts, volume, Euler characteristic, OpenMesh's opinion; or why there is no mesh
};

/// \param result null where nothing was computed yet.
ReportSummary summarise(const NodeResult* result);

/// Everything as plain text: state, counts of every kind, each listed defect and repair with branch and
/// place.
QString reportText(const QString& treeName, const NodeResult* result);

} // namespace ramure
