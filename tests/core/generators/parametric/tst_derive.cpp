#include "core/generators/parametric/derive.h"
#include "tests/support/suite.h"

#include <QFile>
#include <algorithm>
#include <cmath>

namespace tst_derive {

using namespace ramure;

namespace {

Expected<ModuleWord> grown(const std::string& axiom, const std::string& rules, int iterations,
                           bool byChance = false, std::uint64_t seed = 1, std::size_t limit = mostModules)
{
    const auto grammar = parseParametric({axiom, rules, iterations, byChance, static_cast<std::int64_t>(seed),
                                          GrammarDialect::Parametric, "r = 0.5"});
    if (!grammar)
        return fail(grammar.error());
    return derive(*grammar, {iterations, byChance, seed, limit});
}

std::string textOf(const Expected<ModuleWord>& word)
{
    std::string out;
    for (std::size_t i = 0; word && i < word->modules.size(); ++i)
        out += word->text(word->modules[i]);
    return word ? out : word.error().message();
}

} // namespace

class TestDerive : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void numbersThatAreNone();
    void tooManyModules();
    void cancelStops();
    void theFirstRuleThatFits();
    void numbersFollow();
    void contexts_data();
    void contexts();
    void orderAndAge();
    void cutBranchesGo();
    void chanceIsOfTheSeed();
    void chanceIsOfThePlace();
    void weightsAreShares();
    void aSignalRunsPastWhatIsIgnored();
    void theHandbooksPlantGrows_data();
    void theHandbooksPlantGrows();
};

void TestDerive::numbersThatAreNone()
{
    for (const char* const rules : {"\nA(x) : x/x > 1 -> F", "\nA(x) -> F(x/x)    "}) {
        const auto word = grown("A(0)", rules, 3);
        QVERIFY(!word);
        QCOMPARE(word.error().path, std::string("grammar.rules"));
        QCOMPARE(word.error().line, 2);
        QVERIFY(word.error().column == 8 || word.error().column == 11);
        QVERIFY(word.error().plain().find("A(0)") != std::string::npos);
    }
    QVERIFY(!grown("A(1)", "A(x) -> A(x*1e300)", 3));
    QVERIFY(!grown("A(1)", "A(x) : min(1, sqrt(0-x)) > 0 -> A(x)", 3));
    QVERIFY(grown("A(0)", "A(x) : x > 0 && 1/x > 0 -> F", 3)); // the left side decides
}

void TestDerive::tooManyModules()
{
    const auto word = grown("A", "A -> AAAAAAAAAA", 9);
    QVERIFY(!word);
    QCOMPARE(word.error().code, ErrorCode::Limit);

    QVERIFY(!grown("A(1,1,1,1)", "A(a,b,c,d) -> A(a,b,c,d)A(a,b,c,d)", 20, false, 1, 100'000));
    QVERIFY(grown("A", "A -> AA", 10, false, 1, 1024));
    QVERIFY(!grown("A", "A -> AA", 10, false, 1, 1023));
}

void TestDerive::cancelStops()
{
    const auto grammar = parseParametric({"A", "A -> AA", 20, false, 1, GrammarDialect::Parametric, ""});
    std::stop_source stop;
    Progress progress{stop.get_token(), [&stop](double) { stop.request_stop(); }};
    const auto word = derive(*grammar, {20, false, 1}, progress);
    QVERIFY(!word);
    QCOMPARE(word.error().code, ErrorCode::Cancelled);
}

void TestDerive::theFirstRuleThatFits()
{
    const char* const rules = "A(x) : x > 2 -> B\nA(x) : x > 1 -> C\nA(x,y) -> D\nA -> E";
    QCOMPARE(textOf(grown("A(3)A(2)A(1)A(1,2)AF", rules, 1)), std::string("BCA(1)DEF"));
}

void TestDerive::numbersFollow()
{
    QCOMPARE(textOf(grown("A(1,8)", "A(l,w) -> F(l)[+(30)A(l*2,w*r)]!(w)", 2)),
             std::string("F(1)[+(30)F(2)[+(30)A(4, 2)]!(4)]!(8)"));
    QCOMPARE(textOf(grown("F(1)XA", "F(l) -> F(l+1)\nA -> \n", 3)), std::string("F(4)X"));
}

void TestDerive::contexts_data()
{
    QTest::addColumn<QString>("axiom");
    QTest::addColumn<QString>("rule");
    QTest::addColumn<QString>("word");
    QTest::newRow("left") << "BAA"
                          << "B < A -> C"
                          << "BCA";
    QTest::newRow("a branch sees its stem") << "B[X]A[A]"
                                            << "B < A -> C"
                                            << "B[X]C[A]";
    QTest::newRow("into the branch") << "B[A][A]"
                                     << "B < A -> C"
                                     << "B[C][C]";
    QTest::newRow("right past a branch") << "A[X]B"
                                         << "A > B -> C"
                                         << "C[X]B";
    QTest::newRow("not out of the branch") << "[A]B"
                                           << "A > B -> C"
                                           << "[A]B";
    QTest::newRow("both with numbers") << "A(1)B(2)C(3)"
                                       << "A(x) < B(y) > C(z) -> D(x,y,z)"
                                       << "A(1)D(1, 2, 3)C(3)";
    QTest::newRow("as many numbers") << "B(1)A"
                                     << "B < A -> C"
                                     << "B(1)A";
    // The signal of the book, 1.8: it runs up, one module a round.
    QTest::newRow("signal") << "BAAA"
                            << "B < A -> B\nB -> A"
                            << "ABAA";
    QTest::newRow("turns stand in the way") << "B+A"
                                            << "B < A -> C"
                                            << "B+A";
    QTest::newRow("ignored on the left") << "B+-A"
                                         << "#ignore: +-\nB < A -> C"
                                         << "B+-C";
    QTest::newRow("ignored on the right") << "A+[X]-B"
                                          << "ignore: + -\nA > B -> C"
                                          << "C+[X]-B";
    QTest::newRow("ignored without a colon, of two lines") << "B+F(1)A"
                                                           << "#ignore +\n#ignore F\nB < A -> C"
                                                           << "B+F(1)C";
    QTest::newRow("considered alone") << "B+F(1)XA"
                                      << "#consider: AB\nB < A -> C"
                                      << "B+F(1)XC";
    QTest::newRow("an ignored module has contexts") << "B+A"
                                                    << "ignore: +\nB < + > A -> -"
                                                    << "B-A";
    QTest::newRow("digits") << "1F0"
                            << "ignore: F\n1 < 0 -> 10"
                            << "1F10";
}

void TestDerive::contexts()
{
    QFETCH(QString, axiom);
    QFETCH(QString, rule);
    const auto word = grown(axiom.toStdString(), rule.toStdString(), 1);
    QTEST(QString::fromStdString(textOf(word)), "word");
}

void TestDerive::orderAndAge()
{
    QCOMPARE(textOf(grown("A[A[A]]A", "A -> F(order)", 1)), std::string("F(0)[F(1)[F(2)]]F(0)"));
    QCOMPARE(textOf(grown("A", "A : age >= 2 -> F(age)", 2)), std::string("A"));
    QCOMPARE(textOf(grown("A", "A : age >= 2 -> F(age)", 3)), std::string("F(2)"));
    QCOMPARE(textOf(grown("B", "B -> A\nA : age >= 2 -> F(age)", 4)), std::string("F(2)"));
}

void TestDerive::cutBranchesGo()
{
    QCOMPARE(textOf(grown("F[+A%B[C]D]E", "", 1)), std::string("F[+A%]E"));
}

void TestDerive::chanceIsOfTheSeed()
{
    const char* const rules = "A -> 0.5: F(rand(0,1))A | 0.5: [+A]A";
    QCOMPARE(textOf(grown("A", rules, 8, true, 5)), textOf(grown("A", rules, 8, true, 5)));
    QVERIFY(textOf(grown("A", rules, 8, true, 5)) != textOf(grown("A", rules, 8, true, 6)));
    QCOMPARE(textOf(grown("A", rules, 2)), std::string("F(0.5)F(0.5)A")); // without chance
    // A module that stays has its chance in every round.
    QCOMPARE(textOf(grown("A", "A : rand(0,1) < 0.5 -> F", 30, true)), std::string("F"));
}

void TestDerive::chanceIsOfThePlace()
{
    const char* const rules = "A -> 0.5: F(rand(0,1))A | 0.5: F(rand(0,1))F(rand(0,1))A\nB -> ";
    // More iterations keep what is there, and so does a longer twig in front.
    const std::string few = textOf(grown("A", rules, 6, true)), many = textOf(grown("A", rules, 7, true));
    QCOMPARE(many.substr(0, few.size() - 1), few.substr(0, few.size() - 1));
    const std::string other = std::string(rules) + "A";
    const std::string twig = textOf(grown("BA", rules, 6, true)),
                      longer = textOf(grown("BA", other, 6, true));
    QCOMPARE(longer.substr(longer.size() - twig.size()), twig);
    // Two numbers of one production are two draws.
    const auto pair = grown("A", "A -> F(rand(0,1), rand(0,1))", 1, true);
    QVERIFY(pair->numbers[0] != pair->numbers[1]);
}

void TestDerive::weightsAreShares()
{
    int ones = 0;
    for (std::uint64_t seed = 0; seed < 4000; ++seed)
        ones += textOf(grown("A", "A -> 1: F | 3: f", 1, true, seed)) == "F" ? 1 : 0;
    QVERIFY2(std::abs(ones - 1000) < 100, qPrintable(QString::number(ones)));
}

void TestDerive::aSignalRunsPastWhatIsIgnored()
{
    const char* const rules = "#ignore: +-\nI < A -> F(1)I\nI -> ";
    QCOMPARE(textOf(grown("F(1)I+A+A+A", rules, 3)), std::string("F(1)+F(1)+F(1)+F(1)I"));
}

void TestDerive::theHandbooksPlantGrows_data()
{
    QTest::addColumn<QString>("file");
    QTest::newRow("English") << "grammar.md";
    QTest::newRow("French") << "fr/grammar.md";
}

/// Figure 1.31a of the book (after Hogeweg and Hesper), as the page has it from there, and what an
/// independent program of a few lines makes of it.
void TestDerive::theHandbooksPlantGrows()
{
    QFETCH(const QString, file);
    QFile page(QStringLiteral(RAMURE_SOURCE_DIR "/resources/handbook/") + file);
    QVERIFY(page.open(QIODevice::ReadOnly));
    std::string rules;
    for (bool isHere = false; !page.atEnd();) {
        const QByteArray line = page.readLine();
        isHere = (isHere || line.startsWith("    #ignore")) && line.startsWith("    ");
        if (isHere)
            rules += line.toStdString();
    }
    QCOMPARE(textOf(grown("F1F1F1", rules, 1)), std::string("F1F0F1"));
    QCOMPARE(textOf(grown("F1F1F1", rules, 6)), std::string("F1F0F0F0[+F1F1F1]F1"));
    QCOMPARE(textOf(grown("F1F1F1", rules, 8)), std::string("F1F0F1[+F1F1]F1[-F0F1][+F0F1F1F1]F1"));
    const std::string last = textOf(grown("F1F1F1", rules, 30));
    QCOMPARE(last.size(), std::size_t(6910));
    QCOMPARE(std::ranges::count(last, 'F'), 2501);
}

RAMURE_SUITE(TestDerive)

} // namespace tst_derive

#include "tst_derive.moc"
