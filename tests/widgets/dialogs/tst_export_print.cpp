#include "core/qt/session/jobs/recompute.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/base/fields/number_field.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/export/export_dialog.h"
#include "widgets/dialogs/export/print_form.h"
#include "widgets/dialogs/export/print_preview.h"
#include "widgets/dialogs/export/print_view.h"
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>

namespace tst_export_print {

using namespace ramure;

class TestExportPrint : public QObject
{
    Q_OBJECT
    test::OwnSettings m_settings;
    QTemporaryDir m_folder;
    Preferences m_preferences;
    Document m_document;
    Recompute m_recompute{&m_document};
    test::FakeChooser m_chooser;

    static constexpr int patienceMs = test::patience(60'000);
    int m_files = 0;

    /// The dialog on its page for prints.
    struct Bench
    {
        ExportDialog dialog;
        PrintPreview* preview;

        explicit Bench(TestExportPrint& suite)
            : dialog(&suite.m_document, &suite.m_recompute, &suite.m_preferences, &suite.m_chooser)
            , preview(dialog.printing()->preview())
        {
            dialog.setUse(ExportUse::Print);
            dialog.setFormat(QStringLiteral("3mf"));
            dialog.setPath(suite.m_folder.filePath(QStringLiteral("t%1.3mf").arg(++suite.m_files)));
            PrintOptions options;
            options.height = 0.08;
            dialog.printing()->setOptions(options);
            dialog.show();
        }
        template <class T> [[nodiscard]] T* part(const char* name) const
        {
            return dialog.findChild<T*>(QLatin1String(name));
        }
        void click(const char* name) const { part<QPushButton>(name)->click(); }
    };

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        m_preferences.setExportSettings({}); // each page has its own of the last time
        test::openNodes(m_document, {test::treeNode(1, "T")});
        QVERIFY(m_recompute.waitForFull(test::patience(20'000)));
    }
    void aPrintThatIsTooLowIsTold()
    {
        ExportDialog dialog(&m_document, &m_recompute, &m_preferences, &m_chooser);
        dialog.setFormat(QStringLiteral("stl"));
        dialog.printing()->setWanted(true);
        auto* thinnest = dialog.findChild<NumberField*>(QStringLiteral("exportThinnest"));
        thinnest->setValue(50.0);
        dialog.findChild<QPushButton*>(QStringLiteral("printPrepare"))->click();
        QVERIFY(dialog.findChild<QLabel*>(QStringLiteral("problem")));
    }
    void eachProcessHasItsThinnestTwig()
    {
        ExportDialog dialog(&m_document, &m_recompute, &m_preferences, &m_chooser);
        auto* process = dialog.findChild<QComboBox*>(QStringLiteral("exportProcess"));
        for (int i = 0; i < process->count(); ++i) {
            process->setCurrentIndex(i);
            const PrintOptions options = dialog.printing()->options();
            QCOMPARE(options.process, static_cast<PrintProcess>(i));
            QCOMPARE(options.smallestDiameter(), printProcesses()[std::size_t(i)].thinnest);
        }
    }
    void aPrintIsPreparedAndWritten()
    {
        Bench bench(*this);
        QVERIFY(!bench.preview->isVisible());
        bench.click("printPrepare");
        QVERIFY(bench.part<QProgressBar>("printProgress")->isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(bench.preview->isVisible(), patienceMs);
        QVERIFY(!bench.part<QProgressBar>("printProgress")->isVisible());
        const QString text = bench.preview->text();
        for (const char* word : {"1 : ", "Thinnest place: ", "Overhangs: ", "Stands: yes", "1 closed"})
            QVERIFY2(text.contains(QLatin1String(word)), qPrintable(text));
        QVERIFY(!QFile::exists(bench.dialog.path()));
        QVERIFY(bench.dialog.isVisible());
        QSignalSpy exported(&bench.dialog, &ExportDialog::exported);
        bench.dialog.startExport();
        QVERIFY(!bench.part<QProgressBar>("printProgress")->isVisible()); // it is there
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, patienceMs);
        QVERIFY(QFile::exists(bench.dialog.path()));
    }
    void aPrintThatIsNotPreparedIsMadeFirst()
    {
        Bench bench(*this);
        QSignalSpy exported(&bench.dialog, &ExportDialog::exported);
        bench.dialog.startExport();
        QVERIFY(!bench.dialog.printing()->isEnabled());
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, patienceMs);
        QVERIFY(QFile::exists(bench.dialog.path()));
    }
    void preparingIsCancelled()
    {
        Bench bench(*this);
        bench.click("printPrepare");
        bench.part<QToolButton>("printCancel")->click();
        QTRY_VERIFY(!bench.part<QProgressBar>("printProgress")->isVisible());
        QVERIFY(bench.dialog.isVisible() && !bench.preview->isVisible());
        bench.dialog.startExport(); // waits for it, and is given up
        bench.dialog.reject();
        QTRY_VERIFY(bench.dialog.printing()->isEnabled());
        QVERIFY(bench.dialog.isVisible() && !QFile::exists(bench.dialog.path()));
        bench.click("printPrepare"); // and again
        QTRY_VERIFY_WITH_TIMEOUT(bench.preview->isVisible(), patienceMs);
    }
    void theLatestChoiceWins()
    {
        Bench bench(*this);
        bench.click("printPrepare");
        bench.part<QCheckBox>("exportDisc")->click();
        bench.part<QComboBox>("exportShells")->setCurrentIndex(1);
        QVERIFY(bench.part<QProgressBar>("printProgress")->isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(bench.preview->isVisible(), patienceMs);
        QVERIFY2(bench.preview->text().contains(QLatin1String("Leaves: ")),
                 qPrintable(bench.preview->text()));
    }
    void anotherPrintForgetsTheReport()
    {
        Bench bench(*this);
        bench.click("printPrepare");
        QTRY_VERIFY_WITH_TIMEOUT(bench.preview->isVisible(), patienceMs);
        bench.part<QCheckBox>("exportDisc")->click();
        QVERIFY(!bench.preview->isVisible());
        QVERIFY(!bench.part<QProgressBar>("printProgress")->isVisible()); // not by itself
    }
    void thePictureFliesToTheThinnestPlace()
    {
        Bench bench(*this);
        bench.click("printPrepare");
        QTRY_VERIFY_WITH_TIMEOUT(bench.preview->isVisible(), patienceMs);
        PrintView* view = bench.preview->view();
        const Camera whole = view->goal();
        bench.click("printShowThinnest");
        const Camera near = view->goal();
        QVERIFY(near.distance < whole.distance);
        QVERIFY(glm::distance(near.target, whole.target) > 0.0);
        QTRY_VERIFY(view->camera() == near);
        QTest::keyClick(view, Qt::Key_Plus);
        QVERIFY(view->camera().distance < near.distance);
        const double yaw = view->camera().yawRad;
        QTest::keyClick(view, Qt::Key_Right);
        QVERIFY(view->camera().yawRad != yaw);
        const double before = view->camera().yawRad;
        QTest::mousePress(view, Qt::LeftButton, {}, {40, 40});
        QTest::mouseMove(view, {90, 60});
        QTest::mouseRelease(view, Qt::LeftButton, {}, {90, 60});
        QVERIFY(view->camera().yawRad != before);
        bench.click("printShowWhole");
        QTRY_VERIFY(std::abs(view->camera().distance / whole.distance - 1.0) < 0.5);
    }
    void leavesAreKeptWithTheSettings()
    {
        Bench bench(*this);
        bench.part<QComboBox>("exportShells")->setCurrentIndex(1);
        const QVariantMap kept = bench.dialog.settings();
        bench.part<QComboBox>("exportShells")->setCurrentIndex(0);
        bench.dialog.setSettings(kept);
        QCOMPARE(bench.dialog.printing()->options().leaves, PrintLeaves::Shells);
    }
};

RAMURE_SUITE(TestExportPrint)

} // namespace tst_export_print

#include "tst_export_print.moc"
