#include "core/generators/parametric/parametric_grammar.h"
#include "core/generators/parametric/quantity.h"
#include "core/math/random.h"
#include "tests/support/suite.h"
#include <cmath>
#include <numbers>
#include <optional>

namespace tst_quantity {

using namespace ramure;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double inDegrees = pi / 180.0;

} // namespace

class TestQuantity : public QObject
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
        QTest::newRow("squared unit") << "3 m * 2 m" << 5;
        QTest::newRow("digits of other scripts") << QStringLiteral("1٣") << 2;
        QTest::newRow("unknown function") << "log(3)" << 1;
        QTest::newRow("comparison") << "1 < 2" << 3;
        QTest::newRow("choice by chance") << "rand(1, 2)" << 1;
        QTest::newRow("name of grammars") << "order" << 1;
        QTest::newRow("not") << "!1" << 1;
        QTest::newRow("power of a unit") << "2 * (3 m) ^ 2" << 11;
        QTest::newRow("one number too few") << "min(1,2)" << 8;
    }
    void nonsenseIsRefusedAtItsPlace()
    {
        QFETCH(const QString, text);
        QFETCH(const int, column);
        const auto value = evaluateQuantity(text.toStdString(), ParamUnit::Metre);
        QVERIFY(!value);
        QCOMPARE(value.error().code, ErrorCode::Syntax);
        QCOMPARE(value.error().column, column);
    }

    void resultsThatAreNoNumbersAreRefused()
    {
        for (const char* text : {"1/0", "-1/0", "0/0", "sqrt(-1)", "10^1000"}) {
            const auto value = evaluateQuantity(text, ParamUnit::None);
            QVERIFY2(!value, text);
            QCOMPARE(value.error().code, ErrorCode::Invalid);
        }
    }

    void tooLargeNumbersAndWordsForNumbersSayWhatIsWrong()
    {
        const auto said = [](const char* text) {
            const auto value = evaluateQuantity(text, ParamUnit::None);
            return value ? std::string() : value.error().plain();
        };
        QCOMPARE(said("1e999"), std::string("the number 1e999 is out of all range"));
        QCOMPARE(said("2 + 1e400"), std::string("the number 1e400 is out of all range"));
        QCOMPARE(said("1e300 * 1e300"), std::string("the result is not a finite number"));
        QCOMPARE(said("0/0"), std::string("the result is not a finite number"));
        for (const std::string word : {"nan", "NaN", "inf", "Infinity", "thick"})
            QCOMPARE(said(word.c_str()), '"' + word + "\" is neither a number nor a function");
        QCOMPARE(said("2 *"), std::string("a number is missing here"));
        QCOMPARE(evaluateQuantity("1e-999", ParamUnit::None).value_or(1.0), 0.0);
    }

    void noTextExhaustsTheStack()
    {
        QVERIFY(!evaluateQuantity(std::string(100'000, '('), ParamUnit::None));
        QVERIFY(!evaluateQuantity(QByteArray("2^").repeated(100'000).toStdString() + '1', ParamUnit::None));
        const auto signs = evaluateQuantity(std::string(100'000, '-').append("1"), ParamUnit::None);
        QVERIFY(!signs && signs.error().code == ErrorCode::Limit);
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
        QTest::newRow("a power binds more than a sign") << "-2^2" << none << 1.0 << -4.0;
        QTest::newRow("sign of a power") << "2^-2" << none << 1.0 << 0.25;
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
        QTest::newRow("sine of degrees") << "2 * sin(30)" << none << 1.0 << 1.0;
        QTest::newRow("sine of what pi makes") << "2 * sin(pi/6)" << metre << 1.0 << 1.0;
        QTest::newRow("cosine of an angle by name") << "cos(60 deg) * 90" << angle << inDegrees << 0.25 * pi;
        QTest::newRow("tangent of degrees") << "tan(45)" << angle << 1.0 << 1.0;
        QTest::newRow("absolute length") << "abs(-3 cm)" << metre << 1.0 << 0.03;
        QTest::newRow("the larger length") << "max(3 cm, 1)" << metre << 1.0 << 1.0;
        QTest::newRow("power and unit") << "2^2 cm" << metre << 1.0 << 0.04;
        QTest::newRow("capitals") << "3 CM" << metre << 1.0 << 0.03;
        QTest::newRow("blanks that do not break") << "20\u00A0cm\u202F+ 5\u2009mm" << metre << 1.0 << 0.205;
        QTest::newRow("en dash") << "5 \u2013 2" << none << 1.0 << 3.0;
        QTest::newRow("comma at the end") << "3," << none << 1.0 << 3.0;
        QTest::newRow("per cent of a share") << "25 % + 10" << int(ParamUnit::Share) << 0.01 << 0.35;
        QTest::newRow("ratio of units") << "3 m / 1.5 m" << metre << 1.0 << 2.0;
    }
    void values()
    {
        QFETCH(const QString, text);
        QFETCH(const int, unit);
        QFETCH(const double, factor);
        QFETCH(const double, expected);
        const auto value = evaluateQuantity(text.toStdString(), static_cast<ParamUnit>(unit), factor);
        QVERIFY2(value, test::why(value).constData());
        QVERIFY2(std::abs(*value - expected) < 1e-12, qPrintable(QString::number(*value)));
    }

    /// Number fields and grammars read the same arithmetic, to the last bit.
    void fieldsAndGrammarsAgree()
    {
        for (const char* text :
             {"-2^2",          "2^-1",           "-2^-2",     "2^3^2",     "8 - 4 - 2",
              "8 / 4 / 2",     "-(-3)",          "--3",       "+4",        "sin(30)",
              "cos(60)",       "tan(45)",        "sin(-750)", "sqrt(2)^2", "abs(-2^2)",
              "min(3, -1, 2)", "max(1, 2) * .5", "1e3 / 7",   "1e-999",    "2 \u2212 3 \u00D7 4"}) {
            const std::optional<double> inField = ofField(text), inGrammar = ofGrammar(text);
            QVERIFY2(inField && inGrammar && *inField == *inGrammar, text);
        }
        Random random(11, RandomStream::Test);
        int good = 0;
        for (int i = 0; i < test::runs(20'000); ++i) {
            const std::string text = expression(random, 4);
            const std::optional<double> inField = ofField(text), inGrammar = ofGrammar(text);
            QVERIFY2(inField == inGrammar, text.c_str());
            good += inField ? 1 : 0;
        }
        QVERIFY(good > test::runs(20'000) / 20);
    }

private:
    static std::optional<double> ofField(const std::string& text)
    {
        const auto value = evaluateQuantity(text, ParamUnit::None);
        return value ? std::optional(*value) : std::nullopt;
    }
    static std::optional<double> ofGrammar(const std::string& text)
    {
        GrammarParams params;
        params.dialect = GrammarDialect::Parametric;
        params.constants = "x = " + text;
        const auto constants = parseConstants(params);
        return constants ? std::optional(constants->at("x")) : std::nullopt;
    }
    static std::string expression(Random& random, int depth)
    {
        static constexpr const char* numbers[] = {"0", "1", "2", "0.5", "3", "30", "45", "1e2", ".25"};
        static constexpr const char* signs[] = {" + ", "-", "*", " / ", "^"};
        static constexpr const char* functions[] = {"sin", "cos", "tan", "abs", "sqrt"};
        const std::uint32_t kind = depth == 0 ? 0 : random.below(6);
        const auto inner = [&] { return expression(random, depth - 1); };
        switch (kind) {
        case 0:
            return numbers[random.below(std::size(numbers))];
        case 1:
            return '-' + inner();
        case 2:
            return '(' + inner() + ')';
        case 3:
            return std::string(functions[random.below(std::size(functions))]) + '(' + inner() + ')';
        case 4:
            return std::string(random.below(2) == 0 ? "min(" : "max(") + inner() + ", " + inner() + ')';
        default:
            return inner() + signs[random.below(std::size(signs))] + inner();
        }
    }
};

RAMURE_SUITE(TestQuantity)

} // namespace tst_quantity

#include "tst_quantity.moc"
