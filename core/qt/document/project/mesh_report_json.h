/// \file
/// Facts about a mesh as JSON: one schema for `validate --json`, for the files of `export --report` and for
/// whoever reads them. Keys are sorted; angles in radians, lengths in metres, tree space.
#pragma once

#include "core/surface/check/mesh_analysis.h"
#include "core/surface/proof/validate.h"
#include <QJsonObject>
#include <optional>

namespace ramure {

/// Version of the schema; only changes that break readers raise it.
inline constexpr int meshReportVersion = 1;

/// The topology: valid, vertices, faces, one count per kind of defect, components, eulerCharacteristic,
/// volume.
QJsonObject toJson(const MeshReport& report);
/// largestAspect, largestAspectFace, smallestAngle, smallestAngleFace (faces -1 where there are none),
/// angleHistogram (bins of 5 degrees), aspectBins (their lower ends), aspectHistogram, withoutArea.
QJsonObject toJson(const MeshQuality& quality);
/// total; where branches are known also same, siblings, parentChild, far and collisions: a list of branches
/// (two indices), depth, place, triangles.
QJsonObject toJson(const SelfIntersections& crossings, const std::vector<Collision>& collisions);
/// The topology with hash, quality and nearVertices (MeshQuality::nearPairs), and selfIntersections where
/// asked for.
QJsonObject toJson(const MeshReport& report, const MeshAnalysis& analysis, bool withCrossings);

} // namespace ramure
