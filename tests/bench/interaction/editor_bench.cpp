#include "tests/bench/interaction/editor_bench.h"

#include "core/qt/document/commands.h"
#include "core/qt/session/jobs/analysis.h"
#include "core/qt/session/motion/player.h"
#include "tests/bench/interaction/slider_hand.h"
#include "widgets/actions/file_actions.h"
#include "widgets/view/viewport.h"
#include "widgets/view/viewport_host.h"
#include <QDir>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QFile>
#include <QMouseEvent>
#include <QTest>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <ctime>
#include <unistd.h>

namespace ramure::bench {
namespace {

constexpr int patienceMs = 60'000;

/// QTest's own waiting sleeps between its looks at the events.
void waitMs(int milliseconds)
{
    QEventLoop loop;
    QTimer::singleShot(milliseconds, Qt::PreciseTimer, &loop, &QEventLoop::quit);
    loop.exec();
}

double processCpuMs()
{
    return 1e3 * double(std::clock()) / CLOCKS_PER_SEC;
}

} // namespace

EditorBench::EditorBench(WatchedApplication* application)
    : m_application(application)
    , m_recompute(&m_document)
    , m_window(&m_document, &m_recompute, &m_preferences, &m_chooser)
{
    m_chooser.setWindow(&m_window, m_window.banner());
    m_window.resize(1280, 800);
    m_window.show();
    if (!isReady())
        return;
    m_application->watch(view());
    m_window.files()->newFromPreset(QStringLiteral("SmallTree"));
    if (!QTest::qWaitForWindowExposed(&m_window, patienceMs))
        std::fprintf(stderr, "The window does not appear.\n");
    settle();
}

Viewport* EditorBench::view() const
{
    return m_window.viewportHost()->viewport();
}

bool EditorBench::isReady() const
{
    return view() != nullptr;
}

bool EditorBench::shows(quint64 revision, bool full) const
{
    if (view()->frameTimes().revision < revision)
        return false;
    const NodeResult* result = m_document.result(m_document.scene().nodes().front().id);
    return !full || (result && !result->draft && !m_recompute.isBusy());
}

void EditorBench::settle()
{
    m_recompute.waitForFull(patienceMs);
    waitMs(400); // the second opinion, the pick scene, the animation of the camera
    (void)QTest::qWaitFor([this] { return shows(m_document.revision(), true); }, 1000);
}

void EditorBench::setIterations(int iterations)
{
    setParam("grammar.iterations", std::int64_t(iterations));
    view()->frameAll();
    settle();
}

void EditorBench::setParam(const char* key, ParamValue value)
{
    const NodeId tree = m_document.scene().nodes().front().id;
    (void)edit::setParam(m_document, {tree}, *findParam(key), value);
    settle();
}

double EditorBench::frameMs(Quality quality, QSize size, int times, bool selected)
{
    m_window.viewportHost()->settings()->quality.set(quality);
    view()->setFixedSize(size);
    settle();
    view()->frameAll();
    Selection selection;
    if (selected)
        selection.nodes = {m_document.scene().nodes().front().id};
    m_document.setSelection(selection);
    settle();
    (void)m_window.analysis()->waitForAll(patienceMs);
    waitMs(2000); // what else the background makes
    std::vector<double> all;
    for (int i = 0; i <= times; ++i) { // the first one draws the shadow maps, too
        const Stopwatch watch;
        (void)view()->grabFramebuffer();
        if (i > 0)
            all.push_back(watch.elapsed().wallMs);
    }
    std::ranges::sort(all);
    return all[all.size() / 2];
}

void EditorBench::setMode(DisplayMode mode)
{
    m_window.viewportHost()->settings()->displayMode.set(mode);
    settle();
}

ChangeTimes EditorBench::measure(const std::function<void()>& move)
{
    ChangeTimes times;
    bool drawn = false;
    bool fullDrawn = false;
    quint64 wanted = 0;
    m_application->takeLongestBlock();
    const Elapsed before = m_application->rasterised();
    const double cpuBefore = processCpuMs();
    const Stopwatch watch;
    const auto net = [&] { return watch.elapsed().wallMs - (m_application->rasterised() - before).wallMs; };
    QObject context;
    QObject::connect(&m_document, &Document::changed, &context, [&](const Change& change) {
        if (change.has(changeResults) && times.result == 0.0)
            times.result = net();
    });
    // Connected after the application's own: the drawing of this picture is counted already.
    QObject::connect(view(), &Viewport::frameDrawn, &context, [&](const FrameTimes& frame) {
        if (wanted == 0 || frame.revision < wanted)
            return;
        if (!drawn) {
            times.first = net();
            times.firstCpu = processCpuMs() - cpuBefore - (m_application->rasterised() - before).cpuMs;
            times.build = frame.buildMs;
            times.upload = frame.uploadMs;
        }
        drawn = true;
        fullDrawn = fullDrawn || shows(wanted, true);
        if (fullDrawn && times.full == 0.0)
            times.full = net();
    });
    const quint64 revision = m_document.revision();
    move();
    times.edit = net();
    wanted = m_document.revision();
    if (wanted == revision) // a step too small for a whole number: no picture comes
        return times;
    QEventLoop loop;
    QTimer::singleShot(patienceMs, &loop, &QEventLoop::quit);
    const auto quitWhenDone = [&] {
        if (drawn && shows(wanted, true))
            loop.quit();
    };
    QObject::connect(view(), &Viewport::frameDrawn, &context, quitWhenDone, Qt::QueuedConnection);
    QObject::connect(&m_recompute, &Recompute::busyChanged, &context, quitWhenDone, Qt::QueuedConnection);
    loop.exec();
    waitMs(120);
    times.rasteriser = (m_application->rasterised() - before).wallMs;
    times.blockName = m_application->longestName();
    const Elapsed block = m_application->takeLongestBlock();
    times.block = block.wallMs;
    times.blockCpu = block.cpuMs;
    return times;
}

std::vector<ChangeTimes> EditorBench::singleChanges(const QString& key, double from, double to, int changes)
{
    std::vector<ChangeTimes> all;
    SliderHand hand(&m_window, key);
    if (!hand.isThere())
        return all;
    hand.moveTo(from);
    settle();
    for (int i = 1; i <= changes; ++i) {
        const quint64 before = m_document.revision();
        const auto times = measure([&] { hand.moveTo(from + (to - from) * i / changes); });
        if (m_document.revision() > before && times.first > 0.0)
            all.push_back(times);
    }
    return all;
}

EditorBench::DragTimes EditorBench::drag(const QString& key, double from, double to, int moves)
{
    DragTimes times;
    SliderHand hand(&m_window, key);
    if (!hand.isThere())
        return times;
    hand.moveTo(from);
    settle();
    std::vector<std::pair<quint64, double>> waiting; // revision, time of the move
    std::vector<double> latencies;
    int pictures = 0;
    QElapsedTimer clock;
    QObject context;
    QObject::connect(view(), &Viewport::frameDrawn, &context, [&](const FrameTimes& frame) {
        const double now = 1e-6 * double(clock.nsecsElapsed());
        pictures += frame.rebuilt ? 1 : 0;
        std::erase_if(waiting, [&](const auto& entry) {
            if (frame.revision < entry.first)
                return false;
            latencies.push_back(now - entry.second);
            return true;
        });
    });
    m_application->takeLongestBlock();
    clock.start();
    for (int i = 1; i <= moves; ++i) {
        const double now = 1e-6 * double(clock.nsecsElapsed());
        const quint64 before = m_document.revision();
        hand.moveTo(from + (to - from) * (0.5 - 0.5 * std::cos(6.0 * i / moves)));
        if (m_document.revision() > before)
            waiting.emplace_back(m_document.revision(), now);
        waitMs(16);
    }
    times.picturesPerSecond = 1e3 * pictures / (1e-6 * double(clock.nsecsElapsed()));
    const QString name = m_application->longestName();
    const Elapsed block = m_application->takeLongestBlock();
    times.longest.block = block.wallMs;
    times.longest.blockCpu = block.cpuMs;
    times.longest.blockName = name;
    settle();
    std::sort(latencies.begin(), latencies.end());
    times.latency = latencies.empty() ? 0.0 : latencies[latencies.size() / 2];
    return times;
}

EditorBench::DragTimes EditorBench::bend(int moves)
{
    DragTimes times;
    const NodeResult* result = m_document.result(m_document.scene().nodes().front().id);
    if (!result || !result->tree.simplified)
        return times;
    const Skeleton& skeleton = result->tree.simplified->skeleton;
    const Index twig = skeleton.size() - 1;
    const auto ndc = view()->camera().project(0.5 * (skeleton.p0[twig] + skeleton.p1[twig]),
                                              double(view()->width()) / view()->height());
    const QPointF at(0.5 * (ndc->x + 1.0) * view()->width(), 0.5 * (1.0 - ndc->y) * view()->height());
    const auto send = [this](QEvent::Type type, QPointF to, Qt::MouseButtons buttons) {
        const Qt::MouseButton button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
        QMouseEvent event(type, to, view()->mapToGlobal(to), button, buttons, Qt::ControlModifier);
        QCoreApplication::sendEvent(view(), &event);
    };
    std::vector<double> waiting, latencies; // times of moves
    int pictures = 0;
    QElapsedTimer clock;
    QObject context;
    QObject::connect(view(), &Viewport::frameDrawn, &context, [&] {
        const double now = 1e-6 * double(clock.nsecsElapsed());
        pictures += waiting.empty() ? 0 : 1;
        for (const double moved : std::exchange(waiting, {}))
            latencies.push_back(now - moved);
    });
    m_application->takeLongestBlock();
    clock.start();
    send(QEvent::MouseButtonPress, at, Qt::LeftButton);
    for (int i = 1; i <= moves; ++i) {
        waiting.push_back(1e-6 * double(clock.nsecsElapsed()));
        send(QEvent::MouseMove,
             at + 60.0 * QPointF(std::sin(6.0 * i / moves), 1.0 - std::cos(6.0 * i / moves)), Qt::LeftButton);
        waitMs(16);
    }
    times.picturesPerSecond = 1e3 * pictures / (1e-6 * double(clock.nsecsElapsed()));
    send(QEvent::MouseButtonRelease, at, Qt::NoButton);
    times.longest.blockName = m_application->longestName();
    const Elapsed block = m_application->takeLongestBlock();
    times.longest.block = block.wallMs;
    times.longest.blockCpu = block.cpuMs;
    settle();
    std::sort(latencies.begin(), latencies.end());
    times.latency = latencies.empty() ? 0.0 : latencies[latencies.size() / 2];
    return times;
}

namespace {

/// Of the threads that llvmpipe made for itself.
double rasteriserThreadsCpuMs()
{
    double ticks = 0.0;
    const QDir tasks(QStringLiteral("/proc/self/task"));
    for (const QString& task : tasks.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        QFile file(tasks.filePath(task + QStringLiteral("/stat")));
        if (!file.open(QIODevice::ReadOnly))
            continue;
        const QByteArray line = file.readAll();
        const qsizetype open = line.indexOf('('), close = line.lastIndexOf(')');
        if (!line.mid(open + 1, close - open - 1).startsWith("llvmpipe"))
            continue;
        const QList<QByteArray> words = line.mid(close + 2).split(' ');
        ticks += words.value(11).toDouble() + words.value(12).toDouble();
    }
    return 1e3 * ticks / double(sysconf(_SC_CLK_TCK));
}

} // namespace

EditorBench::PlayTimes EditorBench::play(int milliseconds)
{
    PlayTimes times;
    Player* player = m_window.player();
    (void)edit::setTimeline(m_document, {60.0, 0, 100'000, PlayLoop::Once});
    player->setPace(PlayPace::EveryFrame);
    player->setSpeed(Player::mostSpeed);
    settle();
    (void)m_window.analysis()->waitForAll(patienceMs);
    QObject context;
    std::vector<double> steps;
    QObject::connect(player, &Player::motionChanged, &context, [&] {
        for (const auto& [node, motion] : player->motion()->nodes)
            if (motion.stepSeconds > 0.0)
                steps.push_back(1e3 * motion.stepSeconds);
    });
    player->play();
    waitMs(500); // the first frames bind the skin
    std::int64_t last = player->motion()->frame;
    QObject::connect(view(), &Viewport::frameDrawn, &context, [&] {
        times.frames += player->motion()->frame != last ? 1 : 0;
        last = player->motion()->frame;
    });
    m_application->takeLongestBlock();
    const auto rasteriser = [&] { return m_application->rasterised().cpuMs + rasteriserThreadsCpuMs(); };
    const double cpuBefore = processCpuMs() - rasteriser();
    QElapsedTimer clock;
    clock.start();
    waitMs(milliseconds);
    const double seconds = 1e-9 * double(clock.nsecsElapsed());
    const double cpu = processCpuMs() - rasteriser() - cpuBefore;
    times.longest.blockName = m_application->longestName();
    const Elapsed block = m_application->takeLongestBlock();
    times.longest.block = block.wallMs;
    times.longest.blockCpu = block.cpuMs;
    player->stop();
    settle();
    times.framesPerSecond = times.frames / seconds;
    times.cpuPerFrame = cpu / std::max(1, times.frames);
    std::sort(steps.begin(), steps.end());
    times.stepMs = steps.empty() ? 0.0 : steps[steps.size() / 2];
    return times;
}

} // namespace ramure::bench
