#include "core/session/recompute.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/base/number_field.h"
#include "widgets/base/preferences.h"
#include "widgets/dialogs/export_dialog.h"
#include "widgets/dialogs/print_form.h"
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>

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

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        test::openNodes(m_document, {test::treeNode(1, "T")});
        QVERIFY(m_recompute.waitForFull(20'000));
    }
    void aPrintThatIsTooLowIsTold()
    {
        ExportDialog dialog(&m_document, &m_recompute, &m_preferences, &m_chooser);
        dialog.setFormat(QStringLiteral("stl"));
        dialog.printing()->setWanted(true);
        auto* thinnest = dialog.findChild<NumberField*>(QStringLiteral("printThinnest"));
        thinnest->setValue(50.0);
        dialog.findChild<QPushButton*>(QStringLiteral("printPrepare"))->click();
        QVERIFY(dialog.findChild<QLabel*>(QStringLiteral("problem")));
    }
    void eachProcessHasItsThinnestTwig()
    {
        ExportDialog dialog(&m_document, &m_recompute, &m_preferences, &m_chooser);
        auto* process = dialog.findChild<QComboBox*>(QStringLiteral("printProcess"));
        for (int i = 0; i < process->count(); ++i) {
            process->setCurrentIndex(i);
            const PrintOptions options = dialog.printing()->options();
            QCOMPARE(options.process, static_cast<PrintProcess>(i));
            QCOMPARE(options.smallestDiameter(), printProcesses()[std::size_t(i)].thinnest);
        }
    }
    void aPrintIsPreparedAndWritten()
    {
        ExportDialog dialog(&m_document, &m_recompute, &m_preferences, &m_chooser);
        dialog.show();
        dialog.setFormat(QStringLiteral("3mf"));
        dialog.setPath(m_folder.filePath(QStringLiteral("t.3mf")));
        dialog.printing()->setWanted(true);
        auto* report = dialog.findChild<QLabel*>(QStringLiteral("printReport"));
        QVERIFY(!report->isVisible());
        dialog.findChild<QPushButton*>(QStringLiteral("printPrepare"))->click();
        QTRY_VERIFY_WITH_TIMEOUT(report->isVisible(), 60'000);
        QVERIFY2(report->text().contains(QLatin1String("1 : ")), qPrintable(report->text()));
        QVERIFY(!QFile::exists(dialog.path()));
        QVERIFY(dialog.isVisible());
        QSignalSpy exported(&dialog, &ExportDialog::exported);
        QTRY_VERIFY(dialog.printing()->isEnabled());
        dialog.startExport();
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, 60'000);
        QVERIFY(QFile::exists(m_folder.filePath(QStringLiteral("t.3mf"))));
    }
    void anotherPrintForgetsTheReport()
    {
        ExportDialog dialog(&m_document, &m_recompute, &m_preferences, &m_chooser);
        dialog.show();
        dialog.setFormat(QStringLiteral("stl"));
        dialog.printing()->setWanted(true);
        auto* report = dialog.findChild<QLabel*>(QStringLiteral("printReport"));
        dialog.findChild<QPushButton*>(QStringLiteral("printPrepare"))->click();
        QTRY_VERIFY_WITH_TIMEOUT(report->isVisible(), 60'000);
        QTRY_VERIFY(dialog.printing()->isEnabled());
        dialog.findChild<QCheckBox*>(QStringLiteral("printDisc"))->click();
        QVERIFY(!report->isVisible());
    }
};

QTEST_MAIN(TestExportPrint)
#include "tst_export_print.moc"
