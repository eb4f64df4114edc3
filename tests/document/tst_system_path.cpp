#include "core/qt/base/system_path.h"

#include "core/base/file_writer.h"
#include "core/qt/document/project/project_file.h"
#include "tests/support/suite.h"
#include <QFile>
#include <QScopeGuard>
#include <QTemporaryDir>
#include <filesystem>
#include <random>

namespace tst_system_path {

using namespace ramure;

/// Names of files that are no UTF-8.
class TestSystemPath : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void filesThatCannotBeOpened()
    {
        const QTemporaryDir folder;
        QFile file;
        const auto opened = openToRead(file, pathText(folder.path().toStdString() + "/\xEA"));
        QVERIFY(!opened);
        QCOMPARE(opened.error().code, ErrorCode::Io);
        QCOMPARE(opened.error().file, folder.path().toStdString() + "/\xEA");
        QCOMPARE(opened.error().plain(), std::string("cannot be opened: No such file or directory"));
        const auto opensFolder = openToRead(file, folder.path());
        QVERIFY(!opensFolder);
        QCOMPARE(opensFolder.error().plain(), std::string("cannot be opened: Is a directory"));
    }

    /// No two names become one, whatever their bytes are.
    void bytesComeBack()
    {
        std::minstd_rand random(5);
        for (int i = 0; i < 20'000; ++i) {
            std::string bytes;
            for (const std::size_t length = random() % 12; bytes.size() < length;)
                bytes += static_cast<char>(random() % 3 == 0 ? random() % 256 : 0x80 + random() % 128);
            const QString text = pathText(bytes);
            QCOMPARE(systemPath(text), bytes);
            QCOMPARE(systemPath(u'a' + text + QStringLiteral("/b")), "a" + bytes + "/b");
        }
        for (const QString& text :
             {QStringLiteral("a"), QString(), QStringLiteral("ch\u00EAne/\U0001F333")}) {
            QCOMPARE(pathText(text.toStdString()), text);
            QCOMPARE(systemPath(text), text.toStdString());
        }
    }

    void projectsOfSuchNames()
    {
        const QTemporaryDir folder;
        const std::string made = folder.path().toStdString() + "/\xE9t\xE9";
        QVERIFY(makeFolder(made));
        // Qt knows no such names: it could not remove them.
        const auto remover = qScopeGuard([&made] { std::filesystem::remove_all(made); });
        for (const char* name : {"/ch\xEAne.ramure", "/ch\xE9ne.ramure"}) {
            const QString path = pathText(made + name);
            Project project;
            project.extras = name[3] == '\xEA' ? R"({"mine": 1})" : R"({"mine": 2})";
            const auto saved = saveProjectFile(project, path);
            QVERIFY2(saved, test::why(saved));
        }
        for (const char* name : {"/ch\xEAne.ramure", "/ch\xE9ne.ramure"}) {
            const auto project = loadProjectFile(pathText(made + name));
            QVERIFY2(project, test::why(project));
            QVERIFY(project->extras.find(name[3] == '\xEA' ? '1' : '2') != std::string::npos);
        }
    }
};

RAMURE_SUITE(TestSystemPath)

} // namespace tst_system_path

#include "tst_system_path.moc"
