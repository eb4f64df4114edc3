#include "core/qt/document/project/print_report_json.h"

#include <QJsonArray>
#include <cmath>

namespace ramure {
namespace {

/// Of more digits nothing is known.
double sixDecimals(double number)
{
    return std::round(1e6 * number) / 1e6;
}

double millimetres(double metres)
{
    return sixDecimals(1e3 * metres);
}

QJsonArray place(const glm::dvec3& metres)
{
    return {millimetres(metres.x), millimetres(-metres.z), millimetres(metres.y)};
}

} // namespace

QJsonObject toJson(const PrintedTree& print, const PrintOptions& options)
{
    const PrintReport& report = print.report;
    const glm::dvec3 size = report.size();
    const auto& process = printProcesses()[static_cast<std::size_t>(options.process)];
    return {
        {QStringLiteral("process"), QLatin1String(process.name)},
        {QStringLiteral("height"), millimetres(options.height)},
        {QStringLiteral("smallestDiameter"), millimetres(options.smallestDiameter())},
        {QStringLiteral("scale"), print.scale},
        {QStringLiteral("size"), QJsonArray{millimetres(size.x), millimetres(size.z), millimetres(size.y)}},
        {QStringLiteral("volume"), sixDecimals(1e9 * report.volume)},
        {QStringLiteral("thinnest"), millimetres(report.thinnest)},
        {QStringLiteral("thinnestAt"), place(report.thinnestAt)},
        {QStringLiteral("overhangArea"), sixDecimals(1e6 * report.overhang)},
        {QStringLiteral("centreOfMass"), place(report.centreOfMass)},
        {QStringLiteral("footArea"), sixDecimals(1e6 * report.footArea)},
        {QStringLiteral("balance"),
         std::isfinite(report.balance) ? QJsonValue(millimetres(report.balance)) : QJsonValue()},
        {QStringLiteral("stands"), report.standsUp()},
        {QStringLiteral("pieces"), qint64(report.pieces)},
        {QStringLiteral("crossings"), qint64(report.crossings)},
        {QStringLiteral("triangles"), qint64(report.triangles)},
        {QStringLiteral("closed"), report.isClosed},
        {QStringLiteral("thickened"), qint64(print.thickened)},
        {QStringLiteral("cut"), qint64(print.cut)},
        {QStringLiteral("loose"), qint64(print.loose)},
        {QStringLiteral("leaves"), QLatin1String(nameOf(options.leaves))},
        {QStringLiteral("shells"), qint64(print.leaves)},
        {QStringLiteral("leavesLeftOut"), qint64(print.leavesLeftOut)}};
}

} // namespace ramure
