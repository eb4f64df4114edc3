#include "core/rig/physics/lanes.h"
#include "core/rig/physics/wind.h"
#include "tests/core/rig/physics/physics_support.h"
#include "tests/support/suite.h"
#include <thread>

namespace tst_tree_physics {

using namespace ramure;

/// What both modes share: bodies, determinism, the hand, apples, live changes.
class TestTreePhysics : public QObject
{
    Q_OBJECT
private:
    static void addModes()
    {
        QTest::addColumn<int>("mode");
        QTest::newRow("faithful") << int(PhysicsMode::Faithful);
        QTest::newRow("robust") << int(PhysicsMode::Robust);
    }
    /// With the mode of the present row.
    static PhysicsParams fetchedParams()
    {
        PhysicsParams params;
        params.mode = static_cast<PhysicsMode>(*static_cast<int*>(QTest::qData("mode", qMetaTypeId<int>())));
        return params;
    }
    static PhysicsState after(TreePhysics& physics, int steps)
    {
        PhysicsState state = physics.restState();
        for (int k = 0; k < steps; ++k)
            physics.step(state);
        return state;
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void bodiesAreSortedByDepth()
    {
        for (const Preset& preset : courseworkPresets()) {
            const test::MovingTree tree = test::presetTree(preset.name);
            const auto body = tree.body();
            QCOMPARE(body->size(), tree.skeleton.size());
            QCOMPARE(body->depthEnd.back(), body->size());
            Index first = 0;
            for (std::size_t depth = 0; depth < body->depthEnd.size(); ++depth) {
                for (Index slot = first; slot < body->depthEnd[depth]; ++slot) {
                    const Index branch = body->branchOf[slot], parent = tree.skeleton.parent[branch];
                    QCOMPARE(body->slotOf[branch], slot);
                    QCOMPARE(body->parent[slot], parent == noIndex ? noIndex : body->slotOf[parent]);
                    QVERIFY(depth == 0 ? parent == noIndex : body->parent[slot] < first);
                    QVERIFY(body->reach[slot] >= body->length[slot]);
                    QVERIFY(depth == 0 || body->reach[body->parent[slot]] >
                                              body->reach[slot] + 0.999 * body->length[body->parent[slot]]);
                }
                first = body->depthEnd[depth];
            }
            QCOMPARE(body->key != tree.body(false)->key, !body->appleSlot.empty());
            QCOMPARE(body->key, tree.body()->key);
        }
    }

    void anglesAreExact()
    {
        Random random(5, RandomStream::Test);
        for (int i = 0; i < 100'000; ++i) {
            const double angle = i < 1000 ? std::pow(10.0, -0.3 * i) : random.range(0.0, 3.14159265358979);
            const double size = std::pow(10.0, random.range(-3.0, 3.0));
            const double y = size * std::sin(angle), x = size * std::cos(angle);
            const double expected = std::atan2(y, x);
            QVERIFY(std::abs(lanes::angleOf(y, x) - expected) <=
                        4e-16 * std::max(expected, 1e-300) + 1e-300 ||
                    std::abs(lanes::angleOf(y, x) - expected) <= 4.5e-16);
        }
        QCOMPARE(lanes::angleOf(0.0, 1.0), 0.0);
        QCOMPARE(lanes::angleOf(0.0, -1.0), std::acos(-1.0));
        QCOMPARE(lanes::angleOf(1.0, 0.0), std::acos(0.0));
    }

    void sameBitsOnAnyThread_data() { addModes(); }
    void sameBitsOnAnyThread()
    {
        const PhysicsParams params = fetchedParams();
        const auto body = test::presetTree("SmallTree").body();
        TreePhysics physics(body, params);
        const PhysicsState expected = after(physics, 1000);
        std::vector<PhysicsState> states(4);
        {
            std::vector<std::jthread> threads;
            for (PhysicsState& state : states)
                threads.emplace_back([&state, &body, &params] {
                    TreePhysics own(body, params);
                    state = after(own, 1000);
                });
        }
        for (const PhysicsState& state : states)
            QVERIFY(test::sameBits(state, expected));
        QVERIFY(test::sameBits(after(physics, 1000), expected)); // nothing remembered from the first run
    }

    void seedsCountInTheRobustMode()
    {
        const auto body = test::presetTree("TinyTree").body();
        PhysicsParams params;
        TreePhysics one(body, params);
        params.seed = 2;
        TreePhysics two(body, params);
        QVERIFY(!test::sameBits(after(one, 10), after(two, 10)));
    }

    void timeIsStepTimesLength()
    {
        TreePhysics physics(test::presetTree("TinyTree").body());
        PhysicsState state = physics.restState();
        for (int k = 1; k <= 1000; ++k) {
            physics.step(state);
            QCOMPARE(state.timeSeconds, k * 0.01);
        }
        PhysicsParams params;
        params.stepSeconds = 0.004;
        physics.setParams(params);
        for (int k = 1; k <= 1000; ++k)
            physics.step(state);
        QCOMPARE(state.timeSeconds, 10.0 + 1000 * 0.004);
        QCOMPARE(state.step, 2000);
    }

    void posesHangTogether_data() { addModes(); }
    void posesHangTogether()
    {
        const test::MovingTree tree = test::presetTree("FanTree");
        TreePhysics physics(tree.body(), fetchedParams());
        const PhysicsState state = after(physics, 300);
        Pose pose;
        physics.pose(state, pose);
        QCOMPARE(pose.bones.size(), std::size_t(tree.skeleton.size()));
        QCOMPARE(pose.timeSeconds, 3.0);
        for (Index i = 0; i < tree.skeleton.size(); ++i) {
            QVERIFY(std::abs(glm::length(pose.bones[i].rotation) - 1.0) < 1e-12);
            const Index parent = tree.skeleton.parent[i];
            const glm::dvec3& p0 = tree.skeleton.p0[i];
            if (parent != noIndex)
                QVERIFY(glm::length(pose.bones[i].point(p0) - pose.bones[parent].point(p0)) < 1e-12);
            else
                QVERIFY(glm::length(pose.bones[i].point(p0) - p0) < 1e-12);
        }
        physics.pose(physics.restState(), pose);
        for (const RigidTransform& bone : pose.bones)
            QVERIFY(glm::length(bone.translation) < 1e-15 && bone.rotation.w == 1.0);
    }

    void pulledBranchesComeAndSpringBack_data() { addModes(); }
    void pulledBranchesComeAndSpringBack()
    {
        PhysicsParams params = fetchedParams();
        params.windStrength = 0.0;
        const test::MovingTree tree = test::presetTree("TinyTree");
        TreePhysics physics(tree.body(), params);
        const Index branch = tree.skeleton.size() - 1;
        PhysicsState state = after(physics, 2000), held = state;
        Pose pose;
        const auto tip = [&](const PhysicsState& at) {
            physics.pose(at, pose);
            return pose.bones[branch].point(tree.skeleton.p1[branch]);
        };
        const glm::dvec3 rest = tip(state);
        Pull pull{branch, 1.0, rest + glm::dvec3(0.4, 0.1, 0.0), 3.0};
        for (int k = 0; k < 500; ++k)
            physics.step(held, pull);
        const double near = glm::length(tip(held) - pull.target);
        QVERIFY2(near < 0.7 * glm::length(rest - pull.target), QByteArray::number(near));
        PhysicsState freed = held;
        for (int k = 0; k < 4000; ++k)
            physics.step(freed);
        QVERIFY2(glm::length(tip(freed) - rest) < 0.02, QByteArray::number(glm::length(tip(freed) - rest)));
    }

    void applesFallAndTheirBranchRises_data() { addModes(); }
    void applesFallAndTheirBranchRises()
    {
        PhysicsParams params = fetchedParams();
        params.windStrength = 0.0;
        const test::MovingTree tree = test::presetTree("SmallTree");
        TreePhysics physics(tree.body(), params);
        PhysicsState state = after(physics, 3000);
        const Index apple = 3, branch = tree.foliage.apples[apple].branch;
        Pose pose;
        physics.pose(state, pose);
        const double before = pose.bones[branch].point(tree.skeleton.p1[branch]).y;
        const glm::dvec3 hung = pose.bones[branch].point(tree.foliage.apples[apple].position);
        physics.shakeOff(state, apple);
        physics.shakeOff(state, apple);
        QCOMPARE(state.loose.size(), std::size_t(1));
        QVERIFY(glm::length(state.loose[0].position - hung) < 1e-12);
        QVERIFY(glm::length(physics.loosePoses(state)[0].point(tree.foliage.apples[apple].position) - hung) <
                1e-9);
        for (int k = 0; k < 3000; ++k)
            physics.step(state);
        QVERIFY(state.loose[0].resting);
        QCOMPARE(state.loose[0].position.y, tree.body()->appleRadius);
        physics.pose(state, pose);
        QVERIFY(pose.bones[branch].point(tree.skeleton.p1[branch]).y > before);
        QVERIFY(std::abs(physics.loosePoses(state)[0].point(tree.foliage.apples[apple].position).y -
                         tree.body()->appleRadius) < 1e-9);
    }

    void parametersChangeOnTheWay()
    {
        const auto body = test::presetTree("TinyTree").body();
        PhysicsParams params;
        TreePhysics physics(body, params);
        PhysicsState state = after(physics, 100);
        double jump = 0.0;
        Pose before, now;
        Random random(11, RandomStream::Test);
        for (int k = 0; k < 400; ++k) {
            if (k % 40 == 0) {
                params.mode = k % 80 == 0 ? PhysicsMode::Faithful : PhysicsMode::Robust;
                params.windStrength = random.range(0.0, 2.0);
                params.restFrame = random.below(2) == 0 ? RestFrame::World : RestFrame::Parent;
                physics.setParams(params);
            }
            physics.pose(state, before);
            physics.step(state);
            physics.pose(state, now);
            QCOMPARE(state.mode, params.mode);
            QCOMPARE(state.values.size(), std::size_t(state.channels()) * body->size());
            for (Index slot = 0; slot < body->size(); ++slot) {
                const Index branch = body->branchOf[slot];
                jump = std::max(jump, glm::length(now.bones[branch].point(body->p1[slot]) -
                                                  before.bones[branch].point(body->p1[slot])));
            }
        }
        QVERIFY(test::allFinite(state));
        QVERIFY2(jump < 0.6, QByteArray::number(jump)); // metres in a step; the tree is 3.6 m high
    }

    void massesAreThoseOfTheSpecification()
    {
        Skeleton skeleton;
        skeleton.add(noIndex, {0, 0, 0}, {0, 1, 0}, 0.2, 0.1);
        skeleton.add(0, {0, 1, 0}, {0, 2, 0}, 0.1, 0.05);
        skeleton.add(0, {0, 1, 0}, {1, 2, 0}, 0.1, 0.025);
        Foliage foliage;
        foliage.apples.push_back({2, {1, 2, 0}, {1, 0, 0, 0}});
        TreePhysics physics(makeTreeBody(skeleton, &foliage, 0.2), test::faithful());
        PhysicsState state = physics.restState();
        std::ranges::fill(state.channel(PhysicsState::VelX), 1.0);
        QCOMPARE(physics.figures(state).kineticEnergy, 0.5 * ((0.1 + 0.05 + 0.1) + 0.05 + 0.1));
        physics.shakeOff(state, 0);
        QCOMPARE(physics.figures(state).kineticEnergy, 0.5 * ((0.1 + 0.05 + 0.025) + 0.05 + 0.025));
    }
};

RAMURE_SUITE(TestTreePhysics)

} // namespace tst_tree_physics

#include "tst_tree_physics.moc"
