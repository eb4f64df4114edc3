/// \file
/// Trees that grow as one mesh, on their way to files.
#pragma once

#include "core/io/formats/file_format.h"
#include "core/params/node_params.h"
#include "core/qt/session/export/export_options.h"

namespace ramure {

/// Adds the bark of one tree and its leaves at each age of the bark's key shapes. \param node number in the
/// scene \param suffix of the names of its parts. Errors: those of growthMesh() and growthLeaves().
Expected<void> addGrowth(ExportScene& out, Index node, const std::string& suffix, const NodeParams& params,
                         const ExportOptions& options, const Progress& progress);
/// Checks the options for growth; options without it pass. Errors: Invalid (a format without key shapes,
/// another model, instances, levels, seasons, wind or a clip besides).
Expected<void> checkGrowthExport(const ExportOptions& options, const FileFormat& format);

} // namespace ramure
