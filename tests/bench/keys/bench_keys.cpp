// The dope sheet with 100,000 keys on 500 tracks: what a picture and a gesture take. Run with
// QT_QPA_PLATFORM=offscreen. Asserts nothing.
#include "tests/widgets/animation/key_fixture.h"
#include <QApplication>
#include <benchmark/benchmark.h>

using namespace ramure;

namespace {

test::KeyDock& dock()
{
    static test::KeyDock* made = [] {
        auto* fresh = new test::KeyDock(test::keyScene(500, 200));
        fresh->panel.resize(1800, 900);
        fresh->panel.ruler()->showFrames(-5.0, 205.0);
        return fresh;
    }();
    return *made;
}

void selectTenThousand()
{
    dock().model.select(0, 0, 0, keys::ticksOfFrame(dock().model.timeline(), 19.5), SelectHow::Replace);
}

void paint(benchmark::State& state)
{
    QImage image(dock().sheet()->size(), QImage::Format_ARGB32_Premultiplied);
    for (auto _ : state)
        dock().sheet()->render(&image);
    state.counters["selected"] = double(dock().selected());
}

void paintAll(benchmark::State& state)
{
    dock().panel.ruler()->showFrames(-5.0, 205.0);
    paint(state);
}
BENCHMARK(paintAll)->Unit(benchmark::kMillisecond);

void paintZoomedOut(benchmark::State& state)
{
    dock().panel.ruler()->showFrames(-500.0, 2000.0);
    paint(state);
    dock().panel.ruler()->showFrames(-5.0, 205.0);
}
BENCHMARK(paintZoomedOut)->Unit(benchmark::kMillisecond);

void panAndZoom(benchmark::State& state)
{
    QImage image(dock().sheet()->size(), QImage::Format_ARGB32_Premultiplied);
    double shift = 0.0;
    for (auto _ : state) {
        shift = shift > 50.0 ? 0.0 : shift + 0.7;
        dock().panel.ruler()->showFrames(-5.0 + shift, 205.0 - shift);
        dock().sheet()->render(&image);
    }
    dock().panel.ruler()->showFrames(-5.0, 205.0);
}
BENCHMARK(panAndZoom)->Unit(benchmark::kMillisecond);

/// A move of the mouse while 10,000 keys are dragged, and the picture of it.
void dragTenThousand(benchmark::State& state)
{
    selectTenThousand();
    dock().dragMouse(dock().at(0, 5), dock().at(0, 9), {}, false);
    QImage image(dock().sheet()->size(), QImage::Format_ARGB32_Premultiplied);
    double frame = 0.0;
    for (auto _ : state) {
        frame = frame > 40.0 ? 0.0 : frame + 1.0;
        const QPointF place = dock().at(0, frame);
        QMouseEvent event(QEvent::MouseMove, place, dock().sheet()->mapToGlobal(place), Qt::NoButton,
                          Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(dock().sheet(), &event);
        dock().sheet()->render(&image);
    }
    state.counters["selected"] = double(dock().selected());
    QTest::keyClick(dock().sheet(), Qt::Key_Escape);
    QTest::mouseRelease(dock().sheet(), Qt::LeftButton, {}, dock().at(0, frame));
}
BENCHMARK(dragTenThousand)->Unit(benchmark::kMillisecond);

/// Letting go: the command, its undo, and the rows made anew each time.
void dropTenThousandAndUndo(benchmark::State& state)
{
    for (auto _ : state) {
        selectTenThousand();
        dock().commands.retime({0, 1.0, ticksPerSecond * 30}, false);
        dock().document.undoStack()->undo();
    }
}
BENCHMARK(dropTenThousandAndUndo)->Unit(benchmark::kMillisecond);

void selectBox(benchmark::State& state)
{
    for (auto _ : state)
        selectTenThousand();
}
BENCHMARK(selectBox)->Unit(benchmark::kMillisecond);

} // namespace

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
