/// \file
/// The table of export options on the command line: of `export`, of what starts it for many trees, and of
/// `import`.
#pragma once

#include "app/cli/command_line.h"
#include "core/qt/session/export/export_option.h"

namespace ramure::cli {

/// \param who ofExport, ofBatch or ofImport
void addExportOptions(CommandLine& line, OptionFlag who);
/// \param usual where nothing was said. Errors: those of readOption and checkLevels; Invalid (--switch
/// alone).
Expected<ExportOptions> exportOptionsOf(const CommandLine& line, OptionFlag who, ExportOptions usual = {});
/// Returns nothing where none of --up, --unit and --scale was given.
std::optional<FileSpace> spaceGiven(const CommandLine& line, const ExportOptions& options);

} // namespace ramure::cli
