/// \file
/// Export, for the editor and the command line: collects a scene at one time as nodes with meshes, and writes
/// it to files. Arms, terrains, primitives and imported meshes are part of it.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/evaluate/evaluator.h"
#include "core/io/export_scene.h"
#include "core/qt/session/export/export_options.h"
#include <string>
#include <vector>

namespace ramure {

struct FileFormat;

/// Collects the scene at its time and at those of the clip. Shapes come from the parameters at its time.
/// Errors: those of its trees (path = name of the tree and the parameter key if there are several trees);
/// those of EvaluatedScene::solid; Unknown (a node of the options); Invalid (nothing to export, a node
/// flattened by a zero scale); Cancelled.
Expected<ExportScene> collectExport(EvaluatedScene scene, const ExportOptions& options,
                                    const Progress& progress = {});

/// Collects the scene and writes it. The ending of \p path picks a format of core/io/formats/file_format.h
/// and is checked before anything is computed. If the format does not hold levels, each level has a file of
/// its own (levelFile). A list of instances, and textures of pivots, are written first. Errors: Unknown
/// (another ending), those of collectExport, checkWindExport and core/io; Invalid (a clip of instances).
/// After an error the old file is intact.
Expected<void> exportScene(EvaluatedScene scene, const ExportOptions& options, const std::string& path,
                           const Progress& progress = {});
/// Writes the result of collectExport() for the same options. Errors: Unknown, those of core/io.
Expected<void> writeExport(const ExportScene& scene, const ExportOptions& options, const std::string& path,
                           const Progress& progress = {});
/// "tree.obj": "tree_LOD1.obj".
std::string levelFile(const std::string& path, int level);
/// The files that exportScene() writes: \p path itself, or one for each level.
std::vector<std::string> exportFiles(const ExportOptions& options, const std::string& path);
/// Returns the parts to export if nobody chose any. A format without objects gets the one closed mesh alone.
/// \param instances a list of instances is written, so nothing is mixed into that mesh.
std::uint8_t usualParts(const FileFormat& format, bool instances = false);

} // namespace ramure
