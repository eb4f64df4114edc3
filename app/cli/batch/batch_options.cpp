#include "app/cli/batch/batch_options.h"

#include "app/cli/export_options.h"
#include <QRegularExpression>

namespace ramure::cli {

namespace {

constexpr int smallestSide = 16, largestSide = 8192;
constexpr int mostProcesses = 1024;

/// "800M", "2G", "1500000000"
std::optional<std::size_t> bytesFrom(const QString& text)
{
    static const QRegularExpression form(QStringLiteral("^(\\d{1,12})([KMG]?)$"));
    const auto match = form.match(text);
    if (!match.hasMatch())
        return std::nullopt;
    const QString unit = match.captured(2);
    const int shift = unit == QLatin1String("K")   ? 10
                      : unit == QLatin1String("M") ? 20
                      : unit == QLatin1String("G") ? 30
                                                   : 0;
    return std::size_t(match.captured(1).toULongLong()) << shift;
}

} // namespace

Expected<QSize> pictureSizeFrom(const QString& value)
{
    const QStringList sides = value.toLower().split(QLatin1Char('x'));
    bool isWidth = false;
    bool isHeight = false;
    const int width = sides.front().toInt(&isWidth);
    const int height = sides.back().toInt(&isHeight);
    const auto isSide = [](int side) { return side >= smallestSide && side <= largestSide; };
    if (sides.size() != 2 || !isWidth || !isHeight || !isSide(width) || !isSide(height))
        return fail(ErrorCode::Invalid, "--size \"%1\": WIDTHxHEIGHT expected, each %2 to %3 pixels",
                    {value.toStdString(), std::to_string(smallestSide), std::to_string(largestSide)});
    return QSize(width, height);
}

void addPoolOptions(CommandLine& line)
{
    line.add({QStringLiteral("jobs"), QStringLiteral("j")},
             QStringLiteral("So many rows at a time, each by a process of one thread; without it as many as "
                            "there are cores."),
             QStringLiteral("N"));
    line.add(
        {QStringLiteral("memory")},
        QStringLiteral("What one of these processes may take: a row that wants more has an error and ends "
                       "nothing else; 800M, 2G. Without it there is no limit."),
        QStringLiteral("BYTES"));
}

Expected<PoolOptions> poolOptionsOf(const CommandLine& line)
{
    PoolOptions out{usualProcesses(), 0};
    if (line.has("jobs")) {
        bool isNumber = false;
        out.processes = line.value("jobs").toInt(&isNumber);
        if (!isNumber || out.processes < 1 || out.processes > mostProcesses)
            return fail(ErrorCode::Invalid, "--jobs \"%1\": 1 to %2 expected",
                        {line.value("jobs").toStdString(), std::to_string(mostProcesses)});
    }
    if (line.has("memory")) {
        const auto bytes = bytesFrom(line.value("memory"));
        if (!bytes || *bytes == 0)
            return fail(ErrorCode::Invalid, "--memory \"%1\": a number of bytes expected, like 800M or 2G",
                        {line.value("memory").toStdString()});
        out.memoryBytes = *bytes;
    }
    return out;
}

void addFileOptions(CommandLine& line)
{
    line.add(
        {QStringLiteral("file")},
        QStringLiteral("What is written of each row; may be repeated. The ending says what: a mesh as "
                       "`export` writes it, .png a picture, and a name that ends in / the folder of the "
                       "pictures of bark and leaves. {preset}, {row}, {block} (a number for each thousand "
                       "rows, for folders) and {COLUMN} stand for what the row has. Without it "
                       "{preset}_{row}.glb."),
        QStringLiteral("TEMPLATE"));
    addExportOptions(line, ofBatch);
    line.addDefault({QStringLiteral("size")}, QStringLiteral("Of pictures, 512x512 without it."),
                    QStringLiteral("WIDTHxHEIGHT"), QStringLiteral("512x512"));
}

Expected<BatchPlan> planOf(const CommandLine& line, const Shard& shard)
{
    const auto picture = pictureSizeFrom(line.value("size"));
    RAMURE_TRY(picture);
    ExportOptions usual;
    usual.write.mapSize = 0;
    auto options = exportOptionsOf(line, ofBatch, std::move(usual));
    RAMURE_TRY(options);
    auto plan = readPlan(line.arguments().front(), templatesOf(line), shard);
    if (!plan)
        return plan;
    plan->options = std::move(*options);
    plan->picture = *picture;
    return plan;
}

QStringList templatesOf(const CommandLine& line)
{
    return line.has("file") ? line.values("file") : QStringList{QStringLiteral("{preset}_{row}.glb")};
}

} // namespace ramure::cli
