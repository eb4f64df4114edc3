/// \file
/// How alike neighbouring levels are on a screen: outlines and colours, drawn without OpenGL.
#pragma once

#include "core/lod/level_switches.h"
#include <span>

namespace ramure {

struct LevelLikeness
{
    int pixels = 0; ///< how high the tree is on the screen
    /// Each pixel is covered by a share of 0..1: the sum of the lesser of both over that of the greater (the
    /// intersection over the union of fuzzy sets), the least of three views round the tree.
    double overlap = 1.0;
    /// The same of pixels that are covered by a half or more.
    double outline = 1.0;
    double cover = 1.0; ///< of the level, over that of the one before; all views together
    /// CIE76, of the mean colours in the same light: a sun that stands high behind the viewer and a sky.
    double colourDistance = 0.0;
};

/// How high, in pixels, the tree is on the screen where each level but the first takes over.
std::vector<int> switchPixels(const LevelSwitches& switches);
/// The same where the details in which it differs from the one before are a pixel (TreeLevel::detail).
std::vector<int> detailPixels(const std::vector<TreeLevel>& levels);

/// Compares each level but the first with the one before. \param levels with texture coordinates. \param
/// pixels one for each but the first. \param mapSize of the pictures of cards. Errors: those of sprayMaps;
/// Cancelled.
Expected<std::vector<LevelLikeness>> likenessOf(const std::vector<TreeLevel>& levels,
                                                const NodeParams& params, std::span<const int> pixels,
                                                int mapSize, const Progress& progress = {});

} // namespace ramure
