/// \file
/// Levels of detail of the trees of a scene, on their way to files.
#pragma once

#include "core/evaluate/evaluator.h"
#include "core/io/formats/file_format.h"
#include "core/lod/level_skins.h"
#include "core/lod/level_switches.h"
#include "core/qt/session/export/export_options.h"

namespace ramure {

struct LevelledTree
{
    PosedTree tree; ///< that the levels were made of
    std::vector<TreeLevel> levels;
    std::vector<LevelSkins> skins; ///< empty ones where nothing moves
    LevelSwitches switches;
};

/// Of a node: metres of the scene for one of its own, the mean of its axes.
double nodeScale(const EvaluatedScene& scene, NodeId node);
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
