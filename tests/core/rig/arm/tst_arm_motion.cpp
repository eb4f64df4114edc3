#include "core/math/random.h"
#include "core/rig/arm/arm_driver.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

namespace tst_arm_motion {

using namespace ramure;
using namespace ramure::test;

class TestArmMotion : public QObject
{
    Q_OBJECT

private slots:
    void init() { failOnAnyWarning(); }
    void timesThatAreNoneAreErrors();
    void cancellingIsAnError();
    void withoutATargetItStandsStill();
    void everyFrameRateSeesTheSamePath_data() { solvers(); }
    void everyFrameRateSeesTheSamePath();
    void anyOrderGivesTheSame_data() { solvers(); }
    void anyOrderGivesTheSame();
    void speedsHoldAndThePathIsStraight();
    void slowTransposeStaysWithinItsSpeeds();
    void theShorterWayRound();
    void comesToRest();

private:
    static void solvers();
};

namespace {

constexpr double pi = std::numbers::pi;

ArmSolverParams paramsOf(bool transpose)
{
    ArmSolverParams params;
    params.kind = transpose ? ArmSolverKind::Transpose : ArmSolverKind::LeastSquares;
    return params;
}

std::vector<ArmJoint> slowArm()
{
    std::vector<ArmJoint> joints = defaultArmJoints();
    for (ArmJoint& joint : joints) {
        joint.phi.mostSpeed = 1.5;
        joint.theta.mostSpeed = 0.7;
    }
    return joints;
}

glm::dvec3 circling(double time)
{
    return {2.0 * std::cos(time), 2.0 * std::sin(1.3 * time), 1.0 + time};
}

glm::dvec3 tipOf(std::span<const ArmJoint> joints, std::span<const double> angles)
{
    ArmChain chain(joints);
    chain.setAngles(angles);
    return chain.tip();
}

} // namespace

void TestArmMotion::solvers()
{
    QTest::addColumn<bool>("transpose");
    QTest::newRow("least squares") << false;
    QTest::newRow("transpose") << true;
}

void TestArmMotion::timesThatAreNoneAreErrors()
{
    ArmDriver driver(defaultArmJoints(), {}, circling);
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e9}) {
        const auto made = driver.momentAt(bad, {});
        QVERIFY(!made);
        QCOMPARE(made.error().code, ErrorCode::Invalid);
    }
    const auto before = driver.momentAt(-3.0, {}), start = driver.momentAt(0.0, {});
    QVERIFY(before && start);
    QCOMPARE(before->angles, start->angles);
}

void TestArmMotion::cancellingIsAnError()
{
    ArmDriver driver(defaultArmJoints(), {}, circling);
    std::stop_source stop;
    stop.request_stop();
    const auto made = driver.momentAt(5.0, Progress{stop.get_token(), {}});
    QVERIFY(!made);
    QCOMPARE(made.error().code, ErrorCode::Cancelled);
    QVERIFY(driver.momentAt(5.0, {}));
}

void TestArmMotion::withoutATargetItStandsStill()
{
    ArmDriver driver(defaultArmJoints(), {}, {});
    const auto moment = driver.momentAt(10.0, {});
    QVERIFY(moment);
    QCOMPARE(moment->angles, armAngles(defaultArmJoints()));
}

/// Every rate plays the way a player does, frame after frame. Frames at the same time are compared as they
/// are, the others with the straight line between the two frames of the finest rate.
void TestArmMotion::everyFrameRateSeesTheSamePath()
{
    QFETCH(bool, transpose);
    const std::vector<ArmJoint> joints = slowArm();
    const double reach = ArmChain(joints).reach();
    constexpr int rates[] = {30, 60, 144};
    constexpr int seconds = 4;
    std::vector<std::vector<glm::dvec3>> tips;
    for (const int rate : rates) {
        ArmDriver driver(joints, paramsOf(transpose), circling);
        std::vector<glm::dvec3>& path = tips.emplace_back();
        for (int frame = 0; frame <= seconds * rate; ++frame) {
            const auto moment = driver.momentAt(double(frame) / rate, {});
            QVERIFY(moment);
            path.push_back(tipOf(joints, moment->angles));
        }
    }
    double atFrames = 0.0, between = 0.0;
    const std::vector<glm::dvec3>& finest = tips[2];
    for (std::size_t r = 0; r < 2; ++r)
        for (std::size_t i = 0; i < tips[r].size(); ++i) {
            const double at = double(i) * rates[2] / rates[r];
            const auto before = std::min(std::size_t(at + 1e-9), finest.size() - 1);
            const double part = std::max(at - double(before), 0.0);
            const glm::dvec3& to = finest[std::min(before + 1, finest.size() - 1)];
            const double away = glm::distance(tips[r][i], finest[before] + part * (to - finest[before]));
            double& most = part < 1e-6 ? atFrames : between;
            most = std::max(most, away);
        }
    for (std::size_t i = 0; i < tips[0].size(); ++i)
        atFrames = std::max(atFrames, glm::distance(tips[0][i], tips[1][2 * i]));
    qInfo("same times: %.2g of the reach, between frames: %.2g", atFrames / reach, between / reach);
    QVERIFY(atFrames < 1e-9 * reach);
    QVERIFY(between < 1e-3 * reach);
}

void TestArmMotion::anyOrderGivesTheSame()
{
    QFETCH(bool, transpose);
    ArmDriver forwards(slowArm(), paramsOf(transpose), circling);
    ArmDriver anyhow(slowArm(), paramsOf(transpose), circling);
    std::vector<ArmMoment> moments;
    for (int i = 0; i <= 100; ++i)
        moments.push_back(forwards.momentAt(0.11 * i, {}).value());
    Random random(1, RandomStream::Test);
    for (int i = 0; i < 300; ++i) {
        const std::uint32_t which = random.below(101);
        const ArmMoment moment = anyhow.momentAt(0.11 * which, {}).value();
        QCOMPARE(moment.angles, moments[which].angles);
        QCOMPARE(moment.figures.steps, moments[which].figures.steps);
        QCOMPARE(moment.residual, moments[which].residual);
    }
}

void TestArmMotion::speedsHoldAndThePathIsStraight()
{
    const std::vector<ArmJoint> joints = slowArm();
    ArmSolver goal(joints, {});
    const glm::dvec3 target(-2.0, 0.5, 1.0);
    goal.setTarget(target);
    QCOMPARE(goal.solve(), ArmStatus::Reached);
    ArmMotion motion(joints, {});
    motion.setTarget(target);
    std::vector<double> last(motion.angles().begin(), motion.angles().end());
    while (!motion.isStill()) {
        motion.tick();
        QVERIFY(motion.ticks() < 1000);
        for (std::size_t i = 0; i < last.size(); ++i) {
            const double most = (i % 2 == 0 ? 1.5 : 0.7) * armTickSeconds;
            QVERIFY(std::abs(wrappedAngle(motion.angles()[i] - last[i])) <= most * (1.0 + 1e-12));
        }
        // Once the solver has the goal all angles turn in the proportion of what is left.
        if (motion.solver().figures().status == ArmStatus::Reached && !motion.isStill()) {
            double over = 0.0;
            std::vector<double> parts;
            for (std::size_t i = 0; i < last.size(); ++i) {
                const double left = wrappedAngle(goal.angles()[i] - last[i]);
                if (std::abs(left) > 1e-6)
                    parts.push_back(wrappedAngle(motion.angles()[i] - last[i]) / left);
                over = std::max(over, parts.empty() ? 0.0 : std::abs(parts.back() - parts.front()));
            }
            QVERIFY(over < 1e-6);
        }
        last.assign(motion.angles().begin(), motion.angles().end());
    }
    QVERIFY(motion.ticks() > 30);
    QVERIFY(std::ranges::equal(goal.angles(), motion.angles()));
}

void TestArmMotion::slowTransposeStaysWithinItsSpeeds()
{
    std::vector<ArmJoint> joints = slowArm();
    for (ArmJoint& joint : joints)
        joint.theta.mostSpeed = 0.2;
    ArmMotion motion(joints, paramsOf(true));
    motion.setTarget({-2.0, 0.5, 1.0});
    std::vector<double> last(motion.angles().begin(), motion.angles().end());
    int slowed = 0;
    for (int tick = 0; tick < 6000 && !motion.isStill(); ++tick) {
        motion.tick();
        double most = 0.0;
        for (std::size_t i = 0; i < last.size(); ++i)
            most = std::max(most, std::abs(wrappedAngle(motion.angles()[i] - last[i])) /
                                      ((i % 2 == 0 ? 1.5 : 0.2) * armTickSeconds));
        QVERIFY(most <= 1.0 + 1e-12);
        slowed += most > 1.0 - 1e-9;
        last.assign(motion.angles().begin(), motion.angles().end());
    }
    QVERIFY(slowed > 10);
    QVERIFY(motion.isStill());
    QCOMPARE(motion.solver().figures().status, ArmStatus::Reached);
}

/// From 170 degrees to -170 degrees it is 20 degrees, not 340.
void TestArmMotion::theShorterWayRound()
{
    std::vector<ArmJoint> joints(1);
    joints[0].phi.angleRad = 170.0 * pi / 180.0;
    joints[0].phi.mostSpeed = 0.5;
    joints[0].theta.angleRad = 1.0;
    std::vector<ArmJoint> goal = joints;
    goal[0].phi.angleRad = -170.0 * pi / 180.0;
    const glm::dvec3 target = ArmChain(goal).tip();
    for (const bool transpose : {false, true}) {
        ArmSolverParams params = paramsOf(transpose);
        params.gain = 0.5;
        ArmMotion motion(joints, params);
        motion.setTarget(target);
        while (!motion.isStill() && motion.ticks() < 1000) {
            motion.tick();
            QVERIFY(std::abs(motion.angles()[0]) > 3.13 - 20.0 * pi / 180.0);
            for (const double part : {0.0, 0.3, 0.5, 1.0})
                QVERIFY(std::abs(motion.anglesBetween(part)[0]) > 2.8);
        }
        QVERIFY(motion.isStill());
    }
}

void TestArmMotion::comesToRest()
{
    for (const glm::dvec3& target : {glm::dvec3(2.0, 1.0, 2.0), glm::dvec3(50.0, 0.0, 0.0)}) {
        ArmMotion motion(slowArm(), {});
        motion.setTarget(target);
        for (int tick = 0; tick < 2000; ++tick)
            motion.tick();
        QVERIFY(motion.isStill());
        QVERIFY(std::ranges::equal(motion.angles(), motion.anglesBefore()));
    }
}

RAMURE_SUITE(TestArmMotion)

} // namespace tst_arm_motion

#include "tst_arm_motion.moc"
