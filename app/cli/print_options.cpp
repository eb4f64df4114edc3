#include "app/cli/print_options.h"

#include "core/base/file_writer.h"
#include "core/qt/document/project/print_report_json.h"
#include "core/qt/session/export/print_export.h"
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <cmath>

namespace ramure::cli {
namespace {

/// What a print has no say in, or says itself.
constexpr const char* strangers[] = {"part",   "model", "leaves", "texture", "no-texture", "map-size",
                                     "joints", "scale", "time",   "frames",  "fps",        "seamless"};

Expected<double> lengthOf(const CommandLine& line, const char* option)
{
    auto length = printLength(line.value(option).toStdString());
    if (length && *length > 0.0)
        return length;
    Error error = length ? fail(ErrorCode::Invalid, "\"%1\": a length above 0 expected, such as 180mm",
                                {line.value(option).toStdString()})
                               .value()
                         : std::move(length.error());
    error.path = std::string("--") + option;
    return fail(std::move(error));
}

QString decimalText(double value, int digits = 2)
{
    return QString::number(value, 'f', digits);
}

QString textOf(const PrintedTree& print, const PrintOptions& options)
{
    const PrintReport& r = print.report;
    const auto row = [](const char* name, const QString& value) {
        return QStringLiteral("%1 %2\n").arg(QLatin1String(name), -20).arg(value);
    };
    const auto place = [](const glm::dvec3& p) {
        return QStringLiteral("(%1, %2, %3)")
            .arg(decimalText(1e3 * p.x), decimalText(-1e3 * p.z), decimalText(1e3 * p.y));
    };
    const glm::dvec3 size = 1e3 * r.size();
    return row("size", QStringLiteral("%1 x %2 x %3 mm")
                           .arg(decimalText(size.x), decimalText(size.z), decimalText(size.y))) +
           row("scale", QStringLiteral("1 : %1").arg(decimalText(1.0 / print.scale, 1))) +
           row("volume", decimalText(1e9 * r.volume) + QStringLiteral(" mm³")) +
           row("thinnest", QStringLiteral("%1 mm at %2, of %3 mm asked for")
                               .arg(decimalText(1e3 * r.thinnest), place(r.thinnestAt),
                                    decimalText(1e3 * options.smallestDiameter()))) +
           row("overhang", decimalText(1e6 * r.overhang, 0) + QStringLiteral(" mm² steeper than 45°")) +
           row("centreOfMass", place(r.centreOfMass)) +
           row("stands", !r.standsUp() ? QStringLiteral("no: the centre of mass is not over the foot")
                                       : QStringLiteral("yes, %1 mm inside of the foot's border")
                                             .arg(decimalText(1e3 * r.balance))) +
           row("pieces", QString::number(r.pieces)) + row("crossings", QString::number(r.crossings)) +
           row("closed", r.isClosed ? QStringLiteral("yes") : QStringLiteral("no")) +
           row("triangles", QString::number(r.triangles)) +
           row("branches", QStringLiteral("%1 thickened, %2 cut").arg(print.thickened).arg(print.cut)) +
           (options.leaves == PrintLeaves::Off
                ? QString()
                : row("leaves",
                      QStringLiteral("%1 shells, %2 left out").arg(print.leaves).arg(print.leavesLeftOut)));
}

QJsonObject reportOf(const CommandLine& line, const PrintedTree& print, const PrintOptions& options)
{
    QJsonObject report = toJson(print, options);
    QJsonArray files;
    for (const QString& file : line.values("o"))
        files.append(QFileInfo(file).fileName());
    report.insert(QStringLiteral("format"), QStringLiteral("ramure-print-report"));
    report.insert(QStringLiteral("version"), printReportVersion);
    report.insert(QStringLiteral("program"), versionText().trimmed());
    report.insert(QStringLiteral("input"), line.arguments().front());
    report.insert(QStringLiteral("files"), files);
    return report;
}

} // namespace

void addPrintOptions(CommandLine& line)
{
    QStringList names;
    for (const PrintProcessFacts& process : printProcesses())
        names << QLatin1String(process.name);
    line.add({QStringLiteral("print")},
             QStringLiteral("Makes a tree ready for this kind of printer: without leaves, at --height, twigs "
                            "thickened or cut, all branches united into one closed surface that is flat at "
                            "the ground; in mm with Z up unless --unit and --up say otherwise. Prints a "
                            "report: the thinnest place, overhangs, whether it stands."),
             names.join(QLatin1Char('|')));
    line.add({QStringLiteral("height")}, QStringLiteral("Of the print, in mm or with a unit (cm, m, in)."),
             QStringLiteral("LENGTH"));
    line.add({QStringLiteral("thinnest")},
             QStringLiteral("The smallest diameter of a twig; without it 2 mm for fdm, 0.8 for resin, 1 for "
                            "powder. Thinner twigs become so thick; those that would have to be more than "
                            "1.5 times as thick as they are are cut."),
             QStringLiteral("LENGTH"));
    line.addDefault({QStringLiteral("foot")},
                    QStringLiteral("What a print stands on: a disc, or the trunk, cut flat."),
                    QStringLiteral("disc|flat"), QStringLiteral("disc"));
    line.addDefault(
        {QStringLiteral("print-leaves")},
        QStringLiteral("Leaves of a print: off, or closed shells as thick as the thinnest twig, in one "
                       "piece with their twigs. Small leaves are enlarged and fewer; those too far "
                       "from what is left of their twig are left out."),
        QStringLiteral("off|shells"), QStringLiteral("off"));
    line.add({QStringLiteral("json")}, QStringLiteral("With --print, prints the report as JSON."));
}

Expected<std::optional<PrintOptions>> printFrom(const CommandLine& line)
{
    if (!line.has("print")) {
        for (const char* option : {"height", "thinnest", "foot", "print-leaves", "json"})
            if (line.has(option))
                return fail(ErrorCode::Invalid, "--%1 needs --print", {option});
        return std::optional<PrintOptions>();
    }
    PrintOptions options;
    const auto process = printProcessNamed(line.value("print").toStdString());
    if (!process) {
        Error error = process.error();
        error.path = "--print";
        return fail(std::move(error));
    }
    options.process = *process;
    for (const char* option : strangers)
        if (line.has(option))
            return fail(ErrorCode::Invalid, "--print and --%1 exclude each other", {option});
    if (!line.has("height"))
        return fail(ErrorCode::Invalid, "--print needs --height, such as --height 180mm");
    const auto height = lengthOf(line, "height");
    RAMURE_TRY(height);
    options.height = *height;
    if (line.has("thinnest")) {
        const auto thinnest = lengthOf(line, "thinnest");
        RAMURE_TRY(thinnest);
        options.thinnest = *thinnest;
    }
    const QString foot = line.value("foot");
    if (foot != QLatin1String("disc") && foot != QLatin1String("flat"))
        return fail(ErrorCode::Unknown, "--foot \"%1\": disc, flat expected", {foot.toStdString()});
    options.hasFootDisc = foot == QLatin1String("disc");
    const auto leaves = printLeavesNamed(line.value("print-leaves").toStdString());
    if (!leaves) {
        Error error = leaves.error();
        error.path = "--print-leaves";
        return fail(std::move(error));
    }
    options.leaves = *leaves;
    RAMURE_TRY(checkPrint(options));
    return std::optional(options);
}

Expected<int> printTo(const CommandLine& line, const Input& input, const PrintOptions& options,
                      const std::optional<FileSpace>& space, Evaluator& evaluator, const Progress& progress)
{
    if (!input.scene())
        return fail(ErrorCode::Invalid, "--print needs a tree: the input is a mesh");
    const auto made = printScene(evaluator.at(*input.scene()), {}, options, progress.part(0.0, 0.9));
    RAMURE_TRY(made);
    const PrintReport& report = made->tree.report;
    if (line.has("require-valid") && (!report.isClosed || report.pieces != 1 || report.crossings != 0)) {
        printError(QStringLiteral("the print is not one closed surface, nothing was written"));
        return exitCheckFailed;
    }
    WriteOptions write;
    write.ascii = line.has("ascii");
    FileSpace into = space.value_or(printSpace());
    if (!line.has("up"))
        into.up = printSpace().up;
    if (!line.has("unit"))
        into.unit = printSpace().unit;
    for (const QString& file : line.values("o"))
        RAMURE_TRY(writePrint(systemPath(file), *made, into, write, progress.part(0.9, 1.0)));
    const QJsonObject json = reportOf(line, made->tree, options);
    if (line.has("report"))
        RAMURE_TRY(writeFile(systemPath(line.value("report")), QJsonDocument(json).toJson().toStdString()));
    const auto told = line.has("json") ? printJson(json) : print(textOf(made->tree, options));
    return told ? Expected<int>(exitGood) : fail(told.error());
}

} // namespace ramure::cli
