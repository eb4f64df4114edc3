/// \file
/// Options that `batch` and those who start it share.
#pragma once

#include "app/cli/batch/batch_plan.h"
#include "app/cli/batch/worker_pool.h"
#include <QSize>
#include <optional>

namespace ramure::cli {

/// "1280x800". Error: Invalid.
Expected<QSize> pictureSizeFrom(const QString& value);
/// --file, --size and, of the table of export options, those of a batch.
void addFileOptions(CommandLine& line);
/// Of the table that the line names. Errors: those of readPlan and of the options.
Expected<BatchPlan> planOf(const CommandLine& line, const Shard& shard);
QStringList templatesOf(const CommandLine& line); ///< of files
/// --jobs and --memory.
void addPoolOptions(CommandLine& line);
/// Errors: Invalid.
Expected<PoolOptions> poolOptionsOf(const CommandLine& line);

} // namespace ramure::cli
