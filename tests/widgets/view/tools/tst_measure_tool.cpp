#include "tests/support/hand_bench.h"
#include "tests/support/suite.h"
#include <QLocale>
#include <QPainter>
#include <QRegularExpression>

namespace tst_measure_tool {

using namespace ramure;
using test::HandBench;

namespace {

/// The numbers of a hint, in the unit that it says.
std::vector<double> numbersOf(const QString& hint)
{
    static const QRegularExpression number(QStringLiteral("(-?[0-9.]+) c?m"));
    std::vector<double> all;
    for (auto found = number.globalMatch(hint); found.hasNext();)
        all.push_back(found.next().captured(1).toDouble());
    return all;
}

} // namespace

/// The tape measure.
class TestMeasureTool : public QObject
{
    Q_OBJECT
private slots:
    void init()
    {
        test::failOnAnyWarning();
        QLocale::setDefault(QLocale::c());
    }
    void itTakesNothingUnlessItIsChosen();
    void otherButtonsAndKeysAreNotItsOwn();
    void clicksAndDragsMeasure();
    void inTheAirItIsAsDeepAsItsBeginning();
    void overABranchItTellsTheDiameter();
    void theTapeGoesWithEscapeOrTheTool();
    void theDocumentStaysAsItIs();
};

void TestMeasureTool::itTakesNothingUnlessItIsChosen()
{
    HandBench bench(HandTool::None);
    QVERIFY(!bench.tools.hover(bench.at({400.0, 300.0})));
    QVERIFY(!bench.says("tape"));
}

void TestMeasureTool::otherButtonsAndKeysAreNotItsOwn()
{
    HandBench bench(HandTool::None);
    bench.gizmo.tool.set(TransformTool::Measure);
    QVERIFY(bench.says("tape begins"));
    bench.press({400.0, 300.0}, Qt::LeftButton, Qt::ShiftModifier);
    bench.release({400.0, 300.0}, Qt::LeftButton, Qt::ShiftModifier);
    bench.press({400.0, 300.0}, Qt::RightButton);
    bench.release({400.0, 300.0}, Qt::RightButton);
    QVERIFY(bench.says("tape begins"));
    QVERIFY(numbersOf(bench.hint()).empty());
}

void TestMeasureTool::clicksAndDragsMeasure()
{
    HandBench bench(HandTool::None);
    bench.gizmo.tool.set(TransformTool::Measure);
    bench.camera.pitchRad = 0.4;
    const double ground = bench.scene->ground;
    const glm::dvec3 from(-0.8, ground, 0.3), to(0.7, ground, 0.9);
    const double apart = glm::distance(from, to);
    bench.click(bench.pixelOf(from));
    QVERIFY(bench.says("tape ends"));
    bench.tools.hover(bench.at(bench.pixelOf(to)));
    QVERIFY(std::abs(numbersOf(bench.hint()).at(0) - apart) < 0.02); // while the mouse moves
    bench.click(bench.pixelOf(to));
    for (const bool dragged : {false, true}) {
        if (dragged)
            bench.drag(bench.pixelOf(from), bench.pixelOf(to));
        const std::vector<double> said = numbersOf(bench.hint());
        QCOMPARE(said.size(), std::size_t(3));
        QVERIFY(std::abs(said[0] - apart) < 0.02);
        QCOMPARE(said[1], 0.0);
        QCOMPARE(said[2], said[0]);
        bench.tools.hover(bench.at({10.0, 10.0})); // it stays
        QCOMPARE(numbersOf(bench.hint()), said);
    }
    // From the ground to a twig: the three numbers are those of a triangle with a right angle.
    const Index twig = bench.twig();
    bench.drag(bench.pixelOf(from), bench.on(twig));
    const std::vector<double> said = numbersOf(bench.hint());
    const glm::dvec3 there = glm::mix(bench.skeleton().p0[twig], bench.skeleton().p1[twig], 0.6);
    QVERIFY(std::abs(said.at(0) - glm::distance(from, there)) < 0.1);
    QVERIFY(std::abs(said[1] - (there.y - ground)) < 0.1);
    QVERIFY(std::abs(std::hypot(said[1], said[2]) - said[0]) < 0.02);
}

void TestMeasureTool::inTheAirItIsAsDeepAsItsBeginning()
{
    HandBench bench(HandTool::None);
    bench.gizmo.tool.set(TransformTool::Measure);
    bench.camera.pitchRad = 0.0;
    const Index twig = bench.twig();
    bench.drag(bench.on(twig), {5.0, 5.0}); // into the sky
    const double perPixel = bench.camera.heightAtTarget() / bench.size.y;
    const QPointF way = bench.on(twig) - QPointF(5.0, 5.0);
    const double expected = perPixel * std::hypot(way.x(), way.y());
    QVERIFY(std::abs(numbersOf(bench.hint()).at(0) - expected) < 0.2 * expected);
}

void TestMeasureTool::overABranchItTellsTheDiameter()
{
    HandBench bench(HandTool::None);
    bench.gizmo.tool.set(TransformTool::Measure);
    const Index twig = bench.twig();
    const double thick = 200.0 * glm::mix(bench.skeleton().a0[twig], bench.skeleton().a1[twig], 0.6);
    bench.tools.hover(bench.at(bench.on(twig)));
    QVERIFY(bench.says("diameter"));
    QVERIFY(std::abs(numbersOf(bench.hint()).at(0) - thick) < 0.1 * thick + 0.1);
    bench.tools.hover(bench.at({5.0, 5.0}));
    QVERIFY(!bench.says("diameter"));
    bench.tools.hover(bench.at(bench.on(twig)));
    bench.tools.leave();
    QVERIFY(!bench.says("diameter"));
}

void TestMeasureTool::theTapeGoesWithEscapeOrTheTool()
{
    HandBench bench(HandTool::None);
    bench.gizmo.tool.set(TransformTool::Measure);
    bench.press({300.0, 500.0});
    bench.move({500.0, 500.0});
    QVERIFY(bench.says("release"));
    QVERIFY(bench.key(Qt::Key_Escape));
    QVERIFY(numbersOf(bench.hint()).empty());
    bench.drag({300.0, 500.0}, {500.0, 500.0});
    QCOMPARE(numbersOf(bench.hint()).size(), std::size_t(3));
    bench.gizmo.tool.set(TransformTool::Move);
    bench.gizmo.tool.set(TransformTool::Measure);
    QVERIFY(numbersOf(bench.hint()).empty());
}

void TestMeasureTool::theDocumentStaysAsItIs()
{
    HandBench bench(HandTool::None);
    bench.gizmo.tool.set(TransformTool::Measure);
    const Selection before = bench.document.selection();
    bench.drag(bench.on(0), bench.on(bench.twig()));
    bench.click(bench.on(0));
    QImage picture(800, 600, QImage::Format_ARGB32);
    QPainter painter(&picture);
    bench.tools.paint(painter, bench.view());
    bench.document.reset({}, {}); // over what is gone
    bench.show();
    bench.tools.hover(bench.at({400.0, 300.0}));
    bench.tools.paint(painter, bench.view());
    QCOMPARE(bench.document.undoStack()->count(), 0);
    QVERIFY(bench.document.selection() == before || bench.document.selection().nodes.empty());
}

RAMURE_SUITE(TestMeasureTool)

} // namespace tst_measure_tool

#include "tst_measure_tool.moc"
