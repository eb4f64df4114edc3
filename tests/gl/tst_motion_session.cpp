// Playing in the real window: the hand on a branch and on an apple, live parameters, long play, and the end
// of the program at any moment. RAMURE_PLAY_SECONDS sets how long the long play lasts (600: ten minutes; with
// QTEST_FUNCTION_TIMEOUT=1200000).
#include "core/base/kept_memory.h"
#include "core/qt/session/jobs/recompute.h"
#include "core/qt/session/motion/player.h"
#include "core/qt/session/motion/sequence.h"
#include "tests/gl/desk.h"
#include "tests/support/cannot_run.h"
#include "tests/support/waits.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/actions/file_actions.h"
#include "widgets/base/action_set.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/base/timeline_ruler.h"
#include "widgets/dialogs/export/export_dialog.h"
#include "widgets/dialogs/export/moment_form.h"
#include "widgets/panels/timeline/timeline_panel.h"
#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/viewport.h"
#include "widgets/view/viewport_host.h"
#include "widgets/window/main_window.h"
#include <QFile>
#include <QSpinBox>
#include <cstdio>
#include <unistd.h>

namespace tst_motion_session {

using namespace ramure;

namespace {

constexpr int patienceMs = test::patience(120'000);

/// Memory that is in use now, bytes.
double residentBytes()
{
    QFile file(QStringLiteral("/proc/self/statm"));
    if (!file.open(QIODevice::ReadOnly))
        return 0.0;
    return file.readAll().split(' ').value(1).toDouble() * double(::sysconf(_SC_PAGESIZE));
}

/// A document in its window, as main() puts them together.
struct Session
{
    explicit Session(test::FakeChooser& chooser)
        : window(std::make_unique<MainWindow>(&document, &recompute, &preferences, &chooser))
    {
    }
    void open(const char* preset)
    {
        QVERIFY(window->files()->newFromPreset(QLatin1String(preset)));
        window->show();
        QVERIFY(QTest::qWaitForWindowExposed(window.get()));
        QVERIFY(recompute.waitForFull(patienceMs));
        QVERIFY(QTest::qWaitFor([this] { return !view()->work().picture; }, patienceMs));
    }
    /// Where pixels count: the camera has come to rest.
    void letCameraRest()
    {
        test::whenStill(60, [this] { return view()->camera(); });
    }
    Viewport* view() { return window->viewportHost()->viewport(); }
    Player* player() { return window->player(); }
    void trigger(const char* action) { window->actionSet()->find(QLatin1String(action))->trigger(); }
    [[nodiscard]] const TreeResult& tree() const { return document.result(1)->tree; }
    NodeMotion motion() { return *player()->motion()->of(1); }
    bool wait(const std::function<bool()>& holds) { return QTest::qWaitFor(holds, patienceMs); }
    QPoint pixel(const glm::dvec3& world)
    {
        const auto ndc = view()->camera().project(world, double(view()->width()) / view()->height());
        return ndc ? QPoint(int(0.5 * (ndc->x + 1.0) * view()->width()),
                            int(0.5 * (1.0 - ndc->y) * view()->height()))
                   : QPoint(-1, -1);
    }
    void mouse(QEvent::Type type, const QPoint& at, Qt::MouseButton button, Qt::MouseButtons held)
    {
        QMouseEvent event(type, QPointF(at), view()->mapToGlobal(QPointF(at)), button, held, Qt::NoModifier);
        QCoreApplication::sendEvent(view(), &event);
    }

    Preferences preferences;
    Document document;
    Recompute recompute{&document};
    std::unique_ptr<MainWindow> window;
};

} // namespace

class TestMotionSession : public QObject
{
    Q_OBJECT
public:
    static void initMain()
    {
        keepFreedMemory(); // as the editor does
        prepareOpenGl();
    }

private:
    test::OwnSettings m_settings;
    test::FakeChooser m_chooser;
    QTemporaryDir m_folder;

    /// The range is long, so that nothing ends by itself.
    void openLongProject(Session& session)
    {
        session.open("TinyTree");
        TimelineSettings settings;
        settings.lastFrame = 50'000;
        QVERIFY(edit::setTimeline(session.document, settings));
        m_chooser.answer = m_folder.filePath(QStringLiteral("tiny.ramure"));
        QVERIFY(session.window->files()->saveAs());
    }

private slots:
    void initTestCase()
    {
        if (!openGlAvailable())
            RAMURE_CANNOT_RUN("no OpenGL on this display");
        QSettings().setValue(QStringLiteral("view/language"), QStringLiteral("en"));
    }
    void init() { test::failOnWidgetWarning(); }

    void aPulledBranchSpringsBack()
    {
        Session session(m_chooser);
        session.open("TinyTree");
        session.letCameraRest();
        QVERIFY(edit::setParam(session.document, {1}, *findParam("physics.windStrength"), 0.0));
        session.document.markSaved();
        const int steps = session.document.undoStack()->index();
        session.trigger("play.toggle");
        QVERIFY(session.player()->isPlaying());
        QVERIFY(session.wait([&] { return session.player()->motion()->of(1) != nullptr; }));

        // The highest tip of the tree.
        const Skeleton& skeleton = session.tree().simplified->skeleton;
        Index tip = 0;
        for (Index b = 0; b < skeleton.size(); ++b)
            if (skeleton.p1[b].y > skeleton.p1[tip].y)
                tip = b;
        const auto away = [&] {
            return glm::length((*session.motion().bones)[tip].point(skeleton.p1[tip]) - skeleton.p1[tip]);
        };
        const double height = skeleton.p1[tip].y;
        const QPoint from = session.pixel(skeleton.p1[tip]);
        session.mouse(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
        for (int i = 1; i <= 20; ++i) {
            const std::int64_t then = session.player()->frame();
            session.mouse(QEvent::MouseMove, from + QPoint(8 * i, 3 * i), Qt::NoButton, Qt::LeftButton);
            QVERIFY(session.wait([&] { return session.player()->frame() != then; }));
        }
        double most = 0.0;
        QVERIFY2(session.wait([&] {
            most = std::max(most, away());
            return most > 0.05 * height;
        }),
                 "the branch does not follow");
        session.mouse(QEvent::MouseButtonRelease, from + QPoint(160, 60), Qt::LeftButton, Qt::NoButton);
        QVERIFY2(session.wait([&] { return away() < 0.3 * most; }), "it does not spring back");
        session.trigger("play.stop");
        QCOMPARE(session.document.undoStack()->index(), steps);
        QVERIFY(!session.document.isModified());
        QVERIFY(!session.window->isWindowModified());
    }

    void anAppleShakenOffFallsBouncesAndRests()
    {
        Session session(m_chooser);
        session.open("TinyTree");
        session.letCameraRest();
        QVERIFY(session.tree().foliage && !session.tree().foliage->apples.empty());
        session.trigger("play.everyFrame");
        session.player()->setSpeed(2.0);
        session.trigger("play.toggle");
        QVERIFY(session.wait([&] { return session.player()->frame() > 2; }));
        const Index branches = session.tree().simplified->skeleton.size();
        const auto& apples = session.tree().foliage->apples;
        const auto placeOf = [&](std::size_t apple) {
            return (*session.motion().bones)[branches + apple].point(apples[apple].position);
        };
        // The one that hangs highest: nothing stops it early.
        std::size_t high = 0;
        for (std::size_t i = 0; i < apples.size(); ++i)
            if (apples[i].position.y > apples[high].position.y)
                high = i;
        std::optional<std::size_t> loose;
        QVERIFY(session.wait([&] {
            const QPoint at = session.pixel(placeOf(high));
            session.mouse(QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton);
            session.mouse(QEvent::MouseButtonRelease, at, Qt::LeftButton, Qt::NoButton);
            session.mouse(QEvent::MouseButtonDblClick, at, Qt::LeftButton, Qt::LeftButton);
            session.mouse(QEvent::MouseButtonRelease, at, Qt::LeftButton, Qt::NoButton);
            const std::int64_t then = session.player()->frame();
            (void)session.wait([&] { return session.player()->frame() > then + 6; });
            for (std::size_t i = 0; i < apples.size(); ++i)
                if (placeOf(i).y < 0.75 * apples[i].position.y)
                    loose = i;
            return loose.has_value();
        }));
        std::vector<double> heights;
        const auto record = connect(session.player(), &Player::motionChanged, this,
                                    [&] { heights.push_back(placeOf(*loose).y); });
        constexpr std::size_t still = 10;
        QVERIFY2(session.wait([&] {
            const std::size_t n = heights.size();
            return n > still && std::abs(heights[n - 1] - heights[n - still]) < 1e-9;
        }),
                 "it does not come to rest");
        disconnect(record);
        const double radius = 0.5 * session.document.scene().find(1)->params.turtle.alpha;
        QVERIFY(heights.back() < 3.0 * radius);
        bool bounced = false;
        for (std::size_t i = 1; i + 1 < heights.size(); ++i)
            bounced = bounced || (heights[i] < heights[i - 1] && heights[i + 1] > heights[i] + 1e-6);
        QVERIFY2(bounced, "it does not bounce");
        session.trigger("play.stop");
        QVERIFY(session.wait([&] { return !session.player()->isBusy(); }));
        QVERIFY(!session.motion().moves());
        QVERIFY(!session.document.isModified());
    }

    void aParameterActsWhilePlaying()
    {
        Session session(m_chooser);
        session.open("TinyTree");
        QVERIFY(edit::setParam(session.document, {1}, *findParam("physics.windStrength"), 0.0));
        session.trigger("play.toggle");
        QVERIFY(session.wait([&] { return session.player()->frame() > 30; }));
        const double calm = session.motion().figures.kineticEnergy;
        QVERIFY(edit::setParam(session.document, {1}, *findParam("physics.windStrength"), 5.0));
        QVERIFY(session.wait([&] { return session.motion().figures.kineticEnergy > 10.0 * calm + 1e-6; }));
        QVERIFY(session.player()->isPlaying());
        session.document.undo(); // while it plays
        QVERIFY(session.player()->isPlaying());
        const qint64 then = session.player()->frame();
        QVERIFY(session.wait([&] { return session.player()->frame() != then; }));
    }

    void playingAndScrubbingChangeNoDocument()
    {
        Session session(m_chooser);
        session.open("TinyTree");
        session.document.markSaved();
        const quint64 revision = session.document.revision();
        TimelineRuler* ruler = session.window->timeline()->ruler();
        const int y = ruler->height() / 2;
        for (const char* action : {"play.toggle", "play.forward", "play.toggle", "play.back", "play.last",
                                   "play.first", "play.everyFrame", "play.toggle"}) {
            const std::int64_t then = session.player()->frame();
            session.trigger(action);
            QVERIFY(session.wait(
                [&] { return session.player()->frame() != then || !session.player()->isBusy(); }));
        }
        QTest::mouseClick(ruler, Qt::LeftButton, {}, QPoint(int(ruler->xOf(120)), 4));
        QVERIFY(session.wait([&] { return session.player()->frame() >= 118; }));
        session.trigger("play.toggle");
        test::drag(ruler, QPoint(int(ruler->xOf(120)), 4), QPoint(int(ruler->xOf(40)), y - 8));
        QVERIFY(std::abs(session.player()->frame() - 40) <= 1);
        for (const Qt::Key key : {Qt::Key_Right, Qt::Key_Right, Qt::Key_Left})
            QTest::keyClick(ruler, key);
        QVERIFY(std::abs(session.player()->frame() - 41) <= 1);
        QTest::keyClick(ruler, Qt::Key_End);
        QCOMPARE(session.player()->frame(), std::int64_t(250));
        QVERIFY(session.wait([&] { return !session.player()->isBusy(); }));
        QVERIFY(session.motion().moves());
        session.trigger("play.stop");
        QCOMPARE(session.document.revision(), revision);
        QCOMPARE(session.document.undoStack()->count(), 0);
        QVERIFY(!session.window->isWindowModified());
    }

    /// By the window's own close, then the end of all objects in the order of main().
    void closingWhilePlayingEndsCleanly()
    {
        for (const bool late : {false, true}) {
            Session session(m_chooser);
            session.open(late ? "SmallTree" : "TinyTree");
            session.trigger("play.toggle");
            if (late)
                QVERIFY(session.wait([&] { return session.player()->frame() > 2; }));
            QVERIFY(session.window->close());
        }
    }

    void closingWhileBakingEndsCleanly()
    {
        for (const bool late : {false, true}) { // before the first frame, and in the midst of it
            Session session(m_chooser);
            openLongProject(session);
            session.trigger("play.bake");
            QVERIFY(!session.window->actionSet()->find(QStringLiteral("play.bake"))->isEnabled());
            auto* progress = session.window->findChild<QWidget*>(QStringLiteral("bakeProgress"));
            if (late)
                QVERIFY(session.wait([&] { return progress->isVisible(); }));
            QVERIFY(session.window->close());
        }
        QCOMPARE(QDir(m_folder.path()).entryList(QDir::Files | QDir::Hidden),
                 QStringList{QStringLiteral("tiny.ramure")});
    }

    void closingWhileExportingEndsCleanly()
    {
        const QString folder = m_folder.filePath(QStringLiteral("frames"));
        QVERIFY(QDir().mkpath(folder));
        for (int i = 0; i < 2; ++i) {
            Session session(m_chooser);
            openLongProject(session);
            session.trigger("file.export");
            auto* dialog = session.window->findChild<ExportDialog*>();
            QVERIFY(dialog);
            dialog->setFormat(i == 0 ? QStringLiteral("ply") : QStringLiteral("png"));
            dialog->setPath(folder +
                            (i == 0 ? QStringLiteral("/t%1.ply") : QStringLiteral("/t%1.png")).arg(i));
            dialog->moments()->setMoment(ExportMoment::Sequence);
            dialog->startExport();
            QVERIFY(!dialog->isVisible());
            auto* progress = session.window->findChild<QWidget*>(QStringLiteral("sequenceProgress"));
            QVERIFY(session.wait([&] { return progress->isVisible(); }));
            if (i == 0)
                QVERIFY(session.wait([&] { return !QDir(folder).isEmpty(QDir::Files); }));
            QVERIFY(session.window->close());
        }
        QVERIFY(!QDir(folder).entryList(QDir::Files).isEmpty());
        for (const QString& name : QDir(folder).entryList(QDir::Files | QDir::Hidden))
            QVERIFY2(!name.contains(QStringLiteral(".new")), qPrintable(name));
    }

    /// Memory stays, and every key and click that the X server sends arrives.
    void longPlayKeepsItsMemoryAndLosesNoInput()
    {
        if (QStandardPaths::findExecutable(QStringLiteral("xdotool")).isEmpty())
            RAMURE_CANNOT_RUN("xdotool is not installed");
        bool given = false;
        const int asked = qEnvironmentVariableIntValue("RAMURE_PLAY_SECONDS", &given);
        const double seconds = given ? asked : 6.0;
        const test::Desk desk;
        Session session(m_chooser);
        session.open("TinyTree");
        TimelineSettings range;
        range.lastFrame = 71; // three seconds
        QVERIFY(edit::setTimeline(session.document, range));
        session.window->activateWindow();
        TimelineRuler* ruler = session.window->timeline()->ruler();
        ruler->setFocus();
        QVERIFY(QTest::qWaitForWindowActive(session.window.get()));
        int sought = 0; // a spy would keep every signal, and its memory is not the editor's
        connect(ruler, &TimelineRuler::frameSought, this, [&sought] { ++sought; });
        session.player()->setSpeed(Player::mostSpeed);
        session.trigger("play.toggle");
        std::int64_t frames = 0, loops = 0, last = 0;
        connect(session.player(), &Player::frameChanged, this, [&](qint64 frame) {
            loops += frame < last ? 1 : 0; // keys go forward only
            frames += frame < last ? 72 + frame - last : frame - last;
            last = frame;
        });
        const auto press = [&](int count) {
            QProcess tool;
            tool.start(QStringLiteral("xdotool"),
                       {QStringLiteral("key"), QStringLiteral("--delay"), QStringLiteral("12"),
                        QStringLiteral("--repeat"), QString::number(count), QStringLiteral("Right")});
            const int before = sought;
            QVERIFY(QTest::qWaitFor([&] { return tool.state() == QProcess::NotRunning; }, patienceMs));
            QCOMPARE(tool.exitCode(), 0);
            QTRY_COMPARE_WITH_TIMEOUT(sought - before, count, patienceMs);
        };
        // From the first seconds on: the range was gone through once, and keys have been there.
        press(20);
        QVERIFY(session.wait([&] { return loops >= 1; }));
        const double before = residentBytes();
        QElapsedTimer clock;
        clock.start();
        frames = 0;
        int pressed = 0;
        double most = before;
        while (double(clock.elapsed()) * 1e-3 < seconds) {
            press(40);
            pressed += 40;
            const std::int64_t seen = loops;
            QVERIFY(session.wait([&] { return loops > seen; }));
            most = std::max(most, residentBytes());
        }
        const double growth = residentBytes() / before - 1.0;
        std::fprintf(
            stderr,
            "played %.0f s: %.0f s of the timeline, %lld loops, %d keys; memory %.1f MB, growth %.3f %% "
            "(most %.3f %%)\n",
            double(clock.elapsed()) * 1e-3, double(frames) / range.framesPerSecond,
            static_cast<long long>(loops), pressed, before / 1048576.0, 100.0 * growth,
            100.0 * (most / before - 1.0));
        QVERIFY(session.player()->isPlaying());
        QVERIFY2(growth < 0.01, "memory grows");
    }
};

RAMURE_SUITE(TestMotionSession)

} // namespace tst_motion_session

#include "tst_motion_session.moc"
