#include "core/generators/grammar/rewrite.h"
#include "tests/support/suite.h"
#include "tests/widgets/tree_document.h"
#include "widgets/panels/properties/grammar/generations_view.h"
#include "widgets/panels/properties/grammar/grammar_growth.h"
#include <QLabel>
#include <QToolButton>

namespace tst_generations {

using namespace ramure;

namespace {

std::string stringOf(const GrammarParams& params, int iterations)
{
    RewriteOptions options;
    options.iterations = iterations;
    options.stochastic = params.stochastic;
    options.seed = static_cast<std::uint64_t>(params.seed);
    const auto text = rewrite(*parseGrammar(params.axiom, params.rules), options);
    return text ? *text : std::string();
}

} // namespace

class TestGenerations : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void brokenRulesAreErrors()
    {
        GrammarParams params;
        params.rules = std::string("A ->\nA -> B");
        const auto generations = generationsOf(params);
        QVERIFY(!generations);
        QCOMPARE(generations.error().path, std::string("grammar.rules"));
        params.rules = std::string("A -> [B");
        QVERIFY(!generationsOf(params));
    }

    void eachGenerationIsWhatRewritingGives()
    {
        GrammarParams params;
        for (const bool chance : {false, true}) {
            params.stochastic = chance;
            const auto generations = generationsOf(params);
            QVERIFY(generations);
            QCOMPARE(generations->size(), std::size_t{9});
            for (int i = 0; i < 9; ++i) {
                const std::string text = stringOf(params, i);
                const Generation& generation = (*generations)[static_cast<std::size_t>(i)];
                QCOMPARE(generation.symbols, static_cast<double>(text.size()));
                QVERIFY(generation.text == text);
            }
        }
    }

    void longStringsAreCountedNotWritten()
    {
        GrammarParams params;
        params.axiom = std::string("AB");
        params.rules = std::string("A -> AB[A]\nB -> 0.5: BB | 0.5: B");
        params.iterations = 14;
        const auto generations = generationsOf(params);
        QVERIFY(generations);
        QVERIFY(!generations->back().text);
        for (int i = 0; i <= 14; ++i)
            QCOMPARE((*generations)[static_cast<std::size_t>(i)].symbols,
                     static_cast<double>(stringOf(params, i).size()));
        params.stochastic = true; // drawn: beyond the limit nobody knows without drawing
        const auto drawn = generationsOf(params);
        QVERIFY(drawn && drawn->back().atLeast);
        params.stochastic = false;
        params.iterations = 1000;
        QCOMPARE(generationsOf(params)->size(), std::size_t{mostGenerations} + 1);
        params.iterations = -5;
        QCOMPARE(generationsOf(params)->size(), std::size_t{1});
    }

    void modulesHaveTheirNumbers()
    {
        GrammarParams params{"A(1)", "A(l) -> F(l)[+A(l*r)]A(l*r)", 14,       false,
                             1,      GrammarDialect::Parametric,    "r = 0.5"};
        const auto generations = generationsOf(params);
        QVERIFY(generations && generations->size() > 3);
        QCOMPARE(*(*generations)[1].text, std::string("F[+A]A"));
        QCOMPARE((*generations)[1].word.numbers, (std::vector<double>{1.0, 0.5, 0.5}));
        QVERIFY(generations->back().atLeast); // too long to be written, hence not counted
        params.rules = "A(l) -> A(l";
        QCOMPARE(generationsOf(params).error().path, std::string("grammar.rules"));
        params.rules = "A(l) -> A(l/0)"; // what is before the mistake is shown
        QCOMPARE(generationsOf(params)->size(), std::size_t{1});
    }

    void theModuleUnderThePointerIsTold()
    {
        test::TreeDocument trees;
        NodeParams params = test::smallForks();
        params.grammar = {"F(1)A(1,8)", "A(l,w) -> F(l)A(l*r,w)", 2, false, 1, GrammarDialect::Parametric,
                          "r = 0.25"};
        const NodeId tree = trees.add(params);
        GenerationsView view(&trees.document(), nullptr);
        view.setTree(tree);
        view.setUnfolded(true);
        view.show();
        auto* text = view.findChild<QPlainTextEdit*>();
        QTRY_VERIFY(text->toPlainText().endsWith(QStringLiteral("\nFFFA")));
        const auto end = static_cast<int>(text->toPlainText().size());
        QCOMPARE(view.moduleAt(end - 1), QStringLiteral("A(0.0625, 8)"));
        QCOMPARE(view.moduleAt(end - 2), QStringLiteral("F(0.25)"));
        for (const int nowhere : {0, end, end + 5})
            QVERIFY(view.moduleAt(nowhere).isEmpty());
        // Behind the ellipsis of a long text letters stand further on.
        std::string axiom;
        for (int i = 0; i < 400; ++i)
            axiom += "F(" + std::to_string(i + 1) + ")";
        QVERIFY(edit::setParam(trees.document(), {tree}, *findParam("grammar.axiom"), axiom));
        QTRY_VERIFY(text->toPlainText().endsWith(QStringLiteral("FFFFFF")));
        const auto last = static_cast<int>(text->toPlainText().size()) - 1;
        QCOMPARE(view.moduleAt(last), QStringLiteral("F(400)"));
        QCOMPARE(view.moduleAt(last - 59), QStringLiteral("F(341)"));
        QVERIFY(view.moduleAt(last - 61).isEmpty());
        QCOMPARE(view.moduleAt(last - 63), QStringLiteral("F(220)"));
    }

    void theViewTellsWhatTheTreeHas()
    {
        test::TreeDocument trees;
        const NodeId tree = trees.add(test::smallForks());
        GenerationsView view(&trees.document(), nullptr);
        view.show();
        auto* summary = view.findChild<QLabel*>(QStringLiteral("generationsSummary"));
        QVERIFY(summary->text().isEmpty());
        view.setTree(tree);
        const auto& result = trees.document().result(tree)->tree;
        QVERIFY(summary->text().contains(QString::number(result.symbols->size())));
        QVERIFY(summary->text().contains(QString::number(result.skeleton->size())));
        view.findChild<QToolButton*>(QStringLiteral("generationsFold"))->click();
        auto* text = view.findChild<QPlainTextEdit*>();
        QVERIFY(text->isVisible());
        QTRY_VERIFY(text->toPlainText().endsWith(QString::fromStdString(*result.symbols)));
        QVERIFY(edit::setParam(trees.document(), {tree}, *findParam("grammar.axiom"), std::string("F[+F]")));
        QTRY_VERIFY(text->toPlainText().endsWith(QStringLiteral("\nF[+F]")));
        QVERIFY(edit::setParam(trees.document(), {tree}, *findParam("grammar.axiom"), std::string("F[")));
        QTRY_VERIFY(!text->toPlainText().contains(u'['));
    }
};

RAMURE_SUITE(TestGenerations)

} // namespace tst_generations

#include "tst_generations.moc"
