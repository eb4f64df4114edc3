#include "app/cli/print_options.h"

#include "core/base/file_writer.h"
#include "core/qt/document/project/print_report_json.h"
#include "core/qt/session/export/print_export.h"
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>

namespace ramure::cli {
namespace {

/// These options do not stand in the table and cannot be combined with a print.
constexpr const char* strangers[] = {"time", "frames", "fps", "seamless"};

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

Expected<void> checkPrintOptions(const CommandLine& line, const PrintOptions& options)
{
    const bool isPrint = line.has("print");
    const auto check = [&](const char* option, bool isOfPrint, bool isStranger) -> Expected<void> {
        if (!isPrint && isOfPrint && line.has(option))
            return fail(ErrorCode::Invalid, "--%1 needs --print", {option});
        if (isPrint && isStranger && line.has(option))
            return fail(ErrorCode::Invalid, "--print and --%1 exclude each other", {option});
        return {};
    };
    for (const ExportOption& option : exportOptions())
        RAMURE_TRY(check(option.name, option.is(ofPrint), option.is(notOfPrint)));
    RAMURE_TRY(check("json", true, false));
    for (const char* option : strangers)
        RAMURE_TRY(check(option, false, true));
    if (isPrint && !line.has("height"))
        return fail(ErrorCode::Invalid, "--print needs --height, such as --height 180mm");
    return isPrint ? checkPrint(options) : Expected<void>();
}

Expected<ExportOutcome> printTo(const CommandLine& line, const Input& input, const ExportOptions& options,
                                Evaluator& evaluator, const Progress& progress)
{
    if (!input.scene())
        return fail(ErrorCode::Invalid, "--print needs a tree: the input is a mesh");
    const auto made = printScene(evaluator.at(*input.scene()), {}, options.print, progress.part(0.0, 0.9));
    RAMURE_TRY(made);
    const PrintReport& report = made->tree.report;
    if (line.has("require-valid") && (!report.isClosed || report.pieces != 1 || report.crossings != 0))
        return ExportOutcome{exitCheckFailed,
                             QStringLiteral("the print is not one closed surface, nothing was written")};
    FileSpace into = spaceGiven(line, options).value_or(printSpace());
    if (!line.has("up"))
        into.up = printSpace().up;
    if (!line.has("unit"))
        into.unit = printSpace().unit;
    for (const QString& file : line.values("o"))
        RAMURE_TRY(writePrint(systemPath(file), *made, into, options.write, progress.part(0.9, 1.0)));
    const QJsonObject json = reportOf(line, made->tree, options.print);
    if (line.has("report"))
        RAMURE_TRY(writeFile(systemPath(line.value("report")), QJsonDocument(json).toJson().toStdString()));
    return ExportOutcome{
        exitGood, line.has("json") ? QString::fromUtf8(QJsonDocument(json).toJson(QJsonDocument::Indented))
                                   : textOf(made->tree, options.print)};
}

} // namespace ramure::cli
