#include "core/document/joined_steps.h"
#include "tests/document/commands_fixture.h"
#include "tests/support/suite.h"

namespace tst_joined_steps {

using namespace ramure;
using namespace ramure::test;

/// A copy and the move right after it are one step of undo.
class TestJoinedSteps : public QObject
{
    Q_OBJECT

private slots:
    void init() { failOnAnyWarning(); }
    void aKeptGestureJoinsTheLastStep();
    void aGestureGivenUpLeavesTheLastStep();
    void afterSavingItIsAStepOfItsOwn();

private:
    /// Duplicates node 4 and moves the copy, as the hand does. \return the gesture
    static GestureId copyAndMove(Fixture& f)
    {
        const auto copies = edit::duplicateNodes(f.document, {4});
        const GestureId gesture = newGesture();
        f.document.holdGesture(gesture);
        joinToLastStep(f.document, gesture);
        for (const double x : {1.0, 2.5})
            (void)edit::setParam(f.document, *copies, *findParam("tree.translation"), glm::dvec3(x, 0.0, 0.0),
                                 gesture);
        return gesture;
    }
};

void TestJoinedSteps::aKeptGestureJoinsTheLastStep()
{
    Fixture f;
    const QByteArray before = fileOf(f.document);
    f.document.keepGesture(copyAndMove(f));
    QCOMPARE(f.stack.count(), 1);
    QCOMPARE(f.document.scene().nodes().back().params.tree.translation, glm::dvec3(2.5, 0.0, 0.0));
    const QByteArray after = fileOf(f.document);
    f.stack.undo();
    QCOMPARE(fileOf(f.document), before);
    f.stack.redo();
    QCOMPARE(fileOf(f.document), after);
    f.stack.undo();
    QCOMPARE(fileOf(f.document), before);
}

void TestJoinedSteps::aGestureGivenUpLeavesTheLastStep()
{
    Fixture f;
    QVERIFY(f.document.giveUpGesture(copyAndMove(f)));
    QCOMPARE(f.stack.count(), 1);
    QCOMPARE(f.document.scene().nodes().size(), std::size_t(5));
    QCOMPARE(f.document.scene().nodes().back().params.tree.translation, glm::dvec3(0.0));
    // What comes later is nothing of the copy's.
    const GestureId other = newGesture();
    f.document.holdGesture(other);
    QVERIFY(edit::setParam(f.document, {4}, *findParam("tree.translation"), glm::dvec3(1.0), other));
    f.document.keepGesture(other);
    QCOMPARE(f.stack.count(), 2);
}

void TestJoinedSteps::afterSavingItIsAStepOfItsOwn()
{
    Fixture f;
    const GestureId gesture = copyAndMove(f);
    f.stack.setClean();
    f.document.keepGesture(gesture);
    QCOMPARE(f.stack.count(), 2);
    QVERIFY(!f.stack.isClean());
}

RAMURE_SUITE(TestJoinedSteps)

} // namespace tst_joined_steps

#include "tst_joined_steps.moc"
