#include "core/qt/session/jobs/analysis.h"
#include "core/qt/session/jobs/recompute.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/export/export_dialog.h"
#include "widgets/dialogs/export/export_task.h"
#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <algorithm>

namespace tst_export_dialog {

using namespace ramure;

class TestExportDialog : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;
    QTemporaryDir m_folder;
    Preferences m_preferences;
    Document m_document;
    Recompute m_recompute{&m_document};
    test::FakeChooser m_chooser;

    [[nodiscard]] QString path(const char* name) const
    {
        return m_folder.filePath(QString::fromLatin1(name));
    }

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        m_preferences.setExportSettings({}); // each page has its own of the last time
        test::openNodes(m_document, {test::treeNode(1, "T")});
        QVERIFY(m_recompute.waitForFull(test::patience(20'000)));
    }

    void foldersThatDoNotExistAreTold()
    {
        ExportDialog dialog(&m_document, &m_recompute, &m_preferences, &m_chooser);
        dialog.setPath(path("no/folder/tree.obj"));
        dialog.show();
        dialog.startExport();
        auto* message = dialog.findChild<QLabel*>(QStringLiteral("problem"));
        QTRY_VERIFY((message = dialog.findChild<QLabel*>(QStringLiteral("problem"))) != nullptr);
        QVERIFY(!message->text().isEmpty());
        QVERIFY(dialog.isVisible());
    }

    void unknownEndingsAreTold()
    {
        ExportDialog dialog(&m_document, &m_recompute, &m_preferences, &m_chooser);
        dialog.setPath(path("tree.dae"));
        dialog.startExport();
        QVERIFY(dialog.findChild<QLabel*>(QStringLiteral("problem")));
        QVERIFY(!QFileInfo::exists(path("tree.dae")));
    }

    void theUsualNameIsPlain()
    {
        for (const auto& [name, file] :
             {std::pair("Chêne pédonculé", "Chene_pedoncule.obj"),
              std::pair("Œillet n° 3 (vieux)", "Oeillet_n_3_vieux.obj"), std::pair("橡树", "tree.obj")}) {
            test::openNodes(m_document, {test::treeNode(1, name)});
            const ExportDialog dialog(&m_document, &m_recompute, &m_preferences, &m_chooser);
            QCOMPARE(QFileInfo(dialog.path()).completeBaseName(),
                     QFileInfo(QString::fromLatin1(file)).completeBaseName());
        }
        QVERIFY(m_recompute.waitForFull(test::patience(20'000)));
    }

    void filesAreWritten_data()
    {
        QTest::addColumn<QString>("format");
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("begin");
        QTest::newRow("obj") << "obj"
                             << "a.obj" << QByteArray("#");
        QTest::newRow("ply") << "ply"
                             << "b.ply" << QByteArray("ply\nformat binary_little_endian");
        QTest::newRow("text ply") << "ply-text"
                                  << "c.ply" << QByteArray("ply\nformat ascii");
        QTest::newRow("without ending") << "ply-text"
                                        << "d" << QByteArray("ply\nformat ascii");
    }
    void filesAreWritten()
    {
        QFETCH(const QString, format);
        QFETCH(const QString, name);
        QFETCH(const QByteArray, begin);
        ExportDialog dialog(&m_document, &m_recompute, &m_preferences, &m_chooser);
        QSignalSpy exported(&dialog, &ExportDialog::exported);
        dialog.setFormat(format);
        dialog.setPath(m_folder.filePath(name));
        dialog.startExport();
        QTRY_COMPARE(exported.count(), 1);
        QFile file(exported[0][0].toString());
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.read(200).startsWith(begin));
    }

    void leavesAreMergedOrListed()
    {
        Node leafy = test::treeNode(1, "T");
        leafy.params.foliage.leavesCutoff = 10.0;
        test::openNodes(m_document, {leafy});
        QVERIFY(m_recompute.waitForFull(test::patience(20'000)));
        ExportDialog dialog(&m_document, &m_recompute, &m_preferences, &m_chooser);
        auto* foliage = dialog.findChild<QComboBox*>(QStringLiteral("exportInstances"));
        QVERIFY(foliage && foliage->isEnabled() && !foliage->toolTip().isEmpty());
        QVERIFY(!dialog.options().instances);
        dialog.setFormat(QStringLiteral("ply"));
        QVERIFY(dialog.options().parts == exportBranches);
        foliage->setCurrentIndex(1);
        QVERIFY(dialog.options().instances && dialog.options().parts == exportAll);
        QSignalSpy exported(&dialog, &ExportDialog::exported);
        dialog.setPath(path("listed.ply"));
        dialog.startExport();
        QTRY_COMPARE(exported.count(), 1);
        QVERIFY(QFileInfo(path("listed_leaves.csv")).size() > 100);
    }

    void filesAreReplacedOnlyWhenAgreed()
    {
        const QString old = path("mine.obj");
        QFile file(old);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("kept") == 4);
        file.close();
        ExportDialog dialog(&m_document, &m_recompute, &m_preferences, &m_chooser);
        QSignalSpy exported(&dialog, &ExportDialog::exported);
        dialog.setPath(old);
        dialog.startExport();
        auto* message = dialog.findChild<QLabel*>(QStringLiteral("problem"));
        QVERIFY(message && message->text().contains(QStringLiteral("mine.obj")));
        QCOMPARE(QFileInfo(old).size(), qint64(4));
        const auto buttons = dialog.findChildren<QPushButton*>();
        const auto asks = [](const QPushButton* button) {
            return button->text() == QStringLiteral("Replace");
        };
        QVERIFY(std::ranges::any_of(buttons, asks));
        dialog.startExport();
        QTRY_COMPARE(exported.count(), 1);
        QVERIFY(QFileInfo(old).size() > 1000);
    }

    /// Branches that run through each other are the tree's doing: its mesh is not called faulty.
    void collisionsAreNoFaultOfTheMesh()
    {
        Analysis analysis(&m_document, [](const BranchMesh&, const Skeleton&, const Progress&) {
            MeshAnalysis found;
            found.crossings.kindsKnown = true;
            found.crossings.counts = {0, 0, 0, 5};
            found.collisions.push_back({3, 9, 5, {}, 0.01});
            return Expected<MeshAnalysis>(found);
        });
        ExportDialog dialog(&m_document, &m_recompute, &m_preferences, &m_chooser);
        dialog.setAnalysis(&analysis);
        dialog.show();
        QVERIFY(analysis.waitForAll(10'000));
        const QString text = dialog.findChild<QLabel*>(QStringLiteral("meshFaults"))->text();
        QVERIFY2(text.contains(QStringLiteral("is closed. 5 pair")), qPrintable(text));
    }
    void meshesThatAreNotCleanAreTold()
    {
        Analysis analysis(&m_document, [](const BranchMesh&, const Skeleton&, const Progress&) {
            MeshAnalysis found;
            found.crossings.kindsKnown = true;
            found.crossings.counts = {0, 2, 0, 5};
            found.collisions.push_back({3, 9, 5, {}, 0.01});
            return Expected<MeshAnalysis>(found);
        });
        ExportDialog dialog(&m_document, &m_recompute, &m_preferences, &m_chooser);
        QSignalSpy exported(&dialog, &ExportDialog::exported);
        QSignalSpy shown(&dialog, &ExportDialog::showRequested);
        dialog.setPath(path("faulty.obj"));
        dialog.setAnalysis(&analysis);
        dialog.show();
        auto* faults = dialog.findChild<QLabel*>(QStringLiteral("meshFaults"));
        QVERIFY(!faults->isVisible());
        QVERIFY(analysis.waitForAll(10'000));
        QVERIFY(faults->isVisible());
        QVERIFY(faults->text().contains(QStringLiteral("“T”")));
        // Nothing to say of a model that is no continuous mesh, nor without the branches.
        auto* model = dialog.findChild<QComboBox*>(QStringLiteral("exportModel"));
        model->setCurrentIndex(static_cast<int>(ExportModel::Rough));
        QVERIFY(!faults->isVisible());
        model->setCurrentIndex(static_cast<int>(ExportModel::Mesh));
        QVERIFY(faults->isVisible());
        dialog.findChild<QPushButton*>(QStringLiteral("showFaults"))->click();
        QCOMPARE(shown.count(), 1);
        QCOMPARE(shown[0][0].value<NodeId>(), NodeId(1));
        QVERIFY(!dialog.isVisible());
        dialog.show();
        dialog.startExport(); // crossings are no reason to ask
        QTRY_COMPARE(exported.count(), 1);
        QVERIFY(QFileInfo(path("faulty.obj")).size() > 1000);
    }

    void brokenMeshesAreAskedAboutOnce()
    {
        NodeResult result = *m_document.result(1);
        auto report = std::make_shared<MeshReport>(*result.tree.report);
        report->valid = false;
        report->boundaryEdges = 3;
        result.tree.report = report;
        m_document.setResult(1, result);
        ExportDialog dialog(&m_document, &m_recompute, &m_preferences, &m_chooser);
        QSignalSpy exported(&dialog, &ExportDialog::exported);
        dialog.setPath(path("broken.obj"));
        dialog.show();
        auto* faults = dialog.findChild<QLabel*>(QStringLiteral("meshFaults"));
        QVERIFY(faults->property("broken").toBool());
        dialog.startExport(); // asks first
        QCOMPARE(exported.count(), 0);
        QVERIFY(!QFileInfo::exists(path("broken.obj")));
        dialog.startExport();
        QTRY_COMPARE(exported.count(), 1);
    }

    void faultsOfSeveralTreesAreAddedUp()
    {
        test::openNodes(m_document, {test::treeNode(1, "T"), test::treeNode(2, "U")});
        QVERIFY(m_recompute.waitForFull(test::patience(20'000)));
        Analysis analysis(&m_document, [](const BranchMesh&, const Skeleton&, const Progress&) {
            MeshAnalysis found;
            found.crossings.kindsKnown = true;
            found.crossings.counts = {0, 2, 0, 51};
            return Expected<MeshAnalysis>(found);
        });
        QVERIFY(analysis.waitForAll(10'000));
        ExportDialog dialog(&m_document, &m_recompute, &m_preferences, &m_chooser);
        dialog.setAnalysis(&analysis);
        const QString text = dialog.findChild<QLabel*>(QStringLiteral("meshFaults"))->text();
        QVERIFY2(text.contains(QStringLiteral("2 tree")) && text.contains(QStringLiteral("106")),
                 qPrintable(text));
    }

    void collisionsAloneDoNotStopAnExport()
    {
        Analysis analysis(&m_document, [](const BranchMesh&, const Skeleton&, const Progress&) {
            MeshAnalysis found;
            found.crossings.kindsKnown = true;
            found.crossings.counts = {0, 0, 0, 5};
            found.collisions.push_back({3, 9, 5, {}, 0.01});
            return Expected<MeshAnalysis>(found);
        });
        QVERIFY(analysis.waitForAll(10'000));
        ExportDialog dialog(&m_document, &m_recompute, &m_preferences, &m_chooser);
        QSignalSpy exported(&dialog, &ExportDialog::exported);
        dialog.setAnalysis(&analysis);
        dialog.setPath(path("collides.obj"));
        dialog.show();
        QVERIFY(dialog.findChild<QLabel*>(QStringLiteral("meshFaults"))->isVisible());
        dialog.startExport();
        QTRY_COMPARE(exported.count(), 1);
    }

    void aTreeBeingComputedIsWaitedFor()
    {
        ExportDialog dialog(&m_document, &m_recompute, &m_preferences, &m_chooser);
        QSignalSpy exported(&dialog, &ExportDialog::exported);
        dialog.setPath(path("waited.obj"));
        QVERIFY(edit::setParam(m_document, {1}, *findParam("turtle.alpha"), 0.31));
        QTRY_VERIFY(m_recompute.isBusy());
        dialog.startExport();
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, test::patience(20'000));
        QVERIFY(QFileInfo(path("waited.obj")).size() > 1000);
    }

    void choicesFollowTheFormat()
    {
        ExportDialog dialog(&m_document, &m_recompute, &m_preferences, &m_chooser);
        dialog.setPath(path("tree.obj"));
        QCOMPARE(dialog.options().parts, std::uint8_t(exportAll));
        dialog.setFormat(QStringLiteral("ply"));
        QCOMPARE(dialog.options().parts, std::uint8_t(exportBranches));
        QVERIFY(dialog.path().endsWith(QStringLiteral("tree.ply")));
        // Why, is said beside the boxes, for as long as something is left out.
        const auto* note = dialog.findChild<QLabel*>(QStringLiteral("partsNote"));
        QVERIFY(!note->isHidden() && note->text().contains(QStringLiteral("PLY")));
        dialog.setFormat(QStringLiteral("obj"));
        QVERIFY(note->isHidden());
        dialog.setFormat(QStringLiteral("ply-text"));
        QVERIFY(!note->isHidden());
        m_chooser.answer = path("chosen.ply");
        for (QPushButton* button : dialog.findChildren<QPushButton*>()) {
            if (button->text().startsWith(QStringLiteral("Browse")))
                button->click();
        }
        QCOMPARE(dialog.path(), path("chosen.ply"));
    }

    void oldMessagesGoWithTheNextChoice()
    {
        ExportDialog dialog(&m_document, &m_recompute, &m_preferences, &m_chooser);
        dialog.show();
        const auto failed = [&] {
            dialog.setFormat(QStringLiteral("obj"));
            dialog.setPath(path("no/folder/tree.obj"));
            dialog.startExport();
            return QTest::qWaitFor([&] { return dialog.findChild<QLabel*>(QStringLiteral("problem")); });
        };
        QVERIFY(failed());
        auto* message = dialog.findChild<QLabel*>(QStringLiteral("problem"));
        QVERIFY(message->isVisible());
        dialog.setFormat(QStringLiteral("ply"));
        QVERIFY(!message->isVisible() && message->text().isEmpty());
        QVERIFY(failed() && message->isVisible());
        dialog.setPath(path("tree.obj"));
        QVERIFY(!message->isVisible());
        QVERIFY(failed() && message->isVisible());
        dialog.findChild<QCheckBox*>(QStringLiteral("exportTexture"))->click();
        QVERIFY(!message->isVisible());
    }

    void axesAndUnitAreKeptForTheNextExport()
    {
        m_preferences.setExportSpace({});
        const FileSpace chosen{UpAxis::Z, 2, 0.5};
        {
            ExportDialog dialog(&m_document, &m_recompute, &m_preferences, &m_chooser);
            dialog.setFormat(QStringLiteral("obj"));
            QVERIFY(dialog.options().texture); // by default
            QVERIFY(dialog.options().space.isOwn());
            dialog.findChild<QComboBox*>(QStringLiteral("exportUp"))->setCurrentIndex(1);
            dialog.findChild<QComboBox*>(QStringLiteral("exportUnit"))->setCurrentIndex(2);
            auto* scale = dialog.findChild<QAbstractSpinBox*>(QStringLiteral("exportScale"));
            scale->selectAll();
            QTest::keyClicks(scale, QStringLiteral("0.5"));
            QTest::keyClick(scale, Qt::Key_Return);
            QVERIFY(dialog.options().space == chosen);
            QSignalSpy exported(&dialog, &ExportDialog::exported);
            dialog.setPath(path("turned.obj"));
            dialog.startExport();
            QTRY_COMPARE(exported.count(), 1);
        }
        QVERIFY(*fileSpaceOf(path("turned.obj").toStdString()) == chosen);
        ExportDialog next(&m_document, &m_recompute, &m_preferences, &m_chooser);
        QVERIFY(next.options().space == chosen);
        m_preferences.setExportSpace({});
    }

    void aTaskCanBeCancelled()
    {
        ExportTask task;
        std::optional<Error> error;
        bool done = false;
        connect(&task, &ExportTask::finished, this, [&](const std::optional<Error>& e) {
            error = e;
            done = true;
        });
        task.startExport(m_document, {}, path("cancelled.obj"));
        task.cancel();
        QVERIFY(task.isRunning());
        QTRY_VERIFY(done);
        QVERIFY(!task.isRunning());
        // Cancelled in time, or done already: in both cases the file is whole or not there.
        QCOMPARE(QFileInfo::exists(path("cancelled.obj")), !error.has_value());
    }
};

RAMURE_SUITE(TestExportDialog)

} // namespace tst_export_dialog

#include "tst_export_dialog.moc"
