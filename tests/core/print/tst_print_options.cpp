#include "core/print/print_options.h"
#include "tests/support/suite.h"
#include <limits>

namespace tst_print_options {

using namespace ramure;

class TestPrintOptions : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void badLengths()
    {
        for (const char* text : {"", "mm", "18 furlongs", "1e", "nan", "inf", "--3", "180mm mm", "18,5mm"})
            QVERIFY2(!printLength(text), text);
        QCOMPARE(printLength("tall").error().code, ErrorCode::Syntax);
    }
    void lengths()
    {
        QCOMPARE(*printLength("180mm"), 0.18);
        QCOMPARE(*printLength("180"), 0.18);
        QCOMPARE(*printLength("18 cm"), 0.18);
        QCOMPARE(*printLength("0.18m"), 0.18);
        QCOMPARE(*printLength("1in"), 0.0254);
        QCOMPARE(*printLength("-5mm"), -0.005); // the range is checkPrint's
    }
    void badOptions_data()
    {
        QTest::addColumn<double>("height");
        QTest::addColumn<double>("thinnest");
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QTest::newRow("no height") << 0.0 << 0.0;
        QTest::newRow("below 0") << -0.18 << 0.0;
        QTest::newRow("nan") << nan << 0.0;
        QTest::newRow("a tower") << 2.1 << 0.0;
        QTest::newRow("thin below 0") << 0.18 << -0.001;
        QTest::newRow("thin nan") << 0.18 << nan;
        QTest::newRow("too thin") << 0.18 << 0.00001;
        QTest::newRow("a fifth") << 0.02 << 0.0041;
    }
    void badOptions()
    {
        QFETCH(const double, height);
        QFETCH(const double, thinnest);
        PrintOptions options;
        options.height = height;
        options.thinnest = thinnest;
        const auto checked = checkPrint(options);
        QVERIFY(!checked);
        QCOMPARE(checked.error().code, ErrorCode::Invalid);
    }
    void processes()
    {
        const double thinnest[] = {0.002, 0.0008, 0.001};
        for (std::size_t i = 0; i < printProcesses().size(); ++i) {
            PrintOptions options;
            options.process = static_cast<PrintProcess>(i);
            QCOMPARE(options.smallestDiameter(), thinnest[i]);
            QVERIFY(checkPrint(options));
            options.thinnest = 0.0012;
            QCOMPARE(options.smallestDiameter(), 0.0012);
        }
    }
    void leaves()
    {
        QCOMPARE(std::string(nameOf(PrintLeaves::Off)), std::string("off"));
        QCOMPARE(std::string(nameOf(PrintLeaves::Shells)), std::string("shells"));
        QCOMPARE(PrintOptions().leaves, PrintLeaves::Off);
    }
};

RAMURE_SUITE(TestPrintOptions)

} // namespace tst_print_options

#include "tst_print_options.moc"
