#include "core/evaluate/tree_run.h"
#include "core/rig/physics/apple_fall.h"
#include "core/rig/physics/limb_fall.h"
#include "core/rig/physics/physics_bake.h"
#include "core/rig/physics/physics_cache.h"
#include "tests/support/mesh_checker.h"
#include "tests/support/shaped_tree.h"
#include <QTemporaryDir>
#include <cmath>

namespace tst_limb_fall {

using namespace ramure;
using namespace ramure::test;

namespace {

/// The plain tree with its limbs cut, so many seconds after the beginning.
Shaped cutTree(double seconds, double at = 0.3)
{
    Shaped shaped;
    for (const std::size_t axis : {1, 3}) {
        TreeEdit edit = editOf(EditOperation::Cut, shaped.address[axis]);
        edit.at = at;
        edit.falls = true;
        edit.seconds = seconds;
        if (const auto made = shaped.make(edit); !made)
            qFatal("%s", why(made).constData());
    }
    return shaped;
}

std::shared_ptr<const TreeBody> bodyOf(const Shaped& shaped)
{
    return makeTreeBody(shaped.tree(Stage::Simplified).simplified->skeleton, nullptr, 0.2);
}

double lowestOf(const LooseBody& body, const FallingLimb& limb)
{
    double lowest = HUGE_VAL;
    for (const auto& [at, radius] : body.balls)
        lowest = std::min(lowest, limb.centre.y + (limb.rotation * at).y - radius);
    return lowest;
}

/// Any limb: a stem with a few twigs, in the air.
std::shared_ptr<const TreeBody> randomLimb(Random& random)
{
    Skeleton tree;
    const auto vector = [&](double size) {
        return size * glm::dvec3(random.range(-1, 1), random.range(-1, 1), random.range(-1, 1));
    };
    const glm::dvec3 foot(random.range(-3, 3), random.range(0.0, 8.0), 0.0);
    tree.add(noIndex, foot, foot + vector(2.0), 0.1, 0.05);
    while (tree.size() < 12) {
        const Index parent = random.below(tree.size());
        const double thick = random.below(6) == 0 ? 0.0 : 0.5 * tree.a1[parent];
        tree.add(parent, tree.p1[parent], tree.p1[parent] + vector(random.below(8) == 0 ? 0.0 : 1.0), thick,
                 0.5 * thick);
    }
    tree.loose = {{0, noIndex, 0.0}};
    return makeTreeBody(tree, nullptr, 0.2);
}

} // namespace

/// Limbs that were cut come off, fall and rest on the ground.
class TestLimbFall : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }
    void withoutGravityNothingFalls();
    void stumpsThatGoWithTheLimbHoldNothing();
    void whatHangsFollowsItsStump();
    void fallsAsGalileoSays();
    void whatStandsTurnsOverAboutItsFoot();
    void restsOnTheGround();
    void seekingGivesWhatPlayingGives();
    void bakedLimbsComeBack();
    void theMovedMeshIsWhole();
};

void TestLimbFall::withoutGravityNothingFalls()
{
    const auto body = bodyOf(cutTree(0.0));
    PhysicsParams params;
    params.gravity = 0.0;
    FallingLimb limb;
    letGo(body->limbs[0], {}, glm::dvec3(0.0), limb);
    const FallingLimb before = limb;
    stepLimb(body->limbs[0], params, 0.01, limb);
    QVERIFY(limb == before);
    for (const LimbPhase phase : {LimbPhase::Hanging, LimbPhase::Resting}) {
        FallingLimb still{phase};
        stepLimb(body->limbs[0], {}, 0.01, still);
        QVERIFY(still == FallingLimb{phase});
    }
}

void TestLimbFall::stumpsThatGoWithTheLimbHoldNothing()
{
    Skeleton tree;
    tree.add(noIndex, {0, 1, 0}, {0, 2, 0}, 0.1, 0.1);
    tree.add(noIndex, {0, 3, 0}, {0, 4, 0}, 0.1, 0.1);
    tree.loose = {{0, 1, 0.0}, {1, 0, 0.0}}; // each came off the other
    const auto body = makeTreeBody(tree, nullptr, 0.2);
    QCOMPARE(body->limbs[0].stump, noIndex);
    TreePhysics physics(body);
    PhysicsState state = physics.restState();
    Pose pose;
    physics.pose(state, pose);
    QVERIFY(pose.bones[0] == RigidTransform() && pose.bones[1] == RigidTransform());
}

void TestLimbFall::whatHangsFollowsItsStump()
{
    const auto body = bodyOf(cutTree(1000.0));
    QCOMPARE(body->limbs.size(), std::size_t{2});
    TreePhysics physics(body);
    PhysicsState state = physics.restState();
    Pose pose;
    double most = 0.0;
    for (int k = 0; k < 200; ++k) {
        physics.step(state, Pull{0, 1.0, {2.0, 1.0, 0.0}, 5.0});
        physics.pose(state, pose);
        for (const LooseBody& limb : body->limbs) {
            const Index stump = body->branchOf[limb.stump], root = body->branchOf[limb.root];
            most = std::max(most, glm::distance(pose.bones[stump].point(limb.foot), limb.foot));
            QVERIFY(glm::distance(pose.bones[stump].point(limb.foot), pose.bones[root].point(limb.foot)) <
                    1e-9);
        }
    }
    QVERIFY2(most > 0.02, qPrintable(QString::number(most))); // the hand does move it
}

void TestLimbFall::fallsAsGalileoSays()
{
    Random random(5, RandomStream::Test);
    auto body = randomLimb(random);
    LooseBody limb = body->limbs[0];
    limb.foot = limb.centre + glm::dvec3(0.0, 1.0, 0.0); // it hangs below
    FallingLimb now;
    letGo(limb, {{1.0, 0.0, 0.0, 0.0}, {0.0, 100.0, 0.0}}, {1.0, 2.0, 0.0}, now);
    QCOMPARE(now.phase, LimbPhase::Falling);
    const glm::dvec3 from = now.centre;
    for (int k = 0; k < 100; ++k)
        stepLimb(limb, {}, 0.01, now);
    QVERIFY(std::abs(now.centre.x - from.x - 1.0) < 1e-9);
    QVERIFY(std::abs(now.centre.y - from.y - (2.0 - 0.5 * earthGravity)) < 0.03); // steps of 5 ms
}

void TestLimbFall::whatStandsTurnsOverAboutItsFoot()
{
    Shaped shaped;
    TreeEdit edit = editOf(EditOperation::Cut, shaped.address[0]); // the trunk
    edit.at = 0.1;
    edit.falls = true;
    QVERIFY(shaped.make(edit));
    const auto body = bodyOf(shaped);
    const LooseBody& limb = body->limbs[0];
    FallingLimb now;
    letGo(limb, {}, glm::dvec3(0.0), now);
    QCOMPARE(now.phase, LimbPhase::Tearing);
    double farthest = 0.0;
    for (int step = 0; now.phase == LimbPhase::Tearing && step < 3000; ++step) {
        stepLimb(limb, {}, 0.01, now);
        const glm::dvec3 foot = now.centre + now.rotation * (limb.foot - limb.centre);
        farthest = std::max(farthest, glm::distance(foot, limb.foot));
    }
    QVERIFY2(farthest < 0.2, qPrintable(QString::number(farthest))); // lifted by what lies on the ground
    QVERIFY(now.phase != LimbPhase::Tearing);
    QVERIFY(std::abs(now.rotation.w) < 0.97); // by more than 28 degrees
}

/// Whatever it is: never below the ground, its energy only falls, and in the end it lies still.
void TestLimbFall::restsOnTheGround()
{
    Random random(11, RandomStream::Test);
    for (int i = 0; i < 40; ++i) {
        const auto body = randomLimb(random);
        const LooseBody& limb = body->limbs[0];
        FallingLimb now;
        letGo(limb, {}, glm::dvec3(0.0), now);
        int steps = 0;
        for (; now.phase != LimbPhase::Resting && steps < 6000; ++steps) {
            stepLimb(limb, {}, 0.01, now);
            QVERIFY2(lowestOf(limb, now) > -1e-9, qPrintable(QString::number(lowestOf(limb, now))));
            QVERIFY(glm::length(now.velocity) < 20.0 && glm::length(now.spin) < 200.0);
        }
        QVERIFY2(steps < 6000, qPrintable(QString::number(i)));
        QVERIFY(lowestOf(limb, now) < 0.01);
        const FallingLimb before = now;
        stepLimb(limb, {}, 0.01, now);
        QVERIFY(now == before);
    }
}

void TestLimbFall::seekingGivesWhatPlayingGives()
{
    const auto body = bodyOf(cutTree(0.3));
    PhysicsCache played(body, {}), sought(body, {});
    std::vector<PhysicsState> states;
    for (int step = 0; step <= 300; ++step) {
        QVERIFY(played.seek(step));
        states.push_back(played.state());
    }
    QCOMPARE(states[29].limbs[0].phase, LimbPhase::Hanging);
    QVERIFY(states[32].limbs[0].phase != LimbPhase::Hanging);
    for (const int step : {300, 17, 250, 31, 29, 260, 0}) {
        QVERIFY(sought.seek(step));
        QVERIFY(sought.state() == states[std::size_t(step)]);
    }
}

void TestLimbFall::bakedLimbsComeBack()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath(QStringLiteral("bake")).toStdString();
    const auto body = bodyOf(cutTree(0.1));
    PhysicsCache cache(body, {});
    QVERIFY(saveBake(cache, 200, path));
    PhysicsCache other(body, {});
    const auto loaded = loadBake(other, path);
    QVERIFY2(loaded, why(loaded).constData());
    QVERIFY(cache.seek(150) && other.seek(150));
    QVERIFY(other.state() == cache.state());
    QVERIFY(other.state().limbs[0].phase != LimbPhase::Hanging);
    // Another tree: its limbs stay.
    PhysicsCache whole(bodyOf(Shaped()), {});
    QVERIFY(!loadBake(whole, path));
}

void TestLimbFall::theMovedMeshIsWhole()
{
    const Shaped shaped = cutTree(0.0);
    const TreeResult tree = shaped.tree(Stage::Foliage);
    QCOMPARE(tree.report->components, Index{3});
    TreeRun run;
    QVERIFY(run.setTree(tree, shaped.params));
    run.setPhysics(shaped.params.physics, {}, 0.0);
    for (const double seconds : {0.0, 0.4, 6.0}) {
        const auto motion = run.motionAt(seconds, {}, {});
        QVERIFY2(motion, why(motion).constData());
        const auto moved = movedTree(tree, *motion, {});
        QVERIFY2(moved, why(moved).constData());
        QVERIFY(checkMesh(moved->branches->mesh).perfect(3));
        const float lowest = std::ranges::min(moved->branches->mesh.positions, {}, &glm::vec3::y).y;
        QVERIFY(lowest > -0.1F);
        const Index root = tree.simplified->skeleton.loose.back().first;
        QCOMPARE(moved->simplified->skeleton.p1[root].y<1.0, seconds> 1.0); // as thick as it is long
    }
}

RAMURE_SUITE(TestLimbFall)

} // namespace tst_limb_fall

#include "tst_limb_fall.moc"
