/// \file
/// Options that `batch` and those who start it share.
#pragma once

#include "app/cli/command_line.h"
#include "app/cli/worker_pool.h"
#include <QSize>
#include <optional>

namespace ramure::cli {

/// "1280x800". Error: Invalid.
Expected<QSize> pictureSizeFrom(const QString& value);
/// --jobs and --memory.
void addPoolOptions(CommandLine& line);
/// Errors: Invalid.
Expected<PoolOptions> poolOptionsOf(const CommandLine& line);

} // namespace ramure::cli
