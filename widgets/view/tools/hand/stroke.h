/// \file
/// What a hand draws, as a branch: evenly spaced, without its trembling, thinner towards the tip.
#pragma once

#include "core/params/tree_edit.h"
#include <vector>

namespace ramure {

struct StrokeShape
{
    double smoothing = 0.6;  ///< 0: as drawn, 1: very smooth
    double footRadius = 0.1; ///< m
    double tipRadius = 0.03; ///< m
};

/// \param drawn places as the hand passed them, each with its pressure as the radius (1: as without a pen).
/// The first and the last place stay. Empty where it goes nowhere: shorter than a footRadius, or one point.
std::vector<StrokePoint> strokeBranch(const std::vector<StrokePoint>& drawn, const StrokeShape& shape);

} // namespace ramure
