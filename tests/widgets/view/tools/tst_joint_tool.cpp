#include "core/qt/document/commands.h"
#include "tests/support/suite.h"
#include "tests/support/tool_bench.h"
#include "widgets/view/tools/arm/arm_rings.h"

namespace tst_joint_tool {

using namespace ramure;

/// Joints are turned by their rings.
class TestJointTool : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void ringsOfOtherArmsAreNotTaken();
    void aDragTurnsTheJointInOneStep();
    void escapeTakesItBack();
};

namespace {

/// An arm that is selected, seen from above: the ring of its first joint lies flat.
struct Bench : test::ToolBench
{
    Bench()
    {
        Node arm;
        arm.id = 1;
        arm.kind = NodeKind::Arm;
        arm.name = "arm";
        arm.params.joints.resize(3);
        open(Scene::fromNodes({arm}).value_or(Scene()));
        document.setSelection({{1}, noNode, {}, noIndex});
        camera.pitchRad = 0.7;
    }
    [[nodiscard]] ArmRing ring() const { return armRings(document.scene(), 1).front(); }
    [[nodiscard]] QPointF at(double more) const { return pixelOf(ring().at(ring().angle.angleRad + more)); }
    [[nodiscard]] double angle() const { return ring().angle.angleRad; }
    using ToolBench::at;
};

} // namespace

void TestJointTool::ringsOfOtherArmsAreNotTaken()
{
    Bench bench;
    QVERIFY(bench.says("turn the joint", bench.at(0.0)));
    bench.document.setSelection({});
    QVERIFY(!bench.says("turn the joint", bench.at(0.0)));
    const double before = bench.angle();
    bench.drag(bench.at(0.0), bench.at(0.5));
    QCOMPARE(bench.angle(), before);
    bench.document.setSelection({{1}, noNode, {}, noIndex});
    bench.drag(bench.at(0.0), bench.at(0.5), Qt::LeftButton, Qt::ShiftModifier);
    QCOMPARE(bench.angle(), before);
}

void TestJointTool::aDragTurnsTheJointInOneStep()
{
    Bench bench;
    const double before = bench.angle();
    const QPointF from = bench.at(0.0), to = bench.at(0.5);
    bench.drag(from, to);
    QVERIFY(std::abs(bench.angle() - before - 0.5) < 0.01);
    QCOMPARE(bench.document.undoStack()->count(), 1);
    bench.document.undo();
    QCOMPARE(bench.angle(), before);
}

void TestJointTool::escapeTakesItBack()
{
    Bench bench;
    const Scene before = bench.document.scene();
    const QPointF to = bench.at(0.5);
    bench.press(bench.at(0.0));
    bench.move(to);
    QVERIFY(!(bench.document.scene() == before));
    QVERIFY(bench.says("release"));
    QVERIFY(bench.key(Qt::Key_Escape));
    QVERIFY(bench.document.scene() == before);
    QCOMPARE(bench.document.undoStack()->count(), 0);
}

RAMURE_SUITE(TestJointTool)

} // namespace tst_joint_tool

#include "tst_joint_tool.moc"
