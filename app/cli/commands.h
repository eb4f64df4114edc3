/// \file
/// The commands of ramure-cli. Each takes what stands behind its name and returns an exit code; an error is
/// one line on the standard error and exit code 2.
#pragma once

#include "app/cli/command_line.h"

namespace ramure::cli {

Expected<int> runList(const QStringList& arguments);
Expected<int> runInfo(const QStringList& arguments);
Expected<int> runImport(const QStringList& arguments);
Expected<int> runExport(const QStringList& arguments);
Expected<int> runValidate(const QStringList& arguments);
Expected<int> runSimulate(const QStringList& arguments);
Expected<int> runIk(const QStringList& arguments);
/// Starts the application that it needs itself: none may exist.
Expected<int> runRender(const QStringList& arguments);

} // namespace ramure::cli
