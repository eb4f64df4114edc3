#include "core/document/recompute.h"
#include "core/params/presets.h"
#include "tests/support/suite.h"
#include "widgets/viewport/limb_tool.h"

using namespace ramure;

/// Grab a twig: without OpenGL.
class TestLimbTool : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnAnyWarning(); }
    void onlyBranchesOfFreeTreesCanBeGrabbed();
    void theGrabbedPlaceFollowsTheCursor();
    void aDragIsOneStep();
    void theWheelSetsHowManyFollow();
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
        document.undoStack()->clear();
        view.size = {800.0, 600.0};
        compute();
        Box box;
        for (const glm::dvec3& p : skeleton().p1)
            box.add(world(p));
        view.camera.frame(box, view.aspect());
    }
    void compute()
    {
        if (!recompute.waitForFull(20000))
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
    [[nodiscard]] PickHit hit() const { return {tree, twig(), world(skeleton().p1[twig()])}; }
};

} // namespace

void TestLimbTool::onlyBranchesOfFreeTreesCanBeGrabbed()
{
    Desk desk;
    QVERIFY(!LimbTool::grab(desk.document, {}, 8));
    QVERIFY(!LimbTool::grab(desk.document, {desk.tree, noIndex, {}}, 8));
    QVERIFY(!LimbTool::grab(desk.document, {desk.tree, desk.skeleton().size(), {}}, 8));
    QVERIFY(LimbTool::grab(desk.document, desk.hit(), 0));
    QVERIFY(edit::setNodeLocked(desk.document, {desk.tree}, true));
    QVERIFY(!LimbTool::grab(desk.document, desk.hit(), 8));
    QVERIFY(edit::setNodeLocked(desk.document, {desk.tree}, false));
    QVERIFY(edit::setParam(desk.document, {desk.tree}, *findParam("turtle.theta"), 0.4));
    QVERIFY(!LimbTool::grab(desk.document, desk.hit(), 8)); // another tree is on its way
    desk.compute();
    QVERIFY(LimbTool::grab(desk.document, desk.hit(), 8));
}

void TestLimbTool::theGrabbedPlaceFollowsTheCursor()
{
    Desk desk;
    const Index twig = desk.twig();
    const glm::dvec2 from = desk.pixel(desk.hit().point), to = from + glm::dvec2(18.0, -12.0);
    auto tool = LimbTool::grab(desk.document, desk.hit(), 8);
    QVERIFY(tool);
    tool->dragTo(desk.view, to);
    QVERIFY(tool->shortBy() < 1e-4);
    desk.compute();
    const glm::dvec3 now = desk.world(desk.skeleton().p1[twig]);
    QVERIFY(glm::length(desk.pixel(now) - to) < 0.5);
    QVERIFY(glm::distance(now, tool->hand()) < 1e-4);
}

void TestLimbTool::aDragIsOneStep()
{
    Desk desk;
    auto tool = LimbTool::grab(desk.document, desk.hit(), 8);
    const glm::dvec2 from = desk.pixel(desk.hit().point);
    for (int i = 1; i <= 10; ++i)
        tool->dragTo(desk.view, from + glm::dvec2(2.0 * i, i));
    QCOMPARE(desk.document.undoStack()->count(), 1);
    const Scene bent = desk.document.scene();
    desk.document.undoStack()->undo();
    QVERIFY(desk.document.scene().find(desk.tree)->params.branches.empty());
    desk.document.undoStack()->redo();
    QVERIFY(desk.document.scene() == bent);
    tool = nullptr;
    desk.compute();
    // Grabbed again and dragged back and forth: the bends that were there are those at the start.
    tool = LimbTool::grab(desk.document, desk.hit(), 8);
    const glm::dvec2 again = desk.pixel(desk.hit().point);
    tool->dragTo(desk.view, again + glm::dvec2(10.0, 0.0));
    tool->dragTo(desk.view, again);
    for (const auto& [key, branch] : bent.find(desk.tree)->params.branches)
        QVERIFY(glm::distance(desk.document.scene().find(desk.tree)->params.branches.at(key).bendRad,
                              branch.bendRad) < 1e-5);
}

void TestLimbTool::theWheelSetsHowManyFollow()
{
    Desk desk;
    auto tool = LimbTool::grab(desk.document, desk.hit(), 3);
    QCOMPARE(tool->branches(), std::size_t(3));
    const glm::dvec2 from = desk.pixel(desk.hit().point);
    tool->dragTo(desk.view, from + glm::dvec2(10.0, 5.0));
    const auto turned = [&] { return desk.document.scene().find(desk.tree)->params.branches.size(); };
    QCOMPARE(turned(), std::size_t(3));
    tool->setBranches(2);
    QCOMPARE(turned(), std::size_t(2));
    tool->setBranches(4);
    QCOMPARE(turned(), std::size_t(4));
    tool->setBranches(1000);
    QVERIFY(tool->branches() <= LimbTool::mostBranches);
}

QTEST_MAIN(TestLimbTool)
#include "tst_limb_tool.moc"
