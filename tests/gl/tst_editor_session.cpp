// The real window under a virtual X server: it opens, paints, follows keys, undoes; and the program itself,
// from its command line.
#include "core/base/version.h"
#include "core/qt/session/jobs/recompute.h"
#include "tests/support/cannot_run.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/actions/file_actions.h"
#include "widgets/base/action_set.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/viewport.h"
#include "widgets/view/viewport_host.h"
#include "widgets/window/main_window.h"
#include "widgets/window/status_panel.h"
#include <QProcess>
#include <set>

namespace tst_editor_session {

using namespace ramure;

namespace {

constexpr int patienceMs = test::patience(60'000);

/// How many colours a picture has, looked at in a grid: 1 is a picture of nothing.
std::size_t colours(const QImage& image)
{
    std::set<QRgb> seen;
    for (int y = 0; y < image.height(); y += 4)
        for (int x = 0; x < image.width(); x += 4)
            seen.insert(image.pixel(x, y));
    return seen.size();
}

} // namespace

class TestEditorSession : public QObject
{
    Q_OBJECT
public:
    static void initMain() { prepareOpenGl(); }

private:
    test::OwnSettings m_settings;
    QTemporaryDir m_folder;
    test::FakeChooser m_chooser;
    Preferences m_preferences;
    Document m_document;
    Recompute m_recompute{&m_document};
    std::unique_ptr<MainWindow> m_window;

    Viewport* view() { return m_window->viewportHost()->viewport(); }
    /// The whole window once the present tree is there and drawn.
    QImage picture()
    {
        if (!m_recompute.waitForFull(patienceMs))
            return {};
        QSignalSpy drawn(view(), &Viewport::frameDrawn);
        view()->update();
        if (!QTest::qWaitFor([&] { return !drawn.isEmpty() && !view()->work().picture; }, patienceMs))
            return {};
        return m_window->grab().toImage();
    }

private slots:
    void initTestCase()
    {
        if (!openGlAvailable())
            RAMURE_CANNOT_RUN("no OpenGL on this display");
        m_window = std::make_unique<MainWindow>(&m_document, &m_recompute, &m_preferences, &m_chooser);
        QVERIFY(view());
        QVERIFY(m_window->files()->newFromPreset(QStringLiteral("SmallTree")));
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    }
    void init() { test::failOnWidgetWarning(); }
    void cleanupTestCase() { m_window.reset(); }

    void theWindowShowsTheTree()
    {
        const QImage image = picture();
        QVERIFY(image.width() >= 1000);
        const QRect place(view()->mapTo(m_window.get(), QPoint(0, 0)), view()->size());
        QVERIFY2(colours(image.copy(place)) > 200, "the view is empty");
        // Closed; whether branches run through each other is found out in the background.
        QTRY_VERIFY(QStringList({QStringLiteral("good"), QStringLiteral("closed")})
                        .contains(m_window->status()->badgeState()));
    }

    void spaceDrawsAnotherTreeAndUndoTheFirstAgain()
    {
        const QImage before = picture();
        const QString counts = m_window->status()->countsText();
        m_window->actionSet()->find(QStringLiteral("edit.newTree"))->trigger();
        QVERIFY(picture() != before);
        m_window->actionSet()->find(QStringLiteral("edit.undo"))->trigger();
        QVERIFY(m_recompute.waitForFull(patienceMs));
        QTRY_COMPARE(m_window->status()->countsText(), counts);
        QVERIFY(!m_document.isModified());
    }

    void theViewSurvivesFloatingDocks()
    {
        for (QDockWidget* dock : m_window->findChildren<QDockWidget*>()) {
            dock->setFloating(true);
            dock->setFloating(false);
        }
        m_window->resetLayout();
        QVERIFY(colours(picture()) > 200);
    }

    void everyDisplayModePaints()
    {
        for (const DisplayModeRow& row : displayModes()) {
            m_window->actionSet()->find(QString::fromLatin1(row.action))->trigger();
            QVERIFY2(colours(picture()) > 100, row.action);
        }
    }

    void theProgramRunsFromItsCommandLine()
    {
        const QString picturePath = m_folder.filePath(QStringLiteral("editor.png"));
        const QString obj = m_folder.filePath(QStringLiteral("tree.obj"));
        const QString ply = m_folder.filePath(QStringLiteral("tree.ply"));
        QProcess program;
        program.start(QStringLiteral(RAMURE_EDITOR),
                      {QStringLiteral("preset:TinyTree"), QStringLiteral("--screenshot"), picturePath,
                       QStringLiteral("--export"), obj, QStringLiteral("--export"), ply});
        QVERIFY(program.waitForFinished(patienceMs));
        QCOMPARE(program.exitCode(), 0);
        const QByteArray said = program.readAllStandardOutput();
        for (const QString& path : {picturePath, obj, ply}) {
            QVERIFY2(QFileInfo(path).size() > 1000, qPrintable(path));
            QVERIFY2(said.contains(path.toUtf8()), said.constData());
        }
        QVERIFY(colours(QImage(picturePath)) > 200);
    }

    /// Asked over a line without a screen, too.
    void helpNeedsNoScreen()
    {
        QProcess program;
        QProcessEnvironment bare = QProcessEnvironment::systemEnvironment();
        for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
            bare.remove(QLatin1String(name));
        program.setProcessEnvironment(bare);
        const std::pair<const char*, const char*> rows[] = {{"--nonsense", nullptr},
                                                            {"--help", "--screenshot"},
                                                            {"-h", "--screenshot"},
                                                            {"--version", RAMURE_VERSION}};
        for (const auto& [option, about] : rows) {
            program.start(QStringLiteral(RAMURE_EDITOR), {QLatin1String(option)});
            QVERIFY(program.waitForFinished(patienceMs));
            const QByteArray said = program.readAllStandardOutput();
            if (!about) {
                QVERIFY(program.exitStatus() != QProcess::NormalExit || program.exitCode() != 0);
                continue;
            }
            QCOMPARE(program.exitStatus(), QProcess::NormalExit);
            QCOMPARE(program.exitCode(), 0);
            QVERIFY2(said.contains(about), said.constData());
        }
    }

    /// One sentence instead of an abort.
    void theProgramSaysWhyItOpensNoWindow_data()
    {
        QTest::addColumn<QString>("platform");
        QTest::addColumn<QString>("display");
        QTest::addColumn<QString>("part");
        QTest::newRow("nobody answers")
            << QString() << QStringLiteral(":4711")
            << QStringLiteral("could not connect to display :4711 (DISPLAY=:4711)");
        QTest::newRow("none") << QString() << QString() << QStringLiteral("(DISPLAY is not set)");
        for (const char* platform : {"nonsense", "wayland", "xcb"})
            QTest::newRow(platform) << QString(platform) << QStringLiteral(":4711")
                                    << QStringLiteral("(QT_QPA_PLATFORM=%1)").arg(QLatin1String(platform));
    }
    void theProgramSaysWhyItOpensNoWindow()
    {
        QFETCH(QString, platform);
        QFETCH(QString, display);
        QFETCH(QString, part);
        QProcessEnvironment odd = QProcessEnvironment::systemEnvironment();
        for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
            odd.remove(QLatin1String(name));
        if (!platform.isEmpty())
            odd.insert("QT_QPA_PLATFORM", platform);
        if (!display.isEmpty())
            odd.insert("DISPLAY", display);
        QProcess program;
        program.setProcessEnvironment(odd);
        program.start(QStringLiteral(RAMURE_EDITOR), {QStringLiteral("preset:TinyTree")});
        QVERIFY(program.waitForFinished(patienceMs));
        QCOMPARE(program.exitStatus(), QProcess::NormalExit);
        QCOMPARE(program.exitCode(), 2);
        const QByteArray said = program.readAllStandardError();
        QVERIFY2(said.startsWith("ramure: no window can be opened: ") && said.count('\n') == 1 &&
                     said.contains(part.toUtf8()),
                 said.constData());
    }

    void namesThatAreNoUtf8AreRefused()
    {
        QProcess program;
        program.start(QStringLiteral("bash"),
                      {QStringLiteral("-c"), QStringLiteral("exec \"$0\" $'ch\\xEAne.obj'"),
                       QStringLiteral(RAMURE_EDITOR)});
        QVERIFY(program.waitForFinished(patienceMs));
        QCOMPARE(program.exitCode(), 2);
        const QByteArray said = program.readAllStandardError();
        QVERIFY2(said.contains("the name is no UTF-8") && said.count('\n') == 1, said.constData());
    }

    void theProgramSaysWhatItCannotOpen()
    {
        QProcess program;
        for (const char* input : {"preset:NoSuchTree", "/no/such/file.ramure"}) {
            program.start(QStringLiteral(RAMURE_EDITOR),
                          {QLatin1String(input), QStringLiteral("--screenshot"),
                           m_folder.filePath(QStringLiteral("none.png"))});
            QVERIFY(program.waitForFinished(patienceMs));
            QCOMPARE(program.exitCode(), 2);
            QVERIFY(!program.readAllStandardError().isEmpty());
        }
        QVERIFY(!QFileInfo::exists(m_folder.filePath(QStringLiteral("none.png"))));
    }
};

RAMURE_SUITE(TestEditorSession)

} // namespace tst_editor_session

#include "tst_editor_session.moc"
