#include "tests/support/suite.h"
#include "tests/support/tool_bench.h"
#include "widgets/view/tools/navigation_cube.h"

namespace tst_cube_tool {

using namespace ramure;

/// The navigation cube under the mouse.
class TestCubeTool : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void besideItNothingIsTaken();
    void aClickLooksFromTheSide();
    void aDragTurnsTheView();
    void itIsPaintedAboveAll();
};

namespace {

QPointF cube()
{
    return NavigationCube::place({800, 600}).center();
}

} // namespace

void TestCubeTool::besideItNothingIsTaken()
{
    test::ToolBench bench;
    QVERIFY(!bench.tools.hover(bench.at({10.0, 10.0})));
    bench.press(cube(), Qt::RightButton); // whoever takes that, it is not the cube
    QVERIFY(!bench.says("The view turns", cube()));
    QVERIFY(!bench.says("from this side"));
}

void TestCubeTool::aClickLooksFromTheSide()
{
    test::ToolBench bench;
    const Camera before = bench.camera;
    QVERIFY(bench.tools.hover(bench.at(cube())));
    QVERIFY(bench.says("from this side"));
    QVERIFY(bench.press(cube()));
    bench.move(cube() + QPointF(1.0, 0.0)); // a hand is never still
    bench.release(cube());
    QCOMPARE(bench.camera, before);
    QCOMPARE(bench.side, NavigationCube::sideAt(before, {800, 600}, cube()));
    bench.tools.leave();
    QVERIFY(!bench.tools.isHovering());
}

void TestCubeTool::aDragTurnsTheView()
{
    test::ToolBench bench;
    const Camera before = bench.camera;
    bench.drag(cube(), cube() + QPointF(-80.0, 0.0));
    QVERIFY(bench.camera.yawRad != before.yawRad);
    QVERIFY(!bench.side);
    const Camera turned = bench.camera;
    bench.press(cube());
    bench.move({300.0, 300.0});
    QVERIFY(bench.key(Qt::Key_Escape));
    QCOMPARE(bench.camera, turned);
}

void TestCubeTool::itIsPaintedAboveAll()
{
    test::ToolBench bench;
    QImage image(800, 600, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    bench.tools.paint(painter, bench.view());
    painter.end();
    QVERIFY(image.pixelColor(cube().toPoint() + QPoint(0, 20)).alpha() > 200);
}

RAMURE_SUITE(TestCubeTool)

} // namespace tst_cube_tool

#include "tst_cube_tool.moc"
