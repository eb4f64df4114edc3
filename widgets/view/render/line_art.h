/// \file
/// Lines and marks that explain a tree: skeleton, removed nodes, cross-sections, frames. All in tree space;
/// branch ids are those of the simplified skeleton.
#pragma once

#include "core/skeleton/sections.h"
#include "core/skeleton/simplify.h"
#include "widgets/view/render/render_scene.h"
#include <span>

namespace ramure {

/// More marked branches than these are no help to find one.
inline constexpr std::size_t mostCurves = 2000;

/// Branches as lines, as thick as they are relative to the thickest, coloured by level.
/// \param ids per branch the id to give it, empty = its own index.
LineSet skeletonLines(const Skeleton& skeleton, std::span<const Index> ids = {});
/// A mark at every p1, and at the p0 of every root.
PointSet nodeMarks(const Skeleton& skeleton, std::span<const Index> ids = {});
/// A red mark at every node that simplification removed.
PointSet removedMarks(const Skeleton& before, const SimplifiedSkeleton& after);

/// The curve of every branch, its cross-sections as polygons of \p radialDivisions points, and a red line
/// through the first point of each, which shows how little the frames twist.
LineSet sectionLines(const Skeleton& skeleton, const SectionSet& sections, int radialDivisions);
/// Tangent blue, normal red, binormal green, for every section of these branches (out of range: skipped).
LineSet frameArrows(const Skeleton& skeleton, const SectionSet& sections, std::span<const Index> branches);
/// One section: its circle, a square of its plane, its frame.
LineSet inspectedLines(const Skeleton& skeleton, const SectionSet& sections, Index branch, Index section,
                       int radialDivisions);
/// Colours for the selection, for branches under the mouse, and for branches that a tool would remove.
enum class CurveColour : std::uint8_t { Selected, Pointed, Goes };
/// The curves of these branches, to be seen through leaves and bark; straight where there are more than
/// mostCurves.
LineSet branchCurves(const Skeleton& skeleton, std::span<const Index> branches,
                     CurveColour colour = CurveColour::Selected);

} // namespace ramure
