// A mesh of a million triangles is looked at in the background while the view goes on turning in the real
// window. Times are printed, not judged: the machine of a test may be any.
#include "core/presets/presets.h"
#include "core/qt/session/jobs/analysis.h"
#include "core/qt/session/jobs/recompute.h"
#include "tests/bench/interaction/watched_application.h"
#include "tests/support/cannot_run.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/viewport.h"
#include "widgets/view/viewport_host.h"
#include "widgets/window/main_window.h"
#include <QElapsedTimer>
#include <algorithm>

using namespace ramure;

namespace {

constexpr int patienceMs = test::patience(180'000);
constexpr int turningMs = 5000;

/// How long the interface's thread was away from its events at most, and how many pictures it drew.
struct Heartbeat
{
    explicit Heartbeat(Viewport* view)
    {
        m_clock.start();
        QObject::connect(&m_pulse, &QTimer::timeout, &m_pulse, [this] {
            const qint64 now = m_clock.nsecsElapsed();
            longestMs = std::max(longestMs, double(now - m_last) * 1e-6);
            m_last = now;
        });
        QObject::connect(view, &Viewport::frameDrawn, &m_pulse, [this, view] {
            ++pictures;
            view->steer([](Camera& to) { to.orbit(0.05, 0.0); });
        });
        m_last = m_clock.nsecsElapsed();
        m_pulse.start(1);
        view->steer([](Camera& to) { to.orbit(0.05, 0.0); });
    }

    double longestMs = 0.0;
    int pictures = 0;
    [[nodiscard]] double seconds() const { return double(m_clock.nsecsElapsed()) * 1e-9; }

private:
    QTimer m_pulse;
    QElapsedTimer m_clock;
    qint64 m_last = 0;
};

} // namespace

class TestBackgroundAnalysis : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;
    test::FakeChooser m_chooser;
    Preferences m_preferences;
    Document m_document;
    Recompute m_recompute{&m_document};
    std::unique_ptr<MainWindow> m_window;
    NodeId m_tree = noNode;

    Viewport* view() { return m_window->viewportHost()->viewport(); }
    Analysis& analysis() { return *m_window->analysis(); }
    void setSections(std::int64_t radial)
    {
        QVERIFY(edit::setParam(m_document, {m_tree}, *findParam("sections.radialDivisions"), radial));
    }

private slots:
    void initTestCase()
    {
        if (!openGlAvailable())
            RAMURE_CANNOT_RUN("no OpenGL on this display");
        m_window = std::make_unique<MainWindow>(&m_document, &m_recompute, &m_preferences, &m_chooser);
        Node tree = test::treeNode(1, "Large");
        tree.params = *presetParams("SmallTree");
        tree.params.grammar.iterations = 11;
        tree.params.sections.radialDivisions = 11;
        tree.params.foliage.leavesDensity = 0;
        test::openNodes(m_document, {tree});
        m_tree = m_document.scene().nodes().front().id;
        m_window->resize(1000, 700);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        QVERIFY(m_recompute.waitForFull(patienceMs));
    }
    void init() { test::failOnWidgetWarning(); }
    void cleanupTestCase() { m_window.reset(); }

    void theViewTurnsWhileAMillionTrianglesAreLookedAt()
    {
        const Index faces = m_document.result(m_tree)->tree.branches->mesh.faceCount();
        QVERIFY(faces > 1'000'000);
        int during = 0;
        double longest = 0.0, seconds = 0.0;
        auto* const application = static_cast<bench::WatchedApplication*>(qApp);
        application->watch(view());
        application->takeLongestBlock();
        {
            Heartbeat heart(view());
            // A while is enough: where the processor draws, turning the view leaves little for the rest.
            analysis().waitForAll(turningMs);
            during = heart.pictures;
            longest = heart.longestMs;
            seconds = heart.seconds();
        }
        QVERIFY(analysis().waitForAll(patienceMs));
        // Without what a graphics card would draw, and counted by the processor: other programs do not
        // matter.
        const QString longestName = application->longestName();
        const double blockMs = application->takeLongestBlock().cpuMs;
        QCOMPARE(analysis().state(m_tree), Analysis::State::Done);
        const auto found = analysis().findings(m_tree);
        QCOMPARE(found->crossings.aroundForks(), std::uint64_t(0));
        QVERIFY(during > 0);
        Heartbeat alone(view());
        QTRY_VERIFY_WITH_TIMEOUT(alone.pictures >= 20, patienceMs);
        qInfo(
            "%u triangles: analysed in %.2f s; %.1f pictures a second meanwhile (alone %.1f), the "
            "interface's "
            "thread away for %.0f ms at most (alone %.0f ms); its longest block without drawing took %.1f ms "
            "of the processor (longest by the clock: %s)",
            faces, found->seconds, double(during) / seconds, double(alone.pictures) / alone.seconds(),
            longest, alone.longestMs, blockMs, qPrintable(longestName));
    }

    void anEditDropsWhatRuns()
    {
        setSections(10);
        QVERIFY(m_recompute.waitForFull(patienceMs));
        QTRY_COMPARE_WITH_TIMEOUT(analysis().state(m_tree), Analysis::State::Running, patienceMs);
        QElapsedTimer clock;
        clock.start();
        setSections(3);
        qInfo("dropped in %.2f ms", double(clock.nsecsElapsed()) * 1e-6);
        QCOMPARE(analysis().state(m_tree), Analysis::State::None);
        QVERIFY(m_recompute.waitForFull(patienceMs));
        QVERIFY(analysis().waitForAll(patienceMs));
        QCOMPARE(analysis().state(m_tree), Analysis::State::Done);
    }
};

int main(int argc, char** argv)
{
    prepareOpenGl();
    bench::WatchedApplication application(argc, argv);
    TestBackgroundAnalysis test;
    return QTest::qExec(&test, argc, argv);
}
#include "tst_background_analysis.moc"
