#include "app/cli/batch/sheet_page.h"
#include <QJsonArray>
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace ramure::cli {

namespace {

constexpr std::size_t leastRows = 8; ///< of which a median says something
constexpr double farDeviations = 5.0, leastShare = 0.1;
constexpr double normalDeviation = 1.4826; ///< of a normal distribution, in median deviations

double medianOf(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

QString figureText(double value)
{
    return QString::number(value, 'g', std::abs(value) < 1e6 && value == std::floor(value) ? 7 : 4);
}

/// In text and in attributes.
QString html(const QString& text)
{
    return text.toHtmlEscaped();
}

QString inputOf(const QJsonObject& line)
{
    return line.value(QStringLiteral("input")).toString();
}

QString errorOf(const QJsonObject& line)
{
    return line.value(QStringLiteral("error")).toObject().value(QStringLiteral("text")).toString();
}

/// What the row was made from: its seed and its parameters.
QString variationOf(const QJsonObject& line)
{
    QStringList words;
    if (line.contains(QStringLiteral("seed")))
        words << QStringLiteral("seed=%1").arg(line.value(QStringLiteral("seed")).toInteger());
    for (const QJsonValue set : line.value(QStringLiteral("set")).toArray())
        words << set.toString();
    return words.join(QLatin1Char(' '));
}

constexpr const char* head = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>Ramure: contact sheet</title>
<style>
body { font: 13px/1.4 sans-serif; margin: 16px; color: #222; background: #f4f4f2; }
header { position: sticky; top: 0; background: #f4f4f2; padding: 8px 0; }
header label { margin-right: 12px; }
main { display: grid; grid-template-columns: repeat(auto-fill, minmax(170px, 1fr)); gap: 10px; }
figure { margin: 0; padding: 6px; background: #fff; border: 2px solid #ddd; overflow-wrap: anywhere; }
figure[hidden] { display: none; }
figure.outlier { border-color: #d98a00; }
figure.failed { border-color: #c0392b; }
figure img { width: 100%; display: block; }
figure .none { aspect-ratio: 1; background: #eee; }
b.far { color: #a86a00; }
p { margin: 2px 0; }
p.error { color: #c0392b; }
</style>
</head>
<body>
)";

constexpr const char* foot = R"(<script>
"use strict";
const cards = [...document.querySelectorAll("figure")], main = document.querySelector("main");
const field = id => document.getElementById(id);
const figure = (card, key) => card.dataset[key] === undefined ? NaN : Number(card.dataset[key]);
function show() {
    const words = field("words").value.toLowerCase().split(/\s+/).filter(word => word);
    const input = field("input").value, kind = field("kind").value, key = field("key").value;
    const least = parseFloat(field("least").value), most = parseFloat(field("most").value);
    let shown = 0;
    for (const card of cards) {
        const text = card.textContent.toLowerCase(), value = figure(card, key);
        card.hidden = !words.every(word => text.includes(word)) || (input && card.dataset.input !== input) ||
            (kind && !card.classList.contains(kind)) || value < least || value > most ||
            (isNaN(value) && !(isNaN(least) && isNaN(most)));
        shown += card.hidden ? 0 : 1;
    }
    field("shown").textContent = shown + " of " + cards.length;
}
function sort() {
    const key = field("key").value, way = field("order").value;
    const order = (a, b) => figure(a, key) - figure(b, key) || a.dataset.row - b.dataset.row;
    const sorted = [...cards].sort((a, b) => way === "row" ? a.dataset.row - b.dataset.row :
        isNaN(figure(a, key)) - isNaN(figure(b, key)) || (way === "up" ? order(a, b) : order(b, a)));
    main.append(...sorted);
}
for (const id of ["words", "input", "kind", "key", "least", "most"]) field(id).addEventListener("input", show);
for (const id of ["key", "order"]) field(id).addEventListener("input", sort);
show();
</script>
</body>
</html>
)";

QString option(const QString& value, const QString& text)
{
    return QStringLiteral("<option value=\"%1\">%2</option>").arg(html(value), html(text));
}

QString filters(const ManifestLines& lines)
{
    std::set<QString> inputs;
    for (const auto& [row, line] : lines)
        inputs.insert(inputOf(line));
    QString choices = option({}, QStringLiteral("all"));
    for (const QString& input : inputs)
        choices += option(input, input);
    QString keys;
    for (const SheetFigure& figure : sheetFigures)
        keys += option(QString(QLatin1String(figure.key)).toLower(), QLatin1String(figure.key));
    return QStringLiteral("<label>Words <input id=\"words\" type=\"search\"></label>\n"
                          "<label>Input <select id=\"input\">%1</select></label>\n"
                          "<label>Show <select id=\"kind\"><option value=\"\">all</option><option "
                          "value=\"outlier\">outliers"
                          "</option><option value=\"failed\">failed</option></select></label>\n"
                          "<label>Figure <select id=\"key\">%2</select></label>\n"
                          "<label>from <input id=\"least\" type=\"number\" step=\"any\"></label>\n"
                          "<label>to <input id=\"most\" type=\"number\" step=\"any\"></label>\n"
                          "<label>Order <select id=\"order\"><option value=\"row\">rows</option><option "
                          "value=\"up\">smallest first"
                          "</option><option value=\"down\">largest first</option></select></label>\n"
                          "<span id=\"shown\"></span>\n")
        .arg(choices, keys);
}

QString cardOf(std::int64_t row, const QJsonObject& line, const QByteArray& picture, const QStringList& far)
{
    const QString error = errorOf(line);
    QString kinds, data, figures;
    kinds += error.isEmpty() ? QString() : QStringLiteral(" failed");
    kinds += far.isEmpty() ? QString() : QStringLiteral(" outlier");
    for (const SheetFigure& figure : sheetFigures) {
        const auto value = figureOf(line, figure);
        if (!value)
            continue;
        const QString key = QLatin1String(figure.key), number = figureText(*value);
        const bool isFar = far.contains(key);
        data += QStringLiteral(" data-%1=\"%2\"").arg(key.toLower(), QString::number(*value, 'g', 12));
        figures += QStringLiteral("<br>%1 %2%3 %4%5")
                       .arg(key, QLatin1String(isFar ? "<b class=\"far\">" : ""), number,
                            QString::fromUtf8(figure.unit), QLatin1String(isFar ? "</b>" : ""));
    }
    const QString image =
        picture.isEmpty()
            ? QStringLiteral("<div class=\"none\"></div>")
            : QStringLiteral("<img loading=\"lazy\" alt=\"\" src=\"data:image/jpeg;base64,%1\">")
                  .arg(QLatin1String(picture.toBase64()));
    const QString problem =
        error.isEmpty() ? QString() : QStringLiteral("<p class=\"error\">%1</p>").arg(html(error));
    return QStringLiteral("<figure class=\"row%1\" data-row=\"%2\" data-input=\"%3\"%4>%5"
                          "<figcaption><p><b>%2</b> %3</p><p>%6%7</p>%8</figcaption></figure>\n")
        .arg(kinds, QString::number(row), html(inputOf(line)), data, image, html(variationOf(line)), figures,
             problem);
}

} // namespace

std::optional<double> figureOf(const QJsonObject& line, const SheetFigure& figure)
{
    for (const char* object : {"counts", "measures"}) {
        const QJsonValue value =
            line.value(QLatin1String(object)).toObject().value(QLatin1String(figure.key));
        if (value.isDouble())
            return value.toDouble();
    }
    return std::nullopt;
}

std::map<std::int64_t, QStringList> outliersOf(const ManifestLines& lines)
{
    std::map<std::int64_t, QStringList> out;
    std::map<QString, std::vector<std::pair<std::int64_t, double>>> groups;
    for (const SheetFigure& figure : sheetFigures) {
        groups.clear();
        for (const auto& [row, line] : lines)
            if (const auto value = figureOf(line, figure))
                groups[inputOf(line)].emplace_back(row, *value);
        for (const auto& [input, rows] : groups) {
            if (rows.size() < leastRows)
                continue;
            std::vector<double> values;
            for (const auto& [row, value] : rows)
                values.push_back(value);
            const double median = medianOf(values);
            for (double& value : values)
                value = std::abs(value - median);
            const double far =
                std::max(farDeviations * normalDeviation * medianOf(values), leastShare * std::abs(median));
            for (const auto& [row, value] : rows)
                if (std::abs(value - median) > far)
                    out[row] << QLatin1String(figure.key);
        }
    }
    return out;
}

QByteArray sheetPage(const ManifestLines& lines, const std::map<std::int64_t, QByteArray>& pictures)
{
    const auto outliers = outliersOf(lines);
    const auto failed =
        std::ranges::count_if(lines, [](const auto& line) { return !errorOf(line.second).isEmpty(); });
    QByteArray page = head;
    page += QStringLiteral("<header><h1>Contact sheet</h1>\n<p>%1 rows, %2 failed, %3 outliers</p>\n")
                .arg(lines.size())
                .arg(failed)
                .arg(outliers.size())
                .toUtf8();
    page += filters(lines).toUtf8() + "</header>\n<main>\n";
    for (const auto& [row, line] : lines) {
        const auto picture = pictures.find(row);
        const auto far = outliers.find(row);
        page += cardOf(row, line, picture == pictures.end() ? QByteArray() : picture->second,
                       far == outliers.end() ? QStringList() : far->second)
                    .toUtf8();
    }
    return page + "</main>\n" + foot;
}

} // namespace ramure::cli
