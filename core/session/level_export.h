/// \file
/// Levels of detail of the trees of a scene, on their way to files, and when one takes the place of another.
#pragma once

#include "core/io/formats/file_format.h"
#include "core/levels/level_skins.h"
#include "core/session/exporter.h"

namespace ramure {

/// Of what engines take for a screen, pixels.
inline constexpr double levelScreenWidth = 1920.0, levelScreenHeight = 1080.0;

/// By level, the share of that screen's area that the tree covers (its box seen from the front) down to which
/// the level is needed: until the details in which the next one differs are a pixel. Never rises; 0: the last
/// one. \pre not empty
std::vector<double> coverageOf(const std::vector<TreeLevel>& levels);
/// m, by level: how far the eye is from the tree where the level takes the place of the one before, on that
/// screen. Never falls; 0: the first one. \param fovRad the screen's vertical angle of view
std::vector<double> distancesOf(const std::vector<TreeLevel>& levels, double fovRad);

struct LevelledTree
{
    PosedTree tree; ///< that the levels were made of
    std::vector<TreeLevel> levels;
    std::vector<LevelSkins> skins; ///< empty ones where nothing moves
    std::vector<double> coverage;  ///< coverageOf()
};

/// Of one tree of the scene. Errors: those of treeLevels and of the evaluator.
Expected<LevelledTree> levelsOf(const Node& node, EvaluatedScene& scene, const ExportOptions& options,
                                const Progress& progress);
/// Errors: those of checkLevels; Invalid (levels of another model, or with instances). Fine where there are
/// none.
Expected<void> checkLevelExport(const ExportOptions& options);
/// Each level as a file. Errors: those of the format; files that were written stay.
Expected<void> writeLevels(const FileFormat& format, const std::string& path, const ExportScene& scene,
                           const WriteOptions& options, const Progress& progress);

} // namespace ramure
