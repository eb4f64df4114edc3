#include "core/math/random.h"
#include "core/rig/arm/arm_chain.h"
#include "tests/support/suite.h"
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <limits>

namespace tst_arm_chain {

using namespace ramure;
using namespace ramure::test;

class TestArmChain : public QObject
{
    Q_OBJECT

private slots:
    void init() { failOnAnyWarning(); }
    void wrongArmsAreErrors_data();
    void wrongArmsAreErrors();
    void anglesGoThereAndBack();
    void anglesWrap();
    void theDefaultTip();
    void matricesSayTheSame();
    void theJacobianIsTheDerivative_data();
    void theJacobianIsTheDerivative();
    void reachIsTheFarthestAndTheNearest();
    void thePoseMovesTheStraightArm();
};

namespace {

constexpr double pi = std::numbers::pi;

std::vector<ArmJoint> randomArm(std::size_t count, std::uint64_t seed)
{
    Random random(seed, RandomStream::Test);
    std::vector<ArmJoint> joints(count);
    for (ArmJoint& joint : joints) {
        joint.length = random.range(0.1, 2.0);
        joint.phi.angleRad = random.range(-pi, pi);
        joint.theta.angleRad = random.range(-pi, pi);
    }
    return joints;
}

} // namespace

void TestArmChain::wrongArmsAreErrors_data()
{
    QTest::addColumn<std::vector<ArmJoint>>("joints");
    QTest::addColumn<QByteArray>("path");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QTest::newRow("none") << std::vector<ArmJoint>{} << QByteArray("joints");
    QTest::newRow("65") << std::vector<ArmJoint>(65) << QByteArray("joints");
    const auto changed = [](auto change) {
        std::vector<ArmJoint> joints = defaultArmJoints();
        change(joints[1]);
        return joints;
    };
    QTest::newRow("no length") << changed([](ArmJoint& j) { j.length = 0.0; })
                               << QByteArray("joints[1].length");
    QTest::newRow("endless") << changed([](ArmJoint& j) { j.length = 1.0 / 0.0; })
                             << QByteArray("joints[1].length");
    QTest::newRow("no number") << changed([=](ArmJoint& j) { j.phi.angleRad = nan; })
                               << QByteArray("joints[1].phi.angleRad");
    QTest::newRow("limits") << changed([](ArmJoint& j) { j.theta.minRad = 4.0; })
                            << QByteArray("joints[1].theta.minRad");
    QTest::newRow("speed") << changed([](ArmJoint& j) { j.theta.mostSpeed = -1.0; })
                           << QByteArray("joints[1].theta.mostSpeed");
}

void TestArmChain::wrongArmsAreErrors()
{
    QFETCH(std::vector<ArmJoint>, joints);
    QFETCH(QByteArray, path);
    const Expected<void> checked = checkArm(joints);
    QVERIFY(!checked);
    QCOMPARE(checked.error().code, ErrorCode::Invalid);
    QCOMPARE(QByteArray::fromStdString(checked.error().path), path);
}

void TestArmChain::anglesGoThereAndBack()
{
    QVERIFY(checkArm(defaultArmJoints()));
    const std::vector<ArmJoint> joints = randomArm(5, 1);
    std::vector<ArmJoint> other = randomArm(5, 2);
    setArmAngles(other, armAngles(joints));
    QCOMPARE(armAngles(other), armAngles(joints));
}

void TestArmChain::anglesWrap()
{
    QCOMPARE(wrappedAngle(1.0), 1.0);
    QCOMPARE(wrappedAngle(-pi), -pi);
    for (int turns = -3; turns <= 3; ++turns)
        QVERIFY(std::abs(wrappedAngle(0.5 + 2.0 * pi * turns) - 0.5) < 1e-12);
}

void TestArmChain::theDefaultTip()
{
    const ArmChain chain(defaultArmJoints());
    const glm::dvec3 tip(1.7177032, 2.0079169, 3.4335330);
    QVERIFY2(glm::distance(chain.tip(), tip) < 1e-6,
             qPrintable(QStringLiteral("%1 %2 %3").arg(chain.tip().x).arg(chain.tip().y).arg(chain.tip().z)));
}

void TestArmChain::matricesSayTheSame()
{
    const std::vector<ArmJoint> joints = randomArm(7, 3);
    const ArmChain chain(joints);
    glm::dmat4 m(1.0);
    for (std::size_t j = 0; j < joints.size(); ++j) {
        m = glm::rotate(m, joints[j].phi.angleRad, glm::dvec3(0, 0, 1));
        m = glm::rotate(m, joints[j].theta.angleRad, glm::dvec3(0, 1, 0));
        for (int c = 0; c < 3; ++c)
            QVERIFY(glm::distance(chain.frame(j)[c], glm::dvec3(m[c])) < 1e-12);
        m = glm::translate(m, glm::dvec3(0, 0, joints[j].length));
        QVERIFY(glm::distance(chain.points()[j + 1], glm::dvec3(m[3])) < 1e-12);
    }
}

void TestArmChain::theJacobianIsTheDerivative_data()
{
    QTest::addColumn<int>("joints");
    for (const int joints : {1, 2, 3, 10, 64})
        QTest::addRow("%d", joints) << joints;
}

void TestArmChain::theJacobianIsTheDerivative()
{
    QFETCH(int, joints);
    constexpr double h = 1e-5;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const std::vector<ArmJoint> arm = randomArm(static_cast<std::size_t>(joints), seed);
        ArmChain chain(arm);
        std::vector<glm::dvec3> columns(chain.angleCount());
        chain.jacobian(columns);
        std::vector<double> angles = armAngles(arm);
        for (std::size_t i = 0; i < angles.size(); ++i) {
            const double at = angles[i];
            angles[i] = at + h;
            chain.setAngles(angles);
            const glm::dvec3 after = chain.tip();
            angles[i] = at - h;
            chain.setAngles(angles);
            const glm::dvec3 slope = (after - chain.tip()) / (2.0 * h);
            angles[i] = at;
            QVERIFY2(glm::distance(slope, columns[i]) < 1e-6, qPrintable(QString::number(i)));
        }
    }
}

void TestArmChain::reachIsTheFarthestAndTheNearest()
{
    std::vector<ArmJoint> joints(3);
    joints[0].length = 5.0;
    const ArmChain chain(joints);
    QCOMPARE(chain.reach(), 7.0);
    QCOMPARE(chain.leastReach(), 3.0);
    QCOMPARE(ArmChain(defaultArmJoints()).leastReach(), 0.0);
}

void TestArmChain::thePoseMovesTheStraightArm()
{
    const std::vector<ArmJoint> joints = randomArm(6, 4);
    const ArmChain chain(joints);
    std::vector<RigidTransform> bones;
    chain.pose(bones);
    double height = 0.0;
    for (std::size_t j = 0; j < joints.size(); ++j) {
        QVERIFY(glm::distance(bones[j].point({0, 0, height}), chain.points()[j]) < 1e-12);
        height += joints[j].length;
        QVERIFY(glm::distance(bones[j].point({0, 0, height}), chain.points()[j + 1]) < 1e-12);
        QVERIFY(glm::distance(bones[j].direction({1, 0, 0}), chain.frame(j)[0]) < 1e-12);
    }
}

RAMURE_SUITE(TestArmChain)

} // namespace tst_arm_chain

#include "tst_arm_chain.moc"
