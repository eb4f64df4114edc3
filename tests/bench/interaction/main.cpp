// Measures the editor in its real window: from a slider's move to the new picture, and how long the interface
// is held up. Needs a display with OpenGL, a virtual one will do (./dev bench-window). Asserts nothing.
#include "core/base/kept_memory.h"
#include "core/presets/presets.h"
#include "tests/bench/interaction/editor_bench.h"
#include "widgets/panels/presets/preset_gallery.h"
#include "widgets/view/render/passes/gl_setup.h"
#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QProcess>
#include <QTemporaryDir>
#include <algorithm>
#include <cstdio>
#include <cstring>

using namespace ramure;
using namespace ramure::bench;

namespace {

struct Scenario
{
    const char* key;
    double from, to; ///< shares of the slider
    DisplayMode mode;
};

constexpr Scenario scenarios[] = {
    {"turtle.theta", 0.30, 0.40, DisplayMode::Mesh},
    {"sections.radialDivisions", 0.20, 0.60, DisplayMode::Mesh},
    {"foliage.leavesDensity", 0.30, 0.50, DisplayMode::Mesh},
    {"turtle.theta", 0.30, 0.40, DisplayMode::Skeleton},
    {"turtle.theta", 0.30, 0.40, DisplayMode::Rough},
    {"turtle.theta", 0.30, 0.40, DisplayMode::Sections},
};

const char* nameOf(DisplayMode mode)
{
    constexpr const char* names[] = {"skeleton", "simplified", "rough", "sections", "mesh"};
    return names[static_cast<std::size_t>(mode)];
}

struct Spread
{
    double best = 0.0, median = 0.0, worst = 0.0;
};

Spread spread(const std::vector<ChangeTimes>& changes, double ChangeTimes::*member)
{
    std::vector<double> values;
    for (const ChangeTimes& change : changes)
        values.push_back(change.*member);
    std::sort(values.begin(), values.end());
    if (values.empty())
        return {};
    return {values.front(), values[values.size() / 2], values.back()};
}

void printRow(const Scenario& scenario, int iterations, const std::vector<ChangeTimes>& changes)
{
    const auto middle = [&](double ChangeTimes::*member) { return spread(changes, member).median; };
    const Spread first = spread(changes, &ChangeTimes::first);
    const Spread block = spread(changes, &ChangeTimes::block);
    const auto worst =
        std::max_element(changes.begin(), changes.end(),
                         [](const ChangeTimes& a, const ChangeTimes& b) { return a.block < b.block; });
    std::printf("%-26s %-9s %2d | %5.1f %6.1f %5.1f %5.1f | %6.1f %6.1f %5.1f | %6.1f | %5.1f %5.1f %5.1f | "
                "%6.0f | %s\n",
                scenario.key, nameOf(scenario.mode), iterations, middle(&ChangeTimes::edit),
                middle(&ChangeTimes::result), middle(&ChangeTimes::build), middle(&ChangeTimes::upload),
                first.best, first.median, middle(&ChangeTimes::firstCpu), middle(&ChangeTimes::full),
                block.median, block.worst, spread(changes, &ChangeTimes::blockCpu).worst,
                middle(&ChangeTimes::rasteriser), worst == changes.end() ? "" : qPrintable(worst->blockName));
    std::fflush(stdout);
}

void printHead()
{
    std::printf("One change of a slider, milliseconds without the software rasteriser\n");
    std::printf("%-26s %-9s %2s | %5s %6s %5s %5s | %6s %6s %5s | %6s | %5s %5s %5s | %6s | %s\n",
                "parameter", "mode", "it", "edit", "result", "build", "upl.", "first", "median", "cpu",
                "full", "block", "worst", "cpu", "raster", "longest event");
}

void measureDrag(EditorBench& editor, int iterations)
{
    editor.setMode(DisplayMode::Mesh);
    const auto times = editor.drag(QStringLiteral("turtle.theta"), 0.3, 0.6, 120);
    std::printf("dragging turtle.theta, %d iterations: %.1f pictures/s, latency %.0f ms (rasteriser "
                "included), longest block %.1f ms, %.1f ms cpu (%s)\n",
                iterations, times.picturesPerSecond, times.latency, times.longest.block,
                times.longest.blockCpu, qPrintable(times.longest.blockName));
}

void measureBend(EditorBench& editor, int iterations)
{
    editor.setMode(DisplayMode::Mesh);
    const auto times = editor.bend(120);
    std::printf("bending a twig, %d iterations: %.1f pictures/s, latency %.0f ms (rasteriser included), "
                "longest block %.1f ms, %.1f ms cpu (%s)\n",
                iterations, times.picturesPerSecond, times.latency, times.longest.block,
                times.longest.blockCpu, qPrintable(times.longest.blockName));
    std::fflush(stdout);
}

void measurePlay(EditorBench& editor, int iterations)
{
    editor.setMode(DisplayMode::Mesh);
    editor.setParam("foliage.leavesDensity", std::int64_t(10));
    const auto times = editor.play(8000);
    std::printf(
        "playing, %d iterations, 10 leaves a twig: %.2f ms cpu a frame without the rasteriser (%.0f "
        "frames/s on one core; a physics step %.2f ms), %.1f frames/s with it, longest block %.1f ms, "
        "%.1f ms cpu (%s)\n",
        iterations, times.cpuPerFrame, 1e3 / std::max(1e-3, times.cpuPerFrame), times.stepMs,
        times.framesPerSecond, times.longest.block, times.longest.blockCpu,
        qPrintable(times.longest.blockName));
    std::fflush(stdout);
}

/// The program itself, from its start to its tree.
void measureStart(int times)
{
    double firstMs = 1e9;
    double fullMs = 1e9;
    double firstCpuMs = 1e9;
    for (int i = 0; i < times; ++i) {
        QProcess program;
        const Stopwatch watch;
        program.start(QStringLiteral(RAMURE_EDITOR), {QStringLiteral("--measure-start")});
        while (program.state() != QProcess::NotRunning && program.waitForReadyRead(60'000)) {
            const double now = watch.elapsed().wallMs;
            while (program.canReadLine()) {
                const QList<QByteArray> words = program.readLine().trimmed().split(' ');
                if (words.value(0) == "first") {
                    firstMs = std::min(firstMs, now);
                    firstCpuMs = std::min(firstCpuMs, words.value(1).toDouble());
                } else if (words.value(0) == "full") {
                    fullMs = std::min(fullMs, now);
                }
            }
        }
        program.waitForFinished(60'000);
    }
    std::printf("start, best of %d: a tree on the screen after %.0f ms (%.0f ms of the processors, painting "
                "included), the full one after %.0f ms\n",
                times, firstMs, firstCpuMs, fullMs);
    std::fflush(stdout);
}

/// 100,000 leaves and 500,000 triangles of bark, by quality.
void measureFrames(EditorBench& editor)
{
    constexpr QSize size(1280, 720);
    constexpr std::pair<const char*, Quality> qualities[] = {
        {"draft", Quality::Draft}, {"good", Quality::Good}, {"best", Quality::Best}};
    editor.setIterations(11);
    editor.setParam("mesh.targetTriangles", std::int64_t(500'000));
    editor.setParam("foliage.internode", 1.175); // else there are 119,000
    for (const auto& [name, quality] : qualities) {
        const double alone = editor.frameMs(quality, size, 5, false);
        std::printf("a picture of the view at rest, %s: %.0f ms, with the tree selected %.0f ms\n", name,
                    alone, editor.frameMs(quality, size, 5, true));
        std::fflush(stdout);
    }
}

/// All presets from nothing to their first picture; the best of \p times, the first of which reads the files.
void measureGallery(int times)
{
    Preferences preferences;
    double best = 0.0, first = 0.0;
    for (int i = 0; i < times; ++i) {
        QElapsedTimer clock;
        clock.start();
        PresetGallery gallery(140, &preferences, nullptr);
        gallery.grab();
        const double ms = 1e-6 * double(clock.nsecsElapsed());
        first = i == 0 ? ms : first;
        best = i == 0 ? ms : std::min(best, ms);
    }
    std::printf("the gallery of %zu trees: %.0f ms, again %.0f ms (200 are allowed)\n", presets().size(),
                first, best);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
    // The software rasteriser would take the processors from what is measured: pictures stay empty.
    if (std::none_of(argv, argv + argc, [](const char* a) { return std::strcmp(a, "--rasterise") == 0; }))
        qputenv("LP_NO_RAST", "true");
    keepFreedMemory(); // as the program
    prepareOpenGl();
    QTemporaryDir settings; // nobody's preferences are read or changed
    qputenv("XDG_CONFIG_HOME", settings.path().toUtf8());
    qputenv("XDG_DATA_HOME", settings.path().toUtf8());
    WatchedApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("ramure-measure"));
    QCommandLineParser parser;
    const QCommandLineOption iterations(QStringLiteral("iterations"), QStringLiteral("8,10 by default"),
                                        QStringLiteral("LIST"), QStringLiteral("8,10"));
    const QCommandLineOption changes(QStringLiteral("changes"), QStringLiteral("per row, 8 by default"),
                                     QStringLiteral("N"), QStringLiteral("8"));
    const QCommandLineOption rasterise(QStringLiteral("rasterise"),
                                       QStringLiteral("Let llvmpipe fill the pictures"));
    const QCommandLineOption starts(QStringLiteral("starts"), QStringLiteral("of the program, 5 by default"),
                                    QStringLiteral("N"), QStringLiteral("5"));
    const QCommandLineOption frames(QStringLiteral("frames"),
                                    QStringLiteral("Only pictures of a large tree; give --rasterise, too"));
    parser.addOptions({iterations, changes, rasterise, starts, frames});
    parser.addHelpOption();
    parser.process(application);
    if (!parser.isSet(frames)) {
        measureStart(parser.value(starts).toInt());
        measureGallery(5);
    }
    EditorBench editor(&application);
    if (!editor.isReady()) {
        std::fprintf(stderr, "No OpenGL on this display.\n");
        return 1;
    }
    if (parser.isSet(frames)) {
        measureFrames(editor);
        return 0;
    }
    printHead();
    for (const QString& size : parser.value(iterations).split(u',')) {
        editor.setIterations(size.toInt());
        for (const Scenario& scenario : scenarios) {
            editor.setMode(scenario.mode);
            printRow(scenario, size.toInt(),
                     editor.singleChanges(QLatin1String(scenario.key), scenario.from, scenario.to,
                                          parser.value(changes).toInt()));
        }
        measureDrag(editor, size.toInt());
        measureBend(editor, size.toInt());
        measurePlay(editor, size.toInt());
    }
    return 0;
}
