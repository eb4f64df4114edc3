/// \file
/// Reads the table of export options from the command line, for `export`, for commands that run it on many
/// trees, and for `import`.
#pragma once

#include "app/cli/command_line.h"
#include "core/qt/session/export/export_option.h"

namespace ramure::cli {

/// \param who ofExport, ofBatch or ofImport
void addExportOptions(CommandLine& line, OptionFlag who);
/// \param usual values of options that are not given. Errors: those of readOption and checkLevels; Invalid
/// (--switch alone).
Expected<ExportOptions> exportOptionsOf(const CommandLine& line, OptionFlag who, ExportOptions usual = {});
/// Returns nothing where none of --up, --unit and --scale was given.
std::optional<FileSpace> spaceGiven(const CommandLine& line, const ExportOptions& options);

} // namespace ramure::cli
