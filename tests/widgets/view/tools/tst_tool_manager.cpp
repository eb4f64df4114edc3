#include "tests/support/suite.h"
#include "tests/support/tool_bench.h"
#include "widgets/view/tools/tool_table.h"

namespace tst_tool_manager {

using namespace ramure;

/// Which tool gets what the mouse and the keys do.
class TestToolManager : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void whatNobodyTakesIsLeft();
    void theFirstThatClaimsAPressKeepsIt();
    void everyRowOfTheTableMakesATool();
};

void TestToolManager::whatNobodyTakesIsLeft()
{
    test::ToolBench bench;
    bench.style = NavigationStyle::Maya;
    QVERIFY(!bench.press({20.0, 20.0}, Qt::MiddleButton));
    QVERIFY(!bench.move({30.0, 20.0}));
    bench.release({30.0, 20.0}, Qt::MiddleButton);
    QVERIFY(!bench.key(Qt::Key_Escape) && !bench.key(Qt::Key_G));
    QVERIFY(!bench.tools.doubleClick(bench.at({20.0, 20.0}, Qt::LeftButton)));
    QVERIFY(!bench.tools.hover(bench.at({20.0, 20.0})));
    QCOMPARE(bench.tools.cursor().shape(), Qt::ArrowCursor);
}

void TestToolManager::theFirstThatClaimsAPressKeepsIt()
{
    test::ToolBench bench;
    const QPointF cube(734.0, 58.0);
    QVERIFY(bench.press(cube, Qt::LeftButton, Qt::AltModifier)); // Alt turns the view; here it is the cube's
    Tool* holder = bench.tools.current();
    QVERIFY(holder && holder->button() == Qt::LeftButton);
    QVERIFY(bench.press({400.0, 300.0}, Qt::MiddleButton));
    QCOMPARE(bench.tools.current(), holder);
    bench.release({400.0, 300.0}, Qt::MiddleButton);
    QCOMPARE(bench.tools.current(), holder);
    bench.release(cube);
    QVERIFY(!bench.tools.current() && bench.side);
}

void TestToolManager::everyRowOfTheTableMakesATool()
{
    test::ToolBench bench;
    for (const ToolMaker make : toolTable) {
        const std::unique_ptr<Tool> tool = make(bench.context);
        QVERIFY(tool && !tool->isBusy() && !tool->goesOn());
    }
}

RAMURE_SUITE(TestToolManager)

} // namespace tst_tool_manager

#include "tst_tool_manager.moc"
