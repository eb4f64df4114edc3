/// \file
/// A folder with one tree for an engine: a GLB for each level, pieces for collision, data for wind with the
/// shader that reads them, and a README (resources/engines).
#pragma once

#include "core/qt/session/export/exporter.h"

namespace ramure {

/// Returns the options by which the files in the engine's folder are written: its wind, its names for
/// collision, a file each level, and levels of 80,000, 20,000 and 5,000 triangles with cards and a billboard
/// where the options ask for none.
ExportOptions engineOptions(const ExportOptions& options);
/// Returns the name of the tree in its files: that of the folder or archive, without what engines do not
/// like.
std::string engineTreeName(const std::string& path);
/// Writes the folder \p path, or an archive with one where \p path ends in .zip. Files of the folder that are
/// there already are replaced, others stay. Errors: those of collectExport and core/io; Invalid (not one
/// tree; options that a tree for an engine cannot have).
Expected<void> exportEngineFolder(EvaluatedScene scene, const ExportOptions& options, const std::string& path,
                                  const Progress& progress = {});

} // namespace ramure
