/// \file
/// `export --print`: a tree made ready for a printer, and what is to be known about it.
#pragma once

#include "app/cli/command_line.h"
#include "app/cli/input.h"
#include "core/evaluate/evaluator.h"
#include "core/io/file_space.h"
#include "core/print/print_options.h"
#include <optional>

namespace ramure::cli {

void addPrintOptions(CommandLine& line);
/// Nothing without --print. Errors: Invalid, Unknown and Syntax, with the option; options that say something
/// about another kind of export.
Expected<std::optional<PrintOptions>> printFrom(const CommandLine& line);

/// Writes the files; prints the report, with --json as JSON, and writes it into the file of --report.
/// Errors: those of printScene and writePrint; Invalid (the input is no scene).
Expected<int> printTo(const CommandLine& line, const Input& input, const PrintOptions& options,
                      const std::optional<FileSpace>& space, Evaluator& evaluator, const Progress& progress);

} // namespace ramure::cli
