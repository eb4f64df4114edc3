#include "tests/support/suite.h"
#include "tests/support/tool_bench.h"
#include <QSignalSpy>

namespace tst_menu_tool {

using namespace ramure;

/// A right click asks for a menu.
class TestMenuTool : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void aDragAsksForNone();
    void aClickDoesWhenTheButtonIsLetGo();
};

void TestMenuTool::aDragAsksForNone()
{
    test::ToolBench bench;
    QSignalSpy menu(&bench.tools.picks(), &PendingPick::menuWanted);
    bench.drag({100.0, 100.0}, {160.0, 100.0}, Qt::RightButton);
    bench.drag({100.0, 100.0}, {100.0, 100.0}, Qt::RightButton, Qt::AltModifier); // this turns the view
    QCOMPARE(menu.count(), 0);
}

void TestMenuTool::aClickDoesWhenTheButtonIsLetGo()
{
    test::ToolBench bench;
    QSignalSpy menu(&bench.tools.picks(), &PendingPick::menuWanted);
    bench.press({100.0, 100.0}, Qt::RightButton);
    QVERIFY(!bench.tools.goesOn());
    QCOMPARE(menu.count(), 0);
    bench.release({101.0, 100.0}, Qt::RightButton);
    QCOMPARE(menu.count(), 1);
    QVERIFY(!bench.tools.current());
    QVERIFY(bench.says("right: menu"));
}

RAMURE_SUITE(TestMenuTool)

} // namespace tst_menu_tool

#include "tst_menu_tool.moc"
