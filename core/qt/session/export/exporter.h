/// \file
/// What the editor's export and the command line share: from a scene at a time to nodes with meshes, and on
/// to files. Arms, terrains, primitives and imported meshes are part of it.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/evaluate/evaluator.h"
#include "core/io/export_scene.h"
#include "core/qt/session/export/export_options.h"
#include <string>
#include <vector>

namespace ramure {

class Document;
struct FileFormat;

/// The results the document has. Error Invalid: a tree's result is missing, a draft, older than its
/// parameters, or its parameters gave an error (that error).
TreeSource documentSource(const Document& document);

/// The scene at its time and at those of the clip. Shapes, and what parameters make of them, are those of its
/// time. Errors: those of its trees (path = name of the tree and the parameter key, where there are several
/// trees); those of EvaluatedScene::solid; Unknown (a node of the options); Invalid (nothing to export, a
/// node flattened by a zero scale); Cancelled.
Expected<ExportScene> collectExport(EvaluatedScene scene, const ExportOptions& options,
                                    const Progress& progress = {});

/// Writes a format of core/io/formats/file_format.h, by the ending of \p path, which is checked before
/// anything is computed. Of levels each has a file of its own (levelFile) where the format does not hold
/// them. A list of instances, and textures of pivots, are written before it. Errors: Unknown (another
/// ending), those of collectExport, checkWindExport and core/io; Invalid (a clip of instances); the old file
/// is intact.
Expected<void> exportScene(EvaluatedScene scene, const ExportOptions& options, const std::string& path,
                           const Progress& progress = {});
/// Its second half: what collectExport() gave for the same options. Errors: Unknown, those of core/io.
Expected<void> writeExport(const ExportScene& scene, const ExportOptions& options, const std::string& path,
                           const Progress& progress = {});
/// "tree.obj": "tree_LOD1.obj".
std::string levelFile(const std::string& path, int level);
/// The files that exportScene() writes: \p path itself, or one for each level.
std::vector<std::string> exportFiles(const ExportOptions& options, const std::string& path);
/// What a file of this format gets where nobody chose: of one that has no objects the one closed mesh alone.
/// \param instances nothing is mixed into that mesh.
std::uint8_t usualParts(const FileFormat& format, bool instances = false);

} // namespace ramure
