#include "core/params/param_def.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/surface/mesher/mesh_divisions.h"
#include "tests/support/suite.h"
#include "tests/support/turned_branches.h"

namespace tst_pipeline_budget {

using namespace ramure;

/// The triangle budget as a parameter: what it changes, and what no longer has a say.
class TestPipelineBudget : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void budgetsOutsideTheRangeAreErrors();
    void hugeTreesStayRefused();
    void onlyTheMeshChanges();
    void divisionsHaveNoSay();
    void noBudgetIsTheMeshOfTheDivisions();
    void whatDoesNotFitIsSaid();
    void rollsStillTurn();
};

namespace {

NodeParams tinyTree(std::int64_t budget)
{
    NodeParams params = *presetParams("TinyTree");
    params.mesh.targetTriangles = budget;
    return params;
}

} // namespace

void TestPipelineBudget::budgetsOutsideTheRangeAreErrors()
{
    for (const std::int64_t bad : {std::int64_t(-1), std::int64_t(20'000'001)}) {
        const auto tree = TreePipeline().evaluate(tinyTree(bad));
        QVERIFY(!tree);
        QCOMPARE(tree.error().path, std::string("mesh.targetTriangles"));
    }
}

/// A budget does not let more branches through than can be drawn at all.
void TestPipelineBudget::hugeTreesStayRefused()
{
    NodeParams params = tinyTree(1000);
    params.grammar.axiom = std::string(1, 'A');
    params.grammar.rules = "A -> A[+A][-A]";
    params.grammar.iterations = 14;
    const auto tree = TreePipeline().evaluate(params, Stage::Mesh);
    QVERIFY(!tree);
    QCOMPARE(tree.error().code, ErrorCode::Limit);
    QCOMPARE(tree.error().path, std::string("grammar.iterations"));
}

void TestPipelineBudget::onlyTheMeshChanges()
{
    TreePipeline pipeline;
    const auto plain = pipeline.evaluate(tinyTree(0)), budget = pipeline.evaluate(tinyTree(4000));
    QVERIFY2(plain, test::why(plain));
    QVERIFY2(budget, test::why(budget));
    QVERIFY(budget->simplified == plain->simplified && budget->sections == plain->sections);
    QCOMPARE(budget->foliage->leaves.size(), plain->foliage->leaves.size()); // on the bark that there is
    QVERIFY(budget->branches != plain->branches);
    QVERIFY(budget->report->valid);
    QCOMPARE(budget->branches->budget, BudgetFit::Within);
    // Faithful leaves float beside their twigs, whatever the mesh.
    NodeParams faithful = tinyTree(0);
    faithful.leaf = {};
    faithful.fruit = {};
    const auto floating = pipeline.evaluate(faithful);
    faithful.mesh.targetTriangles = 4000;
    const auto still = pipeline.evaluate(faithful);
    QVERIFY(floating && still);
    QVERIFY(floating->branches != still->branches);
    QVERIFY(floating->foliage == still->foliage && floating->leaves == still->leaves);
}

void TestPipelineBudget::divisionsHaveNoSay()
{
    TreePipeline pipeline;
    NodeParams params = tinyTree(4000);
    const auto first = pipeline.evaluate(params);
    params.sections = {8, 16};
    const auto second = pipeline.evaluate(params);
    QVERIFY(first && second);
    QVERIFY(second->branches == first->branches);
    QVERIFY(second->sections != first->sections);
}

void TestPipelineBudget::noBudgetIsTheMeshOfTheDivisions()
{
    TreePipeline pipeline;
    const auto before = pipeline.evaluate(tinyTree(0));
    QVERIFY(pipeline.evaluate(tinyTree(3000)));
    const auto after = pipeline.evaluate(tinyTree(0));
    QVERIFY(before && after && before->branches == after->branches);
    QCOMPARE(after->branches->budget, BudgetFit::NotAsked);
}

void TestPipelineBudget::whatDoesNotFitIsSaid()
{
    const auto tree = TreePipeline().evaluate(tinyTree(10));
    QVERIFY2(tree, test::why(tree));
    QCOMPARE(tree->branches->budget, BudgetFit::Smallest);
    QVERIFY(tree->report->valid);
}

void TestPipelineBudget::rollsStillTurn()
{
    TreePipeline pipeline;
    NodeParams params = tinyTree(4000);
    const auto plain = pipeline.evaluate(params);
    QVERIFY2(plain, test::why(plain));
    const auto rolled = pipeline.evaluate(withSteps(params, std::vector{test::roll(*plain, params, 3, 0.5)}));
    QVERIFY2(rolled, test::why(rolled));
    QVERIFY(rolled->branches->mesh.positions != plain->branches->mesh.positions);
    QVERIFY(rolled->report->valid);
}

RAMURE_SUITE(TestPipelineBudget)

} // namespace tst_pipeline_budget

#include "tst_pipeline_budget.moc"
