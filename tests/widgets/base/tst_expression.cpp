#include "tests/support/suite.h"
#include "widgets/base/expression.h"
#include <cmath>
#include <numbers>

namespace tst_expression {

using namespace ramure;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double inDegrees = pi / 180.0;

} // namespace

class TestExpression : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void nonsenseIsRefusedAtItsPlace_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("column");
        QTest::newRow("empty") << "" << 1;
        QTest::newRow("blank") << "  " << 3;
        QTest::newRow("word") << "thick" << 1;
        QTest::newRow("two numbers") << "1 2" << 3;
        QTest::newRow("open bracket") << "(1+2" << 5;
        QTest::newRow("closing bracket") << "1+2)" << 4;
        QTest::newRow("operator at the end") << "2*" << 3;
        QTest::newRow("unknown unit") << "3 apples" << 3;
        QTest::newRow("unit of an angle") << "3 deg" << 3;
        QTest::newRow("two points") << "1.2.3" << 4;
        QTest::newRow("unit twice") << "(3 m) m" << 7;
        QTest::newRow("squared unit") << "3 m * 2 m" << 10;
        QTest::newRow("digits of other scripts") << QStringLiteral("1٣") << 3;
        QTest::newRow("unknown function") << "log(3)" << 5;
    }
    void nonsenseIsRefusedAtItsPlace()
    {
        QFETCH(const QString, text);
        QFETCH(const int, column);
        const auto value = evaluateExpression(text, ParamUnit::Metre);
        QVERIFY(!value);
        QCOMPARE(value.error().code, ErrorCode::Syntax);
        QCOMPARE(value.error().column, column);
    }

    void resultsThatAreNoNumbersAreRefused()
    {
        for (const char* text : {"1/0", "-1/0", "0/0", "sqrt(-1)", "10^1000"}) {
            const auto value = evaluateExpression(QString::fromLatin1(text), ParamUnit::None);
            QVERIFY2(!value, text);
            QCOMPARE(value.error().code, ErrorCode::Invalid);
        }
    }

    void tooLargeNumbersAndWordsForNumbersSayWhatIsWrong()
    {
        const auto said = [](const char* text) {
            const auto value = evaluateExpression(QString::fromLatin1(text), ParamUnit::None);
            return value ? std::string() : value.error().text;
        };
        QCOMPARE(said("1e999"), std::string("this number is too large"));
        QCOMPARE(said("2 + 1e400"), std::string("this number is too large"));
        QCOMPARE(said("1e300 * 1e300"), std::string("the result is too large"));
        QCOMPARE(said("0/0"), std::string("the result is no number"));
        for (const char* word : {"nan", "NaN", "inf", "-Infinity"})
            QCOMPARE(said(word), std::string("only finite numbers can be used"));
        QCOMPARE(said("thick"), std::string("a number is missing here"));
        QCOMPARE(evaluateExpression(u"1e-999", ParamUnit::None).value_or(1.0), 0.0);
    }

    void noTextExhaustsTheStack()
    {
        QVERIFY(!evaluateExpression(QString(100'000, u'('), ParamUnit::None));
        QVERIFY(!evaluateExpression(QStringLiteral("2^").repeated(100'000) + u'1', ParamUnit::None));
        QCOMPARE(evaluateExpression(QString(100'000, u'-') + u'1', ParamUnit::None).value_or(0.0), 1.0);
    }

    void values_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("unit");
        QTest::addColumn<double>("factor");
        QTest::addColumn<double>("expected");
        const int none = static_cast<int>(ParamUnit::None);
        const int metre = static_cast<int>(ParamUnit::Metre);
        const int angle = static_cast<int>(ParamUnit::Radian);
        QTest::newRow("integer") << "42" << none << 1.0 << 42.0;
        QTest::newRow("comma") << "0,25" << none << 1.0 << 0.25;
        QTest::newRow("leading point") << ".5" << none << 1.0 << 0.5;
        QTest::newRow("exponent") << "1.5e-3" << none << 1.0 << 0.0015;
        QTest::newRow("product before sum") << "1 + 2 * 3" << none << 1.0 << 7.0;
        QTest::newRow("power from the right") << "2^3^2" << none << 1.0 << 512.0;
        QTest::newRow("sign and power") << "(-2)^2" << none << 1.0 << 4.0;
        QTest::newRow("division") << "1/3" << none << 1.0 << 1.0 / 3.0;
        QTest::newRow("minus sign") << "−3 × 2 ÷ 4" << none << 1.0 << -1.5;
        QTest::newRow("percent") << "25%" << none << 1.0 << 0.25;
        QTest::newRow("function") << "sqrt(16) + abs(-1)" << none << 1.0 << 5.0;
        QTest::newRow("metres") << "20cm" << metre << 1.0 << 0.2;
        QTest::newRow("sum of lengths") << "20 cm + 5mm + 1" << metre << 1.0 << 1.205;
        QTest::newRow("feet") << "1ft" << metre << 1.0 << 0.3048;
        QTest::newRow("grams") << "75 g" << int(ParamUnit::Kilogram) << 1.0 << 0.075;
        QTest::newRow("factor") << "2 × 0.75 ×" << int(ParamUnit::Factor) << 1.0 << 1.5;
        QTest::newRow("degrees") << "18 deg" << angle << inDegrees << 18.0 * inDegrees;
        QTest::newRow("degree sign") << "18°" << angle << inDegrees << 18.0 * inDegrees;
        QTest::newRow("plain is what is shown") << "18" << angle << inDegrees << 18.0 * inDegrees;
        QTest::newRow("plain radians") << "0.5" << angle << 1.0 << 0.5;
        QTest::newRow("pi is in radians") << "2*pi/10" << angle << inDegrees << 0.2 * pi;
        QTest::newRow("radians by name") << "0.5 rad" << angle << inDegrees << 0.5;
        QTest::newRow("turns") << "1/4 turn" << angle << inDegrees << 0.5 * pi;
        QTest::newRow("pi plus degrees") << "pi/2 + 10" << angle << inDegrees << 0.5 * pi + 10.0 * inDegrees;
        QTest::newRow("ratio of units") << "3 m / 1.5 m" << metre << 1.0 << 2.0;
    }
    void values()
    {
        QFETCH(const QString, text);
        QFETCH(const int, unit);
        QFETCH(const double, factor);
        QFETCH(const double, expected);
        const auto value = evaluateExpression(text, static_cast<ParamUnit>(unit), factor);
        QVERIFY2(value, test::why(value).constData());
        QVERIFY2(std::abs(*value - expected) < 1e-12, qPrintable(QString::number(*value)));
    }
};

RAMURE_SUITE(TestExpression)

} // namespace tst_expression

#include "tst_expression.moc"
