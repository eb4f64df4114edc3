/// \file
/// Makes the tree of a scene ready for a printer and writes it, for the export dialog and the command line.
#pragma once

#include "core/evaluate/evaluator.h"
#include "core/io/export_scene.h"
#include "core/print/print_tree.h"
#include "core/qt/session/export/export_options.h"

namespace ramure {

struct ScenePrint
{
    std::string name; ///< name of the tree's node
    PrintedTree tree;
};

/// Prints one tree. \p which picks it by its nodes and hidden. The tree is printed at rest, as its parameters
/// make it; the place and the scale of its node do not matter. Errors: Invalid (not one tree), those of
/// printTree and of the evaluator.
Expected<ScenePrint> printScene(EvaluatedScene scene, const ExportOptions& which, const PrintOptions& options,
                                const Progress& progress = {});

/// The axes and the unit that slicers have: Z up, mm.
FileSpace printSpace();
/// Writes a print in a format of the table. Errors: Unknown (its ending), those of the format.
Expected<void> writePrint(const std::string& path, const ScenePrint& print, const FileSpace& space,
                          const WriteOptions& options = {}, const Progress& progress = {});

} // namespace ramure
