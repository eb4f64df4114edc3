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
    PosedTree tree; ///< the tree that the levels were made from
    std::vector<TreeLevel> levels;
    std::vector<LevelSkins> skins; ///< empty ones where nothing moves
    LevelSwitches switches;
};

/// Returns the mean scale of a node's axes: metres of the scene per metre of the node.
double nodeScale(const EvaluatedScene& scene, NodeId node);
/// Makes the levels of one tree of the scene. Errors: those of treeLevels and of the evaluator.
Expected<LevelledTree> levelsOf(const Node& node, EvaluatedScene& scene, const ExportOptions& options,
                                const Progress& progress);
/// Checks the options for levels; options without levels pass. Errors: those of checkLevels; Invalid (levels
/// of another model, with instances or with seasons).
Expected<void> checkLevelExport(const ExportOptions& options, const FileFormat& format);
/// The options that a file of the format can hold: cards and the billboard are pictures.
LevelOptions levelsIn(const FileFormat& format, const ExportOptions& options);
/// Names a mesh of a level and says when it is shown.
void tellLevel(ExportMesh& mesh, const LevelledTree& tree, std::size_t level);
/// Are all levels in one file?
bool isOneFile(const FileFormat& format, const ExportOptions& options);
/// Adds what bodies bump into, if the options ask for it, with the names by which an engine knows it. \param
/// first of the tree's meshes
void addCollision(ExportScene& out, Index node, std::size_t first, const Skeleton& skeleton,
                  const ExportOptions& options);
/// Writes each level as a file. Errors: those of the format; files already written stay.
Expected<void> writeLevels(const FileFormat& format, const std::string& path, const ExportScene& scene,
                           const WriteOptions& options, const Progress& progress);

} // namespace ramure
