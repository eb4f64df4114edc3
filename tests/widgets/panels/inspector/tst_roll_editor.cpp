#include "tests/support/suite.h"
#include "tests/widgets/inspector_bench.h"
#include "widgets/base/fields/number_field.h"
#include "widgets/base/fields/number_slider.h"
#include "widgets/panels/inspector/roll_editor.h"
#include <QSignalSpy>
#include <QToolButton>
#include <numbers>

namespace tst_roll_editor {

using namespace ramure;

namespace {

using Bench = test::InspectorBench;
constexpr double pi = std::numbers::pi;

} // namespace

/// The roll by hand inside the inspector: what it does to the document, and what it shows of it.
class TestRollEditor : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void oneGestureIsOneUndoStep();
    void typedRollTakesWholeTurnsOff();
    void badTextIsRefused();
    void rollGoesToAllSelectedBranches();
    void rollTurnsTheFrames();
    void lockedTreesCannotBeRolled();
};

void TestRollEditor::oneGestureIsOneUndoStep()
{
    Bench bench;
    bench.trees.select(bench.tree, {3}, 3);
    auto* slider = bench.part<NumberSlider>("rollSlider");
    auto* field = bench.part<NumberField>("rollField");
    const QUndoStack* undo = bench.document().undoStack();
    const int before = undo->count();
    const auto drag = [&](std::initializer_list<int> positions) {
        emit slider->gestureBegan(); // what the slider says when the mouse takes and leaves its handle
        for (const int position : positions)
            slider->setValue(position);
        emit slider->gestureEnded();
    };
    drag({5500, 6000, 7000, 7500});
    QCOMPARE(undo->count(), before + 1);
    QVERIFY(std::abs(bench.rollOf(3) - pi / 2) < 0.01);
    QCOMPARE(field->value(), std::optional(bench.rollOf(3)));
    const double first = bench.rollOf(3);
    drag({6000, 2500});
    QCOMPARE(undo->count(), before + 2);
    QVERIFY(std::abs(bench.rollOf(3) + pi / 2) < 0.01);
    bench.document().undo();
    QCOMPARE(bench.rollOf(3), first);
    QCOMPARE(field->value(), std::optional(first));
    drag({5000, 9000, slider->value()}); // back where it began: no step
    bench.document().undo();
    QCOMPARE(bench.rollOf(3), 0.0);
    QCOMPARE(field->value(), std::optional(0.0));
    bench.document().redo();
    QCOMPARE(bench.rollOf(3), first);
    QVERIFY(bench.part<QToolButton>("rollReset")->isEnabled());
    const int steps = undo->count();
    QTest::mouseClick(bench.part<QToolButton>("rollReset"), Qt::LeftButton);
    QCOMPARE(bench.rollOf(3), 0.0);
    QVERIFY(undo->count() <= steps + 1);
    QVERIFY(!bench.part<QToolButton>("rollReset")->isEnabled());
    QVERIFY(bench.document().scene().find(bench.tree)->params.edits.empty());
}

void TestRollEditor::typedRollTakesWholeTurnsOff()
{
    Bench bench;
    bench.trees.select(bench.tree, {3}, 3);
    auto* field = bench.part<NumberField>("rollField");
    const auto type = [&](const char* text) {
        field->selectAll();
        QTest::keyClicks(field, QLatin1String(text));
        QTest::keyClick(field, Qt::Key_Return);
    };
    for (const auto& [text, degrees] : {std::pair("30", 30.0),
                                        {"270", -90.0},
                                        {"-190", 170.0},
                                        {"725", 5.0},
                                        {"pi/2", 90.0},
                                        {"1 rad", 180.0 / pi},
                                        {"180", 180.0}}) {
        type(text);
        QVERIFY2(std::abs(bench.rollOf(3) - degrees * pi / 180.0) < 1e-9, text);
        QCOMPARE(field->value(), std::optional(bench.rollOf(3)));
    }
}

void TestRollEditor::badTextIsRefused()
{
    Bench bench;
    bench.trees.select(bench.tree, {3}, 3);
    QSignalSpy messages(&bench.inspector, &BranchInspector::messageRaised);
    auto* field = bench.part<NumberField>("rollField");
    const int before = bench.document().undoStack()->count();
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("1/"));
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(bench.rollOf(3), 0.0);
    QCOMPARE(bench.document().undoStack()->count(), before);
    QVERIFY(messages.count() >= 1);
    QVERIFY(!messages.front().front().toString().isEmpty());
}

void TestRollEditor::rollGoesToAllSelectedBranches()
{
    Bench bench;
    const auto key = [&](Index branch) { return bench.skeleton().key[branch]; };
    QVERIFY(edit::setBranchRoll(bench.document(), bench.tree, {key(1)}, 0.25));
    const int before = bench.document().undoStack()->count();
    auto* field = bench.part<NumberField>("rollField");
    bench.trees.select(bench.tree, {1, 2, 5}, 2);
    QCOMPARE(field->value(), std::optional<double>()); // they differ
    emit field->valueEdited(0.5);
    QCOMPARE(bench.document().undoStack()->count(), before + 1);
    for (const Index branch : {Index(1), Index(2), Index(5)})
        QCOMPARE(bench.rollOf(branch), 0.5);
    QCOMPARE(bench.rollOf(3), 0.0);
    QCOMPARE(field->value(), std::optional(0.5));
    bench.document().undo();
    QCOMPARE(bench.rollOf(1), 0.25);
    QCOMPARE(bench.rollOf(2), 0.0);
    QCOMPARE(field->value(), std::optional<double>());
    QTest::mouseClick(bench.part<QToolButton>("rollReset"), Qt::LeftButton);
    QCOMPARE(bench.rollOf(1), 0.0);
}

void TestRollEditor::rollTurnsTheFrames()
{
    Bench bench;
    bench.trees.select(bench.tree, {1}, 1);
    const glm::dvec3 before = bench.sections(1)[2].normal;
    emit bench.part<NumberField>("rollField")->valueEdited(pi / 3);
    QVERIFY(bench.trees.compute(bench.tree));
    const SectionFacts after = bench.sections(1)[2];
    QVERIFY(std::abs(std::acos(glm::dot(before, after.normal)) - pi / 3) < 1e-9);
    QVERIFY(std::abs(after.twistRad - pi / 3) < 1e-9);
    FactForm* values = bench.browser()->details();
    QCOMPARE(values->value(values->rowCount() - 1), QStringLiteral("60.00°"));
}

void TestRollEditor::lockedTreesCannotBeRolled()
{
    Bench bench;
    bench.trees.select(bench.tree, {1}, 1);
    auto* field = bench.part<NumberField>("rollField");
    QVERIFY(field->isEnabled());
    QVERIFY(edit::setNodeLocked(bench.document(), {bench.tree}, true));
    QVERIFY(!field->isEnabled());
    QVERIFY(!bench.part<NumberSlider>("rollSlider")->isEnabled());
    QVERIFY(bench.part<QSlider>("sectionSlider")->isEnabled());
    QSignalSpy messages(&bench.inspector, &BranchInspector::messageRaised);
    emit field->valueEdited(1.0); // as if it came late
    QCOMPARE(bench.rollOf(1), 0.0);
    QCOMPARE(messages.count(), 1);
    QVERIFY(edit::setNodeLocked(bench.document(), {bench.tree}, false));
    QVERIFY(field->isEnabled());
}

RAMURE_SUITE(TestRollEditor)

} // namespace tst_roll_editor

#include "tst_roll_editor.moc"
