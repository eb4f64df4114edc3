/// \file
/// `export` but for the command: what its options ask for, and its work on an input that is there already.
/// The Python module runs the same, so that both write the same bytes.
#pragma once

#include "app/cli/export_options.h"
#include "app/cli/input.h"
#include "app/cli/print_options.h"
#include <functional>

namespace ramure::cli {

struct ExportRequest
{
    QStringList files;
    ExportOptions options;
    bool hasParts = false;  ///< else the format decides
    bool needsTree = false; ///< an option that says something about trees was given
    bool requireValid = false;
    QString report; ///< file, or empty

    [[nodiscard]] bool needsCheck() const { return requireValid || !report.isEmpty(); }
};

/// Adds all options of `export`.
void addSceneExportOptions(CommandLine& line);
/// Reads them. \param tell is told what becomes of the trees besides; the request keeps it. Errors: Invalid,
/// Unknown, Syntax, before anything is computed.
Expected<ExportRequest> exportRequestOf(const CommandLine& line,
                                        const std::function<void(const Error&)>& tell);
/// Writes the files. Returns a report of a print, or with exitCheckFailed why nothing was written. Errors:
/// those of exportScene, of --node, --time and --report.
Expected<ExportOutcome> exportInput(const CommandLine& line, const ExportRequest& request, Input& input,
                                    TreePipeline& pipeline, const Progress& progress);

} // namespace ramure::cli
