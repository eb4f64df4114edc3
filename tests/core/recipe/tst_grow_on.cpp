#include "core/params/recipe.h"
#include "tests/support/mesh_checker.h"
#include "tests/support/shaped_tree.h"
#include <set>

namespace tst_grow_on {

using namespace ramure;
using namespace ramure::test;

namespace {

TreeEdit growOnFor(double years)
{
    TreeEdit step = newStep(EditOperation::GrowOn);
    NodeParams values = *step.values;
    values.step.growOn.years = years;
    values.growth.height = 8.0;
    values.growth.density = 0.5;
    step.values = StepValues(std::move(values));
    return step;
}

void append(NodeParams& params, TreeEdit step)
{
    step.id = newEditId(params.edits, step);
    params.edits.push_back(std::move(step));
}

/// A trunk by hand alone.
NodeParams drawn()
{
    NodeParams params;
    params.generator.kind = EditOperation::Draw;
    TreeEdit trunk = editOf(EditOperation::Draw, 0);
    trunk.points = {
        {{0.0, 0.0, 0.0}, 0.1}, {{0.1, 0.8, 0.0}, 0.08}, {{0.0, 1.6, 0.1}, 0.06}, {{0.2, 2.4, 0.1}, 0.03}};
    append(params, trunk);
    return params;
}

} // namespace

/// The step that lets whatever stands live some years longer.
class TestGrowOn : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void impossibleValuesAreRefused()
    {
        for (const double years : {-1.0, 501.0}) {
            const auto checked = checkTreeEdit(growOnFor(years));
            QVERIFY(!checked);
            QCOMPARE(checked.error().path, std::string("values.growOn.years"));
        }
    }

    void aTreeWithALimbThatFallsWaits()
    {
        NodeParams params = plainTree();
        TreeEdit cut = editOf(EditOperation::Cut, axesOf(*grownTree(params).skeleton).axes[1].address);
        cut.falls = true;
        QVERIFY(make(params, cut));
        append(params, growOnFor(5.0));
        const TreeResult tree = grownTree(params);
        QCOMPARE(tree.edits->back().state, EditState::Idle);
        QVERIFY(!tree.edits->back().why.message().empty());
    }

    void noYearsChangeNothing()
    {
        NodeParams params = drawn();
        const Skeleton before = *grownTree(params, Stage::Skeleton).skeleton;
        append(params, growOnFor(0.0));
        QVERIFY(*grownTree(params, Stage::Skeleton).skeleton == before);
    }

    void whateverStandsLivesOn_data()
    {
        QTest::addColumn<NodeParams>("params");
        QTest::newRow("drawn") << drawn();
        QTest::newRow("grammar") << plainTree();
        for (const char* preset : {"SilverBirch1995", "EnglishOak", "TernaryTree"}) {
            NodeParams params = *presetParams(preset);
            params.weberPenn.levels = 2;
            params.growth.age = 8.0;
            params.grammar.iterations = 3;
            QTest::newRow(preset) << params;
        }
    }
    void whateverStandsLivesOn()
    {
        QFETCH(NodeParams, params);
        const TreeResult before = grownTree(params, Stage::Skeleton);
        append(params, growOnFor(6.0));
        const TreeResult after = grownTree(params, Stage::Mesh);
        QCOMPARE(after.edits->back().state, EditState::ByAddress);
        QVERIFY(after.skeleton->size() > before.skeleton->size());
        QVERIFY(after.report->valid);
        QVERIFY(checkMesh(after.branches->mesh).perfect(after.branches->roots));
        std::set<std::uint64_t> addresses;
        for (const Axis& axis : axesOf(*after.skeleton).axes)
            QVERIFY(addresses.insert(axis.address).second);
        QVERIFY(addresses.contains(axesOf(*before.skeleton).axes.front().address));
    }

    /// Steps behind it find old axes and new ones, also when the years change.
    void laterStepsKeepTheirPlaces()
    {
        NodeParams params = drawn();
        append(params, growOnFor(8.0));
        const TreeResult grown = grownTree(params, Stage::Skeleton);
        EditContext context(*grown.grown, params.edits, nullptr, treeSeed(params));
        const TreeAxes axes = axesOf(*grown.skeleton);
        const auto limb = std::ranges::max_element(
            axes.axes, {}, [](const Axis& axis) { return axis.order == 1 ? axis.length : 0.0; });
        TreeEdit bend = editOf(EditOperation::Bend, limb->address);
        bend.rotation = {0.0, 0.0, 0.4};
        const auto made = make(params, bend, context);
        QVERIFY2(made, why(made).constData());
        TreeEdit thick = editOf(EditOperation::Thickness, axes.axes.front().address);
        thick.factor = 1.5;
        QVERIFY(make(params, thick, context));
        append(params, newStep(EditOperation::Gnarl));
        for (const double years : {8.0, 9.0}) {
            NodeParams values = *params.edits[1].values;
            values.step.growOn.years = years;
            params.edits[1].values = StepValues(values);
            const TreeResult tree = grownTree(params, Stage::Mesh);
            for (const EditOutcome& outcome : *tree.edits)
                QVERIFY2(outcome.state == EditState::ByAddress, outcome.why.plain().c_str());
            QVERIFY(tree.report->valid);
        }
    }
};

RAMURE_SUITE(TestGrowOn)

} // namespace tst_grow_on

#include "tst_grow_on.moc"
