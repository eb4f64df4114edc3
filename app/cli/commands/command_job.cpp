#include "app/cli/batch/batch_options.h"
#include "app/cli/batch/job_script.h"
#include "app/cli/commands/commands.h"
#include "core/base/file_writer.h"
#include "core/base/utf8.h"
#include <QDir>
#include <QFileInfo>
#include <algorithm>

namespace ramure::cli {

namespace {

constexpr CommandText jobText = {
    "job", "writes a batch as a job for many machines", "VARIATIONS.csv",
    "Writes what hands the rows of a table out to many machines.",
    "The table is that of `batch`, and it is read as `batch` reads it. What is written stands in the folder "
    "of "
    "the trees, names the table from there, and the program as `ramure-cli`, or as $RAMURE_CLI says. Every "
    "task does one part of the table with --shard and --resume, so that one that is lost may be done again, "
    "anywhere; the last one puts the manifests together and says whether all rows are there."};

constexpr int usualRows = 100, mostShards = 100'000;

Expected<const JobKind*> kindOf(const CommandLine& line)
{
    const JobKind* kind = nullptr;
    for (const JobKind& known : jobKinds)
        if (line.has(known.option)) {
            if (kind)
                return fail(ErrorCode::Invalid, "--%1 and --%2 exclude each other",
                            {kind->option, known.option});
            kind = &known;
        }
    if (!kind)
        return fail(ErrorCode::Invalid, "one of --slurm, --openjd, --flamenco and --make expected");
    return kind;
}

Expected<std::size_t> shardsOf(const CommandLine& line, std::size_t rows)
{
    if (!line.has("shards")) // one alone would have a manifest of another name
        return std::clamp<std::size_t>((rows + usualRows - 1) / usualRows, 2, 1000);
    bool isNumber = false;
    const int shards = line.value("shards").toInt(&isNumber);
    if (!isNumber || shards < 2 || shards > mostShards)
        return fail(ErrorCode::Invalid, "--shards \"%1\": 2 to %2 expected",
                    {line.value("shards").toStdString(), std::to_string(mostShards)});
    return std::size_t(shards);
}

/// Those of `batch` that were given, for its tasks.
QStringList passedOn(const CommandLine& line, const PoolOptions& pool)
{
    QStringList out;
    for (const QString& file : templatesOf(line))
        out << QStringLiteral("--file") << file;
    out << QStringLiteral("--jobs") << QString::number(pool.processes);
    const auto pass = [&](const char* name) {
        if (line.has(name))
            out << QStringLiteral("--") + QLatin1String(name) << line.value(name);
    };
    pass("memory");
    for (const ExportOption& option : exportOptions())
        if (option.is(ofBatch))
            pass(option.name);
    pass("size");
    return out;
}

void addJobOptions(CommandLine& line)
{
    line.add({QStringLiteral("o"), QStringLiteral("output")},
             QStringLiteral("Folder of the trees, which is made where there is none."),
             QStringLiteral("FOLDER"));
    for (const JobKind& kind : jobKinds)
        line.add({QLatin1String(kind.option)},
                 QStringLiteral("%1: %2").arg(QLatin1String(kind.file), QLatin1String(kind.description)));
    line.add(
        {QStringLiteral("shards")},
        QStringLiteral("Parts of the table, each a task; without it one for each 100 rows, 1000 at most."),
        QStringLiteral("N"));
    addFileOptions(line);
    addPoolOptions(line);
}

Expected<int> runJob(const CommandLine& line)
{
    const auto kind = kindOf(line);
    RAMURE_TRY(kind);
    const QString folder = line.value("output");
    if (folder.isEmpty())
        return fail(ErrorCode::Invalid, "missing -o FOLDER: `ramure-cli job --help` shows what it takes");
    auto pool = poolOptionsOf(line);
    RAMURE_TRY(pool);
    if (!line.has("jobs")) // of another machine: how many cores this one has says nothing
        pool->processes = 1;
    const auto plan = planOf(line, Shard());
    RAMURE_TRY(plan);
    const auto shards = shardsOf(line, plan->whole);
    RAMURE_TRY(shards);
    for (const QString& name : {folder, line.arguments().front()})
        if (!isUtf8(systemPath(name)))
            return fail(ErrorCode::Invalid, "\"%1\": the name is no UTF-8, and a script cannot hold it",
                        {name.toStdString()});
    RAMURE_TRY(makeFolder(systemPath(folder)));
    const QString table = QFileInfo(line.arguments().front()).absoluteFilePath();
    const JobRequest request{QDir(folder).relativeFilePath(table),
                             passedOn(line, *pool),
                             plan->whole,
                             *shards,
                             pool->memoryBytes,
                             pool->processes};
    auto file = FileWriter::open(systemPath(folder + QLatin1Char('/') + QLatin1String((*kind)->file)));
    RAMURE_TRY(file);
    file->append((*kind)->write(request).toStdString());
    RAMURE_TRY(file->commit());
    return exitGood;
}

} // namespace

const Command jobCommand{jobText, &addJobOptions, &runJob};

} // namespace ramure::cli
