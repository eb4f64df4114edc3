#include "core/document/arm_reach.h"
#include "core/document/player.h"
#include "core/scene/arm_demo.h"
#include "tests/support/suite.h"
#include "tests/support/view_window.h"
#include "widgets/viewport/arm_rings.h"

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

QTEST_MAIN(TestArmViewport)
#include "tst_arm_viewport.moc"
