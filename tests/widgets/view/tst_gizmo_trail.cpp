#include "core/rig/arm/arm_chain.h"
#include "core/scene/demo_scenes.h"
#include "core/scene/world_transforms.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/view/gizmo_trail.h"
#include "widgets/view/tools/typed_number.h"
#include <QSignalSpy>

namespace tst_gizmo_trail {

using namespace ramure;

namespace {

Scene cylinder()
{
    return demoScene("MovingCylinder").value_or(Scene());
}

NodeId movingIn(const Scene& scene)
{
    for (const Node& node : scene.nodes())
        if (node.animation.movesNode())
            return node.id;
    return noNode;
}

const GizmoTrail::TreeOf noTrees = [](NodeId) { return static_cast<const TreeResult*>(nullptr); };

/// A scene to draw with one mesh for the node.
RenderScene drawn(NodeId node)
{
    RenderScene scene;
    MeshItem item;
    item.mesh = std::make_shared<const TriangleMesh>();
    item.node = node;
    scene.meshes.push_back(item);
    return scene;
}

} // namespace

/// Settings of the tools, typed numbers, paths and ghosts: without OpenGL.
class TestGizmoTrail : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnAnyWarning(); }
    void settingsRefuseNonsense();
    void settingsGoRound();
    void numbersAreTyped_data();
    void numbersAreTyped();
    void nothingMovesAndNothingIsShown();
    void pathsComeFromTheBackground();
    void onlyChangesAreComputed();
    void longPathsDoNotBlock();
    void ghostsStandWhereTheNodesWere();
    void armsHaveGhostsToo();
    void ghostsHaveAnEnd();
};

void TestGizmoTrail::settingsRefuseNonsense()
{
    GizmoSettings settings;
    settings.setSteps({0.0, -5.0, std::numeric_limits<double>::quiet_NaN()});
    QCOMPARE(settings.steps(), SnapSteps{});
    settings.setGhostFrames({-3, 1000, 0});
    QCOMPARE(settings.ghostFrames(), (GhostFrames{0, GizmoSettings::mostGhosts, 1}));
    settings.restore(
        {{QStringLiteral("ghostStep"), -7}, {QStringLiteral("moveStep"), QStringLiteral("many")}});
    QCOMPARE(settings.ghostFrames().step, 1);
    QCOMPARE(settings.steps(), SnapSteps{});
}

void TestGizmoTrail::settingsGoRound()
{
    GizmoSettings one, other;
    QSignalSpy changed(&one, &GizmoSettings::changed);
    one.space.set(TransformSpace::Parent);
    one.snaps.set(true);
    one.setSteps({0.25, 15.0, 0.5});
    one.showsPath.set(true);
    one.showsGhosts.set(true);
    one.setGhostFrames({1, 2, 7});
    one.space.set(TransformSpace::Parent); // as it is: silent
    QCOMPARE(changed.count(), 6);
    one.tool.set(TransformTool::Scale);
    other.restore(one.saved());
    QCOMPARE(other.saved(), one.saved());
    QCOMPARE(other.ghostFrames(), (GhostFrames{1, 2, 7}));
    // A new document keeps the sizes of steps and ghosts and forgets what was switched on.
    one.beginDocument();
    for (const GizmoSettings* each : {&one, &other}) {
        QCOMPARE(each->tool(), TransformTool::Select);
        QCOMPARE(each->space(), TransformSpace::World);
        QVERIFY(!each->snaps() && !each->showsPath() && !each->showsGhosts());
        QCOMPARE(each->steps(), (SnapSteps{0.25, 15.0, 0.5}));
    }
}

void TestGizmoTrail::numbersAreTyped_data()
{
    QTest::addColumn<QString>("keys"); // b: Backspace
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("value"); // -99: none
    QTest::newRow("nothing") << QString() << QString() << -99.0;
    QTest::newRow("sign") << QStringLiteral("-") << QString(QChar(0x2212)) << -99.0;
    QTest::newRow("point") << QStringLiteral(".") << QStringLiteral(".") << -99.0;
    QTest::newRow("whole") << QStringLiteral("90") << QStringLiteral("90") << 90.0;
    QTest::newRow("comma") << QStringLiteral("1,5") << QStringLiteral("1.5") << 1.5;
    QTest::newRow("two points") << QStringLiteral("1.2.5") << QStringLiteral("1.25") << 1.25;
    QTest::newRow("sign behind") << QStringLiteral("90-") << QString(QChar(0x2212)) + QStringLiteral("90")
                                 << -90.0;
    QTest::newRow("sign twice") << QStringLiteral("-9-0") << QStringLiteral("90") << 90.0;
    QTest::newRow("begins with a point") << QStringLiteral(".5") << QStringLiteral(".5") << 0.5;
    QTest::newRow("erased") << QStringLiteral("-12bb") << QString(QChar(0x2212)) << -99.0;
    QTest::newRow("all erased") << QStringLiteral("-12bbbb") << QString() << -99.0;
    QTest::newRow("letters") << QStringLiteral("1e5") << QStringLiteral("15") << 15.0;
    QTest::newRow("long") << QStringLiteral("12345678901234567890") << QStringLiteral("1234567890123456")
                          << 1234567890123456.0;
}

void TestGizmoTrail::numbersAreTyped()
{
    QFETCH(QString, keys);
    QFETCH(QString, text);
    QFETCH(double, value);
    TypedNumber number;
    for (const QChar key : keys)
        if (key == u'b')
            number.erase();
        else
            QCOMPARE(number.type(key), key != u'e');
    QCOMPARE(number.text(), text);
    QCOMPARE(number.value().value_or(-99.0), value);
    QCOMPARE(number.isEmpty(), text.isEmpty());
}

void TestGizmoTrail::nothingMovesAndNothingIsShown()
{
    GizmoTrail trail;
    GizmoSettings how;
    how.showsPath.set(true);
    how.showsGhosts.set(true);
    Node still;
    still.id = 1;
    const Scene scene = *Scene::fromNodes({still});
    trail.show(scene, {1, 99}, how, 10, true);
    QVERIFY(trail.isEmpty() && !trail.isBusy());
    RenderScene shown = drawn(1);
    trail.addTo(shown, noTrees);
    QVERIFY(shown.ghosts.empty() && shown.lines.empty() && shown.trailBox.empty());
}

void TestGizmoTrail::pathsComeFromTheBackground()
{
    GizmoTrail trail;
    GizmoSettings how;
    how.showsPath.set(true);
    const Scene scene = cylinder();
    const NodeId node = movingIn(scene);
    trail.show(scene, {node}, how, 0, true);
    QVERIFY(trail.isBusy());
    QTRY_VERIFY(!trail.isBusy());
    QCOMPARE(trail.paths().size(), std::size_t(1));
    const TimelineSettings& timeline = scene.timeline();
    QCOMPARE(std::int64_t(trail.paths()[0]->points.size()), timeline.lastFrame - timeline.firstFrame + 1);
    RenderScene shown;
    trail.addTo(shown, noTrees);
    QCOMPARE(shown.lines.size(), std::size_t(1));
    QCOMPARE(shown.points.size(), std::size_t(1));
    QVERIFY(shown.box.empty()); // is not framed
    trail.show(scene, {}, how, 0, true);
    QVERIFY(trail.isEmpty());
}

void TestGizmoTrail::onlyChangesAreComputed()
{
    GizmoTrail trail;
    GizmoSettings how;
    how.showsPath.set(true);
    Scene scene = cylinder();
    const NodeId node = movingIn(scene);
    trail.show(scene, {node}, how, 0, true);
    QTRY_VERIFY(!trail.isBusy());
    const quint64 revision = trail.revision();
    for (int frame = 0; frame < 20; ++frame) // the playhead changes no path
        trail.show(scene, {node}, how, frame, true);
    QCOMPARE(trail.revision(), revision);
    QVERIFY(!trail.isBusy());
    scene.find(node)->params.tree.translation.y += 1.0;
    trail.show(scene, {node}, how, 0, true);
    QVERIFY(trail.isBusy());
    QVERIFY(!trail.isEmpty()); // the one before stays until then
    QTRY_VERIFY(!trail.isBusy());
    QVERIFY(trail.revision() > revision);
}

void TestGizmoTrail::longPathsDoNotBlock()
{
    auto trail = std::make_unique<GizmoTrail>();
    GizmoSettings how;
    how.showsPath.set(true);
    Scene scene = cylinder();
    TimelineSettings timeline = scene.timeline();
    timeline.lastFrame = 150'000;
    scene.setTimeline(timeline);
    const NodeId node = movingIn(scene);
    for (int i = 0; i < 50; ++i) { // every wish is taken at once, the older ones are given up
        scene.find(node)->params.tree.translation.x = i;
        trail->show(scene, {node}, how, 0, true);
        QVERIFY(trail->isBusy());
    }
    QVERIFY(trail->paths().empty());
    QTRY_VERIFY_WITH_TIMEOUT(!trail->isBusy(), test::patience(20'000));
    QCOMPARE(trail->paths().front()->points.size(), std::size_t(150'001));
    trail->show(scene, {}, how, 0, true);
    trail->show(scene, {node}, how, 0, true);
    trail.reset(); // while it computes
}

void TestGizmoTrail::ghostsStandWhereTheNodesWere()
{
    GizmoTrail trail;
    GizmoSettings how;
    how.showsGhosts.set(true);
    how.setGhostFrames({2, 3, 4});
    const Scene scene = cylinder();
    const NodeId node = movingIn(scene);
    trail.show(scene, {node}, how, 20, true);
    QCOMPARE(trail.ghostCount(), std::size_t(5));
    RenderScene shown = drawn(node);
    trail.addTo(shown, noTrees);
    QCOMPARE(shown.ghosts.size(), std::size_t(5));
    for (const GhostItem& ghost : shown.ghosts) {
        bool found = false;
        for (const std::int64_t frame : {12, 16, 24, 28, 32}) {
            const glm::dmat4 place = worldTransformAt(scene, node, scene.timeline().timeOf(frame)).geometry;
            found = found ||
                    glm::distance(ghost.world[3], place[3]) + glm::distance(ghost.world[0], place[0]) < 1e-9;
        }
        QVERIFY(found);
        QVERIFY(ghost.colour.a > 0 && ghost.colour.a < 255);
    }
    // Colder before, warmer behind.
    QVERIFY(shown.ghosts.front().colour.r != shown.ghosts.back().colour.r);
    trail.show(scene, {node}, how, 0, true); // nothing before the first frame
    QCOMPARE(trail.ghostCount(), std::size_t(3));
    trail.show(scene, {node}, how, 20, false); // it plays
    QCOMPARE(trail.ghostCount(), std::size_t(0));
}

/// Their segments stand as the joints are by then, keyed or turned towards a target.
void TestGizmoTrail::armsHaveGhostsToo()
{
    Scene scene = *demoScene("Arm");
    NodeId arm = noNode;
    for (const Node& node : scene.nodes())
        if (node.kind == NodeKind::Arm)
            arm = node.id;
    QVERIFY(arm != noNode);
    GizmoSettings how;
    how.showsGhosts.set(true);
    how.setGhostFrames({0, 3, 10});
    for (const bool follows : {false, true}) {
        Node& node = *scene.find(arm);
        node.animation = {};
        node.params.arm.follows = follows;
        if (!follows) {
            Key from, to;
            from.mode = to.mode = KeyMode::Linear;
            from.value = 0.2;
            to.value = 0.8;
            to.time = 4 * ticksPerSecond;
            node.animation.set(jointChannels(1).front(), AnyTrack(*Track::fromKeys({from, to})));
        }
        GizmoTrail trail;
        trail.show(scene, {arm}, how, 0, true);
        QTRY_VERIFY_WITH_TIMEOUT(!trail.isBusy(), test::patience(20'000));
        Evaluator arms;
        const auto now = arms.joints(node, 0.0);
        QVERIFY(now);
        RenderScene shown;
        trail.addTo(shown, noTrees);
        QCOMPARE(shown.lines.size(), trail.ghostCount());
        QVERIFY(shown.ghosts.empty());
        std::size_t expected = 0, drawnLines = 0;
        for (const int place : {3, 2, 1}) { // the furthest away first
            const double seconds = scene.timeline().timeOf(place * 10);
            const auto joints = arms.joints(node, seconds);
            QVERIFY(joints);
            if (*joints == *now)
                continue;
            ++expected;
            const ArmChain chain(*joints);
            const LineItem& line = shown.lines[drawnLines++];
            QCOMPARE(line.lines->segments.size(), joints->size());
            const glm::dmat4 upright = worldTransformAt(scene, arm, seconds).geometry * armUpright();
            QVERIFY(glm::distance(
                        glm::dvec3(line.world * glm::dvec4(glm::dvec3(line.lines->segments.back().b), 1.0)),
                        glm::dvec3(upright * glm::dvec4(chain.tip(), 1.0))) < 1e-4);
        }
        QCOMPARE(trail.ghostCount(), expected);
        QVERIFY(expected == 3 || follows);
        QVERIFY(expected > 0);
        trail.show(scene, {arm}, how, 0, false); // it plays
        QCOMPARE(trail.ghostCount(), std::size_t(0));
        trail.show(scene, {arm}, how, 0, true);
        trail.show(scene, {}, how, 0, true); // while they are computed
        QCOMPARE(trail.ghostCount(), std::size_t(0));
    }
}

void TestGizmoTrail::ghostsHaveAnEnd()
{
    GizmoTrail trail;
    GizmoSettings how;
    how.showsGhosts.set(true);
    how.setGhostFrames({20, 20, 1});
    const Scene scene = demoScene("MovingTree").value_or(Scene());
    QVERIFY(scene.nodes().size() > 1000);
    trail.show(scene, {scene.nodes().front().id}, how, 60, true);
    QVERIFY(trail.ghostCount() > 500);
    QVERIFY(trail.ghostCount() <= GizmoTrail::mostCopies);
}

RAMURE_SUITE(TestGizmoTrail)

} // namespace tst_gizmo_trail

#include "tst_gizmo_trail.moc"
