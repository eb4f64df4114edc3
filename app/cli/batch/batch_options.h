/// \file
/// Options that `batch` and those who start it share.
#pragma once

#include "app/cli/batch/batch_plan.h"
#include "app/cli/batch/worker_pool.h"
#include <QSize>
#include <optional>

namespace ramure::cli {

/// Reads a size like "1280x800". Error: Invalid.
Expected<QSize> pictureSizeFrom(const QString& value);
/// Adds --file, --size and the options of the export table that a batch has.
void addFileOptions(CommandLine& line);
/// Reads the table that the line names and plans its rows. Errors: those of readPlan and of the options.
Expected<BatchPlan> planOf(const CommandLine& line, const Shard& shard);
/// Returns the names of files that the line asks for, with their placeholders.
QStringList templatesOf(const CommandLine& line);
/// Adds --jobs and --memory.
void addPoolOptions(CommandLine& line);
/// Reads --jobs and --memory. Errors: Invalid.
Expected<PoolOptions> poolOptionsOf(const CommandLine& line);

} // namespace ramure::cli
