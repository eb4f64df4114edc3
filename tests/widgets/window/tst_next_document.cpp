#include "core/qt/session/jobs/recompute.h"
#include "core/qt/session/motion/auto_key.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/actions/file_actions.h"
#include "widgets/base/action_set.h"
#include "widgets/base/message_banner.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/panels/properties/properties_panel.h"
#include "widgets/view/tools/gizmo_settings.h"
#include "widgets/view/tools/hand_settings.h"
#include "widgets/view/view_settings.h"
#include "widgets/view/viewport_host.h"
#include "widgets/window/main_window.h"
#include <QLineEdit>
#include <QStatusBar>
#include <QToolButton>

namespace tst_next_document {

using namespace ramure;

/// What was set for one document is not set for the next one.
class TestNextDocument : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;
    QTemporaryDir m_folder;
    Preferences m_preferences;
    test::FakeChooser m_chooser;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<Recompute> m_recompute;
    std::unique_ptr<MainWindow> m_window;

    QAction* autoKey() { return m_window->actionSet()->find(QStringLiteral("keys.auto")); }
    ViewSettings* view() { return m_window->findChild<ViewportHost*>()->settings(); }
    QToolButton* mark() { return m_window->findChild<QToolButton*>(QStringLiteral("autoKeyMark")); }

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        QSettings().clear();
        m_chooser.unsaved = Chooser::Unsaved::Discard;
        m_document = std::make_unique<Document>();
        m_recompute = std::make_unique<Recompute>(m_document.get());
        m_window =
            std::make_unique<MainWindow>(m_document.get(), m_recompute.get(), &m_preferences, &m_chooser);
        QVERIFY(m_window->files()->newFromPreset(QStringLiteral("TinyTree")));
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    }
    void cleanup()
    {
        m_window.reset();
        m_recompute.reset();
        m_document.reset();
    }

    void everyWayToItBeginsWithDefaults_data()
    {
        QTest::addColumn<int>("way");
        QTest::newRow("new") << 0;
        QTest::newRow("demo") << 1;
        QTest::newRow("reopened") << 2;
    }
    void everyWayToItBeginsWithDefaults()
    {
        QFETCH(int, way);
        const QString path = m_folder.filePath(QStringLiteral("tree.ramure"));
        m_chooser.answer = path;
        QVERIFY(m_window->files()->saveAs());
        const HandOptions usual = view()->hand()->options();
        HandOptions other = usual;
        other.symmetryCopies = 3;
        other.falls = true;
        other.brushStrength = 0.9;
        view()->hand()->setOptions(other);
        view()->hand()->setTool(HandTool::Draw);
        view()->gizmo()->space.set(TransformSpace::Local);
        view()->gizmo()->snaps.set(true);
        view()->light.set({270.0, 8.0, Backdrop::Sky, 5.5, -1.5});
        view()->quality.set(Quality::Draft);
        autoKey()->setChecked(true);
        QVERIFY(m_window->findChild<AutoKey*>()->isOn());
        auto* search = m_window->findChild<PropertiesPanel*>()->findChild<QLineEdit*>();
        search->setText(QStringLiteral("wind"));
        switch (way) {
        case 0:
            QVERIFY(m_window->files()->newFromPreset(QStringLiteral("SmallTree")));
            break;
        case 1:
            QVERIFY(m_window->files()->newFromDemo(QStringLiteral("Arm")));
            break;
        default:
            QVERIFY(m_window->files()->openFile(path));
        }
        QVERIFY(!autoKey()->isChecked() && !m_window->findChild<AutoKey*>()->isOn());
        QCOMPARE(search->text(), QString());
        QCOMPARE(view()->light(), SceneLight());
        QCOMPARE(view()->hand()->options(), usual);
        QCOMPARE(view()->hand()->tool(), HandTool::None);
        QCOMPARE(view()->gizmo()->space(), TransformSpace::World);
        QVERIFY(!view()->gizmo()->snaps());
        QCOMPARE(view()->quality(), Quality::Draft); // of the machine, not of the document
    }

    /// "Exported to …" was said of the document before; what went wrong may be the reason for this one.
    void newsOfTheDocumentBeforeIsGone()
    {
        MessageBanner* banner = m_window->banner();
        for (const Severity severity : {Severity::Info, Severity::Error}) {
            banner->showMessage(severity, QStringLiteral("Exported to tree.glb"));
            QVERIFY(m_window->files()->newFromPreset(QStringLiteral("SmallTree")));
            QCOMPARE(banner->isVisible(), severity == Severity::Error);
        }
    }

    void autoKeyIsSeenInTheStatusBar()
    {
        const int height = m_window->statusBar()->height();
        QVERIFY(mark() && !mark()->isVisible());
        autoKey()->setChecked(true);
        QVERIFY(mark()->isVisible() && !mark()->text().isEmpty() && !mark()->toolTip().isEmpty());
        QCoreApplication::processEvents();
        QCOMPARE(m_window->statusBar()->height(), height);
        mark()->click();
        QVERIFY(!autoKey()->isChecked() && !mark()->isVisible());
    }
};

RAMURE_SUITE(TestNextDocument)

} // namespace tst_next_document

#include "tst_next_document.moc"
