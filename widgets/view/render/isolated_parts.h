/// \file
/// What is left of meshes, lines and marks when only some branches are shown.
#pragma once

#include "widgets/view/render/render_scene.h"
#include <vector>

namespace ramure {

/// One flag per branch of the simplified skeleton.
using BranchFlags = std::vector<bool>;

/// \p branches that are at least \p count are passed over.
BranchFlags branchFlags(std::size_t count, const std::vector<Index>& branches);

/// The triangles with a corner on a shown branch, so that the valley at a fork stays whole, and only their
/// vertices. A mesh without branches comes back as it is.
TriangleMesh onlyBranches(const TriangleMesh& mesh, const BranchFlags& shown);
/// Segments and marks of shown branches, with those that belong to none.
LineSet onlyBranches(const LineSet& lines, const BranchFlags& shown);
PointSet onlyBranches(const PointSet& points, const BranchFlags& shown);

} // namespace ramure
