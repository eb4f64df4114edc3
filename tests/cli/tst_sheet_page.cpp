#include "app/cli/batch/sheet_page.h"
#include "tests/cli/cli_support.h"
#include <QJsonArray>

namespace tst_sheet_page {

using namespace ramure;
using namespace ramure::cli;

/// Cards, and what stands out among them.
class TestSheetPage : public QObject
{
    Q_OBJECT
    static QJsonObject line(int row, const char* input, double height, int faces = 1000)
    {
        return {{"row", row},
                {"input", input},
                {"seed", row},
                {"measures", QJsonObject{{"height", height}}},
                {"counts", QJsonObject{{"faces", faces}}}};
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void nothing()
    {
        QVERIFY(outliersOf({}).empty());
        const QByteArray page = sheetPage({}, {});
        QVERIFY(page.startsWith("<!DOCTYPE html>") && page.endsWith("</html>\n"));
        QVERIFY(page.contains("0 rows, 0 failed, 0 outliers") && !page.contains("<figure class"));
    }

    void errorsHaveACardWithoutFigures()
    {
        const QJsonObject failed{
            {"row", 1},
            {"input", "<b>"},
            {"set", QJsonArray{"a=\"x\"&<script>"}},
            {"error", QJsonObject{{"kind", "input"}, {"text", "t.csv:2: no </figure>"}}}};
        const QByteArray page = sheetPage({{1, failed}}, {});
        QVERIFY(page.contains("1 rows, 1 failed, 0 outliers"));
        QVERIFY(page.contains("class=\"row failed\"") && page.contains("no &lt;/figure&gt;"));
        QVERIFY(page.contains("data-input=\"&lt;b&gt;\"") && page.contains("&amp;&lt;script&gt;"));
        QVERIFY(!page.contains("data-height"));
    }

    void whatIsFarFromTheOthersStandsOut()
    {
        ManifestLines lines;
        for (int row = 1; row <= 20; ++row)
            lines[row] = line(row, "preset:Oak", 10.0 + 0.1 * (row % 5));
        QVERIFY(outliersOf(lines).empty());
        lines[7] = line(7, "preset:Oak", 25.0);
        lines[9] = line(9, "preset:Oak", 10.2, 5000);
        const auto found = outliersOf(lines);
        QCOMPARE(found.size(), std::size_t(2));
        QCOMPARE(found.at(7), QStringList{"height"});
        QCOMPARE(found.at(9), QStringList{"faces"});
        QVERIFY(sheetPage(lines, {}).contains("<b class=\"far\">25 m</b>"));
    }

    void inputsAreComparedWithThemselves()
    {
        ManifestLines lines;
        for (int row = 1; row <= 20; ++row)
            lines[row] = line(row, row % 2 == 0 ? "preset:Oak" : "preset:Shrub", row % 2 == 0 ? 20.0 : 1.0);
        QVERIFY(outliersOf(lines).empty());
        // Too few rows to say what is usual.
        lines[21] = line(21, "preset:Palm", 100.0);
        lines[22] = line(22, "preset:Palm", 1.0);
        QVERIFY(outliersOf(lines).empty());
    }

    void picturesAreInThePage()
    {
        const QByteArray page = sheetPage({{3, line(3, "preset:Oak", 2.5)}}, {{3, "bytes"}});
        QVERIFY(page.contains("src=\"data:image/jpeg;base64," + QByteArray("bytes").toBase64() + "\""));
        QVERIFY(page.contains("data-height=\"2.5\"") && page.contains("seed=3"));
    }
};

RAMURE_SUITE(TestSheetPage)

} // namespace tst_sheet_page

#include "tst_sheet_page.moc"
