/// \file
/// The tree of a scene made ready for a printer, and written: what the export dialog and the command line
/// share.
#pragma once

#include "core/evaluate/evaluator.h"
#include "core/io/export_scene.h"
#include "core/print/print_tree.h"
#include "core/qt/session/export/export_options.h"

namespace ramure {

struct ScenePrint
{
    std::string name; ///< of the tree's node
    PrintedTree tree;
};

/// \param which nodes and hidden say which tree. As its parameters have it, at rest: where its node stands in
/// the world, and how large it is there, does not matter. Errors: Invalid (not one tree), those of printTree
/// and of the evaluator.
Expected<ScenePrint> printScene(EvaluatedScene scene, const ExportOptions& which, const PrintOptions& options,
                                const Progress& progress = {});

/// The axes and the unit that slicers have: Z up, mm.
FileSpace printSpace();
/// In a format of the table. Errors: Unknown (its ending), those of the format.
Expected<void> writePrint(const std::string& path, const ScenePrint& print, const FileSpace& space,
                          const WriteOptions& options = {}, const Progress& progress = {});

} // namespace ramure
