#include "core/presets/presets.h"
#include "core/qt/session/jobs/recompute.h"
#include "tests/support/suite.h"
#include "widgets/view/tools/hand/limb_drag.h"
#include "widgets/view/tools/limb_pose.h"

namespace tst_limb_drag {

using namespace ramure;

/// Grab a twig: without OpenGL.
class TestLimbDrag : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnAnyWarning(); }
    void onlyBranchesOfFreeTreesCanBeGrabbed();
    void theGrabbedPlaceFollowsTheCursor();
    void aDragIsOneStep();
    void theWheelSetsHowManyFollow();
    void theTrunkStaysUnlessTheHandSaysSo();
    void givingUpLeavesNothing();
    void thePoseIsSeenAtOnce();
    void thePoseEndsWithItsMesh();
};

namespace {

struct Desk
{
    Document document;
    Recompute recompute{&document};
    NodeId tree = noNode;
    PickView view;

    Desk()
    {
        recompute.setRest(0);
        Node node;
        node.id = 1;
        node.kind = NodeKind::Tree;
        node.name = "tree";
        node.params = presetParams("SmallTree").value_or(NodeParams{});
        node.params.tree.translation = {1.0, 0.5, -2.0};
        node.params.tree.rotation = {0.0, 0.7, 0.0};
        tree = edit::insertNodes(document, {node}, noNode, 0).value_or(noNode);
        document.reset(document.scene(), {}); // no steps
        view.size = {800.0, 600.0};
        compute();
        Box box;
        for (const glm::dvec3& p : skeleton().p1)
            box.add(world(p));
        view.camera.frame(box, view.aspect());
    }
    void compute()
    {
        if (!recompute.waitForFull(test::patience(20000)))
            qWarning("no result");
    }
    [[nodiscard]] const Skeleton& skeleton() const
    {
        return document.result(tree)->tree.simplified->skeleton;
    }
    [[nodiscard]] glm::dvec3 world(const glm::dvec3& p) const
    {
        return glm::dvec3(worldMatrix(document.scene(), tree) * glm::dvec4(p, 1.0));
    }
    [[nodiscard]] glm::dvec2 pixel(const glm::dvec3& p) const
    {
        const auto ndc = view.camera.project(p, view.aspect());
        return 0.5 * glm::dvec2(ndc->x + 1.0, 1.0 - ndc->y) * view.size;
    }
    [[nodiscard]] Index twig() const { return skeleton().size() - 1; }
    /// The lowest end of a branch on a trunk that is too thick for it.
    [[nodiscard]] Index lowLimb() const
    {
        const Skeleton& all = skeleton();
        Index found = noIndex;
        for (Index b = 0; b < all.size(); ++b) {
            const std::size_t length = limbLength(all, b);
            if (length == 0 || length > 4 || all.parent[stays(b)] == noIndex)
                continue; // nothing but the root stays
            if (found == noIndex || all.p1[b].y < all.p1[found].y)
                found = b;
        }
        return found;
    }
    /// The first branch below the limb of \p branch.
    [[nodiscard]] Index stays(Index branch) const
    {
        const Skeleton& all = skeleton();
        const std::size_t length = limbLength(all, branch);
        for (std::size_t i = 0; i < length; ++i)
            branch = all.parent[branch];
        return branch;
    }
    [[nodiscard]] PickHit hit() const { return {tree, twig(), world(skeleton().p1[twig()])}; }
};

} // namespace

void TestLimbDrag::onlyBranchesOfFreeTreesCanBeGrabbed()
{
    Desk desk;
    QVERIFY(!LimbDrag::grab(desk.document, {}, 8));
    QVERIFY(!LimbDrag::grab(desk.document, {desk.tree, noIndex, {}}, 8));
    QVERIFY(!LimbDrag::grab(desk.document, {desk.tree, desk.skeleton().size(), {}}, 8));
    QVERIFY(LimbDrag::grab(desk.document, desk.hit(), 0));
    QVERIFY(edit::setNodeLocked(desk.document, {desk.tree}, true));
    QVERIFY(!LimbDrag::grab(desk.document, desk.hit(), 8));
    QVERIFY(edit::setNodeLocked(desk.document, {desk.tree}, false));
    QVERIFY(edit::setParam(desk.document, {desk.tree}, *findParam("turtle.theta"), 0.4));
    QVERIFY(!LimbDrag::grab(desk.document, desk.hit(), 8)); // another tree is on its way
    desk.compute();
    QVERIFY(LimbDrag::grab(desk.document, desk.hit(), 8));
}

void TestLimbDrag::theGrabbedPlaceFollowsTheCursor()
{
    Desk desk;
    const Index twig = desk.twig();
    const glm::dvec2 from = desk.pixel(desk.hit().point), to = from + glm::dvec2(18.0, -12.0);
    auto tool = LimbDrag::grab(desk.document, desk.hit(), 8);
    QVERIFY(tool);
    tool->setWhole(true);
    tool->dragTo(desk.view, to);
    QVERIFY(tool->shortBy() < 1e-4);
    QVERIFY(desk.document.isCurrent(desk.tree)); // nothing is made while the hand moves
    QVERIFY(tool->apply());
    desk.compute();
    const glm::dvec3 now = desk.world(desk.skeleton().p1[twig]);
    QVERIFY(glm::length(desk.pixel(now) - to) < 0.5);
    QVERIFY(glm::distance(now, tool->hand()) < 1e-4);
}

void TestLimbDrag::aDragIsOneStep()
{
    Desk desk;
    auto tool = LimbDrag::grab(desk.document, desk.hit(), 8);
    const glm::dvec2 from = desk.pixel(desk.hit().point);
    for (int i = 1; i <= 10; ++i) {
        tool->dragTo(desk.view, from + glm::dvec2(2.0 * i, i));
        QVERIFY(tool->apply());
        QVERIFY(!tool->apply());
    }
    tool->keep();
    QCOMPARE(desk.document.undoStack()->count(), 1);
    const Scene bent = desk.document.scene();
    desk.document.undo();
    QVERIFY(desk.document.scene().find(desk.tree)->params.edits.empty());
    desk.document.redo();
    QVERIFY(desk.document.scene() == bent);
    tool = nullptr;
    desk.compute();
    // Grabbed again and dragged back and forth: nothing is added.
    tool = LimbDrag::grab(desk.document, desk.hit(), 8);
    const glm::dvec2 again = desk.pixel(desk.hit().point);
    tool->dragTo(desk.view, again + glm::dvec2(10.0, 0.0));
    tool->dragTo(desk.view, again);
    tool->apply();
    tool = nullptr;
    desk.compute();
    QVERIFY(glm::distance(desk.pixel(desk.hit().point), again) < 0.5);
    const auto& steps = desk.document.scene().find(desk.tree)->params.edits;
    for (std::size_t i = std::as_const(bent).find(desk.tree)->params.edits.size(); i < steps.size(); ++i)
        QVERIFY(glm::length(steps[i].rotation) < 1e-5);
}

void TestLimbDrag::theWheelSetsHowManyFollow()
{
    Desk desk;
    auto tool = LimbDrag::grab(desk.document, desk.hit(), 3);
    QCOMPARE(tool->branches(), std::size_t(3));
    const glm::dvec2 from = desk.pixel(desk.hit().point);
    tool->dragTo(desk.view, from + glm::dvec2(10.0, 5.0));
    const auto turned = [&] {
        tool->apply();
        return desk.document.scene().find(desk.tree)->params.edits.size();
    };
    QCOMPARE(turned(), std::size_t(3));
    tool->setBranches(2);
    QCOMPARE(turned(), std::size_t(2));
    tool->setBranches(4);
    QCOMPARE(turned(), std::size_t(4));
    tool->setBranches(1000);
    QVERIFY(tool->branches() <= LimbDrag::mostBranches);
    tool = nullptr;
    QCOMPARE(desk.document.undoStack()->count(), 1);
}

void TestLimbDrag::theTrunkStaysUnlessTheHandSaysSo()
{
    Desk desk;
    const Skeleton& tree = desk.skeleton();
    const Index limb = desk.lowLimb();
    QVERIFY(limb != noIndex);
    const Index trunk = desk.stays(limb);
    QVERIFY(tree.a0[trunk] > tree.a0[limb]);
    const glm::dvec3 end = desk.world(tree.p1[limb]);
    auto tool = LimbDrag::grab(desk.document, {desk.tree, limb, end}, 8);
    const std::size_t light = tool->branches();
    tool->dragTo(desk.view, desk.pixel(end) + glm::dvec2(300.0, 100.0)); // beyond its reach
    QVERIFY(tool->shortBy() > 0.1);
    const std::vector<glm::dvec3> bends = tool->bends();
    for (Index b = trunk; b != noIndex; b = tree.parent[b])
        QCOMPARE(bends[b], glm::dvec3(0.0));
    QVERIFY(bends[limb] != glm::dvec3(0.0));
    tool->setWhole(true);
    QVERIFY(tool->branches() > light);
    QVERIFY(tool->bends()[trunk] != glm::dvec3(0.0));
    tool->setWhole(false);
    QVERIFY(tool->bends() == bends);
    tool->setBranches(light + 1);
    QCOMPARE(tool->branches(), light + 1);
    // The root alone: nothing follows without a word.
    tool = LimbDrag::grab(desk.document, {desk.tree, 0, desk.world(tree.p1[0])}, 8);
    QCOMPARE(tool->branches(), std::size_t(0));
    tool->setWhole(true);
    QCOMPARE(tool->branches(), std::size_t(1));
}

void TestLimbDrag::givingUpLeavesNothing()
{
    Desk desk;
    const Scene before = desk.document.scene();
    auto tool = LimbDrag::grab(desk.document, desk.hit(), 8);
    QVERIFY(!tool->apply()); // a click
    tool->dragTo(desk.view, desk.pixel(desk.hit().point) + glm::dvec2(20.0, 5.0));
    QVERIFY(tool->apply());
    QVERIFY(!(desk.document.scene() == before));
    tool->cancel();
    tool = nullptr;
    QVERIFY(desk.document.scene() == before);
    QCOMPARE(desk.document.undoStack()->count(), 0);
}

void TestLimbDrag::thePoseIsSeenAtOnce()
{
    Desk desk;
    const Index twig = desk.twig();
    auto tool = LimbDrag::grab(desk.document, desk.hit(), 8);
    LimbPose pose(desk.tree, tool->skeleton(), tool->bendsAtGrab());
    QVERIFY(pose.isRest());
    tool->setWhole(true);
    tool->dragTo(desk.view, desk.pixel(desk.hit().point) + glm::dvec2(18.0, -12.0));
    pose.setBends(tool->bends());
    QVERIFY(!pose.isRest());
    const auto motion = pose.motion(nullptr);
    QCOMPARE(pose.motion(nullptr), motion);
    QVERIFY(motion->of(desk.tree)->moves());
    const RigidTransform& bone = (*motion->of(desk.tree)->bones)[twig];
    const glm::dvec3 seen = bone.point(tool->skeleton()->skeleton.p1[twig]);
    QVERIFY(glm::distance(desk.world(seen), tool->hand()) < 1e-4);
    QVERIFY(tool->apply());
    desk.compute();
    QVERIFY(glm::distance(desk.skeleton().p1[twig], seen) < 1e-9);
}

void TestLimbDrag::thePoseEndsWithItsMesh()
{
    Desk desk;
    const Index twig = desk.twig();
    auto tool = LimbDrag::grab(desk.document, desk.hit(), 8);
    LimbPose pose(desk.tree, tool->skeleton(), tool->bendsAtGrab());
    const glm::dvec2 from = desk.pixel(desk.hit().point);
    tool->setWhole(true);
    tool->dragTo(desk.view, from + glm::dvec2(18.0, -12.0));
    pose.setBends(tool->bends());
    QVERIFY(tool->apply());
    pose.noteEdit(desk.document.revision(), tool->bends());
    desk.compute();
    pose.noteWish(5, desk.document.result(desk.tree)->revision);
    QVERIFY(!pose.isRest()); // the scene of before is still seen
    pose.noteShown(4);
    QVERIFY(!pose.isRest());
    pose.noteShown(5);
    QVERIFY(pose.isRest());
    // The hand goes on: from the new mesh.
    tool->dragTo(desk.view, from + glm::dvec2(-10.0, 4.0));
    pose.setBends(tool->bends());
    const auto motion = pose.motion(nullptr);
    const glm::dvec3 seen = (*motion->of(desk.tree)->bones)[twig].point(desk.skeleton().p1[twig]);
    QVERIFY(glm::distance(desk.world(seen), tool->hand()) < 1e-4);
}

RAMURE_SUITE(TestLimbDrag)

} // namespace tst_limb_drag

#include "tst_limb_drag.moc"
