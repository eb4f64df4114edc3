#include "app/cli/batch/batch_options.h"
#include "app/cli/batch/batch_progress.h"
#include "app/cli/batch/batch_row.h"
#include "app/cli/batch/manifest.h"
#include "app/cli/commands/commands.h"
#include "app/cli/virtual_display.h"
#include "core/base/file_writer.h"
#include "core/base/stopwatch.h"
#include <QJsonDocument>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <sys/resource.h>

namespace ramure::cli {

namespace {

constexpr CommandText batchText = {
    "batch", "makes the trees of a table, with a manifest", "VARIATIONS.csv",
    "Makes a tree for each row of a table, checks its mesh, and writes files and a manifest.",
    "The first line of the table names its columns: `preset` or `input` (preset:NAME, demo:NAME, or a file "
    "beside the table), `seed`, which grows the tree by chance, `name`, `files` (templates with ; between "
    "them, in the place of --file), notes whose names begin with #, and any key that `ramure-cli list "
    "params` "
    "shows. An empty cell leaves what the input has, and makes no name of a file: its row fails. The table "
    "may come from a spreadsheet: cells with commas, semicolons or tabs between them, in UTF-8 or UTF-16.\n"
    "Rows hang on nothing but themselves. One that cannot be done has an error in the manifest, and the "
    "others "
    "go on; its files are there whole or not at all, and those of an earlier run go when it fails. The "
    "manifest has a line of JSON a row, in their order: "
    "`row`, `line`, `input`, `seed`, `set`, `inputs` (the hash of all that the files depend on), `proof` "
    "(the "
    "mesh is closed, manifold, oriented, and OpenMesh agrees, as `validate` has it), `counts`, `measures`, "
    "`files` with their SHA-256, and `error`. It says nothing of times and machines: manifests of shards, "
    "one "
    "behind the other, are the manifest of one run, byte for byte. --timings has the seconds.\n"
    "SIGINT, SIGTERM and a full disk end the batch: rows under way are dropped, those that are done are "
    "kept. "
    "A process that is killed "
    "leaves "
    "folders .row-NUMBER.part, which --resume clears away."};

struct BatchRequest
{
    BatchPlan plan;
    PoolOptions pool;
    ProgressDialect dialect = ProgressDialect::Text;
    QString manifest;
    QString timings; ///< file, or empty
    bool resume = false;
};

Expected<ProgressDialect> dialectFrom(const QString& name)
{
    if (name == QLatin1String("text"))
        return ProgressDialect::Text;
    if (name == QLatin1String("json"))
        return ProgressDialect::Json;
    if (name == QLatin1String("openjd"))
        return ProgressDialect::OpenJd;
    return fail(ErrorCode::Unknown, "--progress \"%1\": json, openjd, text expected", {name.toStdString()});
}

/// "manifest.jsonl", of a shard "manifest-003-of-200.jsonl": their names sort as the rows do.
QString manifestName(const Shard& shard)
{
    if (shard.count == 1)
        return QStringLiteral("manifest.jsonl");
    const int digits = int(QString::number(shard.count).size());
    return QStringLiteral("manifest-%1-of-%2.jsonl")
        .arg(shard.index, digits, 10, QLatin1Char('0'))
        .arg(shard.count);
}

Expected<BatchRequest> batchRequestOf(const CommandLine& line)
{
    BatchRequest out;
    const QString folder = line.value("output");
    if (folder.isEmpty())
        return fail(ErrorCode::Invalid, "missing -o FOLDER: `ramure-cli batch --help` shows what it takes");
    const auto shard = line.has("shard") ? shardFrom(line.value("shard")) : Expected<Shard>(Shard());
    RAMURE_TRY(shard);
    const auto pool = poolOptionsOf(line);
    RAMURE_TRY(pool);
    const auto dialect = dialectFrom(line.value("progress"));
    RAMURE_TRY(dialect);
    auto plan = planOf(line, *shard);
    RAMURE_TRY(plan);
    out.plan = std::move(*plan);
    out.plan.folder = folder;
    out.pool = *pool;
    out.dialect = *dialect;
    out.manifest =
        line.has("manifest") ? line.value("manifest") : folder + QLatin1Char('/') + manifestName(*shard);
    out.timings = line.value("timings");
    out.resume = line.has("resume");
    return out;
}

/// A batch at work.
class Batch
{
public:
    Batch(const BatchRequest& request, ManifestWriter& manifest)
        : m_request(request)
        , m_manifest(manifest)
        , m_before(manifest.before())
        , m_progress(request.dialect, request.plan.rows.size())
    {
    }

    /// \returns an exit code. Errors: Io (what it writes down).
    Expected<int> run()
    {
        clearStaging(m_request.plan);
        if (!m_request.timings.isEmpty()) {
            m_timings.reset(std::fopen(systemPath(m_request.timings).c_str(), "w"));
            if (!m_timings)
                return fail(writeError(systemPath(m_request.timings), errno));
            // A line is on the disk, or known not to be, as soon as its row is done.
            std::setvbuf(m_timings.get(), nullptr, _IOLBF, BUFSIZ);
        }
        const int signal = runJobs(
            m_request.plan.rows.size(), m_request.pool, [this](std::size_t job) { return work(job); },
            [this](std::size_t job, JobEnd end, const QByteArray& answer) { return take(job, end, answer); });
        if (signal != 0 || m_isDiskFull || m_problem)
            clearStaging(m_request.plan);
        removeStale(m_request.plan, m_before, m_manifest.lines());
        std::vector<std::int64_t> rows;
        for (const BatchRow& row : m_request.plan.rows)
            rows.push_back(row.number);
        RAMURE_TRY(m_manifest.commit(rows));
        if (m_problem)
            return fail(*m_problem);
        if (m_isDiskFull) {
            m_progress.ended(
                QStringLiteral("stopped: the disk is full; what is done is kept, --resume goes on"));
            return exitDiskFull;
        }
        return end(signal);
    }

private:
    /// In a process of the pool.
    QByteArray work(std::size_t job)
    {
        const BatchRow& row = m_request.plan.rows[job];
        if (m_request.resume)
            if (const auto found = m_manifest.lines().find(row.number);
                found != m_manifest.lines().end() && isDone(m_request.plan, row, found->second))
                return {};
        if (!m_maker)
            m_maker = std::make_unique<RowMaker>(m_request.plan);
        const Stopwatch watch;
        QJsonObject line = m_maker->make(row);
        rusage usage{};
        ::getrusage(RUSAGE_SELF, &usage);
        return QJsonDocument(QJsonObject{{QStringLiteral("line"), line},
                                         {QStringLiteral("seconds"), watch.elapsed().wallMs / 1000.0},
                                         {QStringLiteral("peakKiB"), qint64(usage.ru_maxrss)}})
            .toJson(QJsonDocument::Compact);
    }

    /// \returns whether the others are worth the work
    bool take(std::size_t job, JobEnd end, const QByteArray& answer)
    {
        const BatchRow& row = m_request.plan.rows[job];
        if (end == JobEnd::Done && answer.isEmpty()) { // it was there
            m_progress.rowEnded({});
            return true;
        }
        const QJsonObject told = QJsonDocument::fromJson(answer).object();
        QJsonObject line = told.value(QStringLiteral("line")).toObject();
        if (end == JobEnd::Memory)
            line = failedLine(m_request.plan, row, row_error::memory, QStringLiteral("out of memory"));
        else if (end == JobEnd::Crash)
            line = failedLine(m_request.plan, row, row_error::crash, QStringLiteral("its process ended"));
        else if (const auto placed = placeFiles(m_request.plan, row, line); !placed) {
            m_before[row.number] = line; // some of its files may be in their places
            line = failedLine(m_request.plan, row, rowErrorOf(placed.error()),
                              fromText(placed.error().message()));
        }
        if (line.contains(QStringLiteral("error")))
            clearStaging(m_request.plan, row);
        if (auto added = m_manifest.add(line); !added)
            m_problem = added.error();
        if (m_timings &&
            std::fprintf(m_timings.get(), "{\"row\":%lld,\"seconds\":%.6f,\"peakKiB\":%lld}\n",
                         static_cast<long long>(row.number), told.value(QStringLiteral("seconds")).toDouble(),
                         static_cast<long long>(told.value(QStringLiteral("peakKiB")).toInteger())) < 0)
            m_problem = writeError(systemPath(m_request.timings), errno);
        const QJsonObject problem = line.value(QStringLiteral("error")).toObject();
        m_progress.rowEnded(problem.value(QStringLiteral("text")).toString());
        m_isDiskFull = problem.value(QStringLiteral("kind")) == QLatin1String(row_error::disk);
        return !m_isDiskFull && !m_problem;
    }

    int end(int signal)
    {
        if (signal != 0) {
            m_progress.ended(QStringLiteral("stopped: what is done is kept, --resume goes on"));
            return 128 + signal;
        }
        bool isMemory = false, isCheck = false, isOther = false;
        for (const BatchRow& row : m_request.plan.rows) {
            const QJsonObject error =
                m_manifest.lines().at(row.number).value(QStringLiteral("error")).toObject();
            const QString kind = error.value(QStringLiteral("kind")).toString();
            if (kind == QLatin1String(row_error::memory))
                isMemory = true;
            else if (kind == QLatin1String(row_error::check))
                isCheck = true;
            else
                isOther = isOther || !error.isEmpty();
        }
        const bool isGood = !isMemory && !isCheck && !isOther;
        m_progress.ended(isGood ? QString()
                                : QStringLiteral("%1 of %2 rows failed: the manifest says why")
                                      .arg(m_progress.failed())
                                      .arg(m_request.plan.rows.size()));
        return isMemory ? exitMemory : isOther ? exitRowsFailed : isCheck ? exitCheckFailed : exitGood;
    }

    struct Closer
    {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    const BatchRequest& m_request;
    ManifestWriter& m_manifest;
    ManifestLines m_before; ///< whose files go where a row fails
    BatchProgress m_progress;
    std::unique_ptr<std::FILE, Closer> m_timings;
    std::unique_ptr<RowMaker> m_maker; ///< of a process of the pool
    std::optional<Error> m_problem;    ///< of what it writes down
    bool m_isDiskFull = false;
};

void addBatchOptions(CommandLine& line)
{
    line.add({QStringLiteral("o"), QStringLiteral("output")},
             QStringLiteral("Writes into this folder, which is made where there is none."),
             QStringLiteral("FOLDER"));
    addFileOptions(line);
    addPoolOptions(line);
    line.add({QStringLiteral("shard")},
             QStringLiteral("Only the Ith of N parts of the table; each has a manifest of its own."),
             QStringLiteral("I/N"));
    line.add(
        {QStringLiteral("resume")},
        QStringLiteral("Goes on where an earlier run ended: keeps the rows whose values are the same and "
                       "whose files are there with the hashes of the manifest, and does the others."));
    line.add({QStringLiteral("manifest")},
             QStringLiteral("Instead of FOLDER/manifest.jsonl, or FOLDER/manifest-I-of-N.jsonl of a shard."),
             QStringLiteral("FILE.jsonl"));
    line.add({QStringLiteral("timings")},
             QStringLiteral("Writes how long each row took and how much memory its process has had at most."),
             QStringLiteral("FILE.jsonl"));
    line.addDefault({QStringLiteral("progress")}, QStringLiteral("How far it is, on the standard error."),
                    QStringLiteral("json|openjd|text"), QStringLiteral("text"));
}

Expected<int> runBatch(const CommandLine& line)
{
    const auto request = batchRequestOf(line);
    RAMURE_TRY(request);
    RAMURE_TRY(makeFolder(systemPath(request->plan.folder)));
    VirtualDisplay display; // one for all processes
    const auto isPicture = [](const QString& file) { return file.endsWith(QLatin1String(".png")); };
    const auto& rows = request->plan.rows;
    if (std::ranges::any_of(rows,
                            [&](const BatchRow& row) { return std::ranges::any_of(row.files, isPicture); }))
        RAMURE_TRY(display.ensure());
    auto manifest = ManifestWriter::open(request->manifest, request->resume);
    RAMURE_TRY(manifest);
    return Batch(*request, *manifest).run();
}

} // namespace

const Command batchCommand{batchText, &addBatchOptions, &runBatch, true};

} // namespace ramure::cli
