/// \file
/// What games move trees by, on its way to files.
#pragma once

#include "core/evaluate/evaluator.h"
#include "core/io/formats/file_format.h"
#include "core/qt/session/export/export_options.h"

namespace ramure {

/// The leaves and fruit of a level, with their numbers in the whole tree's; empty: those are their own.
struct WindFoliage
{
    const Foliage* foliage = nullptr; ///< null: it has none
    std::span<const Index> leafOf{};
};

/// Gives each mesh of one tree its numbers, and the scene the textures that go with them. \param first the
/// first of its meshes; all after it are its own. \param suffix of the names of their parts. \param levels by
/// ExportMesh::level. Errors: Invalid (the tree moves), those of windElements.
Expected<void> addWind(ExportScene& out, std::size_t first, const std::string& suffix, WindProfile profile,
                       const PosedTree& tree, std::span<const WindFoliage> levels);
/// Errors: Invalid (a format without wind data, another model, instances, a clip). Fine where none are
/// wanted.
Expected<void> checkWindExport(const ExportOptions& options, const FileFormat& format);

} // namespace ramure
