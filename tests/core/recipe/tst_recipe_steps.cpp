#include "core/params/recipe.h"
#include "tests/support/mesh_checker.h"
#include "tests/support/shaped_tree.h"

#include <cmath>
#include <functional>

namespace tst_recipe_steps {

using namespace ramure;
using namespace ramure::test;

namespace {

using Change = std::function<void(StepParams&)>;

TreeEdit stepOf(EditOperation operation, const Change& change = {})
{
    TreeEdit step = newStep(operation);
    NodeParams values = *step.values;
    if (change)
        change(values.step);
    step.values = StepValues(std::move(values));
    return step;
}

/// A source that grows a small tree of letters: a trunk with two limbs.
TreeEdit twigs(const Change& change)
{
    TreeEdit step = stepOf(EditOperation::Grammar, change);
    NodeParams values = *step.values;
    values.grammar.axiom = "F[+F]F[^F]F";
    values.grammar.rules.clear();
    values.grammar.iterations = 0;
    step.values = StepValues(std::move(values));
    return step;
}

NodeParams with(NodeParams params, std::vector<TreeEdit> steps)
{
    for (TreeEdit& step : steps) {
        if (step.id == 0)
            step.id = newEditId(params.edits, step);
        params.edits.push_back(std::move(step));
    }
    return params;
}

NodeParams oak()
{
    NodeParams params = *presetParams("EnglishOak1995");
    params.weberPenn.levels = 2;
    params.mesh.targetTriangles = 0;
    params.sections.lengthDivisions = 2;
    params.sections.radialDivisions = 5;
    return params;
}

double lengthOf(const Skeleton& s)
{
    double sum = 0.0;
    for (Index i = 0; i < s.size(); ++i)
        sum += s.length(i);
    return sum;
}

std::vector<std::uint64_t> addressesOf(const Skeleton& skeleton)
{
    std::vector<std::uint64_t> addresses;
    for (const Axis& axis : axesOf(skeleton).axes)
        addresses.push_back(axis.address);
    std::ranges::sort(addresses);
    return addresses;
}

double meanTipHeight(const Skeleton& s)
{
    double sum = 0.0, count = 0.0;
    const ChildLists children = childLists(s);
    for (Index i = 0; i < s.size(); ++i)
        if (children.count(i) == 0) {
            sum += s.p1[i].y;
            ++count;
        }
    return sum / count;
}

EditOutcome outcomeOf(const NodeParams& params)
{
    return grownTree(params, Stage::Skeleton).edits->back();
}

} // namespace

/// Modifiers and sources behind the first one.
class TestRecipeSteps : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void badStepsChangeNothingAndSayWhy_data()
    {
        QTest::addColumn<QByteArray>("where");
        QTest::newRow("unreadable") << QByteArray("order >");
        QTest::newRow("names nothing") << QByteArray("order = 9");
        QTest::newRow("unknown name") << QByteArray("mood = 1");
    }
    void badStepsChangeNothingAndSayWhy()
    {
        QFETCH(QByteArray, where);
        const Skeleton plain = *grownTree(oak(), Stage::Skeleton).skeleton;
        for (const EditOperationInfo& info : editOperations()) {
            if (std::ranges::count(stepParams(info.operation), findParam("step.where")) == 0)
                continue;
            const TreeEdit step =
                stepOf(info.operation, [&](StepParams& s) { s.where = where.toStdString(); });
            const NodeParams params = with(oak(), {step});
            const TreeResult tree = grownTree(params, Stage::Skeleton);
            QCOMPARE(tree.edits->back().state, EditState::Idle);
            QCOMPARE(tree.edits->back().why.path, std::string("step.where"));
            QVERIFY2(tree.skeleton->p1 == plain.p1, info.key);
        }
    }

    void valuesOutOfRangeAreRefused()
    {
        TreeEdit step = stepOf(EditOperation::Sag, [](StepParams& s) { s.sag.amount = 1e9; });
        auto ok = checkTreeEdit(step);
        QVERIFY(!ok);
        QCOMPARE(ok.error().path, std::string("values.sag.amount"));
        step = stepOf(EditOperation::WeberPenn, [](StepParams& s) { s.stand.count = 0; });
        QVERIFY(!checkTreeEdit(step));
        step = stepOf(EditOperation::Gnarl, [](StepParams& s) { s.gnarl.angle = std::nan(""); });
        QVERIFY(!checkTreeEdit(step));
    }

    /// What has grown keeps its lengths, radii and addresses; only directions change.
    void sagAndGnarlTurnOnly_data()
    {
        QTest::addColumn<int>("operation");
        QTest::newRow("sag") << int(EditOperation::Sag);
        QTest::newRow("gnarl") << int(EditOperation::Gnarl);
    }
    void sagAndGnarlTurnOnly()
    {
        QFETCH(int, operation);
        const Skeleton plain = *grownTree(oak(), Stage::Skeleton).skeleton;
        const NodeParams params = with(oak(), {stepOf(EditOperation(operation))});
        const TreeResult tree = grownTree(params, Stage::Skeleton);
        QCOMPARE(tree.edits->back().state, EditState::ByAddress);
        QVERIFY(std::abs(lengthOf(*tree.skeleton) - lengthOf(plain)) < 1e-6 * lengthOf(plain));
        QVERIFY(addressesOf(*tree.skeleton) == addressesOf(plain));
        QVERIFY(tree.skeleton->p0.front() == plain.p0.front());
        QVERIFY(tree.skeleton->p1 != plain.p1);
    }

    void moreWeightHangsLower()
    {
        double before = meanTipHeight(*grownTree(oak(), Stage::Skeleton).skeleton);
        for (const double amount : {5.0, 20.0, 60.0}) {
            const NodeParams params =
                with(oak(), {stepOf(EditOperation::Sag, [&](StepParams& s) { s.sag.amount = amount; })});
            const double now = meanTipHeight(*grownTree(params, Stage::Skeleton).skeleton);
            QVERIFY(now < before);
            before = now;
        }
        const NodeParams none =
            with(oak(), {stepOf(EditOperation::Sag, [](StepParams& s) { s.sag.amount = 0.0; })});
        QVERIFY(grownTree(none, Stage::Skeleton).skeleton->p1 ==
                grownTree(oak(), Stage::Skeleton).skeleton->p1);
    }

    /// A beam that carries its own weight, clamped at one end: f = w L^4 / (8 E I).
    void aStraightLimbBendsAsABeam()
    {
        NodeParams params;
        params.grammar.axiom = "F[++FFFFFFFF]"; // a limb of eight pieces, level
        params.grammar.rules.clear();
        params.grammar.iterations = 0;
        params.turtle.alpha = 0.25;
        params.turtle.decay = 1.0;
        params.turtle.theta = 0.7853981633974483;
        const auto tipOf = [](const Skeleton& s) { return s.p1.back(); };
        const Skeleton plain = *grownTree(params, Stage::Skeleton).skeleton;
        const TreeEdit step = stepOf(EditOperation::Sag, [](StepParams& s) {
            s.where = "order = 1";
            s.sag.load = 0.0;
        });
        const Skeleton sagged = *grownTree(with(params, {step}), Stage::Skeleton).skeleton;
        const double length = glm::length(tipOf(plain) - plain.p0[1]), radius = plain.a0[1];
        const double weight = 900.0 * 9.81 * 3.141592653589793 * radius * radius;
        const double bending = 8e9 * 0.25 * 3.141592653589793 * std::pow(radius, 4);
        const double expected = weight * std::pow(length, 4) / (8.0 * bending);
        const double fell = tipOf(plain).y - tipOf(sagged).y;
        QVERIFY2(std::abs(fell / expected - 1.0) < 0.15, qPrintable(QString::number(fell / expected)));
    }

    void deadLimbsAreBareAndBroken()
    {
        const NodeParams params = with(oak(), {stepOf(EditOperation::DeadWood, [](StepParams& s) {
                                           s.deadWood.share = 1.0;
                                           s.deadWood.low = 0.0;
                                       })});
        const Skeleton plain = *grownTree(oak(), Stage::Skeleton).skeleton;
        const Skeleton dead = *grownTree(params, Stage::Skeleton).skeleton;
        QVERIFY(dead.size() < plain.size());
        const TreeAxes axes = axesOf(dead);
        for (Index i = 0; i < dead.size(); ++i)
            QCOMPARE(std::ranges::binary_search(dead.bare, i), axes.axes[axes.axisOf[i]].order > 0);
        const NodeParams none =
            with(oak(), {stepOf(EditOperation::DeadWood, [](StepParams& s) { s.deadWood.share = 0.0; })});
        QCOMPARE(grownTree(none, Stage::Skeleton).skeleton->size(), plain.size());
    }

    void thePipeRuleKeepsItsFootAndAddsUp()
    {
        const NodeParams params = with(oak(), {stepOf(EditOperation::Pipe)});
        const Skeleton plain = *grownTree(oak(), Stage::Skeleton).skeleton;
        const Skeleton s = *grownTree(params, Stage::Skeleton).skeleton;
        QVERIFY(std::abs(s.a0.front() - plain.a0.front()) < 1e-9);
        const double n = PipeParams().exponent;
        const ChildLists children = childLists(s);
        for (Index i = 0; i < s.size(); ++i) {
            QVERIFY(s.a1[i] <= s.a0[i]);
            double sum = 0.0;
            for (const Index child : children.of(i))
                sum += std::pow(s.a0[child], n);
            if (children.count(i) > 0)
                QVERIFY(std::abs(std::pow(s.a1[i], n) / sum - 1.0) < 1e-9);
        }
    }

    void theFootSwells()
    {
        const NodeParams params =
            with(oak(), {stepOf(EditOperation::Flare, [](StepParams& s) { s.flare.amount = 0.5; })});
        const Skeleton plain = *grownTree(oak(), Stage::Skeleton).skeleton;
        const Skeleton s = *grownTree(params, Stage::Skeleton).skeleton;
        QVERIFY(std::abs(s.a0.front() / plain.a0.front() - 1.5) < 1e-9);
        QCOMPARE(s.p1.back(), plain.p1.back());
    }

    /// What grows on what: closed, manifold, with one part a tree.
    void stacksAreWhole_data()
    {
        QTest::addColumn<QByteArray>("stack");
        for (const char* stack : {"limbs on a drawn trunk", "twigs on colonised limbs", "two on one parent",
                                  "at tips", "beside it", "like another species"})
            QTest::newRow(stack) << QByteArray(stack);
    }
    void stacksAreWhole()
    {
        QFETCH(QByteArray, stack);
        const NodeParams params = stackOf(stack);
        const TreeResult tree = grownTree(params, Stage::Mesh);
        for (const EditOutcome& outcome : *tree.edits)
            QVERIFY2(outcome.state == EditState::ByAddress, outcome.why.plain().c_str());
        QVERIFY(tree.skeleton->size() > tree.grown->size());
        QVERIFY(tree.report->valid);
        QCOMPARE(tree.report->components, tree.branches->roots);
        QVERIFY(checkMesh(tree.branches->mesh).perfect(tree.branches->roots));
        // The same again, and another draw with another seed of the tree.
        QVERIFY(*grownTree(params, Stage::Skeleton).skeleton == *tree.skeleton);
        std::vector<std::uint64_t> addresses = addressesOf(*tree.skeleton);
        QVERIFY(std::ranges::adjacent_find(addresses) == addresses.end());
    }

    void nothingThickerGrowsOnAnAxis()
    {
        const NodeParams params = stackOf("two on one parent");
        const Skeleton s = *grownTree(params, Stage::Skeleton).skeleton;
        const TreeAxes axes = axesOf(s);
        for (const Axis& axis : axes.axes)
            if (axis.parent != noIndex) {
                const Index foot = axes.nodes[axis.firstNode];
                QVERIFY(s.a0[foot] <= s.a1[s.parent[foot]] * (1.0 + 1e-9));
            }
    }

    /// Steps before or beside it, on or off: what a source has grown keeps its names, and edits on it hold.
    void namesSurviveOtherSteps()
    {
        const TreeEdit source = twigs([](StepParams& s) {
            s.where = "order = 1";
            s.stand.count = 2;
        });
        NodeParams params = with(oak(), {source});
        const std::vector<std::uint64_t> before = addressesOf(*grownTree(params, Stage::Skeleton).skeleton);
        for (const EditOperation other : {EditOperation::Gnarl, EditOperation::Sag, EditOperation::Pipe}) {
            NodeParams more = params;
            TreeEdit step = stepOf(other);
            step.id = 4711;
            more.edits.insert(more.edits.begin(), step);
            QVERIFY(addressesOf(*grownTree(more, Stage::Skeleton).skeleton) == before);
        }
        const Skeleton grown = *grownTree(params, Stage::Skeleton).skeleton;
        const std::vector<std::uint64_t> plain = addressesOf(*grownTree(oak(), Stage::Skeleton).skeleton);
        const auto made = std::ranges::find_if(
            before, [&](std::uint64_t address) { return !std::ranges::binary_search(plain, address); });
        QVERIFY(made != before.end());
        QVERIFY(test::make(params, editOf(EditOperation::Remove, *made)));
        QVERIFY(grownTree(params, Stage::Skeleton).skeleton->size() < grown.size());
        TreeEdit step = stepOf(EditOperation::Gnarl);
        step.id = 4711;
        params.edits.insert(params.edits.begin(), step);
        QCOMPARE(outcomeOf(params).state, EditState::ByAddress);
    }

    void theSeedDraws()
    {
        const NodeParams params = with(oak(), {stepOf(EditOperation::Gnarl)});
        NodeParams other = params;
        NodeParams values = *other.edits.back().values;
        values.step.seed = 5;
        other.edits.back().values = StepValues(std::move(values));
        QVERIFY(grownTree(params, Stage::Skeleton).skeleton->p1 !=
                grownTree(other, Stage::Skeleton).skeleton->p1);
    }

    void aStepActsOnItsLimbAlone()
    {
        Shaped shaped;
        TreeEdit step = stepOf(EditOperation::Gnarl);
        step.target.address = shaped.address[1];
        QVERIFY(shaped.make(step));
        const Shaped plain;
        QCOMPARE(shaped.tip(shaped.address[0]), plain.tip(shaped.address[0]));
        QVERIFY(shaped.tip(shaped.address[1]) != plain.tip(shaped.address[1]));
        QVERIFY(shaped.tip(shaped.address[2]) != plain.tip(shaped.address[2]));
    }

    void tooMuchIsALimit()
    {
        const NodeParams params =
            with(*presetParams("EnglishOak1995"), {stepOf(EditOperation::WeberPenn, [](StepParams& s) {
                s.where = "order = 2";
                s.stand.way = StandWay::Along;
                s.stand.count = 1000;
            })});
        const EditOutcome outcome = outcomeOf(params);
        QCOMPARE(outcome.state, EditState::Idle);
        QCOMPARE(outcome.why.code, ErrorCode::Limit);
    }

    void stepsAreNamedInTexts()
    {
        NodeParams params = with(oak(), {stepOf(EditOperation::Sag), stepOf(EditOperation::Gnarl)});
        params.edits[0].name = "Old limbs. All";
        QCOMPARE(*findStep(params, "#1"), StepNumber(0));
        QCOMPARE(*findStep(params, "gnarl"), StepNumber(2));
        QCOMPARE(*findStep(params, "Old limbs. All"), StepNumber(1));
        QCOMPARE(findStep(params, "#4").error().code, ErrorCode::Unknown);
        QCOMPARE(findStep(params, "sag").error().code, ErrorCode::Unknown);
        const auto set = [&params](const char* key, ParamValue value) {
            const auto parsed = parseRecipeKey(key);
            return parsed ? setRecipeValue(params, *parsed, value) : Expected<void>(fail(parsed.error()));
        };
        QVERIFY(set("step:Old limbs. All.sag.amount", 3.0));
        QVERIFY(set("sag.stiffness", 5.0));
        QVERIFY(set("#3.gnarl.angle", 0.5));
        QVERIFY(set("#1.weberPenn.levels", std::int64_t(1)));
        QVERIFY(set("weberPenn.levels", std::int64_t(2)));
        QCOMPARE(params.edits[0].values->step.sag.amount, 3.0);
        QCOMPARE(params.edits[0].values->step.sag.stiffness, 5.0);
        QCOMPARE(params.edits[1].values->step.gnarl.angle, 0.5);
        QCOMPARE(params.weberPenn.levels, std::int64_t(2));
        const auto none = set("turtle.theta", 0.3);
        QCOMPARE(none.error().code, ErrorCode::Unknown);
        QVERIFY(none.error().plain().find("1 weberPenn, 2 Old limbs. All, 3 gnarl") != std::string::npos);
        QVERIFY(!set("#2.gnarl.angle", 0.5));
        QVERIFY(!set("#9.gnarl.angle", 0.5));
        QVERIFY(!set("step:gnarl.nothing", 0.5));
        params = with(params, {stepOf(EditOperation::Sag)});
        QCOMPARE(set("sag.amount", 1.0).error().code, ErrorCode::Invalid);
    }

private:
    static NodeParams stackOf(const QByteArray& stack)
    {
        if (stack == "limbs on a drawn trunk") {
            NodeParams drawn = oak();
            drawn.generator.kind = EditOperation::Draw;
            TreeEdit trunk = editOf(EditOperation::Draw, 0);
            trunk.points = {{{0.0, 0.0, 0.0}, 0.3},
                            {{0.3, -0.1, 2.0}, 0.25},
                            {{0.1, -0.4, 4.5}, 0.15},
                            {{0.0, -0.2, 7.0}, 0.05}};
            TreeEdit limbs = newStep(EditOperation::WeberPenn);
            NodeParams values = *presetParams("EnglishOak1995");
            values.weberPenn.levels = 2;
            values.step = limbs.values->step;
            limbs.values = StepValues(std::move(values));
            return with(drawn, {trunk, limbs});
        }
        if (stack == "twigs on colonised limbs") {
            NodeParams park = *presetParams("ParkTree");
            park.colonisation.points = 200;
            return with(park, {twigs([](StepParams& s) { s.where = "order > 0 and length > 0.4"; })});
        }
        if (stack == "two on one parent")
            return with(oak(),
                        {twigs([](StepParams& s) { s.where = "order = 1"; }),
                         stepOf(EditOperation::WeberPenn, [](StepParams& s) { s.where = "order = 1"; })});
        if (stack == "at tips")
            return with(*presetParams("TinyTree"), {twigs([](StepParams& s) {
                s.where = "order = 1";
                s.stand.way = StandWay::Tips;
            })});
        if (stack == "beside it")
            return with(oak(), {stepOf(EditOperation::Colonisation,
                                       [](StepParams& s) { s.stand.way = StandWay::Ground; })});
        NodeParams birch = *presetParams("SilverBirch1995");
        birch.weberPenn.levels = 2;
        TreeEdit step = newStep(EditOperation::WeberPenn);
        birch.step = step.values->step;
        birch.step.where = "order = 1 and length > 1";
        step.values = StepValues(std::move(birch));
        return with(oak(), {step});
    }
};

RAMURE_SUITE(TestRecipeSteps)

} // namespace tst_recipe_steps

#include "tst_recipe_steps.moc"
