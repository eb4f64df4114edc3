#include "tests/core/rig/physics/physics_support.h"
#include "tests/support/suite.h"

namespace tst_robust_step {

using namespace ramure;

namespace {

double degrees(double rad)
{
    return rad * 57.29577951308232;
}

/// How far the springs would swing out from where they are: without a load it can only shrink.
double amplitude(const TreePhysics& physics, const PhysicsState& state)
{
    double worst = 0.0;
    for (Index slot = 0; slot < state.slotCount; ++slot) {
        const double rate = physics.swingRate(physics.body().branchOf[slot]);
        double sum = 0.0;
        for (int i = 0; i < 3; ++i) {
            const double bend = state.channel(PhysicsState::BendX + i)[slot];
            const double speed = state.channel(PhysicsState::RateX + i)[slot] / rate;
            sum += bend * bend + speed * speed;
        }
        worst = std::max(worst, std::sqrt(sum));
    }
    return worst;
}

/// One wild run: wind, a hand, apples let go, another set of parameters halfway, then calm. Empty where all
/// is well.
QByteArray wildRun(std::uint64_t seed, bool settled)
{
    Random random(seed, RandomStream::Test);
    const test::MovingTree tree = test::randomTree(random, 12 + random.below(20));
    const auto body = tree.body();
    PhysicsParams params = test::randomPhysics(random);
    params.mode = PhysicsMode::Robust;
    params.settled = settled;
    TreePhysics physics(body, params);
    PhysicsState state = physics.restState();
    std::optional<Pull> pull;
    for (int frame = 0; frame < 300; ++frame) {
        if (frame == 50)
            pull = Pull{random.below(body->size()),
                        random.unit(),
                        {random.range(-9, 9), random.range(-9, 9), 3.0},
                        random.range(0.0, 100.0)};
        if (frame == 120)
            physics.shakeOff(state, random.below(5));
        if (frame == 150) {
            pull.reset();
            PhysicsParams other = test::randomPhysics(random);
            other.mode = PhysicsMode::Robust;
            physics.setParams(other);
        }
        physics.step(state, pull);
    }
    if (!test::allFinite(state))
        return "not finite in the wind";
    PhysicsParams calm = physics.params();
    calm.windStrength = calm.gravity = 0.0;
    physics.setParams(calm);
    double before = 0.0, after = 0.0;
    for (int frame = 300; frame < 600; ++frame) {
        physics.step(state);
        if (frame < 310)
            before = std::max(before, amplitude(physics, state));
        if (frame >= 590)
            after = std::max(after, amplitude(physics, state));
    }
    if (!test::allFinite(state))
        return "not finite without wind";
    // A swing may pass from a branch to those it carries; the largest of the tree does not grow. A settled
    // tree without its weight rises.
    if (!settled && after > before * 1.05 + 1e-6)
        return "grows without wind: " + QByteArray::number(before) + " to " + QByteArray::number(after);
    const PhysicsFigures figures = physics.figures(state);
    if (figures.lengthError > 1e-6)
        return "lengths: " + QByteArray::number(figures.lengthError);
    return {};
}

} // namespace

class TestRobustStep : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void anEmptyTreeIsNoTrouble()
    {
        for (const PhysicsMode mode : {PhysicsMode::Faithful, PhysicsMode::Robust}) {
            PhysicsParams params;
            params.mode = mode;
            TreePhysics physics(makeTreeBody(Skeleton(), nullptr, 0.2), params);
            PhysicsState state = physics.restState();
            physics.step(state, Pull{});
            physics.shakeOff(state, 0);
            Pose pose;
            physics.pose(state, pose);
            QVERIFY(pose.bones.empty() && state.loose.empty());
            QCOMPARE(physics.figures(state).kineticEnergy, 0.0);
            QCOMPARE(physics.swingRate(0), 0.0);
        }
    }

    void valuesOutsideAreClamped()
    {
        PhysicsParams wild;
        wild.stepSeconds = -1.0;
        wild.damping = std::nan("");
        wild.substeps = 1'000'000;
        const TreePhysics physics(test::presetTree("TinyTree").body(), wild);
        QCOMPARE(physics.params().stepSeconds, 1e-4);
        QCOMPARE(physics.params().damping, PhysicsParams().damping);
        QCOMPARE(physics.params().substeps, std::int64_t(64));
    }

    void handsThatHoldNothingDoNothing()
    {
        const auto body = test::presetTree("TinyTree").body();
        TreePhysics physics(body);
        PhysicsState plain = physics.restState(), pulled = plain;
        physics.step(plain);
        physics.step(pulled, Pull{body->size(), 1.0, {0.0, 0.0, 0.0}, 1.0});
        QVERIFY(test::sameBits(plain, pulled));
        pulled = physics.restState();
        physics.step(pulled, Pull{0, 1.0, {std::nan(""), 0.0, 0.0}, 1.0});
        QVERIFY(test::sameBits(plain, pulled));
        PhysicsState unshaken = physics.restState();
        physics.shakeOff(unshaken, 1'000'000);
        QVERIFY(unshaken.loose.empty());
    }

    /// 10,000 with RAMURE_MANY_RUNS=10000 in the environment.
    void wildParametersStayCalm()
    {
        const int wanted = qEnvironmentVariableIntValue("RAMURE_MANY_RUNS");
        for (int run = 0; run < std::max(wanted, test::runs(150)); ++run) {
            for (const bool settled : {false, true}) {
                const QByteArray fault = wildRun(std::uint64_t(run), settled);
                QVERIFY2(fault.isEmpty(), "run " + QByteArray::number(run) + ": " + fault);
            }
        }
    }

    void lengthsStay_data() { test::addPresetRows(); }
    void lengthsStay()
    {
        QFETCH(QByteArray, name);
        PhysicsParams params;
        params.windStrength = 2.0;
        TreePhysics physics(test::presetTree(name.constData()).body(), params);
        PhysicsState state = physics.restState();
        double worst = 0.0;
        for (int k = 1; k <= 10'000; ++k) {
            physics.step(state);
            if (k % 50 == 0)
                worst = std::max(worst, physics.figures(state).lengthError);
        }
        QVERIFY2(worst < 1e-6, QByteArray::number(worst));
        QVERIFY(test::allFinite(state));
    }

    void aBreezeLooksLikeABreeze_data() { test::addPresetRows(); }
    void aBreezeLooksLikeABreeze()
    {
        QFETCH(QByteArray, name);
        const auto body = test::presetTree(name.constData()).body(false);
        TreePhysics physics(body);
        PhysicsState state = physics.restState();
        double tips = 0.0, trunk = 0.0;
        for (int k = 1; k <= 2000; ++k) {
            physics.step(state);
            tips = std::max(tips, physics.figures(state).largestTurnRad);
            trunk = std::max(trunk, 2.0 * std::acos(std::min(1.0, state.channel(PhysicsState::RotW)[0])));
        }
        QVERIFY2(degrees(tips) > 15.0 && degrees(tips) < 50.0, QByteArray::number(degrees(tips)));
        QVERIFY2(degrees(trunk) > 0.01 && degrees(trunk) < 10.0, QByteArray::number(degrees(trunk)));
        Index root = 0, twig = body->branchOf[body->size() - 1];
        QVERIFY(physics.swingRate(twig) > 2.0 * physics.swingRate(root));
    }

    void calmTreesComeToRest()
    {
        for (const RestFrame frame : {RestFrame::Parent, RestFrame::World}) {
            PhysicsParams params;
            params.windStrength = 0.0;
            params.settled = false;
            params.restFrame = frame;
            TreePhysics physics(test::presetTree("TinyTree").body(), params);
            PhysicsState state = physics.restState();
            double sag = 0.0;
            for (int k = 0; k < 6000; ++k)
                physics.step(state);
            const PhysicsFigures figures = physics.figures(state);
            sag = degrees(figures.largestTurnRad);
            QVERIFY2(sag > 0.1 && sag < 15.0, QByteArray::number(sag));
            QVERIFY2(figures.kineticEnergy < 1e-12, QByteArray::number(figures.kineticEnergy));
        }
    }

    void settledTreesStandStill_data() { test::addPresetRows(); }
    void settledTreesStandStill()
    {
        QFETCH(QByteArray, name);
        const auto body = test::presetTree(name.constData()).body();
        for (const double gravity : {0.0, 1.0, 100.0})
            for (const RestFrame frame : {RestFrame::Parent, RestFrame::World}) {
                PhysicsParams params;
                params.windStrength = 0.0;
                params.gravity = gravity;
                params.restFrame = frame;
                params.restitution = gravity > 1.0 ? 1.0 : 700.0;
                TreePhysics physics(body, params);
                PhysicsState state = physics.restState();
                for (int k = 0; k < 100; ++k)
                    physics.step(state);
                QVERIFY(state.values == physics.restState().values);
            }
    }

    /// No jump at the beginning: the first step moves a tree in the wind less than the later ones do.
    void settledTreesStartGently()
    {
        TreePhysics physics(test::presetTree("SmallTree").body());
        PhysicsState state = physics.restState();
        std::vector<double> ways;
        glm::dvec3 before = physics.figures(state).tip;
        for (int k = 0; k < 300; ++k) {
            physics.step(state);
            const glm::dvec3 tip = physics.figures(state).tip;
            ways.push_back(glm::length(tip - before));
            before = tip;
        }
        const double first = ways.front();
        std::ranges::nth_element(ways, ways.begin() + 150);
        QVERIFY2(first < ways[150], QByteArray::number(first));
    }

    void settledTreesFeelWhatChanges()
    {
        PhysicsParams params;
        params.windStrength = 0.0;
        const auto turnAfter = [](TreePhysics& physics, PhysicsState state) {
            for (int k = 0; k < 1000; ++k)
                physics.step(state);
            return degrees(physics.figures(state).largestTurnRad);
        };
        TreePhysics physics(test::presetTree("SmallTree").body(), params);
        const PhysicsState rest = physics.restState();
        QVERIFY(turnAfter(physics, rest) < 1e-5);
        PhysicsState lighter = rest;
        physics.shakeOff(lighter, 0);
        QVERIFY(turnAfter(physics, lighter) > 0.01);
        for (const double gravity : {0.0, 2.0}) {
            PhysicsParams other = params;
            other.gravity = gravity;
            physics.setParams(other);
            QVERIFY(turnAfter(physics, rest) > 0.1); // the beginning of the run counts
            QVERIFY(turnAfter(physics, physics.restState()) < 1e-5);
        }
    }

    void stepsOfAnyLengthGiveTheSameMotion()
    {
        const test::MovingTree tree = test::presetTree("TinyTree");
        const auto tipAfter = [&](double stepSeconds, std::int64_t substeps) {
            PhysicsParams params;
            params.stepSeconds = stepSeconds;
            params.substeps = substeps;
            TreePhysics physics(tree.body(), params);
            PhysicsState state = physics.restState();
            while (state.timeSeconds < 4.0 - 1e-9)
                physics.step(state);
            return physics.figures(state).tip;
        };
        const glm::dvec3 fine = tipAfter(0.001, 1);
        const double coarse = glm::length(tipAfter(0.02, 1) - fine),
                     medium = glm::length(tipAfter(0.01, 1) - fine);
        QVERIFY2(medium < 0.05 && medium < coarse, QByteArray::number(medium));
        QVERIFY(glm::length(tipAfter(0.01, 10) - fine) < 1e-6);
    }

    void windBlowsWhereItIsTold()
    {
        const auto lean = [](double direction) {
            PhysicsParams params;
            params.windDirection = direction;
            params.windTurbulence = params.gravity = 0.0;
            TreePhysics physics(test::presetTree("SmallTree").body(false), params);
            PhysicsState state = physics.restState();
            for (int k = 0; k < 500; ++k)
                physics.step(state);
            Pose pose;
            physics.pose(state, pose);
            glm::dvec3 sum(0.0);
            for (Index slot = 0; slot < physics.body().size(); ++slot)
                sum += pose.bones[physics.body().branchOf[slot]].point(physics.body().p1[slot]) -
                       physics.body().p1[slot];
            return sum / glm::length(sum);
        };
        QVERIFY(lean(0.0).x > 0.9);
        QVERIFY(lean(1.5707963267948966).z < -0.9);
        QVERIFY(lean(3.141592653589793).x < -0.9);
    }
};

RAMURE_SUITE(TestRobustStep)

} // namespace tst_robust_step

#include "tst_robust_step.moc"
