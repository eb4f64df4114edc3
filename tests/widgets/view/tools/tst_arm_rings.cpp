#include "core/rig/arm/arm_chain.h"
#include "core/scene/arm_demo.h"
#include "tests/support/suite.h"
#include "widgets/view/tools/arm/arm_rings.h"
#include <cmath>
#include <numbers>

namespace tst_arm_rings {

using namespace ramure;

class TestArmRings : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnAnyWarning(); }
    void otherNodesHaveNone();
    void knobsShowTheAngles();
    void ringsAreFoundWhereTheyAre();
    void draggingAKnobTurnsTheArm();
    void limitsHold();
};

namespace {

constexpr double pi = std::numbers::pi;

PickView viewOf(double yaw = 0.6)
{
    PickView view;
    view.size = {800.0, 600.0};
    view.camera.yawRad = yaw;
    view.camera.pitchRad = 0.4;
    Box box;
    box.add({-3.0, 0.0, -3.0});
    box.add({3.0, 4.0, 3.0});
    view.camera.frame(box, view.aspect());
    return view;
}

glm::dvec2 pixelOf(const PickView& view, const glm::dvec3& world)
{
    const auto ndc = view.camera.project(world, view.aspect());
    return 0.5 * glm::dvec2(ndc->x + 1.0, 1.0 - ndc->y) * view.size;
}

} // namespace

void TestArmRings::otherNodesHaveNone()
{
    const Scene scene = armDemo();
    QVERIFY(armRings(scene, noNode).empty());
    QVERIFY(armRings(scene, 2).empty());
    QCOMPARE(armRings(scene, 1).size(), std::size_t(6));
    QVERIFY(!ringUnder(viewOf(), {400.0, 300.0}, {}));
}

/// The knob of theta points along the segment, that of phi where theta's plane begins.
void TestArmRings::knobsShowTheAngles()
{
    Scene scene = armDemo();
    scene.find(1)->params.tree.translation = {1.0, 0.0, 2.0};
    scene.find(1)->params.tree.rotation = {0.3, 0.7, 0.0};
    const auto rings = armRings(scene, 1);
    const std::vector<ArmJoint>& joints = scene.find(1)->params.joints;
    const ArmChain chain(joints);
    const glm::dmat4 world = worldMatrix(scene, 1) * armUpright();
    for (std::size_t j = 0; j < joints.size(); ++j) {
        const glm::dvec3 along =
            glm::normalize(glm::dmat3(world) * (chain.points()[j + 1] - chain.points()[j]));
        const ArmRing& theta = rings[2 * j + 1];
        const glm::dvec3 knob = (theta.at(joints[j].theta.angleRad) - theta.centre) / theta.radius;
        QVERIFY(glm::distance(knob, along) < 1e-9);
        const ArmRing& phi = rings[2 * j];
        const glm::dvec3 start = (phi.at(joints[j].phi.angleRad) - phi.centre) / phi.radius;
        QVERIFY(std::abs(glm::dot(start, glm::cross(theta.zero, theta.across))) < 1e-9);
    }
}

void TestArmRings::ringsAreFoundWhereTheyAre()
{
    const auto rings = armRings(armDemo(), 1);
    const PickView view = viewOf();
    for (std::size_t r = 0; r < rings.size(); ++r)
        for (const double angle : {-2.0, 0.3, 1.9}) {
            const auto found = ringUnder(view, pixelOf(view, rings[r].at(angle)), {rings[r]});
            QVERIFY(found);
            const auto back = ringAngle(view, pixelOf(view, rings[r].at(angle)), rings[r]);
            if (back)
                QVERIFY(std::abs(wrappedAngle(*back - angle)) < 1e-6);
        }
    QVERIFY(!ringUnder(view, {2.0, 2.0}, rings));
}

void TestArmRings::draggingAKnobTurnsTheArm()
{
    const Scene scene = armDemo();
    const auto rings = armRings(scene, 1);
    const PickView view = viewOf();
    for (const ArmRing& ring : rings) {
        const auto from = ringAngle(view, pixelOf(view, ring.at(ring.angle.angleRad)), ring);
        const auto to = ringAngle(view, pixelOf(view, ring.at(ring.angle.angleRad + 0.4)), ring);
        if (from && to)
            QVERIFY(std::abs(turnedBy(ring.angle, *from, *to) - wrappedAngle(ring.angle.angleRad + 0.4)) <
                    1e-6);
    }
}

void TestArmRings::limitsHold()
{
    const ArmAngle limited{0.2, true, -0.5, 0.5, 0.0};
    QCOMPARE(turnedBy(limited, 0.0, 1.0), 0.5);
    QCOMPARE(turnedBy(limited, 0.0, -1.0), -0.5);
    const ArmAngle free{3.0, false, -0.5, 0.5, 0.0};
    QVERIFY(std::abs(turnedBy(free, 0.0, 0.5) - (3.5 - 2.0 * pi)) < 1e-12);
    QVERIFY(std::abs(turnedBy(free, 3.0, -3.0) - wrappedAngle(3.0 + 2.0 * pi - 6.0)) < 1e-12);
}

RAMURE_SUITE(TestArmRings)

} // namespace tst_arm_rings

#include "tst_arm_rings.moc"
