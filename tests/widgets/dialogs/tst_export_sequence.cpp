#include "core/qt/session/jobs/recompute.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/export/export_dialog.h"
#include "widgets/dialogs/export/moment_form.h"
#include "widgets/dialogs/picture_form.h"
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QSignalSpy>
#include <QSpinBox>

namespace tst_export_sequence {

using namespace ramure;

/// The export dialog about moments, sequences and pictures.
class TestExportSequence : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;
    std::unique_ptr<QTemporaryDir> m_folder;
    Preferences m_preferences;
    Document m_document;
    Recompute m_recompute{&m_document};
    test::FakeChooser m_chooser;
    SequenceTask m_task;
    std::unique_ptr<ExportDialog> m_dialog;

    [[nodiscard]] QString path(const char* name) const
    {
        return m_folder->filePath(QString::fromLatin1(name));
    }
    [[nodiscard]] QStringList files() const
    {
        return QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden, QDir::Name);
    }
    QString message(const char* kind = "problem")
    {
        for (const QLabel* label : m_dialog->findChildren<QLabel*>(QString::fromLatin1(kind)))
            if (label->isVisible())
                return label->text();
        return {};
    }
    QString summary()
    {
        for (const QLabel* label : m_dialog->findChildren<QLabel*>(QStringLiteral("dim")))
            if (label->text().contains(QStringLiteral("about")))
                return label->text();
        return {};
    }
    void setFrames(int first, int last, int step)
    {
        m_dialog->moments()->setMoment(ExportMoment::Sequence);
        m_dialog->findChild<QSpinBox*>(QStringLiteral("firstFrame"))->setValue(first);
        m_dialog->findChild<QSpinBox*>(QStringLiteral("lastFrame"))->setValue(last);
        m_dialog->findChild<QSpinBox*>(QStringLiteral("frameStep"))->setValue(step);
    }

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        m_preferences.setExportSettings({}); // each page has its own of the last time
        m_folder = std::make_unique<QTemporaryDir>();
        test::openNodes(m_document, {test::treeNode(1, "T")});
        QVERIFY(m_recompute.waitForFull(test::patience(20'000)));
        m_dialog = std::make_unique<ExportDialog>(&m_document, &m_recompute, &m_preferences, &m_chooser,
                                                  nullptr, 48);
        m_dialog->setSequenceTask(&m_task);
        m_dialog->setFormat(QStringLiteral("obj"));
        m_dialog->setPath(path("tree.obj"));
        m_dialog->show();
    }
    void cleanup() { QTRY_VERIFY(!m_task.isRunning()); }

    void badSequencesAreTold()
    {
        setFrames(9, 8, 1);
        m_dialog->startExport();
        QVERIFY(message().contains(QStringLiteral("before the first")));
        setFrames(0, 8, 1);
        m_dialog->setPath(path("no/folder/tree.obj"));
        m_dialog->startExport();
        QVERIFY(message().contains(QStringLiteral("folder")));
        QVERIFY(m_dialog->isVisible());
        QVERIFY(files().isEmpty());
    }

    void namesNumberAndSizeAreSaidBefore()
    {
        QVERIFY(!summary().contains(QStringLiteral("…")));
        setFrames(0, 250, 2);
        QVERIFY2(summary().contains(QStringLiteral("tree_0000.obj … tree_0250.obj")), qPrintable(summary()));
        QVERIFY2(summary().contains(QStringLiteral("252")), qPrintable(summary())); // with their materials
        m_dialog->setFormat(QStringLiteral("ply"));
        QVERIFY2(summary().contains(QStringLiteral("126")), qPrintable(summary()));
        QVERIFY2(summary().contains(QStringLiteral("tree_0250.ply")), qPrintable(summary()));
        m_dialog->setPictureLook({});
        m_dialog->setFormat(QStringLiteral("png"));
        m_dialog->moments()->setMoment(ExportMoment::Turntable);
        QVERIFY2(summary().contains(QStringLiteral("tree_0000.png … tree_0071.png")), qPrintable(summary()));
        m_dialog->setFormat(QStringLiteral("obj"));                      // there is no turntable of meshes
        QCOMPARE(m_dialog->moments()->moment(), ExportMoment::Sequence); // of its own page
    }

    void framesAreWrittenBesideTheWork()
    {
        QSignalSpy finished(&m_task, &Job::finished);
        QSignalSpy started(m_dialog.get(), &ExportDialog::started);
        setFrames(10, 12, 2);
        m_dialog->startExport();
        QCOMPARE(started.count(), 1);
        QVERIFY(!m_dialog->isVisible());
        QVERIFY(finished.wait(test::patience(20'000)));
        QVERIFY(!finished[0][0].value<std::optional<Error>>());
        QCOMPARE(files(), (QStringList{QStringLiteral("tree_0010.mtl"), QStringLiteral("tree_0010.obj"),
                                       QStringLiteral("tree_0012.mtl"), QStringLiteral("tree_0012.obj")}));
    }

    void theFrameOnShowIsOneFile()
    {
        QSignalSpy exported(m_dialog.get(), &ExportDialog::exported);
        m_dialog->startExport();
        QTRY_COMPARE(exported.count(), 1);
        QFile rest(path("tree.obj"));
        QVERIFY(rest.open(QIODevice::ReadOnly));
        const QByteArray before = rest.readAll();
        m_dialog->setPath(path("moved.obj"));
        m_dialog->moments()->setMoment(ExportMoment::Shown);
        m_dialog->startExport();
        QTRY_COMPARE(exported.count(), 2);
        QFile moved(path("moved.obj"));
        QVERIFY(moved.open(QIODevice::ReadOnly));
        const QByteArray after = moved.readAll();
        QCOMPARE(after.count("\nv "), before.count("\nv "));
        QVERIFY(after.mid(after.indexOf("\nv ")) != before.mid(before.indexOf("\nv ")));
    }

    void filesAreReplacedOnlyWhenAgreed()
    {
        QFile file(path("tree_0011.obj"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("kept") == 4);
        file.close();
        setFrames(10, 12, 1);
        m_dialog->startExport();
        QVERIFY(m_dialog->isVisible());
        QVERIFY(!message("problem").isEmpty());
        QCOMPARE(QFileInfo(path("tree_0011.obj")).size(), qint64(4));
        QSignalSpy finished(&m_task, &Job::finished);
        m_dialog->startExport();
        QVERIFY(finished.wait(test::patience(20'000)));
        QVERIFY(QFileInfo(path("tree_0011.obj")).size() > 100);
    }

    void oneSequenceAtATime()
    {
        setFrames(0, 5000, 1);
        m_dialog->startExport();
        QVERIFY(m_task.isRunning());
        ExportDialog second(&m_document, &m_recompute, &m_preferences, &m_chooser);
        second.setSequenceTask(&m_task);
        second.setPath(path("other.obj"));
        second.moments()->setMoment(ExportMoment::Sequence);
        second.show();
        second.startExport();
        QVERIFY(second.isVisible());
        QSignalSpy finished(&m_task, &Job::finished);
        m_task.cancel();
        QVERIFY(finished.wait(test::patience(20'000)));
        QCOMPARE(finished[0][0].value<std::optional<Error>>()->code, ErrorCode::Cancelled);
        for (const QString& name : files())
            QVERIFY2(name.startsWith(QStringLiteral("tree_")) && !name.contains(QStringLiteral(".new")),
                     qPrintable(name));
    }

    void filmsNeedTheirEncoderAndManyPictures()
    {
        const QByteArray before = qgetenv("PATH");
        qputenv("PATH", QFile::encodeName(m_folder->path()));
        m_dialog->setPictureLook({});
        m_dialog->setFormat(QStringLiteral("mp4"));
        QCOMPARE(m_dialog->moments()->moment(), ExportMoment::Turntable);
        QVERIFY(m_dialog->path().endsWith(QStringLiteral("tree.mp4")));
        QVERIFY(!m_dialog->findChild<QCheckBox*>(QStringLiteral("pictureTransparent"))->isEnabled());
        m_dialog->startExport();
        QVERIFY(message().contains(QStringLiteral("ffmpeg")));
        QFile encoder(path("ffmpeg"));
        QVERIFY(encoder.open(QIODevice::WriteOnly));
        encoder.close();
        QVERIFY(encoder.setPermissions(QFile::ReadOwner | QFile::ExeOwner));
        m_dialog->moments()->setMoment(ExportMoment::Shown);
        m_dialog->startExport();
        QVERIFY(message().contains(QStringLiteral("all sides")));
        m_dialog->setPath(path("tree.png"));
        m_dialog->startExport();
        QVERIFY(message().contains(QStringLiteral(".mp4")));
        QVERIFY(m_dialog->isVisible());
        qputenv("PATH", before);
    }

    void picturesWithoutOpenGlAreTold()
    {
        m_dialog->setPictureLook({});
        m_dialog->setFormat(QStringLiteral("png"));
        QCOMPARE(m_dialog->moments()->moment(), ExportMoment::Shown);
        QVERIFY(m_dialog->path().endsWith(QStringLiteral("tree.png")));
        QSignalSpy finished(&m_task, &Job::finished);
        m_dialog->startExport();
        QVERIFY(finished.count() == 1 || finished.wait(test::patience(20'000)));
        if (qEnvironmentVariableIsEmpty("DISPLAY")) {
            QCOMPARE(finished[0][0].value<std::optional<Error>>()->code, ErrorCode::Unknown);
        }
    }

    void endingWhileASequenceIsWritten()
    {
        for (int i = 0; i < 3; ++i) {
            SequenceTask task;
            QSignalSpy progress(&task, &Job::progress);
            task.startMeshes(m_document, {}, {0, 5000, 1, 24.0}, path("closed.ply"));
            QTRY_VERIFY(progress.count() >= i);
        }
        for (const QString& name : files())
            QVERIFY2(!name.contains(QStringLiteral(".new")), qPrintable(name));
    }
};

RAMURE_SUITE(TestExportSequence)

} // namespace tst_export_sequence

#include "tst_export_sequence.moc"
