#include "core/generators/grammar/rewrite.h"
#include "core/math/random.h"
#include "tests/support/suite.h"

#include <cmath>

namespace tst_rewrite {

using namespace ramure;

namespace {

Grammar grammarOf(const char* axiom, const char* rules)
{
    auto grammar = parseGrammar(axiom, rules);
    if (!grammar)
        qFatal("%s", grammar.error().message().c_str());
    return *grammar;
}

/// The definition, symbol by symbol.
std::string plainRewrite(const Grammar& grammar, int iterations)
{
    std::string text = grammar.axiom;
    for (int i = 0; i < iterations; ++i) {
        std::string next;
        for (const char symbol : text) {
            const auto rule = std::ranges::find(grammar.rules, symbol, &Rule::symbol);
            next += rule == grammar.rules.end() ? std::string(1, symbol) : rule->defaultText;
        }
        text = next;
    }
    return text;
}

Grammar randomGrammar(std::uint64_t seed)
{
    Random random(seed, RandomStream::Test);
    const auto text = [&](std::uint32_t longest) {
        std::string out;
        for (std::uint32_t i = random.below(longest + 1); i > 0; --i)
            out += static_cast<char>('A' + static_cast<char>(random.below(5)));
        return out;
    };
    Grammar grammar{text(10), {}};
    for (char symbol = 'A'; symbol < 'E'; ++symbol)
        if (random.unit() < 0.7)
            grammar.rules.push_back({symbol, text(random.unit() < 0.1 ? 60 : 4), {}, {}});
    return grammar;
}

} // namespace

class TestRewrite : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void badGrammarIsRefused();
    void explosionStopsBeforeItStarts();
    void stochasticExplosionStops();
    void limitIsExact();
    void countsDoNotOverflow();
    void cancelStops();
    void noIterationGivesTheAxiom();
    void ruleOfTheDefinition_data();
    void ruleOfTheDefinition();
    void randomGrammars();
    void randomBytesNeverCrash();
    void longTexts();
    void chanceOnlyWhereAsked();
    void chanceIsRepeatable();
    void chanceFollowsTheProbabilities();
    void impossibleChoicesAreNeverDrawn();
    void progressReachesOne();
};

void TestRewrite::badGrammarIsRefused()
{
    const auto out = rewrite({"A]", {}}, {1});
    QVERIFY(!out);
    QCOMPARE(out.error().path, std::string("grammar.axiom"));
}

void TestRewrite::explosionStopsBeforeItStarts()
{
    // 8^9 passes the limit of 64 million.
    const auto out = rewrite(grammarOf("A", "A -> AAAAAAAA"), {30});
    QVERIFY(!out);
    QCOMPARE(out.error().code, ErrorCode::Limit);
    const std::string text = out.error().plain();
    QVERIFY2(text.find("iteration 9 of 30") != std::string::npos, text.c_str());
    QVERIFY2(text.find("64000000") != std::string::npos, text.c_str());
}

void TestRewrite::stochasticExplosionStops()
{
    const auto out = rewrite(grammarOf("A", "A -> 1: AAAAAAAA | 1: AAAAAAA"), {30, true});
    QVERIFY(!out);
    QCOMPARE(out.error().code, ErrorCode::Limit);
    QVERIFY(out.error().plain().find("iteration 9 of 30") != std::string::npos ||
            out.error().plain().find("iteration 10 of 30") != std::string::npos);
}

void TestRewrite::limitIsExact()
{
    const Grammar doubling = grammarOf("A", "A -> AA");
    const Grammar byChance = grammarOf("A", "A -> 1: AA");
    for (const bool stochastic : {false, true}) {
        const Grammar& grammar = stochastic ? byChance : doubling;
        QCOMPARE(rewrite(grammar, {10, stochastic, 1, 1024})->size(), std::size_t(1024));
        const auto over = rewrite(grammar, {10, stochastic, 1, 1023});
        QVERIFY(!over);
        QVERIFY(over.error().plain().find("iteration 10 of 10") != std::string::npos);
    }
    QVERIFY(!rewrite({"AAAA", {}}, {0, false, 1, 3}));
}

void TestRewrite::countsDoNotOverflow()
{
    const Grammar grammar{"A", {{'A', std::string(100'000, 'A'), {}, {}}}};
    const auto out = rewrite(grammar, {30, false, 1, std::numeric_limits<std::size_t>::max()});
    QVERIFY(!out);
    QCOMPARE(out.error().code, ErrorCode::Limit);
}

void TestRewrite::cancelStops()
{
    std::stop_source source;
    source.request_stop();
    const auto out = rewrite(grammarOf("A", "A -> AB"), {3}, {source.get_token(), {}});
    QVERIFY(!out);
    QCOMPARE(out.error().code, ErrorCode::Cancelled);
}

void TestRewrite::noIterationGivesTheAxiom()
{
    for (const int iterations : {0, -1, -1000})
        QCOMPARE(*rewrite(grammarOf("AB", "A -> B"), {iterations}), std::string("AB"));
    QCOMPARE(*rewrite({"", {}}, {5}), std::string());
    QCOMPARE(*rewrite({"A[B]", {}}, {1'000'000}), std::string("A[B]"));
}

void TestRewrite::ruleOfTheDefinition_data()
{
    QTest::addColumn<QByteArray>("axiom");
    QTest::addColumn<QByteArray>("rules");
    QTest::addColumn<int>("iterations");
    QTest::addColumn<QByteArray>("expected");
    const auto row = [](const char* axiom, const char* rules, int iterations, const char* expected) {
        QTest::addRow("%s %s %d", axiom, rules, iterations)
            << QByteArray(axiom) << QByteArray(rules) << iterations << QByteArray(expected);
    };
    row("A", "A -> AB\nB -> A", 5, "ABAABABAABAAB");
    row("ABA", "A -> B\nB -> A", 1, "BAB");
    row("ABA", "A ->", 1, "B");
    row("AAA", "A ->", 3, "");
    row("A", "A -> [+A]-A\n+ -> ++", 2, "[++[+A]-A]-[+A]-A");
    row("XY", "X -> 0.5: P | 0.5: Q | default: R", 1, "RY");
    row("\xFF", "\xFF -> \xFF\x01", 2, "\xFF\x01\x01");
}

void TestRewrite::ruleOfTheDefinition()
{
    QFETCH(QByteArray, axiom);
    QFETCH(QByteArray, rules);
    QFETCH(int, iterations);
    QFETCH(QByteArray, expected);
    const auto out = rewrite(grammarOf(axiom.constData(), rules.constData()), {iterations});
    QVERIFY2(out, test::why(out));
    QCOMPARE(QByteArray::fromStdString(*out), expected);
}

void TestRewrite::randomGrammars()
{
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        const Grammar grammar = randomGrammar(seed);
        for (int iterations = 0; iterations < 6; ++iterations) {
            const auto out = rewrite(grammar, {iterations, false, 1, 20'000});
            if (!out) {
                QCOMPARE(out.error().code, ErrorCode::Limit);
                break;
            }
            QCOMPARE(*out, plainRewrite(grammar, iterations));
        }
    }
}

void TestRewrite::randomBytesNeverCrash()
{
    Random random(4, RandomStream::Test);
    const auto text = [&](std::uint32_t longest) {
        std::string out(random.below(longest + 1), ' ');
        for (char& c : out)
            c = static_cast<char>(random.unit() < 0.5 ? 'A' + static_cast<char>(random.below(3))
                                                      : random.below(256));
        return out;
    };
    int grown = 0;
    for (int i = 0; i < 20'000; ++i) {
        Grammar grammar{text(8), {}};
        for (std::uint32_t k = random.below(4); k > 0; --k) {
            Rule rule{text(1).append("A")[0], text(6), {}, {}};
            for (std::uint32_t choice = random.below(3); choice > 0; --choice) {
                rule.probabilities.push_back(random.range(-0.1, 1.0));
                rule.replacements.push_back(text(6));
            }
            grammar.rules.push_back(std::move(rule));
        }
        const int iterations = static_cast<int>(random.below(40)) - 2;
        const auto out = rewrite(grammar, {iterations, random.unit() < 0.5, random.next(), 5'000});
        QCOMPARE(checkGrammar(grammar).has_value(), out.has_value() || out.error().code == ErrorCode::Limit);
        QVERIFY(!out || out->size() <= 5'000);
        grown += out ? 1 : 0;
    }
    QVERIFY(grown > 1000);
}

void TestRewrite::longTexts()
{
    // Around the size of the blocks in which texts are copied.
    for (std::size_t size : {0, 1, 15, 16, 17, 31, 32, 33, 1000}) {
        const Grammar grammar{"ABA", {{'A', std::string(size, 'x') + "B", {}, {}}}};
        QCOMPARE(*rewrite(grammar, {2}), plainRewrite(grammar, 2));
    }
}

void TestRewrite::chanceOnlyWhereAsked()
{
    const Grammar grammar = grammarOf(std::string(100, 'A').c_str(), "A -> 1: B | 1: C | default: D");
    QCOMPARE(*rewrite(grammar, {1, false, 7}), std::string(100, 'D'));
    const std::string drawn = *rewrite(grammar, {1, true, 7});
    QCOMPARE(drawn.size(), std::size_t(100));
    QVERIFY(drawn.find('B') != std::string::npos && drawn.find('C') != std::string::npos);
    QVERIFY(drawn.find('D') == std::string::npos);
}

void TestRewrite::chanceIsRepeatable()
{
    const Grammar grammar = grammarOf("A", "A -> 1: AB | 1: BA | 1: A[B]A");
    const auto grown = [&](std::uint64_t seed) { return *rewrite(grammar, {8, true, seed}); };
    QCOMPARE(grown(1), grown(1));
    QVERIFY(grown(1) != grown(2));
    // The numbers themselves are a promise: saved seeds keep their trees.
    Random random(42, RandomStream::Rewrite, 1);
    std::string expected;
    for (int i = 0; i < 20; ++i)
        expected += random.unit() < 0.25 ? 'X' : 'Y';
    QCOMPARE(*rewrite(grammarOf("AAAAAAAAAAAAAAAAAAAA", "A -> 1: X | 3: Y"), {1, true, 42}), expected);
}

void TestRewrite::chanceFollowsTheProbabilities()
{
    const Grammar grammar = grammarOf(std::string(100'000, 'A').c_str(), "A -> 1: X | 2: Y | 7: Z");
    const std::string out = *rewrite(grammar, {1, true, 3});
    const auto share = [&](char symbol) {
        return double(std::ranges::count(out, symbol)) / double(out.size());
    };
    // Five standard deviations.
    QVERIFY(std::abs(share('X') - 0.1) < 0.005);
    QVERIFY(std::abs(share('Y') - 0.2) < 0.0065);
    QVERIFY(std::abs(share('Z') - 0.7) < 0.0075);
}

void TestRewrite::impossibleChoicesAreNeverDrawn()
{
    const Grammar grammar = grammarOf(std::string(10'000, 'A').c_str(), "A -> 0: X | 1: Y | 0: Z");
    QCOMPARE(*rewrite(grammar, {1, true, 5}), std::string(10'000, 'Y'));
}

void TestRewrite::progressReachesOne()
{
    double last = 0.0;
    const Progress progress{{}, [&](double fraction) {
                                QVERIFY(fraction >= last && fraction <= 1.0);
                                last = fraction;
                            }};
    QVERIFY(rewrite(grammarOf("A", "A -> AB"), {10}, progress));
    QCOMPARE(last, 1.0);
}

RAMURE_SUITE(TestRewrite)

} // namespace tst_rewrite

#include "tst_rewrite.moc"
