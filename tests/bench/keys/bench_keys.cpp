// The dope sheet with 100,000 keys on 500 tracks: what a picture and a gesture take. Run with
// QT_QPA_PLATFORM=offscreen. Asserts nothing.
#include "tests/widgets/panels/animation/key_fixture.h"
#include "widgets/panels/animation/key_curves.h"
#include <QApplication>
#include <benchmark/benchmark.h>
#include <cmath>

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
        dock().document.undo();
    }
}
BENCHMARK(dropTenThousandAndUndo)->Unit(benchmark::kMillisecond);

void selectBox(benchmark::State& state)
{
    for (auto _ : state)
        selectTenThousand();
}
BENCHMARK(selectBox)->Unit(benchmark::kMillisecond);

/// One track with 100,000 keys.
test::KeyDock& longDock()
{
    static auto* made = new test::KeyDock(test::keyScene(1, 100'000));
    return *made;
}

void selectOne()
{
    const Ticks time = longDock().model.rows()[2].times[50'000];
    longDock().model.selectTimes(time, time, SelectHow::Replace);
}

void retimeOneOfHundredThousand(benchmark::State& state)
{
    selectOne();
    Ticks way = ticksPerSecond / 100;
    for (auto _ : state) {
        longDock().commands.retime({0, 1.0, way}, false);
        way = -way;
    }
}
BENCHMARK(retimeOneOfHundredThousand)->Unit(benchmark::kMillisecond);

void moveOneOfHundredThousand(benchmark::State& state)
{
    selectOne();
    const TrackRef ref = longDock().model.tracks()[0];
    for (auto _ : state)
        longDock().commands.shift(0, {{CurveRef{ref, 0}, 0.1}});
}
BENCHMARK(moveOneOfHundredThousand)->Unit(benchmark::kMillisecond);

/// Far away, over others.
void throwOneOfHundredThousand(benchmark::State& state)
{
    selectOne();
    Ticks way = 40'000 * ticksPerSecond / 24 + 7;
    for (auto _ : state) {
        longDock().commands.retime({0, 1.0, way}, false);
        way = -way;
    }
}
BENCHMARK(throwOneOfHundredThousand)->Unit(benchmark::kMillisecond);

/// The curve editor, all 500 tracks with all their keys in sight.
void panCurves(benchmark::State& state)
{
    dock().panel.setCurvesShown(true);
    KeyCurves* curves = dock().panel.curves();
    QImage image(curves->size(), QImage::Format_ARGB32_Premultiplied);
    double shift = 0.0;
    for (auto _ : state) {
        shift = shift > 50.0 ? 0.0 : shift + 0.7;
        dock().panel.ruler()->showFrames(-5.0 + shift, 205.0 + shift);
        curves->render(&image);
    }
}
BENCHMARK(panCurves)->Unit(benchmark::kMillisecond);

void paintLongCurve(benchmark::State& state)
{
    longDock().panel.setCurvesShown(true);
    KeyCurves* curves = longDock().panel.curves();
    QImage image(curves->size(), QImage::Format_ARGB32_Premultiplied);
    double shift = 0.0;
    for (auto _ : state) {
        shift = shift > 500.0 ? 0.0 : shift + 7.0;
        longDock().panel.ruler()->showFrames(shift, 100'000.0 + shift);
        curves->render(&image);
    }
}
BENCHMARK(paintLongCurve)->Unit(benchmark::kMillisecond);

/// A handle of one of 100,000 keys follows the mouse, in sight.
void dragHandleOfLongCurve(benchmark::State& state)
{
    longDock().panel.setCurvesShown(true);
    KeyCurves* curves = longDock().panel.curves();
    longDock().panel.ruler()->showFrames(0.0, 100'000.0);
    const TrackRef ref = longDock().model.tracks()[0];
    Key key = std::get<Track>(*keys::find(longDock().document.scene(), ref)).keys()[50'000];
    key.before = key.behind = HandleType::Free;
    const GestureId gesture = newGesture();
    longDock().document.holdGesture(gesture);
    QImage image(curves->size(), QImage::Format_ARGB32_Premultiplied);
    for (auto _ : state) {
        key.out.dv = key.out.dv > 1.0 ? 0.0 : key.out.dv + 0.01;
        longDock().commands.replaceKey(ref, key, gesture);
        curves->render(&image);
    }
    longDock().document.giveUpGesture(gesture);
}
BENCHMARK(dragHandleOfLongCurve)->Unit(benchmark::kMillisecond);

/// A key inserted and taken out.
void insertOneOfHundredThousand(benchmark::State& state)
{
    longDock().panel.setCurvesShown(false);
    const std::vector<TrackRef> tracks = longDock().model.tracks();
    const Ticks time = 50'000 * ticksPerSecond / 24 + 77;
    for (auto _ : state) {
        benchmark::DoNotOptimize(keys::insert(longDock().document, tracks, time));
        benchmark::DoNotOptimize(keys::remove(longDock().document, {{tracks.front(), {time}}}));
    }
}
BENCHMARK(insertOneOfHundredThousand)->Unit(benchmark::kMillisecond);

/// One track of orientations with 100,000 keys that swings to and fro.
test::KeyDock& turnDock()
{
    static auto* made = [] {
        Scene scene;
        Node node;
        node.id = scene.newId();
        node.kind = NodeKind::Primitive;
        std::vector<OrientationKey> all(100'000);
        for (std::size_t i = 0; i < all.size(); ++i) {
            all[i].time = ticksOf(double(i) / 24.0);
            all[i].value =
                glm::angleAxis(std::sin(0.2 * double(i)), glm::normalize(glm::dvec3(1.0, 2.0, 0.5)));
        }
        for (const Channel& channel : channelsOf(NodeKind::Primitive))
            if (channel.isOrientation() && node.animation.empty())
                node.animation.set(channel, AnyTrack(*OrientationTrack::fromKeys(all)));
        [[maybe_unused]] const auto done = scene.insert({node}, noNode, 0);
        return new test::KeyDock(std::move(scene));
    }();
    return *made;
}

void selectOneTurn()
{
    const Ticks time = turnDock().model.rows()[2].times[50'000];
    turnDock().model.selectTimes(time, time, SelectHow::Replace);
}

void retimeOneTurn(benchmark::State& state)
{
    selectOneTurn();
    Ticks way = ticksPerSecond / 100;
    for (auto _ : state) {
        turnDock().commands.retime({0, 1.0, way}, false);
        way = -way;
    }
}
BENCHMARK(retimeOneTurn)->Unit(benchmark::kMillisecond);

void throwOneTurn(benchmark::State& state)
{
    selectOneTurn();
    Ticks way = 40'000 * ticksPerSecond / 24 + 7;
    for (auto _ : state) {
        turnDock().commands.retime({0, 1.0, way}, false);
        way = -way;
    }
}
BENCHMARK(throwOneTurn)->Unit(benchmark::kMillisecond);

/// One of its angles by a few degrees, and back.
void turnOne(benchmark::State& state)
{
    selectOneTurn();
    const TrackRef ref = turnDock().model.tracks()[0];
    double angle = 0.05;
    for (auto _ : state) {
        turnDock().commands.shift(0, {{CurveRef{ref, 1}, angle}});
        angle = -angle;
    }
}
BENCHMARK(turnOne)->Unit(benchmark::kMillisecond);

void insertOneTurn(benchmark::State& state)
{
    const std::vector<TrackRef> tracks = turnDock().model.tracks();
    const Ticks time = 50'000 * ticksPerSecond / 24 + 77;
    for (auto _ : state) {
        benchmark::DoNotOptimize(keys::insert(turnDock().document, tracks, time));
        benchmark::DoNotOptimize(keys::remove(turnDock().document, {{tracks.front(), {time}}}));
    }
}
BENCHMARK(insertOneTurn)->Unit(benchmark::kMillisecond);

/// The track alone, without the document and its rows.
void overwriteOneTurn(benchmark::State& state)
{
    OrientationTrack track =
        std::get<OrientationTrack>(*keys::find(turnDock().document.scene(), turnDock().model.tracks()[0]));
    const std::size_t index[] = {50'000};
    OrientationKey key = track.keys()[50'000];
    const glm::dquat value = key.value;
    double angle = 0.0;
    for (auto _ : state) {
        angle = angle > 0.1 ? 0.0 : angle + 0.01;
        key.value = value * glm::angleAxis(angle, glm::dvec3(0.0, 1.0, 0.0));
        benchmark::DoNotOptimize(track.replace(index, std::span(&key, 1)));
    }
}
BENCHMARK(overwriteOneTurn)->Unit(benchmark::kMillisecond);

void dragTenThousandInCurves(benchmark::State& state)
{
    dock().panel.setCurvesShown(true);
    dock().panel.ruler()->showFrames(-5.0, 205.0);
    KeyCurves* curves = dock().panel.curves();
    selectTenThousand();
    const KeyCurve& first = curves->curves().front();
    const QPointF from = curves->placeOf(first.ref(), first.timeOf(3), first.valueOf(3));
    const auto send = [curves](QEvent::Type type, const QPointF& at, Qt::MouseButton button) {
        QMouseEvent event(type, at, curves->mapToGlobal(at), button, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(curves, &event);
    };
    send(QEvent::MouseButtonPress, from, Qt::LeftButton);
    QImage image(curves->size(), QImage::Format_ARGB32_Premultiplied);
    double way = 20.0;
    for (auto _ : state) {
        way = way > 200.0 ? 20.0 : way + 3.0;
        send(QEvent::MouseMove, from + QPointF(way, way), Qt::NoButton);
        curves->render(&image);
    }
    state.counters["selected"] = double(dock().selected());
    QTest::keyClick(curves, Qt::Key_Escape);
}
BENCHMARK(dragTenThousandInCurves)->Unit(benchmark::kMillisecond);

} // namespace

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
