#include "core/generators/grammar/grammar.h"
#include "core/math/random.h"
#include "tests/support/grammar_text.h"
#include "tests/support/suite.h"

#include <cmath>
#include <iterator>
#include <limits>

namespace tst_grammar {

using namespace ramure;

namespace {

QByteArray bytes(const std::string& text)
{
    return QByteArray::fromStdString(text);
}

std::string randomBalanced(Random& random, int length)
{
    static constexpr std::string_view alphabet("AB+-/\\^_|:`# \t\r.0\x01\xFF>", 20);
    std::string text;
    int open = 0;
    for (int i = 0; i < length; ++i) {
        const double kind = random.unit();
        if (kind < 0.1) {
            text += '[';
            ++open;
        } else if (kind < 0.2 && open > 0) {
            text += ']';
            --open;
        } else {
            text += alphabet[random.below(std::uint32_t(alphabet.size()))];
        }
    }
    return text + std::string(std::size_t(open), ']');
}

std::vector<Rule> randomRules(Random& random)
{
    std::vector<Rule> rules;
    std::array<bool, 256> used{};
    used[std::size_t('\n')] = true;
    for (std::uint32_t i = random.below(6); i > 0; --i) {
        const std::uint32_t symbol = random.below(256);
        if (std::exchange(used[symbol], true))
            continue;
        Rule rule;
        rule.symbol = static_cast<char>(symbol);
        rule.defaultText = randomBalanced(random, int(random.below(12)));
        for (std::uint32_t choice = random.below(4); choice > 0; --choice) {
            rule.probabilities.push_back(random.unit() < 0.2 ? 1e-300 : random.range(0, 1000));
            rule.replacements.push_back(randomBalanced(random, int(random.below(12))));
        }
        if (!rule.replacements.empty() && random.unit() < 0.3)
            rule.defaultText = rule.replacements[0];
        rules.push_back(std::move(rule));
    }
    return rules;
}

} // namespace

class TestGrammar : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void badRules_data();
    void badRules();
    void badAxiom_data();
    void badAxiom();
    void badGrammarInCode_data();
    void badGrammarInCode();
    void mistakesSayWhatToWrite_data();
    void mistakesSayWhatToWrite();
    void rulesAreRead_data();
    void rulesAreRead();
    void axiomIsRead();
    void roundTrip();
    void randomBytesNeverCrash();
    void everyRuleThatParsesSurvivesFormatting();
    void lookalikesAreRemarked_data();
    void lookalikesAreRemarked();
    void whatIsMeantIsNotRemarked();
    void replacementsLeaveNothingToRemark();
};

void TestGrammar::badRules_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("code");
    QTest::addColumn<int>("line");
    QTest::addColumn<int>("column");
    const auto bad = [](const char* text, ErrorCode code, int line, int column) {
        QTest::addRow("%s", text) << QByteArray(text) << int(code) << line << column;
    };
    const auto syntax = ErrorCode::Syntax;
    const auto invalid = ErrorCode::Invalid;
    bad("A", syntax, 1, 2);
    bad("A B", syntax, 1, 3);
    bad("A = B", syntax, 1, 3);
    bad("AB -> C", syntax, 1, 2);
    bad("A -", syntax, 1, 3);
    bad("A `-> B", syntax, 1, 3);
    bad("A -`> B", syntax, 1, 3);
    bad("\n\n  A B", syntax, 3, 5);
    bad("-> B", syntax, 1, 1);
    bad("  -> B", syntax, 1, 3);
    bad("->", syntax, 1, 1);
    bad("`# B", syntax, 1, 4);
    bad("`", syntax, 1, 1);
    bad("A -> B`", syntax, 1, 7);
    bad("A -> B`\nC -> D", syntax, 1, 7);
    bad("A -> B\nA -> C", invalid, 2, 1);
    bad("A -> B\n# x\n\n  A -> C", invalid, 4, 3);
    bad("A -> B | C", syntax, 1, 6);
    bad("A -> 0.5: B | C", syntax, 1, 15);
    bad("A -> 0.5: B |", syntax, 1, 14);
    bad("A -> | 0.5: B", syntax, 1, 6);
    bad("A -> x: B", syntax, 1, 6);
    bad("A -> : B", syntax, 1, 6);
    bad("A -> 0.5x: B", syntax, 1, 6);
    bad("A -> 0,5: B", syntax, 1, 6);
    bad("A -> Default: B", syntax, 1, 6);
    bad("A -> 0.5: B: C", syntax, 1, 12);
    bad("A -> 0.5: B | default: C | default: D", syntax, 1, 28);
    bad("A -> -0.5: B", invalid, 1, 6);
    bad("A -> 0.5: B | -1e-9: C", invalid, 1, 15);
    bad("A -> nan: B", invalid, 1, 6);
    bad("A -> inf: B", invalid, 1, 6);
    bad("A -> 1e999: B", invalid, 1, 6);
    bad("A -> 0: B", invalid, 1, 6);
    bad("A -> 0: B | 0.0: C | default: D", invalid, 1, 6);
    bad("A -> 1e308: B | 1e308: C", invalid, 1, 6);
}

void TestGrammar::badRules()
{
    QFETCH(QByteArray, text);
    QFETCH(int, code);
    QFETCH(int, line);
    QFETCH(int, column);
    const auto rules = parseRules(text.toStdString());
    QVERIFY(!rules);
    QVERIFY(*rules.error().text);
    QCOMPARE(int(rules.error().code), code);
    QCOMPARE(rules.error().line, line);
    QCOMPARE(rules.error().column, column);
    const auto grammar = parseGrammar("A", text.toStdString());
    QVERIFY(!grammar);
    QCOMPARE(grammar.error().path, std::string("grammar.rules"));
    QCOMPARE(grammar.error().line, line);
    QCOMPARE(grammar.error().column, column);
}

void TestGrammar::badAxiom_data()
{
    QTest::addColumn<QByteArray>("axiom");
    QTest::addColumn<QByteArray>("rules");
    QTest::addColumn<QByteArray>("message");
    const auto bad = [](const char* axiom, const char* rules, const char* message) {
        QTest::addRow("%s, %s", axiom, rules)
            << QByteArray(axiom) << QByteArray(rules) << QByteArray(message);
    };
    const char* extra = "this \"]\" has no \"[\" before it";
    const char* open = "this \"[\" is never closed";
    const auto at = [](const char* place, const char* path, const char* text) {
        return QByteArray(place) + " grammar." + path + ": " + text;
    };
    bad("]", "", at("1:1:", "axiom", extra));
    bad("A [ + B ] ] C", "", at("1:11:", "axiom", extra));
    bad("A[[B]", "", at("1:2:", "axiom", open));
    bad("[A\n[B", "", at("2:1:", "axiom", open));
    bad("A`", "",
        at("1:2:", "axiom", "the backquote takes the next character as it is, but the line ends here"));
    bad("A", "A -> B\nB -> A[", at("2:7:", "rules", open));
    bad("A", "A -> B]", at("1:7:", "rules", extra));
    bad("A", "A -> 0.5: B | 0.5: [C]]", at("1:23:", "rules", extra));
    bad("A", "A -> 0.5: B | default: [C", at("1:24:", "rules", open));
    bad("A", "A -> B `] C", at("1:8:", "rules", extra));
}

void TestGrammar::badAxiom()
{
    QFETCH(QByteArray, axiom);
    QFETCH(QByteArray, rules);
    QFETCH(QByteArray, message);
    const auto grammar = parseGrammar(axiom.toStdString(), rules.toStdString());
    QVERIFY(!grammar);
    QCOMPARE(bytes(grammar.error().message()), message);
}

void TestGrammar::badGrammarInCode_data()
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    QTest::addColumn<std::string>("axiom");
    QTest::addColumn<std::vector<Rule>>("rules");
    QTest::addColumn<QByteArray>("path");
    QTest::addColumn<int>("line");
    QTest::addColumn<int>("column");
    const auto bad = [](const char* name, const char* axiom, const std::vector<Rule>& rules, const char* path,
                        int line, int column) {
        QTest::newRow(name) << std::string(axiom) << rules << QByteArray(path) << line << column;
    };
    const Rule good{'A', "B", {}, {}};
    bad("axiom", "A]", {}, "grammar.axiom", 0, 2);
    bad("axiom with a line feed", "A\nB", {}, "grammar.axiom", 0, 2);
    bad("default", "A", {good, {'B', "[[A]", {}, {}}}, "grammar.rules", 2, 1);
    bad("replacement", "A", {{'B', "", {1, 1}, {"A", "A]"}}}, "grammar.rules", 1, 2);
    bad("lists of different length", "A", {good, {'B', "", {1, 1}, {"A"}}}, "grammar.rules", 2, 0);
    bad("no probabilities", "A", {{'B', "", {}, {"A"}}}, "grammar.rules", 1, 0);
    bad("negative", "A", {{'B', "", {2, -1}, {"A", "B"}}}, "grammar.rules", 1, 0);
    bad("zero", "A", {{'B', "", {0, 0}, {"A", "B"}}}, "grammar.rules", 1, 0);
    bad("not a number", "A", {{'B', "", {nan}, {"A"}}}, "grammar.rules", 1, 0);
    bad("twice", "A", {good, good}, "grammar.rules", 2, 0);
    bad("line feed", "A", {{'\n', "", {}, {}}}, "grammar.rules", 1, 0);
}

void TestGrammar::badGrammarInCode()
{
    QFETCH(std::string, axiom);
    QFETCH(std::vector<Rule>, rules);
    QFETCH(QByteArray, path);
    QFETCH(int, line);
    QFETCH(int, column);
    const auto checked = checkGrammar({axiom, rules});
    QVERIFY(!checked);
    QCOMPARE(checked.error().code, ErrorCode::Invalid);
    QCOMPARE(bytes(checked.error().path), path);
    QCOMPARE(checked.error().line, line);
    QCOMPARE(checked.error().column, column);
}

void TestGrammar::mistakesSayWhatToWrite_data()
{
    QTest::addColumn<QByteArray>("rules");
    QTest::addColumn<QByteArray>("part");
    const auto bad = [](const char* rules, const char* part) {
        QTest::addRow("%s", rules) << QByteArray(rules) << QByteArray(part);
    };
    bad("A \u2013> B", "1:3: grammar.rules: \"\u2013\" (U+2013) is not \"-\": write \"-\"");
    bad("A\u00A0-> B", "1:2: grammar.rules: U+00A0 has no meaning here: remove it");
    bad("\uFF21 -> B", "1:1: grammar.rules: \"\uFF21\" (U+FF21) is not \"A\": write \"A\"");
    bad("A(l) -> F(l)", "grammar.dialect=parametric");
    bad("B < A -> C", "grammar.dialect=parametric");
    bad("A : * -> B", "grammar.dialect=parametric");
    bad("A -> B\nignore: +-", "grammar.rules: numbers, contexts");
    bad("p1:", "1:4: grammar.rules: \"->\" must follow the symbol p1:");
}

void TestGrammar::mistakesSayWhatToWrite()
{
    QFETCH(QByteArray, rules);
    QFETCH(QByteArray, part);
    const auto grammar = parseGrammar("A", rules.toStdString());
    QVERIFY(!grammar);
    QVERIFY2(bytes(grammar.error().message()).contains(part), grammar.error().message().c_str());
}

void TestGrammar::rulesAreRead_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<std::vector<Rule>>("rules");
    const auto good = [](const char* text, const std::vector<Rule>& rules) {
        QTest::addRow("%s", text) << QByteArray(text) << rules;
    };
    good("", {});
    good("\n \t\r\n# A -> B\n   # and so on `", {});
    good("A->B", {{'A', "B", {}, {}}});
    good("  A \t->  B [ + C ]  \r\n", {{'A', "B[+C]", {}, {}}});
    good("A ->", {{'A', "", {}, {}}});
    good("A -> #B", {{'A', "#B", {}, {}}});
    good("- -> +-", {{'-', "+-", {}, {}}});
    good("-->-", {{'-', "-", {}, {}}});
    good("> ->->", {{'>', "->", {}, {}}});
    good(": -> A", {{':', "A", {}, {}}});
    good("| -> A", {{'|', "A", {}, {}}});
    good("\\ -> \\\\", {{'\\', "\\\\", {}, {}}});
    good("`# -> `|`:`` ` ", {{'#', "|:` ", {}, {}}});
    good("B -> 0.5: B | 0.5: \\\\B | default: \\B", {{'B', "\\B", {0.5, 0.5}, {"B", "\\\\B"}}});
    good("B -> default: X | 1: | 2e1: Z", {{'B', "X", {1, 20}, {"", "Z"}}});
    good("B -> 1:X|3:Y", {{'B', "X", {1, 3}, {"X", "Y"}}});
    good("B -> 0: X | 3: Y", {{'B', "X", {0, 3}, {"X", "Y"}}});
    good("B -> default: X", {{'B', "X", {}, {}}});
    good("A -> B\nB -> A\n", {{'A', "B", {}, {}}, {'B', "A", {}, {}}});
    good("A -> ]", {{'A', "]", {}, {}}});
    good("p1 : A -> B\n p2: B->A", {{'A', "B", {}, {}}, {'B', "A", {}, {}}});
    good("A \u2192 B\nB\u27F6A", {{'A', "B", {}, {}}, {'B', "A", {}, {}}});
    good("p1: B \u2192 0.5: B | 0.5: BB", {{'B', "B", {0.5, 0.5}, {"B", "BB"}}});
}

void TestGrammar::rulesAreRead()
{
    QFETCH(QByteArray, text);
    QFETCH(std::vector<Rule>, rules);
    const auto read = parseRules(text.toStdString());
    QVERIFY2(read, test::why(read));
    QVERIFY(*read == rules);
}

void TestGrammar::axiomIsRead()
{
    QCOMPARE(*parseAxiom(""), std::string());
    QCOMPARE(*parseAxiom(" B [ + A ]\t|:#\r\n B\n"), std::string("B[+A]|:#B"));
    QCOMPARE(*parseAxiom("` ```-"), std::string(" `-"));
    QVERIFY(parseGrammar("[A][B]", "A -> [B]"));
}

void TestGrammar::roundTrip()
{
    Random random(1, RandomStream::Test);
    for (int i = 0; i < 5000; ++i) {
        const std::vector<Rule> rules = randomRules(random);
        const auto checked = checkGrammar({"A", rules});
        QVERIFY2(checked, test::why(checked));
        const std::string text = test::formatRules(rules);
        const auto read = parseRules(text);
        QVERIFY2(read, test::why(read) + "\n" + bytes(text));
        QVERIFY2(*read == rules, text.c_str());
        QVERIFY(parseGrammar("A", text));
    }
}

void TestGrammar::randomBytesNeverCrash()
{
    static constexpr std::string_view likely = "AB[]->|:`#.05 default\n\t\r\\";
    Random random(2, RandomStream::Test);
    int good = 0;
    for (int i = 0; i < 50'000; ++i) {
        std::string text(random.below(24), ' ');
        const bool wild = random.unit() < 0.2;
        for (char& c : text)
            c = wild ? static_cast<char>(random.below(256))
                     : likely[random.below(std::uint32_t(likely.size()))];
        if (random.unit() < 0.5)
            text.insert(0, "A ->");
        const auto grammar = parseGrammar(text, text);
        const auto rules = parseRules(text);
        good += rules ? 1 : 0;
        if (rules)
            continue;
        // Every error has a place inside the text, or just behind a line of it.
        QVERIFY(rules.error().line >= 1 && rules.error().column >= 1);
        const QList<QByteArray> lines = bytes(text).split('\n');
        QVERIFY(rules.error().line <= lines.size());
        QVERIFY(rules.error().column <= lines[rules.error().line - 1].size() + 1);
    }
    QVERIFY(good > 1000);
}

void TestGrammar::everyRuleThatParsesSurvivesFormatting()
{
    static constexpr std::string_view likely = "ABC:|`05. ";
    Random random(3, RandomStream::Test);
    for (int i = 0; i < 50'000; ++i) {
        std::string text = "A -> ";
        for (std::uint32_t k = random.below(12); k > 0; --k)
            text += likely[random.below(std::uint32_t(likely.size()))];
        if (const auto rules = parseRules(text))
            QVERIFY2(*parseRules(test::formatRules(*rules)) == *rules, text.c_str());
    }
}

void TestGrammar::lookalikesAreRemarked_data()
{
    QTest::addColumn<QString>("axiom");
    QTest::addColumn<QString>("rules");
    QTest::addColumn<QString>("place"); // "line:column path"
    QTest::addColumn<QString>("plain"); // "-" for no replacement
    const auto row = [](const char* axiom, const char* rules, const char* place, const char* plain) {
        QTest::addRow("%s, %s", axiom, rules) << axiom << rules << place << plain;
    };
    row("A\u2212B", "", "1:2 grammar.axiom", "-");
    row("A", "A -> B\n B -> [\u2013A]", "2:8 grammar.rules", "-");
    row("A", "A -> 0.5: B | 0.5: \u2014B", "1:20 grammar.rules", "-");
    row("A\u00A0B", "", "1:2 grammar.axiom", " ");
    row("A\u200BB", "", "1:2 grammar.axiom", "");
    row("A\uFEFF", "", "1:2 grammar.axiom", "");
    row("A", "A -> \uFF3BA\uFF0BB\uFF3D", "1:6 grammar.rules", "[");
    row("A\u201C", "", "1:2 grammar.axiom", "");
    row("A\"", "", "1:2 grammar.axiom", "");
    row("A", "A -> {A}", "1:6 grammar.rules", "[");
    row("\u0410", "", "1:1 grammar.axiom", "A");     // of Cyrillic
    row("\U0001D434", "", "1:1 grammar.axiom", "A"); // of formulas
    row("A \u2192 B", "", "1:3 grammar.axiom", "->");
    row("\u00E9", "", "1:1 grammar.axiom", "none");
    row("A", "#define r 2\nA -> B", "1:1 grammar.rules", "none");
    row("A", "A -> B\n  #ignore: +-", "2:3 grammar.rules", "none");
}

/// They grow as they did: what grows is the same with a look at the remarks.
void TestGrammar::lookalikesAreRemarked()
{
    QFETCH(QString, axiom);
    QFETCH(QString, rules);
    GrammarNotes notes;
    const auto grammar = parseGrammar(axiom.toStdString(), rules.toStdString(), &notes);
    QVERIFY2(grammar, test::why(grammar));
    QVERIFY(*grammar == *parseGrammar(axiom.toStdString(), rules.toStdString()));
    QVERIFY(!notes.empty());
    const GrammarNote& first = notes.front();
    QTEST(QStringLiteral("%1:%2 %3")
              .arg(first.what.line)
              .arg(first.what.column)
              .arg(QString::fromStdString(first.what.path)),
          "place");
    QTEST(QString::fromStdString(first.replacement.value_or("none")), "plain");
    QVERIFY(!first.what.plain().empty());
}

void TestGrammar::whatIsMeantIsNotRemarked()
{
    const auto remarks = [](const std::string& axiom, const std::string& rules) {
        GrammarNotes notes;
        const auto grammar = parseGrammar(axiom, rules, &notes);
        return grammar ? notes.size() : 99;
    };
    QCOMPARE(remarks("EEBA[+-/\\^_]xyz09", "A -> B | C"), std::size_t(99));
    QCOMPARE(remarks("EEBA[+-/\\^_]xyz09", "A \u2192 [++BB]A\nB -> 0.5: B | default: BB"), std::size_t(0));
    QCOMPARE(remarks("A`\u2212`{", "A -> `\u00A0"), std::size_t(0)); // escaped
    QCOMPARE(remarks("A{", "{ -> A\nB -> {"), std::size_t(0));       // with a rule
    QCOMPARE(remarks("A", "# \u2212 in a comment\n# define it\n#ignored\nA -> B"), std::size_t(0));
}

void TestGrammar::replacementsLeaveNothingToRemark()
{
    static constexpr const char* parts[] = {"A",       "B",      "[A]",    "+",      " ",   "\u2212",
                                            "\u2013",  "\u00A0", "\uFF0B", "\u0410", "{A}", "\"",
                                            "`\u2212", "`{",     "\u201C", "\u2265"};
    Random random(3, RandomStream::Test);
    const auto text = [&random] {
        std::string out;
        for (std::uint32_t n = random.below(12); n > 0; --n)
            out += parts[random.below(std::size(parts))];
        return out;
    };
    for (int i = 0; i < test::runs(5000); ++i) {
        const std::string axiom = text(), rules = "A -> " + text() + "\n# \u2212\nB\u2192" + text();
        GrammarNotes notes;
        QVERIFY(parseGrammar(axiom, rules, &notes));
        const std::string plainAxiom = withReplacements(axiom, "grammar.axiom", notes),
                          plainRules = withReplacements(rules, "grammar.rules", notes);
        GrammarNotes left;
        const auto plain = parseGrammar(plainAxiom, plainRules, &left);
        QVERIFY2(plain, test::why(plain) + bytes(plainAxiom + '\n' + plainRules));
        QVERIFY2(left.empty(), (plainAxiom + '\n' + plainRules).c_str());
    }
}

RAMURE_SUITE(TestGrammar)

} // namespace tst_grammar

#include "tst_grammar.moc"
