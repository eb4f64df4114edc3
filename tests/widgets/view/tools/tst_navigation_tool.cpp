#include "tests/support/suite.h"
#include "tests/support/tool_bench.h"

namespace tst_navigation_tool {

using namespace ramure;

/// Turning, moving and zooming the view with the mouse.
class TestNavigationTool : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void otherButtonsAreNotItsOwn();
    void aDragMovesTheCameraUntilTheRelease();
    void escapeTakesItBack();
    void theWheelZoomsToTheCursor();
    void theHintSaysWhatIsDone();
};

namespace {

constexpr QPointF middle(400.0, 300.0);

} // namespace

void TestNavigationTool::otherButtonsAreNotItsOwn()
{
    test::ToolBench bench;
    bench.style = NavigationStyle::Maya;
    QVERIFY(!bench.press(middle, Qt::MiddleButton));
    QVERIFY(!bench.press(middle, Qt::BackButton, Qt::AltModifier));
    QVERIFY(!bench.tools.current());
}

void TestNavigationTool::aDragMovesTheCameraUntilTheRelease()
{
    test::ToolBench bench;
    const Camera before = bench.camera;
    QVERIFY(bench.press(middle, Qt::MiddleButton));
    QVERIFY(bench.tools.goesOn());
    QVERIFY(bench.press(middle, Qt::LeftButton)); // a second button does nothing
    bench.release(middle, Qt::LeftButton);
    QVERIFY(bench.move(middle + QPointF(40.0, 0.0)));
    QVERIFY(bench.camera.yawRad < before.yawRad);
    QCOMPARE(bench.camera.distance, before.distance);
    bench.release(middle, Qt::MiddleButton);
    const Camera turned = bench.camera;
    QVERIFY(!bench.move(middle));
    QCOMPARE(bench.camera, turned);
    bench.drag(middle, middle + QPointF(0.0, 50.0), Qt::LeftButton, Qt::AltModifier | Qt::ControlModifier);
    QVERIFY(bench.camera.distance > turned.distance);
}

void TestNavigationTool::escapeTakesItBack()
{
    test::ToolBench bench;
    const Camera before = bench.camera;
    QVERIFY(!bench.key(Qt::Key_Escape)); // nothing goes on: it means something else
    bench.press(middle, Qt::MiddleButton, Qt::ShiftModifier);
    bench.move(middle + QPointF(40.0, 30.0));
    QVERIFY(bench.camera != before);
    QVERIFY(!bench.key(Qt::Key_X));
    QVERIFY(bench.key(Qt::Key_Escape));
    QCOMPARE(bench.camera, before);
    bench.move(middle);
    bench.release(middle, Qt::MiddleButton);
    QCOMPARE(bench.camera, before);
}

void TestNavigationTool::theWheelZoomsToTheCursor()
{
    test::ToolBench bench;
    const Camera before = bench.camera;
    QVERIFY(bench.tools.wheel(bench.at(middle), 0.0));
    QCOMPARE(bench.camera, before);
    const QPointF aside(600.0, 200.0);
    const PickView view = bench.view();
    const glm::dvec3 there = before.pointAtTargetDepth(view.ndc({600.0, 200.0}), view.aspect());
    QVERIFY(bench.tools.wheel(bench.at(aside), 120.0));
    QVERIFY(bench.camera.distance < before.distance);
    QVERIFY((bench.pixelOf(there) - aside).manhattanLength() < 1e-6);
}

void TestNavigationTool::theHintSaysWhatIsDone()
{
    test::ToolBench bench;
    QVERIFY(bench.says("Ctrl + middle", middle, Qt::ControlModifier));
    QVERIFY(bench.says("middle or Alt"));
    bench.style = NavigationStyle::Maya;
    QVERIFY(!bench.says("middle", middle, Qt::ControlModifier));
    QVERIFY(bench.says("middle: moves", middle, Qt::AltModifier));
    for (const Qt::KeyboardModifiers held : {Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier}) {
        bench.press(middle, Qt::LeftButton, held | Qt::AltModifier);
        QVERIFY(bench.says("release"));
        bench.release(middle);
    }
}

RAMURE_SUITE(TestNavigationTool)

} // namespace tst_navigation_tool

#include "tst_navigation_tool.moc"
