#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/qt/session/arm/arm_reach.h"
#include "core/qt/session/motion/auto_key.h"
#include "core/qt/session/motion/player.h"
#include "core/scene/arm_demo.h"
#include "tests/support/suite.h"
#include "tests/support/view_window.h"
#include "widgets/base/theme/theme.h"
#include "widgets/view/tools/arm/arm_rings.h"
#include <algorithm>
#include <cstdlib>

namespace tst_arm_viewport {

using namespace ramure;
using test::differing;

/// The arm in a real window. With RAMURE_PICTURES set to a folder, its pictures are left there.
class TestArmViewport : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnAnyWarning(); }
    void theArmIsSeen();
    void controlClickSetsTheTarget();
    void draggingMovesTheTarget();
    void aPlayedArmFollows();
    void ringsTurnJoints();
    void skinsDiffer();
    void limitsAreSeen();
    void aLimbFollowsTheHand();
    void autoKeyFramesTheView();
};

namespace {

struct Window : test::ViewWindow
{
    Window()
    {
        document.reset(armDemo(), {});
        show({800, 600});
    }
    [[nodiscard]] const NodeParams& arm() const { return document.scene().find(1)->params; }
    void move(QPoint to, Qt::KeyboardModifiers modifiers) const
    {
        ViewWindow::move(to, Qt::LeftButton, modifiers);
    }
};

} // namespace

void TestArmViewport::theArmIsSeen()
{
    Window window;
    const QImage with = window.view->grabFramebuffer();
    window.keep("arm-rest");
    QVERIFY(edit::setNodeVisible(window.document, {1}, false));
    window.waitForPicture();
    QVERIFY(differing(with, window.view->grabFramebuffer()) > 4000);
}

/// Red at all edges while every edit becomes a key.
void TestArmViewport::autoKeyFramesTheView()
{
    Window window;
    Player player(&window.document);
    AutoKey keys(&window.document, &player);
    window.view->setKeys(&keys);
    const auto isRed = [&](const QImage& picture) {
        const QColor red = errorColour(window.view->palette());
        const QPoint edges[] = {{400, 1}, {400, picture.height() - 2}, {1, 300}, {picture.width() - 2, 300}};
        return std::ranges::all_of(edges, [&](QPoint at) {
            const QColor there = picture.pixelColor(at);
            return std::abs(there.red() - red.red()) + std::abs(there.green() - red.green()) +
                       std::abs(there.blue() - red.blue()) <
                   30;
        });
    };
    QVERIFY(!isRed(window.view->grabFramebuffer()));
    keys.setOn(true);
    window.waitForPicture();
    window.keep("auto-key");
    QVERIFY(isRed(window.view->grabFramebuffer()));
    keys.setOn(false);
    QVERIFY(!isRed(window.view->grabFramebuffer()));
}

void TestArmViewport::controlClickSetsTheTarget()
{
    Window window;
    const QPoint at = window.pixelOf({2.0, 0.3, 2.0});
    QTest::mouseClick(window.view, Qt::LeftButton, Qt::ControlModifier, at);
    const ArmProgress* progress = window.view->armReach()->progress();
    QVERIFY(progress && progress->moves);
    // The target lies under the cursor: upright, Y of the world is Z of the arm.
    const glm::dvec3 target = window.arm().arm.target;
    QVERIFY((window.pixelOf({target.x, target.z, -target.y}) - at).manhattanLength() <= 3);
    for (int i = 0; i < 30; ++i)
        window.view->armReach()->step();
    window.waitForPicture();
    window.keep("arm-on-its-way");
    window.view->armReach()->finish();
    window.waitForPicture();
    window.keep("arm-reached");
    QVERIFY(window.view->armReach()->progress()->figures.status != ArmStatus::Moving);
}

void TestArmViewport::draggingMovesTheTarget()
{
    Window window;
    const QPoint from = window.pixelOf({2.0, 0.3, 2.0});
    QTest::mousePress(window.view, Qt::LeftButton, Qt::ControlModifier, from);
    const glm::dvec3 first = window.arm().arm.target;
    for (int i = 1; i <= 5; ++i)
        window.move(from + QPoint(-12 * i, 0), Qt::ControlModifier);
    QTest::mouseRelease(window.view, Qt::LeftButton, Qt::ControlModifier, from + QPoint(-60, 0));
    QVERIFY(glm::distance(window.arm().arm.target, first) > 0.2);
    QCOMPARE(window.document.undoStack()->index(), 1);
    window.view->armReach()->finish();
    QCOMPARE(window.document.undoStack()->index(), 1);
}

void TestArmViewport::aPlayedArmFollows()
{
    Window window;
    Player player(&window.document);
    window.view->setPlayer(&player);
    const QImage rest = window.view->grabFramebuffer();
    player.seek(30);
    QVERIFY(player.waitForIdle(20000));
    const NodeMotion* motion = player.motion()->of(1);
    QVERIFY(motion && motion->moves() && motion->arm);
    QVERIFY(motion->arm->residual <
            glm::distance(ArmChain(window.arm().joints).tip(), window.arm().arm.target));
    window.waitForPicture();
    QVERIFY(differing(rest, window.view->grabFramebuffer()) > 1000);
    const auto angles = motion->arm->angles;
    player.seek(90);
    QVERIFY(player.waitForIdle(20000));
    player.seek(30);
    QVERIFY(player.waitForIdle(20000));
    QCOMPARE(player.motion()->of(1)->arm->angles, angles);
}

void TestArmViewport::ringsTurnJoints()
{
    Window window;
    Selection selection;
    selection.nodes = {1};
    window.document.setSelection(selection);
    window.waitForPicture();
    window.keep("arm-rings");
    Camera above = window.view->camera();
    above.pitchRad = 0.7; // the ring lies flat: seen from its edge, a pixel is a large angle
    window.view->setCamera(above);
    window.waitForPicture();
    const auto rings = armRings(window.document.scene(), 1);
    const ArmRing& ring = rings[0]; // phi of the first joint, which lies flat
    const QPoint from = window.pixelOf(ring.at(ring.angle.angleRad));
    const QPoint to = window.pixelOf(ring.at(ring.angle.angleRad + 0.5));
    QTest::mousePress(window.view, Qt::LeftButton, Qt::NoModifier, from);
    window.move((from + to) / 2, Qt::NoModifier);
    window.move(to, Qt::NoModifier);
    QTest::mouseRelease(window.view, Qt::LeftButton, Qt::NoModifier, to);
    QCOMPARE(window.document.undoStack()->index(), 1);
    QVERIFY(std::abs(window.arm().joints[0].phi.angleRad - (ring.angle.angleRad + 0.5)) < 0.1);
}

void TestArmViewport::skinsDiffer()
{
    Window window;
    std::vector<ArmJoint> joints = window.arm().joints;
    joints[1].theta.angleRad = 2.0;
    QVERIFY(edit::setJoints(window.document, 1, joints, QStringLiteral("x")));
    std::vector<QImage> pictures;
    for (const char* method : {"rigid", "linear", "dualQuaternion"}) {
        QVERIFY(edit::setParam(window.document, {1}, *findParam("skin.method"), EnumValue{method}));
        window.waitForPicture();
        window.keep((std::string("arm-skin-") + method).c_str());
        pictures.push_back(window.view->grabFramebuffer());
    }
    QVERIFY(differing(pictures[0], pictures[1]) > 100);
    QVERIFY(differing(pictures[1], pictures[2]) > 100);
    QVERIFY(edit::setParam(window.document, {1}, *findParam("armSkin.weights"), true));
    window.waitForPicture();
    window.keep("arm-weights");
    QVERIFY(differing(pictures[2], window.view->grabFramebuffer()) > 1000);
    QVERIFY(edit::setParam(window.document, {1}, *findParam("armSkin.shown"), false));
    window.waitForPicture();
    window.keep("arm-joints");
    QVERIFY(differing(pictures[2], window.view->grabFramebuffer()) > 1000);
}

/// Driven against its limits: the text names them, the knobs of its rings change.
void TestArmViewport::limitsAreSeen()
{
    Window window;
    std::vector<ArmJoint> joints = window.arm().joints;
    for (ArmJoint& joint : joints)
        joint.theta = {0.3, true, -0.7, 0.7, 0.0};
    QVERIFY(edit::setJoints(window.document, 1, joints, QStringLiteral("x")));
    QVERIFY(window.view->armReach()->reachFor(1, {1.5, 0.0, -0.5}, 0));
    window.view->armReach()->finish();
    const ArmProgress* progress = window.view->armReach()->progress();
    QVERIFY(progress->figures.status == ArmStatus::Settled);
    QVERIFY(std::ranges::count(progress->limits, ArmLimit::Upper) +
                std::ranges::count(progress->limits, ArmLimit::Lower) >
            0);
    Selection selection;
    selection.nodes = {1};
    window.document.setSelection(selection);
    window.waitForPicture();
    window.keep("arm-at-a-limit");
}

/// At rest a limb is bent, one step of undo; while it plays it is pulled, and the document stays as it is.
void TestArmViewport::aLimbFollowsTheHand()
{
    test::ViewWindow window;
    Player player(&window.document);
    window.view->setPlayer(&player);
    Scene scene;
    Node tree;
    tree.id = scene.newId();
    tree.kind = NodeKind::Tree;
    tree.name = "SmallTree";
    // Its parameters are the table's: bark without a picture, and nothing large hangs in front of limbs.
    QVERIFY(scene.insert({tree}, noNode, 0));
    window.document.reset(std::move(scene), {});
    TreePipeline pipeline;
    const auto compute = [&] {
        NodeResult result;
        result.revision = window.document.revision();
        result.tree = *pipeline.evaluate(window.document.scene().find(tree.id)->params);
        window.document.setResult(tree.id, std::move(result));
    };
    compute();
    window.show({800, 600});
    window.keep("limb-at-rest");
    const Skeleton& skeleton = window.document.result(tree.id)->tree.simplified->skeleton;
    Index thick = 0; // well seen: the highest of the thicker branches
    for (Index b = 0; b < skeleton.size(); ++b)
        if (skeleton.a0[b] > 0.05 && skeleton.p1[b].y > skeleton.p1[thick].y)
            thick = b;
    const QPoint from = window.pixelOf(0.5 * (skeleton.p0[thick] + skeleton.p1[thick]));
    const auto drag = [&](const char* name) {
        QTest::mousePress(window.view, Qt::LeftButton, Qt::ControlModifier, from);
        for (int i = 1; i <= 6; ++i)
            window.move(from + QPoint(18 * i, 8 * i), Qt::LeftButton, Qt::ControlModifier);
        if (!player.isPlaying())
            compute();
        window.waitForPicture();
        window.keep(name);
        QTest::mouseRelease(window.view, Qt::LeftButton, Qt::ControlModifier, from + QPoint(108, 48));
    };
    // A click waits for the structure to pick in; a limb is grabbed only where that is ready.
    QTest::mouseClick(window.view, Qt::LeftButton, Qt::NoModifier, from);
    QTRY_VERIFY_WITH_TIMEOUT(!window.view->work().pick, test::patience(20'000));
    QTRY_VERIFY(!window.view->work().settling);
    window.waitForPicture();
    QTRY_VERIFY_WITH_TIMEOUT(!window.view->work().pick, test::patience(20'000));
    drag("limb-grabbed");
    QCOMPARE(window.document.undoStack()->count(), 1);
    QVERIFY(!window.document.scene().find(tree.id)->params.edits.empty());
    window.document.undo();
    compute();
    player.setPace(PlayPace::EveryFrame);
    player.play();
    QTRY_VERIFY_WITH_TIMEOUT(player.frame() > 5 && player.motion()->of(tree.id), test::patience(20'000));
    window.waitForPicture();
    const std::vector<Index> selected = window.document.selection().branches;
    drag("limb-while-playing");
    QCOMPARE(window.document.selection().branches, selected); // no box was drawn
    player.pause();
    QVERIFY(player.waitForIdle(20'000));
    QCOMPARE(window.document.undoStack()->index(), 0);
}

RAMURE_SUITE(TestArmViewport)

} // namespace tst_arm_viewport

#include "tst_arm_viewport.moc"
