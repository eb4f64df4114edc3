#include "core/math/random.h"
#include "tests/document/commands_fixture.h"
#include "tests/support/suite.h"
#include <QRegularExpression>
#include <QSignalSpy>

namespace tst_undo_steps {

using namespace ramure;
using namespace ramure::test;

/// How commands and gestures become steps of undo, whatever else is done in between.
class TestUndoSteps : public QObject
{
    Q_OBJECT

private slots:
    void init() { failOnAnyWarning(); }

    void aCommandWithinAnotherIsRefused();
    void stepsWithoutCommandsAreNone();
    void severalCommandsAreOneStep();
    void aGestureOfSeveralKindsIsOneStep();
    void aKeptGestureJoinsTheLastStep();
    void aGestureGivenUpLeavesTheLastStep();
    void afterSavingItIsAStepOfItsOwn();

    void somebodyElsesCommandKeepsTheGesture();
    void undoGivesUpTheGesture();
    void redoGivesUpTheGesture();
    void savingKeepsTheGesture();
    void anotherDocumentForgetsTheGesture();
    void tenThousandInterleavings();

    void theOldestStepsGo();
    void sharedDataCountsOnce();

private:
    static Expected<void> place(Document& document, NodeId node, double x, GestureId gesture = 0)
    {
        return edit::setParam(document, {node}, *findParam("tree.translation"), glm::dvec3(x, 0.0, 0.0),
                              gesture);
    }
    static double placeOf(const Document& document, NodeId node)
    {
        return document.scene().find(node)->params.tree.translation.x;
    }
    static GestureId hold(Document& document)
    {
        const GestureId gesture = newGesture();
        document.holdGesture(gesture);
        return gesture;
    }
    /// Duplicates node 4 and moves the copy, as the hand does. \return the gesture
    static GestureId copyAndMove(Fixture& f)
    {
        const auto copies = edit::duplicateNodes(f.document, {4});
        const GestureId gesture = hold(f.document);
        f.document.history().joinToLast(gesture);
        for (const double x : {1.0, 2.5})
            (void)place(f.document, copies->front(), x, gesture);
        return gesture;
    }
    static void undoAndRedoAll(Document& document, const QByteArray& first);
};

void TestUndoSteps::undoAndRedoAll(Document& document, const QByteArray& first)
{
    while (document.undoStack()->canRedo()) // some may have been undone before
        document.redo();
    const QByteArray last = fileOf(document);
    while (document.undoStack()->canUndo())
        document.undo();
    QCOMPARE(fileOf(document), first);
    while (document.undoStack()->canRedo())
        document.redo();
    QCOMPARE(fileOf(document), last);
}

void TestUndoSteps::aCommandWithinAnotherIsRefused()
{
    Fixture f;
    bool tries = true;
    connect(&f.document, &Document::changed, this, [&](const Change&) {
        if (std::exchange(tries, false))
            (void)place(f.document, 3, 7.0);
    });
    QTest::ignoreMessage(QtWarningMsg, QRegularExpression(QStringLiteral("in the middle of another")));
    QVERIFY(place(f.document, 2, 1.0));
    QCOMPARE(placeOf(f.document, 3), 0.0);
    QCOMPARE(f.stack.count(), 1);
    tries = true;
    QTest::ignoreMessage(QtWarningMsg, QRegularExpression(QStringLiteral("in the middle of another")));
    f.document.undo();
    QCOMPARE(f.stack.count(), 1);
    QVERIFY(f.stack.canRedo());
    QCOMPARE(placeOf(f.document, 3), 0.0);
}

void TestUndoSteps::stepsWithoutCommandsAreNone()
{
    Fixture f;
    QVERIFY(place(f.document, 2, 1.0));
    f.document.undo();
    {
        const OneStep step(f.document, QStringLiteral("nothing"));
    }
    f.document.keepGesture(hold(f.document));
    QVERIFY(f.document.giveUpGesture(hold(f.document)));
    QVERIFY(f.stack.canRedo());
    // A gesture that ends where it began.
    const GestureId gesture = hold(f.document);
    for (const double x : {3.0, 0.0})
        QVERIFY(place(f.document, 2, x, gesture));
    f.document.keepGesture(gesture);
    QVERIFY(f.stack.canRedo());
    QVERIFY(!f.document.isModified());
}

void TestUndoSteps::severalCommandsAreOneStep()
{
    Fixture f;
    const QByteArray before = fileOf(f.document);
    {
        const OneStep step(f.document, QStringLiteral("both"));
        QVERIFY(place(f.document, 2, 1.0));
        {
            const OneStep within(f.document, QStringLiteral("within"));
            QVERIFY(edit::removeNodes(f.document, {3}));
        }
        f.document.undo(); // not in the middle of it
        QVERIFY(place(f.document, 2, 4.0));
    }
    QCOMPARE(f.stack.count(), 1);
    QCOMPARE(f.stack.undoText(), QStringLiteral("both"));
    undoAndRedoAll(f.document, before);
}

void TestUndoSteps::aGestureOfSeveralKindsIsOneStep()
{
    Fixture f;
    const QByteArray before = fileOf(f.document);
    const GestureId gesture = hold(f.document);
    TimelineSettings timeline;
    for (const int i : {1, 2, 3}) {
        QVERIFY(place(f.document, 2, i, gesture));
        timeline.lastFrame = 100 + i;
        QVERIFY(edit::setTimeline(f.document, timeline, gesture));
    }
    QCOMPARE(f.stack.count(), 0);
    f.document.keepGesture(gesture);
    QCOMPARE(f.stack.count(), 1);
    undoAndRedoAll(f.document, before);
}

void TestUndoSteps::aKeptGestureJoinsTheLastStep()
{
    Fixture f;
    const QByteArray before = fileOf(f.document);
    f.document.keepGesture(copyAndMove(f));
    QCOMPARE(f.stack.count(), 1);
    QCOMPARE(f.document.scene().nodes().back().params.tree.translation, glm::dvec3(2.5, 0.0, 0.0));
    undoAndRedoAll(f.document, before);
    f.document.undo();
    QCOMPARE(fileOf(f.document), before);
}

void TestUndoSteps::aGestureGivenUpLeavesTheLastStep()
{
    Fixture f;
    QVERIFY(f.document.giveUpGesture(copyAndMove(f)));
    QCOMPARE(f.stack.count(), 1);
    QCOMPARE(f.document.scene().nodes().size(), std::size_t(5));
    QCOMPARE(f.document.scene().nodes().back().params.tree.translation, glm::dvec3(0.0));
    // What comes later is nothing of the copy's.
    const GestureId other = hold(f.document);
    QVERIFY(place(f.document, 4, 1.0, other));
    f.document.keepGesture(other);
    QCOMPARE(f.stack.count(), 2);
}

void TestUndoSteps::afterSavingItIsAStepOfItsOwn()
{
    Fixture f;
    const GestureId gesture = copyAndMove(f);
    f.document.markSaved();
    f.document.keepGesture(gesture);
    QCOMPARE(f.stack.count(), 2);
    QVERIFY(!f.stack.isClean());
}

void TestUndoSteps::somebodyElsesCommandKeepsTheGesture()
{
    Fixture f;
    QVERIFY(place(f.document, 2, 1.0));
    f.document.markSaved();
    const QSignalSpy ended(&f.document.history(), &UndoHistory::gestureEnded);
    const GestureId gesture = hold(f.document);
    QVERIFY(place(f.document, 2, 2.0, gesture));
    QVERIFY(f.document.isModified());
    QVERIFY(place(f.document, 2, 3.0));
    QCOMPARE(ended.count(), 1);
    QVERIFY(!f.document.history().isHeld(gesture));
    f.document.keepGesture(gesture);
    QCOMPARE(f.stack.count(), 3);
    f.document.undo();
    QCOMPARE(placeOf(f.document, 2), 2.0);
    f.document.undo();
    QCOMPARE(placeOf(f.document, 2), 1.0);
    QVERIFY(!f.document.isModified());
    // The commands that once went past the document.
    for (int i = 0; i < 5; ++i) {
        Fixture g;
        const QByteArray before = fileOf(g.document);
        const GestureId held = hold(g.document);
        QVERIFY(place(g.document, 2, 2.0, held));
        TimelineSettings timeline;
        timeline.lastFrame = 77;
        i == 0   ? (void)edit::setTimeline(g.document, timeline)
        : i == 1 ? (void)edit::insertNodes(g.document, {makeNode(9)}, noNode, 0)
        : i == 2 ? (void)edit::removeNodes(g.document, {2})
        : i == 3 ? (void)edit::duplicateNodes(g.document, {2})
                 : (void)edit::moveNode(g.document, 2, noNode, 0, false);
        g.document.keepGesture(held);
        QCOMPARE(g.stack.count(), 2);
        undoAndRedoAll(g.document, before);
    }
}

void TestUndoSteps::undoGivesUpTheGesture()
{
    Fixture f;
    QVERIFY(place(f.document, 2, 1.0));
    const QSignalSpy ended(&f.document.history(), &UndoHistory::gestureEnded);
    const GestureId gesture = hold(f.document);
    QVERIFY(place(f.document, 2, 2.0, gesture));
    f.document.undo();
    QCOMPARE(ended.count(), 1);
    QCOMPARE(placeOf(f.document, 2), 1.0);
    QCOMPARE(f.stack.count(), 1);
    QVERIFY(!f.document.giveUpGesture(gesture));
    // One that has changed nothing yet is no step that could be taken back.
    hold(f.document);
    QVERIFY(f.document.history().canUndo());
    f.document.undo();
    QVERIFY(!f.document.history().isHolding());
    QCOMPARE(placeOf(f.document, 2), 0.0);
    QVERIFY(!f.document.history().canUndo());
}

void TestUndoSteps::redoGivesUpTheGesture()
{
    Fixture f;
    QVERIFY(place(f.document, 2, 1.0));
    f.document.undo();
    const GestureId gesture = hold(f.document);
    QVERIFY(place(f.document, 3, 2.0, gesture));
    f.document.redo();
    QCOMPARE(placeOf(f.document, 2), 1.0);
    QCOMPARE(placeOf(f.document, 3), 0.0);
    QVERIFY(place(f.document, 3, 2.0, hold(f.document)));
    f.document.history().goToStep(0);
    QCOMPARE(placeOf(f.document, 2), 0.0);
    QCOMPARE(placeOf(f.document, 3), 0.0);
    QVERIFY(f.stack.canRedo());
}

void TestUndoSteps::savingKeepsTheGesture()
{
    Fixture f;
    const GestureId gesture = hold(f.document);
    QVERIFY(place(f.document, 2, 2.0, gesture));
    f.document.history().settle();
    const QByteArray saved = fileOf(f.document);
    f.document.markSaved();
    QVERIFY(place(f.document, 2, 3.0, gesture)); // whoever does not listen goes on
    QVERIFY(f.document.isModified());
    f.document.undo();
    QVERIFY(!f.document.isModified());
    QCOMPARE(fileOf(f.document), saved);
}

void TestUndoSteps::anotherDocumentForgetsTheGesture()
{
    Fixture f;
    const GestureId gesture = hold(f.document);
    QVERIFY(place(f.document, 2, 2.0, gesture));
    f.document.reset(*Scene::fromNodes({makeNode(2)}), {});
    f.document.keepGesture(gesture);
    QVERIFY(!f.document.giveUpGesture(gesture));
    QCOMPARE(f.stack.count(), 0);
    QVERIFY(!f.document.isModified());
}

/// Any gestures, commands, undo, redo, keeping, giving up, saving and several at once, in any order: the
/// state after so many steps is always the same.
void TestUndoSteps::tenThousandInterleavings()
{
    Random random(40, RandomStream::Test);
    const auto edit = [&random](Document& document, GestureId gesture) {
        const NodeId node = 1 + random.below(3);
        switch (random.below(gesture == 0 ? 7 : 3)) {
        case 0:
        case 1:
            return (void)place(document, node, random.below(4), gesture);
        case 2: {
            TimelineSettings timeline;
            timeline.lastFrame = 100 + random.below(3);
            return (void)edit::setTimeline(document, timeline, gesture);
        }
        case 3:
            return (void)edit::insertNodes(document, {makeNode(9)}, noNode, 0);
        case 4:
            return (void)edit::removeNodes(document, {node});
        case 5:
            return (void)edit::duplicateNodes(document, {node});
        default:
            return (void)edit::moveNode(document, node, noNode, int(random.below(3)), false);
        }
    };
    const Scene begin =
        *Scene::fromNodes({makeNode(1, noNode, NodeKind::Group), makeNode(2, 1, NodeKind::Group),
                           makeNode(3, noNode, NodeKind::Group)});
    for (int round = 0; round < 10'000; ++round) {
        Document document;
        document.reset(begin, {});
        const QByteArray first = fileOf(document);
        std::vector<std::optional<Scene>> states{begin}; // by the number of steps, where it was seen
        GestureId gesture = newGesture();
        for (std::uint32_t i = 4 + random.below(16); i-- > 0;) {
            const std::uint32_t what = random.below(12);
            const auto before = static_cast<std::size_t>(document.undoStack()->index());
            if (what < 4) {
                edit(document, gesture);
            } else if (what < 6) {
                edit(document, 0);
            } else if (what == 6) {
                gesture = newGesture();
                if (random.below(4) != 0)
                    document.holdGesture(gesture);
            } else if (what == 7) {
                document.keepGesture(gesture);
            } else if (what == 8) {
                document.giveUpGesture(gesture);
            } else if (what == 9) {
                document.undo();
            } else if (what == 10) {
                document.redo();
            } else if (random.below(2) == 0) {
                document.history().settle();
                document.markSaved();
            } else {
                const OneStep step(document, QStringLiteral("several"));
                edit(document, random.below(2) == 0 ? gesture : 0);
                edit(document, 0);
            }
            const auto index = static_cast<std::size_t>(document.undoStack()->index());
            if (!document.undoStack()->canRedo())
                states.resize(std::min(before, index) + 1);
            states.resize(std::max(states.size(), index + 1));
            if (document.history().isHolding())
                continue;
            if (what >= 8 && what <= 10 && states[index])
                QVERIFY(document.scene() == *states[index]);
            states[index] = document.scene();
        }
        document.history().settle();
        undoAndRedoAll(document, first);
        if (QTest::currentTestFailed()) {
            qInfo("in round %d", round);
            return;
        }
    }
}

void TestUndoSteps::theOldestStepsGo()
{
    Fixture f;
    const QSignalSpy forgotten(&f.document.history(), &UndoHistory::stepsForgotten);
    const auto rename = [&f](int i) {
        return edit::setParam(f.document, {2}, *findParam("grammar.axiom"),
                              std::string(100'000, char('A' + i)));
    };
    QVERIFY(rename(0));
    f.document.markSaved();
    f.document.history().setMemory(1'000'000);
    for (int i = 1; i < 20; ++i)
        QVERIFY(rename(i));
    QCOMPARE(forgotten.count(), 1);
    QVERIFY(f.stack.count() >= 8 && f.stack.count() <= 10);
    QCOMPARE(f.stack.index(), f.stack.count());
    const QByteArray last = fileOf(f.document);
    const int steps = f.stack.count();
    for (int i = 0; i < steps; ++i)
        f.document.undo();
    QCOMPARE(f.document.scene().find(2)->params.grammar.axiom[0], char('A' + 19 - steps));
    QVERIFY(f.document.isModified()); // the saved state cannot be reached any more
    for (int i = 0; i < steps; ++i)
        f.document.redo();
    QCOMPARE(fileOf(f.document), last);
    // A saved state that is still there stays the saved one.
    f.document.undo();
    f.document.markSaved();
    f.document.redo();
    QVERIFY(rename(3));
    QVERIFY(rename(4));
    for (int i = 0; i < 3; ++i)
        f.document.undo();
    QVERIFY(!f.document.isModified());
    // The last step always stays.
    f.document.history().setMemory(1);
    QVERIFY(rename(5));
    QCOMPARE(f.stack.count(), 1);
    f.document.undo();
    QCOMPARE(forgotten.count(), 1);
}

void TestUndoSteps::sharedDataCountsOnce()
{
    Document document;
    Node node = makeNode(1, noNode, NodeKind::Mesh);
    TriangleMesh mesh;
    mesh.positions.resize(100'000);
    mesh.triangles.assign(1, {0, 1, 2});
    node.mesh = SharedValue<TriangleMesh>(mesh);
    document.reset(*Scene::fromNodes({node}), {});
    document.history().setMemory(2'000'000); // one such mesh, not two
    const QSignalSpy forgotten(&document.history(), &UndoHistory::stepsForgotten);
    for (int i = 0; i < 10; ++i) { // the scene has the mesh, too
        const auto copy = edit::duplicateNodes(document, {1});
        QVERIFY(copy && edit::removeNodes(document, *copy));
    }
    QCOMPARE(document.undoStack()->count(), 20);
    for (int i = 0; i < 3; ++i) {
        mesh.positions[0].x = float(i + 1);
        node.mesh = SharedValue<TriangleMesh>(mesh);
        const auto other = edit::insertNodes(document, {node}, noNode, 0);
        QVERIFY(other && edit::removeNodes(document, {*other}));
    }
    QCOMPARE(forgotten.count(), 1);
    QVERIFY(document.undoStack()->count() < 6);
}

RAMURE_SUITE(TestUndoSteps)

} // namespace tst_undo_steps

#include "tst_undo_steps.moc"
