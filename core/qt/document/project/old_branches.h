/// \file
/// Rolls and bends of branches as older files have them, beside the recipe: a tree's "branches". They become
/// steps of the recipe, which do the same.
#pragma once

#include "core/base/error.h"
#include "core/params/branch_place.h"
#include "core/scene/scene.h"

#include <QJsonValue>
#include <map>

namespace ramure::json {

struct OldBranch
{
    double rollRad = 0.0;    ///< about its curve
    glm::dvec3 bendRad{0.0}; ///< about its start, axis times angle, tree space, before the bends below it
    BranchPlace place{};     ///< empty in files before version 3
};
using OldBranches = std::map<std::uint64_t, OldBranch>; ///< by Skeleton::key when it was made

/// \param value of the key "branches" of a tree. Errors: Invalid (path "branches...").
Expected<OldBranches> readOldBranches(const QJsonValue& value);
/// Grows the tree once and adds the steps. Those whose branch is not found are added without a place, so that
/// they are listed. \pre the tree knows what it grows around (linkGrowthSpaces)
void addOldBranches(Node& tree, const OldBranches& branches);

} // namespace ramure::json
