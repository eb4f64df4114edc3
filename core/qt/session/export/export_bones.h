/// \file
/// The bones of what moves, for files that do with fewer of them or hang them on each other.
#pragma once

#include "core/evaluate/evaluator.h"
#include "core/io/export_scene.h"

namespace ramure {

/// Of the straight arm, one for each joint.
std::vector<ExportBone> bonesOf(const NodeParams& arm);
/// Branches, and what hangs on them with bones of its own: apples, leaves.
std::vector<ExportBone> bonesOf(const Skeleton& skeleton, const Foliage* foliage, const NodeMotion& motion);

} // namespace ramure
