#include "core/math/random.h"
#include "core/rig/arm/arm_solver.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

namespace tst_arm_solver {

using namespace ramure;
using namespace ramure::test;

class TestArmSolver : public QObject
{
    Q_OBJECT

private slots:
    void init() { failOnAnyWarning(); }
    void targetsThatAreNoNumbersAreNone();
    void startsOutsideTheLimitsAreClamped();
    void oneTransposeStepIsAsWritten();
    void faithfulReachesRandomTargets();
    void reachesWhatCanBeReached_data();
    void reachesWhatCanBeReached();
    void settlesOutOfReach_data();
    void settlesOutOfReach();
    void aStraightArmStartsToo();
    void isTheSameEveryTime();
    void limitsHold_data();
    void limitsHold();
    void tellsWhatHappened();
};

namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180.0;

/// Segments of 1 m, phi within 170 degrees, theta within 60, theta a little off the straight arm.
std::vector<ArmJoint> limitedArm(std::size_t count)
{
    std::vector<ArmJoint> joints(count);
    for (ArmJoint& joint : joints) {
        joint.phi = {0.0, true, -170.0 * degree, 170.0 * degree, 0.0};
        joint.theta = {0.1, true, -60.0 * degree, 60.0 * degree, 0.0};
    }
    return joints;
}

glm::dvec3 reachableTarget(std::span<const ArmJoint> joints, Random& random)
{
    std::vector<ArmJoint> posed(joints.begin(), joints.end());
    for (ArmJoint& joint : posed) {
        joint.phi.angleRad = random.range(joint.phi.minRad, joint.phi.maxRad);
        joint.theta.angleRad = random.range(joint.theta.minRad, joint.theta.maxRad);
    }
    return ArmChain(posed).tip();
}

glm::dvec3 unitVector(Random& random)
{
    const double z = random.range(-1.0, 1.0), turn = random.range(-pi, pi), r = std::sqrt(1.0 - z * z);
    return {r * std::cos(turn), r * std::sin(turn), z};
}

double mostOver(std::span<const ArmJoint> joints, std::span<const double> angles)
{
    double most = 0.0;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const ArmAngle& rule = i % 2 == 0 ? joints[i / 2].phi : joints[i / 2].theta;
        most = std::max({most, angles[i] - rule.maxRad, rule.minRad - angles[i]});
    }
    return most;
}

} // namespace

void TestArmSolver::targetsThatAreNoNumbersAreNone()
{
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        ArmSolver solver(defaultArmJoints(), {});
        const std::vector<double> before(solver.angles().begin(), solver.angles().end());
        solver.setTarget({1.0, bad, 0.0});
        QVERIFY(!solver.target());
        QVERIFY(!solver.step());
        QVERIFY(std::ranges::equal(before, solver.angles()));
    }
    ArmSolver solver(defaultArmJoints(), {});
    QVERIFY(!solver.step()); // without a target
    // Squares that overflow.
    solver.setTarget(glm::dvec3(1e200));
    QVERIFY(!solver.step());
    for (const ArmSolverKind kind : {ArmSolverKind::LeastSquares, ArmSolverKind::Transpose}) {
        ArmSolver far(defaultArmJoints(), {kind, 0.01 * pi, 1, 1e-4});
        far.setTarget(glm::dvec3(1e100));
        far.solve(100);
        for (const double angle : far.angles())
            QVERIFY(std::isfinite(angle));
    }
}

void TestArmSolver::startsOutsideTheLimitsAreClamped()
{
    std::vector<ArmJoint> joints = limitedArm(3);
    joints[1].theta.angleRad = 2.0;
    ArmSolver solver(joints, {});
    QCOMPARE(solver.angles()[3], 60.0 * degree);
    QCOMPARE(solver.limit(3), ArmLimit::Upper);
    QCOMPARE(solver.limit(2), ArmLimit::Free);
}

void TestArmSolver::oneTransposeStepIsAsWritten()
{
    const std::vector<ArmJoint> joints = defaultArmJoints();
    ArmSolver solver(joints, {ArmSolverKind::Transpose, 0.01 * pi, 1, 1e-4});
    const glm::dvec3 target(-1.0, 2.0, 1.5);
    ArmChain chain(joints);
    std::vector<glm::dvec3> columns(chain.angleCount());
    std::vector<double> angles = armAngles(joints);
    solver.setTarget(target);
    for (int step = 0; step < 50; ++step) {
        chain.setAngles(angles);
        chain.jacobian(columns);
        for (std::size_t i = 0; i < angles.size(); ++i)
            angles[i] = wrappedAngle(angles[i] + 0.01 * pi * glm::dot(columns[i], target - chain.tip()));
        solver.step();
        for (std::size_t i = 0; i < angles.size(); ++i)
            QVERIFY(std::abs(angles[i] - solver.angles()[i]) < 1e-12);
    }
}

/// Targets spread evenly over the half shell. How many steps the worst of 300 needs is chance: of 200 such
/// draws half stay below 1,772, a tenth below 857 and a tenth need over 4,477; targets that lie almost in
/// line with the folded arm are slow. The median is steady.
void TestArmSolver::faithfulReachesRandomTargets()
{
    Random random(1, RandomStream::Test);
    std::vector<std::int64_t> steps;
    while (steps.size() < 300) {
        const glm::dvec3 target(random.range(-4.2, 4.2), random.range(-4.2, 4.2), random.range(0.0, 4.2));
        if (glm::length(target) < 0.5 || glm::length(target) > 4.2)
            continue;
        ArmSolver solver(defaultArmJoints(), {ArmSolverKind::Transpose, 0.01 * pi, 1, 1e-3});
        solver.setTarget(target);
        QCOMPARE(solver.solve(50000), ArmStatus::Reached);
        QVERIFY(glm::distance(solver.chain().tip(), target) <= 1e-3);
        steps.push_back(solver.figures().steps);
    }
    std::ranges::sort(steps);
    qInfo("median %lld, worst %lld", static_cast<long long>(steps[150]), static_cast<long long>(steps[299]));
    QVERIFY(steps[150] >= 170 && steps[150] <= 240);
}

void TestArmSolver::reachesWhatCanBeReached_data()
{
    QTest::addColumn<int>("joints");
    for (const int joints : {2, 3, 5, 10, 20})
        QTest::addRow("%d", joints) << joints;
}

void TestArmSolver::reachesWhatCanBeReached()
{
    QFETCH(int, joints);
    const std::vector<ArmJoint> arm = limitedArm(static_cast<std::size_t>(joints));
    ArmSolverParams params;
    params.tolerance = 1e-4 * joints;
    Random random(2, RandomStream::Test);
    constexpr int targets = 10000;
    int reached = 0, quick = 0, calls = 0;
    std::int64_t total = 0;
    for (int t = 0; t < targets; ++t) {
        const glm::dvec3 target = reachableTarget(arm, random);
        ArmSolver solver(arm, params);
        solver.setTarget(target);
        const bool good = solver.solve(50) == ArmStatus::Reached;
        QCOMPARE(good, glm::distance(solver.chain().tip(), target) <= params.tolerance);
        QVERIFY(mostOver(arm, solver.angles()) <= 0.0);
        reached += good;
        quick += good && solver.figures().steps <= 15;
        total += solver.figures().steps;
        calls += solver.figures().starts;
    }
    qInfo("%d reached, %d within 15 steps, mean %.1f steps, %d further starts", reached, quick,
          double(total) / targets, calls);
    QVERIFY(reached >= targets * 999 / 1000);
    QVERIFY(quick >= targets * 95 / 100);
}

void TestArmSolver::settlesOutOfReach_data()
{
    QTest::addColumn<int>("joints");
    QTest::addColumn<double>("distance");
    for (const int joints : {1, 2, 3, 5, 10, 20, 64})
        for (const double distance : {0.0, 0.3, 0.99999, 1.0, 1.001, 1.5, 100.0, 1e9})
            QTest::addRow("%d at %g", joints, distance) << joints << distance;
}

/// With and without limits; behind limits near targets are out of reach too.
void TestArmSolver::settlesOutOfReach()
{
    QFETCH(int, joints);
    QFETCH(double, distance);
    Random random(3, RandomStream::Test);
    for (const bool limits : {true, false}) {
        std::vector<ArmJoint> arm = limitedArm(static_cast<std::size_t>(joints));
        for (ArmJoint& joint : arm)
            joint.phi.limited = joint.theta.limited = limits;
        for (int t = 0; t < 20; ++t) {
            ArmSolver solver(arm, {});
            const glm::dvec3 target = unitVector(random) * (distance * joints);
            solver.setTarget(target);
            solver.solve(50);
            const std::vector<double> before(solver.angles().begin(), solver.angles().end());
            QVERIFY(solver.figures().status != ArmStatus::Moving);
            for (int step = 0; step < 10; ++step)
                QVERIFY(!solver.step());
            QVERIFY(std::ranges::equal(before, solver.angles()));
            QVERIFY(std::isfinite(solver.figures().residual));
            for (const double angle : before)
                QVERIFY(std::isfinite(angle));
            if (!limits && distance > 1.0) {
                const double missing = glm::length(target) - joints;
                QVERIFY(solver.figures().shortBy() >= missing * (1.0 - 1e-12));
                QVERIFY2(solver.figures().shortBy() <= missing + 0.002 * joints,
                         qPrintable(QString::number(solver.figures().shortBy() - missing)));
            }
        }
    }
}

/// All columns of phi vanish, those of theta are at right angles to a target in line with the arm.
void TestArmSolver::aStraightArmStartsToo()
{
    const std::vector<ArmJoint> arm(4);
    for (const double height : {2.0, 0.5, -3.0}) {
        ArmSolver solver(arm, {});
        solver.setTarget({0.0, 0.0, height});
        QCOMPARE(solver.solve(), ArmStatus::Reached);
    }
}

void TestArmSolver::isTheSameEveryTime()
{
    const std::vector<ArmJoint> arm = limitedArm(2);
    Random random(4, RandomStream::Test);
    for (int t = 0; t < 50; ++t) {
        const glm::dvec3 target = unitVector(random) * 1.5;
        ArmSolver a(arm, {}), b(arm, {});
        a.setTarget({0.5, 0.2, 0.7});
        a.solve();
        a.setAngles(armAngles(arm));
        a.setTarget(target);
        b.setTarget(target);
        a.solve();
        b.solve();
        QVERIFY(std::ranges::equal(a.angles(), b.angles()));
        QCOMPARE(a.figures().steps, b.figures().steps);
    }
}

void TestArmSolver::limitsHold_data()
{
    QTest::addColumn<bool>("transpose");
    QTest::newRow("least squares") << false;
    QTest::newRow("transpose") << true;
}

/// A million steps in all with RAMURE_LONG_TESTS set, a tenth of them without.
void TestArmSolver::limitsHold()
{
    QFETCH(bool, transpose);
    const std::int64_t wanted = qEnvironmentVariableIsSet("RAMURE_LONG_TESTS") ? 500'000 : 50'000;
    ArmSolverParams params;
    params.kind = transpose ? ArmSolverKind::Transpose : ArmSolverKind::LeastSquares;
    Random random(5, RandomStream::Test);
    std::int64_t steps = 0;
    for (std::size_t joints = 1; steps < wanted; joints = joints % 12 + 1) {
        std::vector<ArmJoint> arm = limitedArm(joints);
        for (ArmJoint& joint : arm) {
            joint.phi.minRad = random.range(-4.0, 0.0);
            joint.phi.maxRad = random.range(0.0, 4.0);
            joint.theta.minRad = random.range(-2.0, 0.0);
            joint.theta.maxRad = random.range(0.0, 2.0);
        }
        ArmSolver solver(arm, params);
        for (int t = 0; t < 20; ++t) {
            solver.setTarget(unitVector(random) * random.range(0.0, 1.5 * double(joints)));
            for (int step = 0; step < 100 && solver.step(); ++step, ++steps)
                QVERIFY(mostOver(arm, solver.angles()) <= 1e-9);
        }
    }
}

void TestArmSolver::tellsWhatHappened()
{
    ArmSolver solver(defaultArmJoints(), {});
    solver.setTarget({2.0, 1.0, 2.0});
    QCOMPARE(solver.figures().status, ArmStatus::Moving);
    QCOMPARE(solver.figures().residuals.size(), std::size_t(1));
    const double before = solver.figures().residual;
    int calls = 0;
    while (solver.step())
        ++calls;
    QCOMPARE(solver.figures().status, ArmStatus::Reached);
    QCOMPARE(solver.figures().residuals.size(), std::size_t(calls + 2));
    QVERIFY(solver.figures().residual < before);
    QCOMPARE(solver.figures().shortBy(), 0.0);
    QVERIFY(std::ranges::is_sorted(solver.figures().residuals, std::ranges::greater{}));
    solver.setTarget(solver.chain().tip());
    QCOMPARE(solver.figures().status, ArmStatus::Reached);
    QCOMPARE(solver.figures().steps, std::int64_t(0));
}

RAMURE_SUITE(TestArmSolver)

} // namespace tst_arm_solver

#include "tst_arm_solver.moc"
