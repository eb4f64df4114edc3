#include "app/cli/commands/commands.h"
#include "app/cli/export_options.h"
#include "app/cli/input.h"
#include "app/cli/work.h"
#include "core/evaluate/evaluator.h"
#include "core/io/formats/file_format.h"
#include "core/qt/session/export/exporter.h"
#include <algorithm>
#include <cmath>

namespace ramure::cli {

namespace {

constexpr CommandText ageText = {
    "age", "writes a tree at several ages", "INPUT",
    "Writes a file for each age of the trees that grow by years, each cut out of one life.",
    "FILE holds {age}, in whose place stand the years, with as many digits for all of them: "
    "`ramure-cli age preset:EnglishOak --from 5 --to 90 --step 5 -o 'oak_{age}.glb'`. The ages are those "
    "from --from to --to, --step apart. Trees that do not grow by years stay as they are. The other options "
    "are those of `export`."};

const QString placeholder = QStringLiteral("{age}");
constexpr std::size_t mostAges = 2000;

Expected<double> yearsOf(const CommandLine& line, const char* option, double usual)
{
    if (!line.has(option))
        return usual;
    bool isNumber = false;
    const double years = line.value(option).toDouble(&isNumber);
    if (!isNumber || !std::isfinite(years) || years < 0.0)
        return fail(ErrorCode::Invalid, "--%1 \"%2\": a number of years expected",
                    {option, line.value(option).toStdString()});
    return years;
}

Expected<std::vector<double>> agesOf(const CommandLine& line)
{
    const auto from = yearsOf(line, "from", 1.0), to = yearsOf(line, "to", 100.0),
               step = yearsOf(line, "step", 10.0);
    RAMURE_TRY(from);
    RAMURE_TRY(to);
    RAMURE_TRY(step);
    if (*to < *from)
        return fail(ErrorCode::Invalid, "--to is less than --from");
    if (!(*step > 0.0) || (*to - *from) / *step >= static_cast<double>(mostAges))
        return fail(ErrorCode::Invalid, "--step: more than 0, and at most %1 ages",
                    {std::to_string(mostAges)});
    std::vector<double> ages;
    for (double age = *from; age <= *to + 1e-9; age = *from + *step * static_cast<double>(ages.size()))
        ages.push_back(age);
    return ages;
}

/// "005" beside "090".
QString ageName(double age, double oldest)
{
    const QString years = QString::number(age);
    const auto digits = QString::number(std::floor(oldest)).size();
    const auto whole = years.section(u'.', 0, 0).size();
    return QString(std::max<qsizetype>(digits - whole, 0), u'0') + years;
}

bool setAge(Scene& scene, double age)
{
    bool grows = false;
    for (const Node& node : scene.nodes())
        if (node.kind == NodeKind::Tree && node.params.generator.kind == EditOperation::Growth) {
            scene.find(node.id)->params.growth.age = age;
            grows = true;
        }
    return grows;
}

Expected<void> writeAges(Scene scene, const CommandLine& line, const std::vector<double>& ages,
                         ExportOptions options, const Progress& progress)
{
    const QStringList files = line.values("o");
    TreePipeline pipeline;
    Evaluator evaluator(pipelineSource(pipeline), {});
    const auto count = static_cast<double>(ages.size());
    for (std::size_t i = 0; i < ages.size(); ++i) {
        if (!setAge(scene, ages[i]))
            return fail(ErrorCode::Invalid,
                        "no tree here grows by years: `preset:EnglishOak` does, and `generator.kind=growth` "
                        "makes one");
        const Progress part = progress.part(double(i) / count, double(i + 1) / count);
        for (QString file : files) {
            file.replace(placeholder, ageName(ages[i], ages.back()));
            const auto format = findFormat(systemPath(file), FormatUse::Write, options.write.ascii);
            RAMURE_TRY(format);
            if (!line.has("part"))
                options.parts = usualParts(**format, options.instances);
            const auto written = exportScene(evaluator.at(scene, 0.0), options, systemPath(file), part);
            RAMURE_TRY(written);
        }
    }
    return {};
}

void addAgeOptions(CommandLine& line)
{
    line.add({QStringLiteral("o"), QStringLiteral("output")},
             QStringLiteral("Writes these files; may be repeated."), QStringLiteral("FILE"));
    line.addInputOptions();
    line.addNodeOption();
    line.add({QStringLiteral("from")}, QStringLiteral("The first age, in years; 1 where it is missing."),
             QStringLiteral("YEARS"));
    line.add({QStringLiteral("to")}, QStringLiteral("The last age; 100 where it is missing."),
             QStringLiteral("YEARS"));
    line.add({QStringLiteral("step")}, QStringLiteral("From one age to the next; 10 where it is missing."),
             QStringLiteral("YEARS"));
    addExportOptions(line, ofExport);
    line.add({QStringLiteral("ascii")}, QStringLiteral("Writes a format that has both as text, not binary."));
}

Expected<int> runAge(const CommandLine& line)
{
    const auto ages = agesOf(line);
    RAMURE_TRY(ages);
    const QStringList files = line.values("o");
    if (files.isEmpty())
        return fail(ErrorCode::Invalid, "missing -o FILE: `ramure-cli age --help` shows what it takes");
    for (const QString& file : files)
        if (ages->size() > 1 && !file.contains(placeholder))
            return fail(ErrorCode::Invalid, "-o \"%1\": {age} is missing, where the years are to stand",
                        {file.toStdString()});
    ExportOptions usual;
    usual.texture = true;
    usual.write.ascii = line.has("ascii");
    auto options = exportOptionsOf(line, ofExport, std::move(usual));
    RAMURE_TRY(options);
    auto input = loadInput(line);
    RAMURE_TRY(input);
    RAMURE_TRY(keepNodes(*input, line.values("node")));
    if (!input->scene())
        return fail(ErrorCode::Invalid, "\"%1\" is a mesh: only trees have an age",
                    {line.arguments().front().toStdString()});
    const Work work("age");
    auto written = writeAges(*input->scene(), line, *ages, std::move(*options), work.progress());
    RAMURE_TRY(written);
    return exitGood;
}

} // namespace

const Command ageCommand{ageText, &addAgeOptions, &runAge};

} // namespace ramure::cli
