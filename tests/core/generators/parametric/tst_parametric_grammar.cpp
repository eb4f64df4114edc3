#include "core/generators/parametric/grammar_notes.h"
#include "core/generators/parametric/parametric_grammar.h"
#include "core/math/random.h"
#include "tests/support/suite.h"

namespace tst_parametric_grammar {

using namespace ramure;

namespace {

GrammarParams paramsOf(const std::string& axiom, const std::string& rules, const std::string& constants = {})
{
    return {axiom, rules, 1, false, 1, GrammarDialect::Parametric, constants};
}

double valueOf(const std::string& expression)
{
    const auto constants = parseConstants(paramsOf("", "", "x = " + expression));
    return constants ? constants->at("x") : -1e9;
}

} // namespace

class TestParametricGrammar : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void errorsNameTheirPlace_data();
    void errorsNameTheirPlace();
    void nestingIsLimited();
    void randomTextsNeverCrash();
    void expressions_data();
    void expressions();
    void constantsUseThoseAbove();
    void commentsAndBlanksDoNotCount();
    void barsPartOutcomesOrTurn();
    void parametersOfContexts();
    void theBooksNotationIsRead_data();
    void theBooksNotationIsRead();
    void whatCannotBeReadSaysWhatToWrite_data();
    void whatCannotBeReadSaysWhatToWrite();
    void definitionsAreConstants();
    void lookalikesAreNamedAndReplaced();
};

void TestParametricGrammar::errorsNameTheirPlace_data()
{
    QTest::addColumn<QString>("axiom");
    QTest::addColumn<QString>("rules");
    QTest::addColumn<QString>("constants");
    QTest::addColumn<QString>("path");
    QTest::addColumn<int>("line");
    QTest::addColumn<int>("column");
    const auto add = [](const char* name, const char* axiom, const char* rules, const char* constants,
                        const char* path, int line, int column) {
        QTest::newRow(name) << axiom << rules << constants << path << line << column;
    };
    const char* const axiom = "grammar.axiom";
    const char* const rules = "grammar.rules";
    const char* constants = "grammar.constants";
    add("a module that never ends", "A", "\nA(l) -> F(l", "", rules, 2, 12);
    add("a module of the axiom that never ends", "F\nA(1,", "", "", axiom, 2, 5);
    add("a context of three letters", "A", "ABC < D -> F", "", rules, 1, 2);
    add("a right context of three letters", "A", "A > BCD -> F", "", rules, 1, 6);
    add("0/0 in a condition", "A", "A(l) : 0/0 > l -> F", "", rules, 1, 9);
    add("0/0 in a constant", "A", "", "a = 1\nb = 0/0", constants, 2, 6);
    add("no arrow", "A", "A", "", rules, 1, 2);
    add("an organ that there is not", "F\n ~(petal, 1)", "", "", axiom, 2, 4);
    add("an organ of a rule that there is not", "A", "\nA(s) -> F~(s)", "", rules, 2, 12);
    add("an organ without a name", "A", "A -> F~(0.1)", "", rules, 1, 9);
    add("an organ without the number after its comma", "F~(leaf,)", "", "", axiom, 1, 9);
    add("no module before the arrow", "A", "-> F", "", rules, 1, 1);
    add("an unknown name", "A", "A(l) -> F(l * k)", "", rules, 1, 15);
    add("a name for two", "A", "A(l) < B(l) -> F", "", rules, 1, 13);
    add("a name of the language", "A", "A(order) -> F", "", rules, 1, 3);
    add("a number of two dots", "F(1.2.3)", "", "", axiom, 1, 6);
    add("a huge number", "F(1e999)", "", "", axiom, 1, 3);
    add("a digit with a point", "F2.5", "", "", axiom, 1, 3);
    add("a number in front of no colon", "A", "A -> 0.5 F", "", rules, 1, 10);
    add("a comment that never ends", "A", "A -> F /* one\nB -> F", "", rules, 1, 8);
    add("a quote of typography", "A", "A -> \u201CF", "", rules, 1, 6);
    add("a full-width letter behind a comment", "A", "A -> F /* \u2212 */ \uFF21", "", rules, 1, 18);
    add("a definition twice", "A", "#define r 1\n#define r 2", "", rules, 2, 9);
    add("a definition of a constant", "A", "#define r 1", "r = 2", rules, 1, 9);
    add("a definition without a value", "A", "#define r\nA -> F", "", rules, 1, 10);
    add("a bracket that is ignored", "A", "ignore: +[", "", rules, 1, 10);
    add("an open bracket", "F[[F]", "", "", axiom, 1, 2);
    add("no module in brackets", "A", "A -> [+_F]", "", rules, 1, 8);
    add("an open bracket of an outcome", "A", "A -> 1: [F | 2: F", "", rules, 1, 9);
    add("a closing bracket", "A", "A -> F]", "", rules, 1, 7);
    add("a rule for brackets", "A", "[ -> F", "", rules, 1, 1);
    add("no weight", "A", "A -> 0.5: F | 0.5 F", "", rules, 1, 19);
    add("weights of zero", "A", "A -> 0: F | 0: FF", "", rules, 1, 6);
    add("a function without its number", "F(sqrt())", "", "", axiom, 1, 8);
    add("too many for a function", "F(abs(1, 2))", "", "", axiom, 1, 11);
    add("no equals sign", "A", "", "r 0.9", constants, 1, 3);
    add("a constant twice", "A", "", "r = 1\nr = 2", constants, 2, 1);
    add("more than a number", "A", "", "r = 1 2", constants, 1, 7);
    add("a constant that comes later", "A", "", "r = s\ns = 1", constants, 1, 5);
}

void TestParametricGrammar::errorsNameTheirPlace()
{
    QFETCH(QString, axiom);
    QFETCH(QString, rules);
    QFETCH(QString, constants);
    const auto grammar =
        parseParametric(paramsOf(axiom.toStdString(), rules.toStdString(), constants.toStdString()));
    QVERIFY(!grammar);
    QTEST(QString::fromStdString(grammar.error().path), "path");
    QTEST(grammar.error().line, "line");
    QTEST(grammar.error().column, "column");
    QVERIFY(!grammar.error().plain().empty());
}

void TestParametricGrammar::nestingIsLimited()
{
    for (const char* const open : {"(", "-", "!", "1^", "abs(", "min(1,", "1+(1*("}) {
        std::string text;
        while (text.size() < 500'000)
            text += open;
        const auto constants = parseConstants(paramsOf("", "", "x = " + text));
        QVERIFY(!constants);
        QCOMPARE(constants.error().code, ErrorCode::Limit);
    }
    // As deep as it goes, every level with a number that waits.
    std::string deep = "x = ";
    for (int i = 0; i < 50; ++i)
        deep += "0 < 1 + 1 * 1 ^ (";
    QVERIFY2(parseConstants(paramsOf("", "", deep + "1" + std::string(50, ')'))), deep.c_str());
}

void TestParametricGrammar::randomTextsNeverCrash()
{
    static constexpr std::string_view alphabet =
        "AB(l,)w<>:->[]|0.5+*/^!%~$&=#\n min rand ignore #define \xE2\x88\x92";
    Random random(7, RandomStream::Test);
    const auto text = [&random] {
        std::string out;
        for (std::uint32_t n = random.below(40); n > 0; --n)
            out += alphabet[random.below(std::uint32_t(alphabet.size()))];
        return out;
    };
    int read = 0;
    for (int i = 0; i < 20'000; ++i) {
        const auto grammar = parseParametric(paramsOf(text(), "A(l) -> " + text(), ""));
        read += grammar ? 1 : 0;
        if (!grammar)
            QVERIFY(grammar.error().line >= 1 && grammar.error().column >= 1);
    }
    QVERIFY(read > 0);
}

void TestParametricGrammar::expressions_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("value");
    QTest::newRow("products before sums") << "1 + 2 * 3 - 4 / 2" << 5.0;
    QTest::newRow("from left to right") << "8 - 4 - 2" << 2.0;
    QTest::newRow("brackets") << "(1 + 2) * 3" << 9.0;
    QTest::newRow("powers bind more than signs") << "-2 ^ 2" << -4.0;
    QTest::newRow("powers from right to left") << "2 ^ 3 ^ 2" << 512.0;
    QTest::newRow("comparison") << "1 + 1 <= 2" << 1.0;
    QTest::newRow("and before or") << "1 || 0 && 0" << 1.0;
    QTest::newRow("not") << "!(1 > 2) + !3" << 1.0;
    QTest::newRow("equal") << "(2 == 2) + (2 != 2)" << 1.0;
    QTest::newRow("true is one") << "0 || 7" << 1.0;
    QTest::newRow("the rest does not matter") << "0 && (age - age) / (age - age)" << 0.0;
    QTest::newRow("degrees") << "sin(30) + cos(60)" << 1.0;
    QTest::newRow("functions") << "min(3, 1, 2) + max(3, 1, 2) + abs(-4) + sqrt(9)" << 11.0;
    QTest::newRow("without chance the middle") << "rand(1, 3)" << 2.0;
}

void TestParametricGrammar::expressions()
{
    QFETCH(QString, text);
    QFETCH(double, value);
    QVERIFY2(std::abs(valueOf(text.toStdString()) - value) < 1e-12, qPrintable(text));
}

void TestParametricGrammar::constantsUseThoseAbove()
{
    const auto constants = parseConstants(paramsOf("", "", "# lengths\na = 2\n\nb = a * 3 # six\r\n"));
    QVERIFY2(constants, test::why(constants));
    QCOMPARE(constants->at("a"), 2.0);
    QCOMPARE(constants->at("b"), 6.0);
}

void TestParametricGrammar::commentsAndBlanksDoNotCount()
{
    const auto grammar =
        parseParametric(paramsOf(" F ( 1 ) # seed\n A", "# all\n\nA -> F [ + A ] # B -> C\n"));
    QVERIFY2(grammar, test::why(grammar));
    QCOMPARE(grammar->axiom.modules.size(), std::size_t(2));
    QCOMPARE(grammar->rules.size(), std::size_t(1));
    QCOMPARE(grammar->rules[0].productions[0].modules.size(), std::size_t(5));
}

void TestParametricGrammar::barsPartOutcomesOrTurn()
{
    const auto grammar = parseParametric(paramsOf("A", "A -> 0.3: F|F | 0.7: | \nB -> F|F"));
    QVERIFY2(grammar, test::why(grammar));
    QCOMPARE(grammar->rules[0].productions.size(), std::size_t(2));
    QCOMPARE(grammar->rules[0].productions[0].modules.size(), std::size_t(3));
    QCOMPARE(grammar->rules[0].productions[1].modules.size(), std::size_t(1));
    QCOMPARE(grammar->rules[0].likeliest, std::size_t(1));
    QCOMPARE(grammar->rules[1].productions[0].modules.size(), std::size_t(3));
}

void TestParametricGrammar::parametersOfContexts()
{
    const auto grammar = parseParametric(paramsOf("A", "A(x) < B(y) > C(z) : x < y && y -> z > 0 -> F(z)"));
    QVERIFY(!grammar); // "y ->" ends the condition
    const auto right =
        parseParametric(paramsOf("A", "A(x) < B(y) > C(z) : x < y && y - 1 > 0 -> F(x*100 + y*10 + z)"));
    QVERIFY2(right, test::why(right));
    const double numbers[] = {2, 1, 3}; // of the module, of the left one, of the right one
    ExpressionInputs inputs;
    inputs.parameters = numbers;
    QCOMPARE(right->rules[0].condition.value(inputs), 1.0);
    QCOMPARE(right->rules[0].productions[0].computed[0].expression.value(inputs), 123.0);
}

void TestParametricGrammar::theBooksNotationIsRead_data()
{
    QTest::addColumn<QString>("rules");
    QTest::addColumn<QString>("plain");
    const auto row = [](const char* rules, const char* plain) {
        QTest::addRow("%s", rules) << rules << plain;
    };
    row("p1 : A(l) -> F(l)", "A(l) -> F(l)");
    row("p1: A -> F\np2: F -> A", "A -> F\nF -> A");
    row("p\u2081 : A \u2192 F", "A -> F");
    row("A(l) : * -> F(l)", "A(l) -> F(l)");
    row("A(l) : \u2217 \u2192 F(l)", "A(l) -> F(l)");
    row("A(l) : l=1 -> F(l)", "A(l) : l==1 -> F(l)");
    row("A(l) : l>=1 & l<3 | l=0 -> F(l)", "A(l) : l>=1 && l<3 || l==0 -> F(l)");
    row("A(l) : l\u22651 \u2192 F(l\u22120.5)", "A(l) : l>=1 -> F(l-0.5)");
    row("A(l) --> F(l\u00D72)", "A(l) -> F(l*2)");
    row("A(l) : l>1 --> F(l)", "A(l) : l>1 -> F(l)");
    row("A \u2192 [\u2212A]+A", "A -> [-A]+A");
    row("A\u00A0->\u2009F", "A -> F");
    row("* < A > * -> F", "A -> F");
    row("* < A > B -> F", "A > B -> F");
    row("0 < 1 > 0 -> 1[+F1F1]\n0 -> 1", "0 < 1 > 0 -> 1 [+F1F1]\n0 -> 1");
    row("A -> F /* a stem */ [+A] # and its branch", "A -> F[+A]");
    row("/* two\nlines */\nA -> F", "\n\nA -> F");
    row("A(\u03B1) -> +(\u03B1)F", "A(a) -> +(a)F");
    row("A -> 0.5: F1 | 0.5: F|1", "A -> 0.5: F 1 | 0.5: F | 1");
}

void TestParametricGrammar::theBooksNotationIsRead()
{
    QFETCH(QString, rules);
    QFETCH(QString, plain);
    const auto read = parseParametric(paramsOf("A(1)0", rules.toStdString()));
    const auto same = parseParametric(paramsOf("A(1)0", plain.toStdString()));
    QVERIFY2(read, test::why(read));
    QVERIFY2(same, test::why(same));
    QCOMPARE(read->rules.size(), same->rules.size());
    QCOMPARE(read->sources.size(), same->sources.size());
    for (std::size_t i = 0; i < read->sources.size(); ++i)
        QVERIFY(read->sources[i].name == same->sources[i].name &&
                read->sources[i].numbers == same->sources[i].numbers);
    for (std::size_t i = 0; i < read->rules.size(); ++i) {
        const ParametricRule &a = read->rules[i], &b = same->rules[i];
        QVERIFY(a.left.has_value() == b.left.has_value() && a.right.has_value() == b.right.has_value());
        QVERIFY(a.condition.empty() == b.condition.empty() && a.productions.size() == b.productions.size());
        for (const double number : {0.0, 0.5, 1.0, 2.0, 3.0, 7.0}) {
            ExpressionInputs inputs;
            inputs.parameters = &number;
            QVERIFY(a.condition.empty() || a.condition.value(inputs) == b.condition.value(inputs));
            for (std::size_t j = 0; j < a.productions[0].computed.size(); ++j)
                QCOMPARE(a.productions[0].computed[j].expression.value(inputs),
                         b.productions[0].computed[j].expression.value(inputs));
        }
    }
}

void TestParametricGrammar::whatCannotBeReadSaysWhatToWrite_data()
{
    QTest::addColumn<QString>("rules");
    QTest::addColumn<QString>("part");
    const auto row = [](const char* rules, const char* part) { QTest::addRow("%s", rules) << rules << part; };
    row("A -> 'F", "leave ' out");
    row("A -> {.F.}", "~(leaf, 0.1)");
    row("#include <leaf.h>", "paste the text of the file here");
    row("#define twice(x) 2*x", "macros with parameters are not supported");
    row("A -> F : 0.5", "\"0.5: F | 0.5: FF\"");
    row("\u03C9 : A(1)", "grammar.axiom");
    row("axiom: A(1)", "grammar.axiom");
    row("derivation length: 5", "grammar.iterations");
    row("A -> \uFF21", "write \"A\"");
}

void TestParametricGrammar::whatCannotBeReadSaysWhatToWrite()
{
    QFETCH(QString, rules);
    QFETCH(QString, part);
    const auto grammar = parseParametric(paramsOf("A", rules.toStdString()));
    QVERIFY(!grammar);
    QVERIFY2(QString::fromStdString(grammar.error().plain()).contains(part),
             grammar.error().message().c_str());
    QVERIFY(grammar.error().line == 1 && grammar.error().column >= 1);
}

void TestParametricGrammar::definitionsAreConstants()
{
    const auto params =
        paramsOf("A(CH)", "#define CH 900 /* high */\n#define r = CH / 3\nA(x) -> F(x * r * s)",
                 "#define s 2\nt = s + 1");
    const auto grammar = parseParametric(params);
    QVERIFY2(grammar, test::why(grammar));
    QVERIFY((grammar->constants == Constants{{"CH", 900.0}, {"r", 300.0}, {"s", 2.0}, {"t", 3.0}}));
    QCOMPARE(grammar->axiom.numbers.front(), 900.0);
    QVERIFY(*parseConstants(params) == grammar->constants);
    // A word of a comment is no command.
    QVERIFY(parseParametric(paramsOf("A", "# define r 2\n#defined\n#ignored\nA -> F # ignore: F")));
}

void TestParametricGrammar::lookalikesAreNamedAndReplaced()
{
    GrammarParams params = paramsOf("A \uFF22", "A -> \u201CF\u201D [\u2212A]\nB -> \u0410 # \u201C");
    const GrammarNotes notes = grammarNotes(params);
    QCOMPARE(notes.size(), std::size_t(4));
    QCOMPARE(QString::fromStdString(notes.back().what.message()),
             QStringLiteral("2:6: grammar.rules: \"\u0410\" (U+0410) is not \"A\": write \"A\""));
    params.axiom = withReplacements(params.axiom, "grammar.axiom", notes);
    params.rules = withReplacements(params.rules, "grammar.rules", notes);
    QCOMPARE(params.axiom, std::string("A B"));
    QCOMPARE(QString::fromStdString(params.rules), QStringLiteral("A -> F [\u2212A]\nB -> A # \u201C"));
    QVERIFY(grammarNotes(params).empty() && parseParametric(params));
    NodeParams node;
    node.grammar = paramsOf("\uFF22", "");
    QVERIFY(grammarWarnings(node).empty()); // an error says it
    node.grammar.dialect = GrammarDialect::Classic;
    QCOMPARE(grammarWarnings(node).size(), std::size_t(1));
    node.generator.kind = EditOperation::WeberPenn;
    QVERIFY(grammarWarnings(node).empty());
}

RAMURE_SUITE(TestParametricGrammar)

} // namespace tst_parametric_grammar

#include "tst_parametric_grammar.moc"
