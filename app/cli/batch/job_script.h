/// \file
/// A batch as a job for many machines, in the words of whoever hands the work out. Every script names paths
/// relative to the folder of the trees, where it stands, and the program by its name or by $RAMURE_CLI: the
/// same table gives the same bytes everywhere.
#pragma once

#include "core/base/error.h"
#include <QByteArray>
#include <QString>
#include <QStringList>

namespace ramure::cli {

struct JobRequest
{
    QString table;       ///< from the folder of the trees
    QStringList options; ///< options of `batch` besides the table, -o, --shard, --resume and --progress
    std::size_t rows = 0, shards = 0;
    std::size_t memoryBytes = 0; ///< memory that a task may take; 0: not specified
    int processes = 1;           ///< processes of a task
};

/// One that hands work out.
struct JobKind
{
    const char* option; ///< "slurm"
    const char* file;   ///< "job.sbatch"
    const char* description;
    QByteArray (*write)(const JobRequest& request);
};

extern const JobKind jobKinds[4];

/// Returns one word of a shell, in quotes if needed.
QString shellWord(const QString& text);

} // namespace ramure::cli
