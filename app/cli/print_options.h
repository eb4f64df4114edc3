/// \file
/// `export --print`: makes a tree ready for a printer and reports on it.
#pragma once

#include "app/cli/export_options.h"
#include "app/cli/input.h"
#include "core/evaluate/evaluator.h"

namespace ramure::cli {

/// Checks which options go with --print, and that it can be printed. Errors: Invalid, with the option.
Expected<void> checkPrintOptions(const CommandLine& line, const PrintOptions& options);

/// The end of an export whose input was good.
struct ExportOutcome
{
    int code = exitGood;
    QString text; ///< to be printed; with another code the reason why nothing was written
};

/// Writes the files; returns the report, with --json as JSON, and writes it into the file of --report.
/// Errors: those of printScene and writePrint; Invalid (the input is no scene).
Expected<ExportOutcome> printTo(const CommandLine& line, const Input& input, const ExportOptions& options,
                                Evaluator& evaluator, const Progress& progress);

} // namespace ramure::cli
