/// \file
/// What is shown while edits keep coming: every branch as an open tube, without forks. No mesh to export or
/// to check.
#pragma once

#include "core/params/node_params.h"
#include "core/skeleton/sections.h"
#include "core/surface/mesh/triangle_mesh.h"

namespace ramure {

/// Most ring points that drafts have, beyond the least they need.
inline constexpr std::size_t draftPoints = 150'000;

/// The divisions of a draft: those of \p params, fewer where all branches together would have more than
/// draftPoints points. Never under 2 sections of 3 points.
SectionParams draftDivisions(const SectionParams& params, Index branches);

/// Tubes through the sections, with normals and branch ids, counter-clockwise seen from outside.
/// \param sections those of \p skeleton. \param radialDivisions points per section, >= 3.
TriangleMesh buildDraftTubes(const Skeleton& skeleton, const SectionSet& sections, int radialDivisions);

} // namespace ramure
