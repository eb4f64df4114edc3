#include "core/qt/document/project/project_file.h"
#include "tests/support/hand_bench.h"
#include "tests/support/suite.h"
#include "widgets/view/tools/motion_tools.h"
#include <random>

namespace tst_interrupted_gestures {

using namespace ramure;
using test::HandBench;

/// While a hand drags, somebody undoes, or does something else: by a shortcut, or in the background.
class TestInterruptedGestures : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void undoGivesUpTheStroke();
    void undoGivesUpWhatGoesOnByKeys();
    void aNodeThatIsDeletedUnderTheHandComesBackAsItWas();
    void anythingMeanwhileCanBeUndone_data();
    void anythingMeanwhileCanBeUndone();

private:
    static QByteArray bytesOf(HandBench& bench) { return writeProject(bench.document.project()); }
    static void addBox(HandBench& bench)
    {
        Node box;
        box.id = 9;
        box.kind = NodeKind::Primitive;
        box.name = "box";
        QVERIFY(edit::insertNodes(bench.document, {box}, noNode, 1));
    }
};

void TestInterruptedGestures::undoGivesUpTheStroke()
{
    HandBench bench(HandTool::Draw);
    addBox(bench);
    bench.grow();
    const QByteArray before = bytesOf(bench);
    const QPointF from = bench.on(0, 0.5);
    bench.press(from);
    for (int i = 1; i <= 8; ++i)
        bench.move(from + QPointF(12.0 * i, -4.0 * i));
    QVERIFY(!bench.edits().empty());
    QVERIFY(bench.document.history().canUndo());
    bench.document.undo();
    QVERIFY(!bench.tools.current());
    QCOMPARE(bytesOf(bench), before);
    // The rest of the drag does nothing.
    bench.move(from + QPointF(150.0, -60.0));
    bench.release(from + QPointF(150.0, -60.0));
    QCOMPARE(bytesOf(bench), before);
    QCOMPARE(bench.document.undoStack()->count(), 1);
    bench.document.undo();
    QCOMPARE(bench.document.scene().nodes().size(), std::size_t(1));
    bench.document.redo();
    QCOMPARE(bytesOf(bench), before);
}

void TestInterruptedGestures::undoGivesUpWhatGoesOnByKeys()
{
    HandBench bench(HandTool::Length);
    const QByteArray before = bytesOf(bench);
    bench.click(bench.on(0, 0.5));
    QVERIFY(bench.tools.current());
    bench.key(Qt::Key_2, QStringLiteral("2"));
    QVERIFY(bytesOf(bench) != before);
    const QKeyEvent undo(QEvent::KeyPress, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(!bench.tools.takesKey(undo)); // it stays a shortcut
    bench.document.undo();
    QVERIFY(!bench.tools.current());
    QCOMPARE(bytesOf(bench), before);
}

void TestInterruptedGestures::aNodeThatIsDeletedUnderTheHandComesBackAsItWas()
{
    HandBench bench(HandTool::Draw);
    const QByteArray before = bytesOf(bench);
    const QPointF from = bench.on(0, 0.5);
    bench.press(from);
    for (int i = 1; i <= 8; ++i)
        bench.move(from + QPointF(12.0 * i, -4.0 * i));
    const QByteArray drawn = bytesOf(bench);
    QVERIFY(edit::removeNodes(bench.document, {1}));
    QVERIFY(!bench.tools.current());
    bench.move(from);
    bench.release(from);
    QCOMPARE(bench.document.undoStack()->count(), 2);
    bench.document.undo();
    QCOMPARE(bytesOf(bench), drawn);
    bench.document.undo();
    QCOMPARE(bytesOf(bench), before);
}

void TestInterruptedGestures::anythingMeanwhileCanBeUndone_data()
{
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 12; ++seed)
        QTest::addRow("%d", seed) << seed;
}

/// Any tools; in the middle of their gestures anything else.
void TestInterruptedGestures::anythingMeanwhileCanBeUndone()
{
    QFETCH(int, seed);
    std::mt19937 random(static_cast<unsigned>(seed));
    const auto below = [&random](int most) { return static_cast<int>(random() % unsigned(most)); };
    HandBench bench(HandTool::None);
    Document& document = bench.document;
    const QByteArray first = bytesOf(bench);
    const auto meanwhile = [&] {
        switch (below(5)) {
        case 0:
            return document.undo();
        case 1:
            return document.redo();
        case 2:
            document.history().settle();
            return document.markSaved();
        case 3:
            return (void)edit::setParam(document, {1}, *findParam("physics.windStrength"), double(below(9)));
        default:
            return (void)edit::setNodeName(document, 1, QString::number(below(9)));
        }
    };
    for (int gesture = 0; gesture < 20; ++gesture) {
        bench.hand.setTool(handTools()[std::size_t(below(int(handTools().size())))].tool);
        const QPointF at = bench.on(Index(below(int(bench.skeleton().size()))), 0.1 * below(10));
        bench.press(at);
        for (int i = below(7); i > 0; --i) {
            bench.move(at + QPointF(below(300) - 150, below(300) - 150));
            if (below(4) == 0)
                meanwhile();
        }
        bench.release(at + QPointF(below(100), below(100)));
        if (bench.tools.current())
            bench.key(Qt::Key_Return);
        QVERIFY(!bench.tools.current());
        QVERIFY(!document.history().isHolding());
        bench.grow();
    }
    while (document.undoStack()->canRedo()) // some may have been undone before
        document.redo();
    const QByteArray last = bytesOf(bench);
    while (document.undoStack()->canUndo())
        document.undo();
    QCOMPARE(bytesOf(bench), first);
    while (document.undoStack()->canRedo())
        document.redo();
    QCOMPARE(bytesOf(bench), last);
}

RAMURE_SUITE(TestInterruptedGestures)

} // namespace tst_interrupted_gestures

#include "tst_interrupted_gestures.moc"
