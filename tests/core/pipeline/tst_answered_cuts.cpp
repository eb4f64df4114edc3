#include "core/generators/tree_life.h"
#include "core/pipeline/freeze.h"
#include "core/recipe/edit_context.h"
#include "tests/support/mesh_checker.h"
#include "tests/support/shaped_tree.h"
#include <limits>
#include <set>

namespace tst_answered_cuts {

using namespace ramure;
using namespace ramure::test;

namespace {

constexpr double cutAt = 20.0;

NodeParams oak(double age)
{
    NodeParams params = *presetParams("EnglishOak");
    params.growth.age = age;
    params.growth.density = 0.4;
    return params;
}

std::set<std::uint64_t> addressesOf(const Skeleton& tree)
{
    std::set<std::uint64_t> addresses;
    for (const Axis& axis : axesOf(tree).axes)
        addresses.insert(axis.address);
    return addresses;
}

/// The longest limb of the trunk.
std::uint64_t longestLimb(const Skeleton& tree)
{
    const TreeAxes axes = axesOf(tree);
    const Axis* longest = nullptr;
    for (const Axis& axis : axes.axes)
        if (axis.order == 1 && (!longest || axis.length > longest->length))
            longest = &axis;
    return longest ? longest->address : 0;
}

/// The oak with its longest limb of 20 years cut then.
struct Pruned
{
    NodeParams params = oak(cutAt);
    std::uint64_t limb = 0, other = 0;

    explicit Pruned(EditOperation operation = EditOperation::Remove, double at = 0.5)
    {
        const Skeleton grown = *grownTree(params, Stage::Skeleton).grown;
        limb = longestLimb(grown);
        EditContext context(grown, {});
        TreeEdit edit = editOf(operation, limb);
        edit.at = at;
        edit.year = cutAt;
        if (!make(params, edit, context))
            qFatal("not made");
    }
    [[nodiscard]] TreeResult at(double age, Stage last = Stage::Skeleton) const
    {
        NodeParams older = params;
        older.growth.age = age;
        return grownTree(older, last);
    }
};

} // namespace

/// Edits that a growing tree lives with: growthCuts() through the recipe and the pipeline.
class TestAnsweredCuts : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void impossibleYearsAreRefused()
    {
        for (const double year : {-1.0, 2001.0, std::numeric_limits<double>::quiet_NaN()}) {
            TreeEdit edit = editOf(EditOperation::Cut, 7);
            edit.year = year;
            const auto checked = checkTreeEdit(edit);
            QVERIFY(!checked);
            QCOMPARE(checked.error().path, std::string("year"));
        }
    }

    void cutsOfOtherTreesAreNoPartOfTheirLives()
    {
        NodeParams params = Pruned().params;
        QCOMPARE(growthCuts(params).size(), std::size_t(1));
        QCOMPARE(growthYears(params), cutAt);
        TreeEdit& edit = params.edits.front();
        const auto isNone = [&](auto&& change) {
            const TreeEdit before = edit;
            change();
            const bool none = growthCuts(params).empty();
            edit = before;
            return none;
        };
        QVERIFY(isNone([&] { edit.enabled = false; }));
        QVERIFY(isNone([&] { edit.year = 0.0; }));
        QVERIFY(isNone([&] { edit.operation = EditOperation::Cut, edit.falls = true; }));
        QVERIFY(isNone([&] { edit.target.maker = 5; }));
        QVERIFY(isNone([&] { edit.operation = EditOperation::Keep; }));
        params.generator.kind = EditOperation::WeberPenn;
        QVERIFY(growthCuts(params).empty());
        QCOMPARE(growthYears(params), 0.0);
    }

    void youngerTreesWaitForIt()
    {
        const Pruned pruned;
        const TreeResult young = pruned.at(cutAt - 1.0);
        QCOMPARE(young.edits->front().state, EditState::Waits);
        const Skeleton uncut = *grownTree(oak(cutAt - 1.0), Stage::Skeleton).skeleton;
        QVERIFY(young.skeleton->p1 == uncut.p1 && young.skeleton->a0 == uncut.a0);
        QVERIFY(addressesOf(*young.skeleton).contains(pruned.limb));
    }

    void olderTreesAreWithoutTheLimbAndAnswer()
    {
        const Pruned pruned;
        for (const double age : {cutAt, cutAt + 0.5, 31.0, 45.0}) {
            const TreeResult tree = pruned.at(age);
            QCOMPARE(tree.edits->front().state, EditState::ByAddress);
            QVERIFY(!addressesOf(*tree.skeleton).contains(pruned.limb));
        }
        // What stood then elsewhere goes on to live, and there is wood that would not be there.
        const auto then = addressesOf(*pruned.at(cutAt).skeleton);
        const auto later = addressesOf(*pruned.at(27.0).skeleton),
                   uncut = addressesOf(*grownTree(oak(27.0), Stage::Skeleton).skeleton);
        std::size_t stays = 0, is = 0, isNew = 0;
        for (const std::uint64_t address : then) {
            stays += uncut.contains(address) ? 1 : 0;
            is += uncut.contains(address) && later.contains(address) ? 1 : 0;
        }
        for (const std::uint64_t address : later)
            isNew += uncut.contains(address) ? 0 : 1;
        QVERIFY(stays > 50);
        QVERIFY2(double(is) >= 0.95 * double(stays), qPrintable(QString::number(is)));
        QVERIFY(isNew > 0);
    }

    void offOrInAFrozenTreeItIsAsOfOld()
    {
        Pruned pruned;
        pruned.params.edits.front().enabled = false;
        QVERIFY(pruned.at(45.0).grown->p1 == grownTree(oak(45.0), Stage::Skeleton).grown->p1);
        pruned.params.edits.front().enabled = true;
        const TreeResult before = pruned.at(cutAt);
        const auto frozen = frozenBehind(pruned.params, 1);
        QVERIFY(frozen);
        pruned.params.edits = *frozen;
        const TreeResult held = pruned.at(90.0);
        QVERIFY(held.skeleton->p1 == before.skeleton->p1);
        QCOMPARE(held.edits->front().state, EditState::Frozen);
    }

    /// Of what is younger than the cut there is no life to answer for: this year's shoots go as they are.
    void whatCameLaterIsCutAsItHasGrown()
    {
        Pruned pruned;
        pruned.params.edits.front().year = 1.0;
        const TreeResult tree = pruned.at(cutAt);
        QCOMPARE(tree.edits->front().state, EditState::ByAddress);
        QVERIFY(!addressesOf(*tree.skeleton).contains(pruned.limb));
    }

    void whatNeverStoodIsMissed()
    {
        Pruned pruned;
        pruned.params.edits.front().target.address = 12345;
        const TreeResult tree = pruned.at(cutAt);
        QCOMPARE(tree.edits->front().state, EditState::Unplaced);
        QVERIFY(!tree.edits->front().why.message().empty());
        QVERIFY(tree.skeleton->p1 == grownTree(oak(cutAt), Stage::Skeleton).skeleton->p1);
    }

    /// A hedge is clipped at an age, and grows out again.
    void whatIsPrunedToAShapeGrowsOutAgain()
    {
        NodeParams params = oak(cutAt);
        TreeEdit prune = editOf(EditOperation::Prune, 0);
        prune.shape.kind = EditShapeKind::Box;
        prune.shape.numbers = {-1.5, 1.0, -1.5, 1.5, 5.0, 1.5};
        prune.year = cutAt;
        QVERIFY(make(params, prune));
        const auto outside = [&](double age) {
            NodeParams older = params;
            older.growth.age = age;
            const TreeResult tree = grownTree(older, Stage::Mesh);
            if (!tree.report->valid || tree.edits->front().state == EditState::Unplaced)
                return -1.0;
            double metres = 0.0;
            const Skeleton& s = *tree.skeleton;
            for (Index i = 0; i < s.size(); ++i)
                if (const glm::dvec3 p = s.p1[i]; std::abs(p.x) > 1.6 || std::abs(p.z) > 1.6 || p.y > 5.1)
                    metres += s.length(i);
            return metres;
        };
        QVERIFY(outside(cutAt - 1.0) > 50.0);
        const double clipped = outside(cutAt), grown = outside(cutAt + 12.0);
        QVERIFY2(clipped >= 0.0 && clipped < 1.0, qPrintable(QString::number(clipped)));
        QVERIFY2(grown > 10.0, qPrintable(QString::number(grown)));
        params.edits.front().shape.numbers = {-50.0, -1.0, -50.0, 50.0, 50.0, 50.0};
        QCOMPARE(outside(cutAt + 1.0), -1.0); // nothing stands out
    }

    void stumpsAndLaterEditsAreWhole()
    {
        Pruned pruned(EditOperation::Cut, 0.4);
        const double whole = [&] {
            const Skeleton uncut = *grownTree(oak(cutAt), Stage::Skeleton).grown;
            return EditContext(uncut, {}).lengthOf(pruned.limb);
        }();
        QVERIFY(pruned.at(cutAt + 12.0).skeleton->sawn.empty());
        std::size_t wounds = 0; // that are open; beside a shoot at its end none is seen
        for (const double at : {0.3, 0.4, 0.5, 0.6, 0.7})
            wounds += Pruned(EditOperation::Cut, at).at(cutAt).skeleton->sawn.size();
        QVERIFY(wounds > 0);
        const double stump = pruned.at(cutAt).edited->lengthOf(pruned.limb);
        QVERIFY2(stump > 0.2 * whole && stump < 0.6 * whole, qPrintable(QString::number(stump / whole)));
        // Another hand edit on the answered tree, and one more cut ten years later.
        pruned.params.growth.age = 30.0;
        const TreeResult later = pruned.at(30.0);
        TreeEdit second = editOf(EditOperation::Remove, longestLimb(*later.grown));
        second.year = 30.0;
        QVERIFY(make(pruned.params, second));
        TreeEdit gnarl = newStep(EditOperation::Gnarl);
        gnarl.id = newEditId(pruned.params.edits, gnarl);
        pruned.params.edits.push_back(gnarl);
        for (const double age : {19.5, 20.0, 24.0, 30.0, 42.0}) {
            const TreeResult tree = pruned.at(age, Stage::Mesh);
            QVERIFY(tree.report->valid);
            QVERIFY(checkMesh(tree.branches->mesh).perfect(tree.branches->roots));
            QCOMPARE((*tree.edits)[0].state, age < cutAt ? EditState::Waits : EditState::ByAddress);
            QCOMPARE((*tree.edits)[1].state, age < 30.0 ? EditState::Waits : EditState::ByAddress);
            QCOMPARE((*tree.edits)[2].state, EditState::ByAddress);
        }
    }
};

RAMURE_SUITE(TestAnsweredCuts)

} // namespace tst_answered_cuts

#include "tst_answered_cuts.moc"
