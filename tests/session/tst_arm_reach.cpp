#include "core/math/random.h"
#include "core/qt/session/arm/arm_reach.h"
#include "core/qt/session/motion/auto_key.h"
#include "core/qt/session/motion/player.h"
#include "core/rig/arm/arm_driver.h"
#include "core/scene/arm_demo.h"
#include "tests/support/suite.h"
#include <QSignalSpy>
#include <glm/geometric.hpp>
#include <limits>

namespace tst_arm_reach {

using namespace ramure;

/// An arm on its way while nothing plays.
class TestArmReach : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnAnyWarning(); }
    void badTargetsAreErrors();
    void theWayEndsInOneStep();
    void canBeGoneThroughStepByStep();
    void runsByItself();
    void aMovedTargetIsFollowed();
    void otherEditsEndIt();
    void anArmThatArrivesWaitsForTheHand();
    void outOfReachIsTold();
    void aimingAsksTheTimeline();
    void aKeyedTargetIsReachedToo();
    void whatIsToldIsOfTheArmThatIsShown();
};

namespace {

struct Desk
{
    Document document;
    ArmReach reach{&document};

    Desk() { document.reset(armDemo(), {}); }
    [[nodiscard]] const NodeParams& params() const { return document.scene().find(1)->params; }
    [[nodiscard]] glm::dvec3 tip() const { return ArmChain(params().joints).tip(); }
};

} // namespace

void TestArmReach::badTargetsAreErrors()
{
    Desk desk;
    QVERIFY(!desk.reach.reachFor(99, {1.0, 1.0, 1.0}, 0));
    QVERIFY(!desk.reach.reachFor(2, {1.0, 1.0, 1.0}, 0)); // a terrain
    QVERIFY(!desk.reach.reachFor(1, {1.0, std::numeric_limits<double>::quiet_NaN(), 1.0}, 0));
    QVERIFY(edit::setNodeLocked(desk.document, {1}, true));
    QVERIFY(!desk.reach.reachFor(1, {1.0, 1.0, 1.0}, 0));
    QVERIFY(!desk.reach.progress());
    desk.reach.step(); // nothing to do
}

void TestArmReach::theWayEndsInOneStep()
{
    Desk desk;
    const Scene before = desk.document.scene();
    const glm::dvec3 target(1.0, 2.0, 1.0);
    QVERIFY(desk.reach.reachFor(1, target, newGesture()));
    QVERIFY(desk.params().arm.target == target);
    QVERIFY(desk.reach.progress()->moves);
    desk.reach.finish();
    QVERIFY(!desk.reach.progress()->moves);
    QVERIFY(desk.reach.progress()->figures.status == ArmStatus::Reached);
    QVERIFY(desk.reach.progress()->residual <= 1e-4);
    QVERIFY(glm::distance(desk.tip(), target) <= 1e-4);
    QCOMPARE(desk.document.undoStack()->count(), 1); // the target and the joints
    desk.document.undo();
    QVERIFY(desk.document.scene() == before);
}

void TestArmReach::canBeGoneThroughStepByStep()
{
    Desk desk;
    desk.reach.setPaused(true);
    QVERIFY(desk.reach.reachFor(1, {-2.0, 0.5, 1.0}, 0));
    QSignalSpy moved(&desk.reach, &ArmReach::moved);
    double last = desk.reach.progress()->residual;
    int steps = 0;
    while (desk.reach.progress()->moves && steps < 2000) {
        const std::vector<double> angles = desk.reach.progress()->angles;
        desk.reach.step();
        QCOMPARE(moved.count(), ++steps);
        for (std::size_t i = 0; i < angles.size(); ++i) {
            const double most = (i % 2 == 0 ? 3.0 : 1.5) * armTickSeconds;
            QVERIFY(std::abs(wrappedAngle(desk.reach.progress()->angles[i] - angles[i])) <= most * 1.000001);
        }
        last = desk.reach.progress()->residual;
    }
    QVERIFY(steps > 20 && last <= 1e-4);
    QCOMPARE(desk.reach.progress()->residuals.size(), std::size_t(steps + 1));
}

void TestArmReach::runsByItself()
{
    Desk desk;
    QVERIFY(desk.reach.reachFor(1, desk.tip() + glm::dvec3(0.1, 0.0, -0.1), 0));
    QTRY_VERIFY(!desk.reach.progress()->moves);
    QVERIFY(desk.reach.progress()->residual <= 1e-4);
}

void TestArmReach::aMovedTargetIsFollowed()
{
    Desk desk;
    desk.reach.setPaused(true);
    const GestureId drag = newGesture();
    for (int i = 0; i < 20; ++i) {
        QVERIFY(desk.reach.reachFor(1, {1.5, 0.1 * i, 1.0}, drag));
        desk.reach.step();
    }
    QVERIFY(desk.reach.progress()->residuals.size() > 20); // one way
    QCOMPARE(desk.document.undoStack()->count(), 1);
    desk.reach.finish();
    QVERIFY(glm::distance(desk.tip(), glm::dvec3(1.5, 1.9, 1.0)) <= 1e-4);
    QCOMPARE(desk.document.undoStack()->count(), 1);
    const std::vector<ArmJoint> after = desk.params().joints;
    desk.document.undo();
    desk.document.redo();
    QVERIFY(desk.params().joints == after);
}

/// Somebody drags another node when the arm arrives: the drag is not cut in two.
void TestArmReach::anArmThatArrivesWaitsForTheHand()
{
    Desk desk;
    const glm::dvec3 target(1.0, 2.0, 1.0);
    desk.reach.setPaused(true);
    QVERIFY(desk.reach.reachFor(1, target, 0));
    const GestureId drag = newGesture();
    desk.document.holdGesture(drag);
    QVERIFY(edit::setParam(desk.document, {2}, *findParam("tree.translation"), glm::dvec3(1.0), drag));
    desk.reach.finish();
    QVERIFY(desk.document.history().isHeld(drag));
    desk.document.keepGesture(drag);
    QCOMPARE(desk.document.undoStack()->count(), 2);
    desk.reach.step();
    QVERIFY(!desk.reach.progress()->moves);
    QVERIFY(glm::distance(desk.tip(), target) <= 1e-4);
}

void TestArmReach::otherEditsEndIt()
{
    for (int way = 0; way < 4; ++way) {
        Desk desk;
        desk.reach.setPaused(true);
        QVERIFY(desk.reach.reachFor(1, {-2.0, 0.5, 1.0}, 0));
        desk.reach.step();
        std::vector<ArmJoint> joints(2);
        if (way == 0)
            QVERIFY(edit::setJoints(desk.document, 1, joints, QStringLiteral("x")));
        else if (way == 1)
            QVERIFY(edit::removeNodes(desk.document, {1}));
        else if (way == 2)
            desk.document.reset({}, {});
        else
            desk.document.undo();
        QVERIFY(!desk.reach.progress());
    }
}

void TestArmReach::outOfReachIsTold()
{
    Desk desk;
    QVERIFY(desk.reach.reachFor(1, {10.0, 0.0, 0.0}, 0));
    desk.reach.finish();
    QVERIFY(desk.reach.progress()->figures.status == ArmStatus::Settled);
    QVERIFY(std::abs(desk.reach.progress()->figures.shortBy() - 5.6) < 0.01);
}

/// At rest the arm is sent; elsewhere it follows the timeline.
void TestArmReach::aimingAsksTheTimeline()
{
    Desk desk;
    Player player(&desk.document);
    desk.reach.setPlayer(&player);
    desk.reach.setPaused(true);
    QVERIFY(!desk.reach.reachFor(99, glm::dvec3(1.0), 0));
    QVERIFY(!desk.reach.reachFor(2, glm::dvec3(1.0), 0)); // a terrain
    player.seek(10);
    QVERIFY(desk.reach.reachFor(1, {1.0, 1.0, 1.0}, 0));
    QVERIFY(!desk.reach.progress());
    player.seek(0);
    const Channel size{ChannelPart::Parameter, 0, paramId(*findParam("surface.color"))};
    QVERIFY(edit::insertKeys(desk.document, {1}, {size}, 0)); // keeps the arm from nothing
    QVERIFY(desk.reach.reachFor(1, {1.0, 1.5, 1.0}, 0));
    QVERIFY(desk.reach.progress() && desk.reach.progress()->moves);
    QVERIFY(player.waitForIdle(20'000));
}

namespace {

/// m, from the tip of the arm that is shown to its target: as tracks have both at the player's frame, or as
/// the document has them where nothing moves.
double residualOf(const Player& player, const Document& document)
{
    const Node& arm = *document.scene().find(1);
    const glm::dvec3 target = *armSource(arm.params, arm.animation)(player.timeSeconds()).target;
    std::vector<ArmJoint> joints = armSource(arm.params, arm.animation)(player.timeSeconds()).joints;
    if (const NodeMotion* moving = player.motion()->of(1))
        setArmAngles(joints, moving->arm->angles);
    return glm::distance(ArmChain(joints).tip(), target);
}

} // namespace

/// With auto-key on the target is a key, and the arm goes there all the same.
void TestArmReach::aKeyedTargetIsReachedToo()
{
    Desk desk;
    Player player(&desk.document);
    AutoKey keys(&desk.document, &player);
    desk.reach.setPlayer(&player);
    desk.reach.setKeys(&keys);
    keys.setOn(true);
    const Scene before = desk.document.scene();
    const glm::dvec3 unkeyed = desk.params().arm.target, target(1.0, 2.0, 1.0);
    QVERIFY(desk.reach.reachFor(1, target, newGesture()));
    QVERIFY(desk.params().arm.target == unkeyed);
    QVERIFY(desk.reach.shown(1) && desk.reach.shown(1)->moves);
    desk.reach.finish();
    QVERIFY(glm::distance(desk.tip(), target) <= 1e-4);
    QVERIFY(desk.reach.shown(1)->residual <= 1e-4);
    QVERIFY(player.waitForIdle(20'000));
    QVERIFY(residualOf(player, desk.document) <= 1e-4);
    QCOMPARE(desk.document.undoStack()->count(), 1); // key and joints
    // Elsewhere the target gets another key, which the arm follows along the timeline.
    player.seek(100);
    QVERIFY(player.waitForIdle(20'000));
    QVERIFY(desk.reach.reachFor(1, {1.0, -2.0, 1.0}, 0));
    QVERIFY(player.waitForIdle(20'000));
    QVERIFY(desk.reach.shown(1));
    QVERIFY(std::abs(desk.reach.shown(1)->residual - residualOf(player, desk.document)) < 1e-9);
    while (desk.document.undoStack()->canUndo())
        desk.document.undo();
    QVERIFY(desk.document.scene() == before);
    QVERIFY(player.waitForIdle(20'000));
}

/// Whatever of it has keys, in whatever order it was sent and keyed.
void TestArmReach::whatIsToldIsOfTheArmThatIsShown()
{
    Random random(40, RandomStream::Test);
    const auto somewhere = [&random] {
        return glm::dvec3(random.range(-2.0, 2.0), random.range(-2.0, 2.0), random.range(0.0, 2.0));
    };
    for (int round = 0; round < 12; ++round) {
        Desk desk;
        Player player(&desk.document);
        AutoKey keys(&desk.document, &player);
        desk.reach.setPlayer(&player);
        desk.reach.setKeys(&keys);
        for (int step = 0; step < 6; ++step) {
            keys.setOn(random.below(2) == 0);
            switch (random.below(4)) {
            case 0:
                QVERIFY(edit::insertKeys(desk.document, {1}, jointChannels(random.below(3)), 0));
                break;
            case 1:
                QVERIFY(desk.reach.reach(1));
                break;
            default:
                QVERIFY(desk.reach.reachFor(1, somewhere(), 0));
            }
            desk.reach.finish();
            QVERIFY(player.waitForIdle(20'000));
            const ArmProgress* told = desk.reach.shown(1);
            const double real = residualOf(player, desk.document);
            if (told)
                QVERIFY2(std::abs(told->residual - real) < 1e-9,
                         qPrintable(QStringLiteral("%1 %2").arg(told->residual).arg(real)));
        }
    }
}

RAMURE_SUITE(TestArmReach)

} // namespace tst_arm_reach

#include "tst_arm_reach.moc"
