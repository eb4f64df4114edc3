#include "core/qt/document/project/project_file.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/actions/file_actions.h"
#include "widgets/actions/import_actions.h"
#include "widgets/base/action_set.h"
#include "widgets/base/theme/preferences.h"
#include <QMenu>
#include <QSignalSpy>
#include <unistd.h>

namespace tst_file_actions {

using namespace ramure;

namespace {

QByteArray bytesOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void write(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
}

} // namespace

class TestFileActions : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Preferences> m_preferences;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<test::FakeChooser> m_chooser;
    std::unique_ptr<ActionSet> m_set;
    std::unique_ptr<FileActions> m_files;

    [[nodiscard]] QString path(const char* name) const
    {
        return m_folder->filePath(QString::fromLatin1(name));
    }
    void edit()
    {
        const NodeId id = m_document->scene().nodes().front().id;
        QVERIFY(edit::setParam(*m_document, {id}, *findParam("turtle.alpha"),
                               0.1 + 0.001 * m_document->undoStack()->count()));
        QVERIFY(m_document->isModified());
    }

private slots:
    /// Named by its file; off, with the reason, where there is nothing to repeat.
    void theLastExportIsNamed()
    {
        QAction* again = m_set->find(QStringLiteral("file.exportAgain"));
        QVERIFY(again && !again->isEnabled() &&
                again->toolTip().contains(QStringLiteral("Nothing was exported")));
        QSignalSpy asked(m_files.get(), &FileActions::exportAgainRequested);
        again->trigger();
        QCOMPARE(asked.count(), 0);
        m_files->setLastExport(path("a & b.glb"));
        QVERIFY(again->isEnabled() && again->text().contains(QStringLiteral("a && b.glb")));
        QVERIFY(again->toolTip().contains(QDir::toNativeSeparators(path("a & b.glb"))));
        again->trigger();
        QCOMPARE(asked.count(), 1);
        m_files->setLastExport({});
        QVERIFY(!again->isEnabled() && !again->text().contains(QStringLiteral("glb")));
    }

    void init()
    {
        test::failOnWidgetWarning();
        m_folder = std::make_unique<QTemporaryDir>();
        m_preferences = std::make_unique<Preferences>();
        m_preferences->recentFiles.set({});
        m_document = std::make_unique<Document>();
        m_chooser = std::make_unique<test::FakeChooser>();
        m_set = std::make_unique<ActionSet>();
        m_files = std::make_unique<FileActions>(m_document.get(), m_preferences.get(), m_chooser.get(),
                                                m_set.get(), nullptr);
        QVERIFY(m_files->newFromPreset(QStringLiteral("TinyTree")));
    }
    void cleanup()
    {
        m_files.reset();
        m_document.reset();
    }

    void unknownPresetsLeaveTheDocument()
    {
        edit();
        QVERIFY(!m_files->newFromPreset(QStringLiteral("NoSuchTree")));
        QCOMPARE(m_chooser->reports.size(), 1);
        QCOMPARE(m_chooser->questions, 0);
        QVERIFY(m_document->isModified());
    }

    void filesThatCannotBeReadLeaveTheDocument_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("random") << QByteArray("\x01\xff\x80 no json", 12);
        QTest::newRow("truncated") << QByteArray("{\"format\": \"ramure\", \"version\": 1, \"nodes\": [");
        QTest::newRow("newer") << QByteArray("{\"format\": \"ramure\", \"version\": 999, \"nodes\": []}");
    }
    void filesThatCannotBeReadLeaveTheDocument()
    {
        QFETCH(const QByteArray, bytes);
        QFile file(path("bad.ramure"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        file.close();
        edit();
        const Scene before = m_document->scene();
        QVERIFY(!m_files->openFile(file.fileName()));
        QCOMPARE(m_chooser->reports.size(), 1);
        QVERIFY(m_chooser->reports[0].contains(QStringLiteral("bad.ramure")));
        QCOMPARE(m_chooser->questions, 0); // a bad file costs no question
        QVERIFY(m_document->scene() == before);
        QVERIFY(m_document->isModified());
        QVERIFY(m_document->filePath().isEmpty());
    }

    void missingFilesAreForgotten()
    {
        m_preferences->addRecentFile(path("gone.ramure"));
        QVERIFY(!m_files->openFile(path("gone.ramure")));
        QVERIFY(m_preferences->recentFiles().isEmpty());
    }

    void failedSavingKeepsTheFileAndTheStar()
    {
        m_chooser->answer = path("tree.ramure");
        QVERIFY(m_files->save());
        const QByteArray before = bytesOf(path("tree.ramure"));
        edit();
        // A folder in the file's place, a missing folder: refused for every user, root too.
        for (const QString& bad : {m_folder->path(), path("no/such/folder/tree.ramure")}) {
            m_chooser->answer = bad;
            m_chooser->reports.clear();
            QVERIFY(!m_files->saveAs());
            QCOMPARE(m_chooser->reports.size(), 1);
            QVERIFY(m_document->isModified());
            QCOMPARE(m_document->filePath(), path("tree.ramure"));
        }
        QCOMPARE(bytesOf(path("tree.ramure")), before);
    }

    void readOnlyFoldersKeepTheStar()
    {
        m_chooser->answer = path("tree.ramure");
        QVERIFY(m_files->save());
        edit();
        QVERIFY(QFile::setPermissions(m_folder->path(), QFile::ReadOwner | QFile::ExeOwner |
                                                            QFile::ReadOther | QFile::ExeOther));
        const bool isRoot = geteuid() == 0; // may write everywhere: it tries as nobody
        QVERIFY(!isRoot || seteuid(65534) == 0);
        const bool saved = m_files->save();
        QVERIFY(!isRoot || seteuid(0) == 0);
        QVERIFY(!saved);
        QVERIFY(m_document->isModified());
        QVERIFY(
            QFile::setPermissions(m_folder->path(), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
        QVERIFY(m_files->save());
        QVERIFY(!m_document->isModified());
    }

    void savedFilesOpenAsTheyWere()
    {
        edit();
        m_chooser->answer = path("tree.ramure");
        m_set->find(QStringLiteral("file.save"))->trigger(); // asks for a name: there is none yet
        QCOMPARE(m_chooser->saves, 1);
        QVERIFY(m_chooser->lastSuggestion.endsWith(QStringLiteral("TinyTree.ramure")));
        QVERIFY(!m_document->isModified());
        QCOMPARE(m_document->filePath(), path("tree.ramure"));
        const Scene saved = m_document->scene();
        edit();
        m_set->find(QStringLiteral("file.save"))->trigger();
        QCOMPARE(m_chooser->saves, 1);
        m_document->undo();
        QVERIFY(m_document->isModified());
        QVERIFY(m_files->newFromPreset(QStringLiteral("SmallTree")) == false); // asked: Cancel
        m_chooser->unsaved = Chooser::Unsaved::Save;
        QVERIFY(m_files->newFromPreset(QStringLiteral("SmallTree")));
        m_chooser->answer = path("tree.ramure");
        m_set->find(QStringLiteral("file.open"))->trigger();
        QVERIFY(m_document->scene() == saved);
        QVERIFY(!m_document->isModified());
        QVERIFY(!m_document->selection().nodes.empty());
    }

    void theQuestionDecides()
    {
        edit();
        QVERIFY(!m_files->mayDiscard());
        m_chooser->unsaved = Chooser::Unsaved::Discard;
        QVERIFY(m_files->mayDiscard());
        m_chooser->unsaved = Chooser::Unsaved::Save;
        m_chooser->answer.clear(); // and then cancels the file dialog
        QVERIFY(!m_files->mayDiscard());
        m_chooser->answer = path("asked.ramure");
        QVERIFY(m_files->mayDiscard());
        QVERIFY(QFileInfo::exists(path("asked.ramure")));
        m_chooser->questions = 0;
        QVERIFY(m_files->mayDiscard());
        QCOMPARE(m_chooser->questions, 0); // nothing to lose
    }

    void objectsOpenIntoANewScene_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("obj") << "rock.obj" << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        QTest::newRow("OBJ") << "ROCK.OBJ" << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        QTest::newRow("ply") << "rock.ply"
                             << QByteArray("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                                           "property float y\nproperty float z\nelement face 1\n"
                                           "property list uchar int vertex_indices\nend_header\n"
                                           "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
        QTest::newRow("keys") << "rock.animation" << QByteArray("0,LINEAR,0,0,0,0,0,0,1,1,1,1\n");
    }
    void objectsOpenIntoANewScene()
    {
        QFETCH(const QString, name);
        QFETCH(const QByteArray, bytes);
        QWidget window;
        ImportActions imports(m_document.get(), m_preferences.get(), m_chooser.get(), m_set.get(), &window);
        m_files->setImports(&imports);
        m_chooser->answer = m_folder->filePath(name);
        write(m_chooser->answer, bytes);
        QSignalSpy ended(m_files.get(), &FileActions::openEnded);
        edit();
        QVERIFY(m_files->open()); // asked: Cancel
        QTRY_COMPARE(ended.count(), 1);
        QVERIFY(!ended.takeFirst()[0].toBool());
        QCOMPARE(m_chooser->questions, 1);
        QCOMPARE(m_document->scene().nodes()[0].name, std::string("TinyTree"));
        m_chooser->unsaved = Chooser::Unsaved::Discard;
        QVERIFY(m_files->open());
        QTRY_COMPARE(ended.count(), 1);
        QVERIFY(ended[0][0].toBool());
        QCOMPARE(m_document->scene().nodes().size(), std::size_t(1));
        QCOMPARE(QString::fromStdString(m_document->scene().nodes()[0].name), QFileInfo(name).baseName());
        QCOMPARE(m_document->selection().nodes.size(), std::size_t(1));
        QVERIFY(m_document->filePath().isEmpty());
        QCOMPARE(m_files->documentName(), QStringLiteral("Untitled"));
        QVERIFY(!m_document->isModified());
        QCOMPARE(m_preferences->recentFiles().value(0), m_chooser->answer);
        m_files->setImports(nullptr);
    }
    void objectsThatCannotBeReadLeaveTheDocument()
    {
        QWidget window;
        ImportActions imports(m_document.get(), m_preferences.get(), m_chooser.get(), m_set.get(), &window);
        m_files->setImports(&imports);
        QSignalSpy ended(m_files.get(), &FileActions::openEnded);
        write(path("bad.obj"), "v 0 0 0\nv 1 0 0\nf 1 2 7\n");
        m_preferences->addRecentFile(path("gone.ply"));
        edit();
        const Scene before = m_document->scene();
        for (const auto& [name, reason] : {std::pair("bad.obj", "3"), std::pair("gone.ply", "gone.ply")}) {
            m_chooser->reports.clear();
            m_files->openFile(path(name));
            QTRY_COMPARE(ended.count(), 1);
            QVERIFY(!ended.takeFirst()[0].toBool());
            QCOMPARE(m_chooser->reports.size(), 1);
            QVERIFY2(m_chooser->reports[0].contains(QLatin1String(name)) &&
                         m_chooser->reports[0].contains(QLatin1String(reason)),
                     qPrintable(m_chooser->reports[0]));
        }
        QCOMPARE(m_chooser->questions, 0);
        QVERIFY(m_document->scene() == before);
        QVERIFY(!m_preferences->recentFiles().contains(path("gone.ply")));
        // What is no file of ours at all is not said to be bad JSON.
        m_chooser->reports.clear();
        write(path("tree.dae"), "solid tree\n");
        QVERIFY(!m_files->openFile(path("tree.dae")));
        QVERIFY2(m_chooser->reports[0].contains(QStringLiteral("unknown file ending")),
                 qPrintable(m_chooser->reports[0]));
        m_files->setImports(nullptr);
    }

    void unknownKeysSurviveOpenAndSave()
    {
        m_chooser->answer = path("tree.ramure");
        QVERIFY(m_files->save());
        QByteArray bytes = bytesOf(path("tree.ramure"));
        bytes.replace(bytes.indexOf('{'), 1, "{\"future\": {\"key\": 1},");
        QFile file(path("tree.ramure"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        file.close();
        QVERIFY(m_files->openFile(path("tree.ramure")));
        edit();
        QVERIFY(m_files->save());
        QVERIFY(bytesOf(path("tree.ramure")).contains("future"));
    }

    void missingPicturesAreNamedWhenAProjectIsOpened()
    {
        const NodeId tree = m_document->scene().nodes().front().id;
        const std::string gone = QFile::encodeName(path("gone.png")).toStdString();
        QVERIFY(edit::setParam(*m_document, {tree}, *findParam("bark.colourPicture"), gone));
        m_chooser->answer = path("tree.ramure");
        QVERIFY(m_files->save());
        QVERIFY(m_chooser->reports.isEmpty());
        QVERIFY(m_files->openFile(path("tree.ramure")));
        QCOMPARE(m_chooser->reports.size(), 1);
        QVERIFY(m_chooser->reports.front().contains(QStringLiteral("gone.png")));
        QCOMPARE(m_document->scene().nodes().front().params.barkPictures.colour, gone);
    }

    void anEmptySceneIsOfferedFirst()
    {
        QMenu menu;
        m_files->fillNewMenus(&menu);
        QAction* empty = menu.actions().front();
        QCOMPARE(empty, m_set->find(QStringLiteral("file.newEmpty")));
        edit();
        empty->trigger(); // asked: Cancel
        QVERIFY(m_document->isModified() && !m_document->scene().empty());
        m_chooser->unsaved = Chooser::Unsaved::Discard;
        empty->trigger();
        QVERIFY(m_document->scene().empty() && !m_document->isModified());
        QVERIFY(m_document->selection().nodes.empty() && m_document->filePath().isEmpty());
        m_chooser->answer = path("empty.ramure");
        QVERIFY(m_files->save() && m_files->openFile(path("empty.ramure")));
        QVERIFY(m_document->scene().empty());
    }

    void recentFilesAreListedAndOpen()
    {
        QMenu menu;
        m_files->fillNewMenus(&menu);
        for (const char* name : {"a.ramure", "b.ramure"}) {
            m_chooser->answer = path(name);
            QVERIFY(m_files->saveAs());
        }
        QCOMPARE(m_preferences->recentFiles(), QStringList({path("b.ramure"), path("a.ramure")}));
        QMenu* recent = nullptr;
        for (QMenu* each : menu.findChildren<QMenu*>()) {
            if (each->title().contains(QStringLiteral("recent")))
                recent = each;
        }
        QVERIFY(recent);
        emit recent->aboutToShow();
        recent->actions().at(1)->trigger();
        QCOMPARE(m_document->filePath(), path("a.ramure"));
        for (int i = 0; i < 2 * Preferences::maxRecentFiles; ++i)
            m_preferences->addRecentFile(path("x") + QString::number(i));
        QCOMPARE(m_preferences->recentFiles().size(), Preferences::maxRecentFiles);
    }

    void everyActionHasTextAndTooltip()
    {
        for (const QAction* action : m_set->actions()) {
            QVERIFY2(!action->text().isEmpty(), qPrintable(action->objectName()));
            QVERIFY2(!action->toolTip().isEmpty(), qPrintable(action->objectName()));
        }
    }
};

RAMURE_SUITE(TestFileActions)

} // namespace tst_file_actions

#include "tst_file_actions.moc"
