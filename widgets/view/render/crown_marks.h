/// \file
/// The crown that a tree grows to fill, as the viewport shows it: its envelope and its points, in tree space.
#pragma once

#include "core/params/colonisation_params.h"
#include "widgets/view/render/render_scene.h"

namespace ramure {

class EvaluatedScene;

/// More marks than these are no help.
inline constexpr std::int64_t mostCrownMarks = 3000;

/// Outlines all around, and rings. Empty where the profile cannot be read.
LineSet crownLines(const ColonisationParams& params);
/// The first mostCrownMarks of its points.
PointSet crownMarks(const ColonisationParams& params, std::uint64_t seed);

/// Appends both for the trees among these nodes that grow so. Nobody frames or picks them.
void addCrowns(RenderScene& built, EvaluatedScene& now, const std::vector<NodeId>& selected);

} // namespace ramure
