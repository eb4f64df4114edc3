#include "tests/support/suite.h"
#include "widgets/window/tool_box.h"
#include <QAction>
#include <QToolButton>

namespace tst_tool_box {

using namespace ramure;

/// The tool bar at the view's edge.
class TestToolBox : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void withoutToolsItIsEmpty()
    {
        ToolBox box;
        box.show();
        QVERIFY(box.buttons().isEmpty());
        box.addGroup({});
        QVERIFY(box.minimumSizeHint().isValid());
    }
    void allToolsAreSeenInLowWindows()
    {
        QObject owner;
        ToolBox box;
        qsizetype tools = 0;
        for (const int count : {4, 7, 1}) {
            QList<QAction*> group;
            for (int i = 0; i < count; ++i)
                group += new QAction(QStringLiteral("tool"), &owner);
            box.addGroup(group);
            tools += count;
        }
        QCOMPARE(box.buttons().size(), tools);
        box.show();
        int widest = 0;
        for (const int height : {600, box.minimumSizeHint().height(), 600}) {
            box.resize(box.minimumSizeHint().width(), height);
            QTRY_COMPARE(box.buttons()[2]->y() > box.buttons()[0]->y(), height == 600);
            box.resize(box.minimumSizeHint().width(), height);
            QTRY_VERIFY(box.rect().contains(box.buttons().back()->geometry()));
            QRegion covered;
            for (const QToolButton* button : box.buttons()) {
                QVERIFY(button->isVisible() && box.rect().contains(button->geometry()));
                QVERIFY(!covered.intersects(button->geometry()));
                covered += button->geometry();
            }
            QVERIFY(height == 600 || box.width() > widest);
            widest = box.width();
        }
    }
    void aButtonChoosesItsTool()
    {
        QAction tool(QStringLiteral("tool"));
        tool.setCheckable(true);
        ToolBox box;
        box.addGroup({&tool});
        box.buttons().front()->click();
        QVERIFY(tool.isChecked());
    }
};

RAMURE_SUITE(TestToolBox)

} // namespace tst_tool_box

#include "tst_tool_box.moc"
