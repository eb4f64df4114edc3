/// \file
/// When one level of detail takes the place of another on a screen.
#pragma once

#include "core/lod/tree_levels.h"

namespace ramure {

/// The screen that engines assume, in pixels.
inline constexpr double levelScreenWidth = 1920.0, levelScreenHeight = 1080.0;

/// Where an engine fades one level into the next, it begins and ends so much nearer and farther than the
/// switch, as a share of that.
inline constexpr double levelFade = 0.1;

/// When each level is shown, the finest first.
struct LevelSwitches
{
    /// m in the scene, from the eye to the tree: where the level takes the place of the one before, seen with
    /// levelFovRad. Rises; 0: the first one.
    std::vector<double> distances;
    /// The share of the picture's height that the tree has where the level takes over; infinite for the
    /// first.
    std::vector<double> shares;
    /// Share of that screen's area that the tree covers (its box seen from the front) down to which the level
    /// is needed. Never rises; 0: the last one.
    std::vector<double> coverage;
    /// m: from where on the details in which the level differs from the one before are a pixel of that screen
    /// or less. Never falls.
    std::vector<double> unseen;
};

/// Returns the switches that the options ask for, or the usual ones. \param scale of the node: m of the scene
/// for 1 m of the tree. \pre checkLevels(options); levels are not empty
LevelSwitches switchesOf(const std::vector<TreeLevel>& levels, const LevelOptions& options, double scale);

} // namespace ramure
