/// \file
/// The copies of a scatter, for files.
#pragma once

#include "core/evaluate/evaluator.h"
#include "core/io/export_scene.h"
#include "core/qt/session/export/export_options.h"

namespace ramure {

/// The numbers of the scatters whose copies are wanted, in the order of the scene.
std::vector<Index> scattersOf(const Scene& scene, const ExportOptions& options);

/// Errors of what a file of copies cannot hold: Invalid (motion, levels, growth, wind, the skeleton, with the
/// reason), path = the name of the scatter.
Expected<void> checkScatterExport(const Scene& scene, const ExportOptions& options);

/// collectExport(), which knows this file.
using CollectNode = Expected<ExportScene>(EvaluatedScene scene, const ExportOptions& options,
                                          const Progress& progress);

/// Adds every mesh of every prototype: once, with the places of its copies, or, where the options want no
/// copies, as one mesh of all. \param number of the scatter in the scene \param collect for each prototype
/// Errors: those of scatterPlaces() and of \p collect, named; Limit (one mesh of all would have too many
/// triangles).
Expected<void> addScatter(ExportScene& out, Index number, EvaluatedScene& scene, const ExportOptions& options,
                          CollectNode* collect, const Progress& progress);

} // namespace ramure
