/// \file
/// Facts about a print as JSON.
#pragma once

#include "core/print/print_tree.h"
#include <QJsonObject>

namespace ramure {

/// Version of the schema; only changes that break readers raise it.
inline constexpr int printReportVersion = 1;

/// mm, mm², mm³; places as slicers have them: Z up, the foot's middle at the origin. Keys: process, height,
/// smallestDiameter, scale, size, volume, thinnest, thinnestAt, overhangArea, centreOfMass, footArea,
/// balance, stands, pieces, crossings, triangles, closed, thickened, cut, loose, leaves (off or shells),
/// shells, leavesLeftOut.
QJsonObject toJson(const PrintedTree& print, const PrintOptions& options);

} // namespace ramure
