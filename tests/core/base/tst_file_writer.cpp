#include "core/base/file_writer.h"
#include "tests/core/io/io_support.h"
#include "tests/support/failing_disk.h"
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QScopeGuard>
#include <QTemporaryDir>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <unistd.h>

namespace tst_file_writer {

using namespace ramure;

namespace {

Error errorOf(const QString& path, const MeshPart& part)
{
    const auto result = writeObj(path.toStdString(), {&part, 1});
    if (result)
        qFatal("written without an error: %s", qPrintable(path));
    return result.error();
}

} // namespace

class TestFileWriter : public QObject
{
    Q_OBJECT
    TriangleMesh m_mesh = test::tetrahedron();
    MeshPart m_part{"branches", &m_mesh, barkMaterial()};

private slots:
    void init() { test::failOnAnyWarning(); }

    void missingFolder()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("none/x.obj");
        const Error error = errorOf(path, m_part);
        QCOMPARE(error.code, ErrorCode::Io);
        QCOMPARE(error.message(), path.toStdString() + ": cannot be written: No such file or directory");
    }
    void partsOfKilledWritersGoAndNothingElse()
    {
        QTemporaryDir folder;
        const auto make = [&folder](const QString& name, int secondsAgo) {
            const QString path = folder.filePath(name);
            test::writeBytes(path, "half a file");
            QFile file(path);
            const QDateTime then = QDateTime::currentDateTime().addSecs(-secondsAgo);
            return file.open(QIODevice::ReadWrite) &&
                   file.setFileTime(then, QFileDevice::FileModificationTime);
        };
        const QString gone = QStringLiteral("2147483646"); // no process has that number
        const QString alive = QString::number(::getpid());
        const QStringList stay{
            "x.obj",
            "x.obj.backup",
            "x.obj.new-" + gone,
            "x.obj.new-" + gone + "-",
            "x.obj.new-" + gone + "-1a",
            "x.obj.new--1",
            "x.obj.new-" + gone + "-1.obj",
            "x.obj.new-99999999999999999999-1",
            "y.obj.new-" + gone + "-1",
            "xx.obj.new-" + gone + "-1",
            "x.obj.new-" + alive + "-77",
        };
        for (const QString& name : stay)
            QVERIFY(make(name, 600));
        QVERIFY(make("x.obj.new-" + gone + "-1", 600));
        QVERIFY(make("x.obj.new-" + gone + "-2", 60));
        QVERIFY(make("x.obj.new-" + alive + "-3", 4000)); // of another machine, long ago
        QVERIFY(make("x.obj.new-" + gone + "-4", 0)); // of another sandbox, perhaps, which writes just now
        QVERIFY(QDir(folder.path()).mkdir("x.obj.new-" + gone + "-5"));
        QVERIFY(QFile::link(folder.filePath("x.obj"), folder.filePath("x.obj.new-" + gone + "-6")));
        QCOMPARE(removeAbandonedParts(folder.filePath("x.obj").toStdString()), 3);
        for (const QString& name : stay)
            QVERIFY2(QFileInfo::exists(folder.filePath(name)), qPrintable(name));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Dirs | QDir::NoDotAndDotDot).size(),
                 stay.size() + 3);
        QVERIFY(make("x.obj.new-" + gone + "-1", 600));
        QVERIFY(writeObj(folder.filePath("x.obj").toStdString(), {&m_part, 1})); // the next save
        QVERIFY(!QFileInfo::exists(folder.filePath("x.obj.new-" + gone + "-1")));
        QCOMPARE(removeAbandonedParts(""), 0);
        QCOMPARE(removeAbandonedParts("/no/such/folder/x.obj"), 0);
    }
    void targetIsAFolder()
    {
        QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkdir("x.obj"));
        QCOMPARE(errorOf(folder.filePath("x.obj"), m_part).args[0], std::string("Is a directory"));
        QVERIFY(QDir(folder.path()).mkdir("y.mtl"));
        QCOMPARE(errorOf(folder.filePath("y.obj"), m_part).file, folder.filePath("y.mtl").toStdString());
        QVERIFY(!QFileInfo::exists(folder.filePath("y.obj")));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 0);
    }
    void readOnly()
    {
        if (::geteuid() == 0) {
            QVERIFY(errorOf("/sys/ramure-test.obj", m_part).code == ErrorCode::Io); // even root may not
            return;
        }
        QTemporaryDir folder;
        test::writeBytes(folder.filePath("old.obj"), "old");
        QVERIFY(QFile::setPermissions(folder.filePath("old.obj"), QFile::ReadOwner));
        QCOMPARE(errorOf(folder.filePath("old.obj"), m_part).args[0], std::string("Permission denied"));
        QVERIFY(QFile::setPermissions(folder.path(), QFile::ReadOwner | QFile::ExeOwner));
        QCOMPARE(errorOf(folder.filePath("new.obj"), m_part).args[0], std::string("Permission denied"));
        QCOMPARE(test::fileBytes(folder.filePath("old.obj")), QByteArray("old"));
        QFile::setPermissions(folder.path(), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    }
    void fullDisk()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("full.obj");
        QVERIFY(QFile::link("/dev/full", path));
        QCOMPARE(errorOf(path, m_part).message(),
                 path.toStdString() + ": cannot be written: No space left on device");
        const QString ply = folder.filePath("full.ply");
        QVERIFY(QFile::link("/dev/full", ply));
        const auto result = writePly(ply.toStdString(), {&m_part, 1}, {});
        QVERIFY(!result);
        QCOMPARE(result.error().code, ErrorCode::Io);
        QVERIFY(QFileInfo(path).isSymLink());
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::System).size(), 2); // nothing left behind
    }
    /// Of errors with the same words: batches stop at one, and go on after the others.
    void aFullDiskIsToldFromOtherErrors()
    {
        for (const int code : {ENOSPC, EDQUOT})
            QVERIFY(isDiskFull(writeError("a.obj", code)) && isWriteError(writeError("a.obj", code)));
        for (const int code : {EIO, EACCES, EFBIG, ENAMETOOLONG, EROFS})
            QVERIFY(!isDiskFull(writeError("a.obj", code)) && isWriteError(writeError("a.obj", code)));
        const Error other = fail(ErrorCode::Io, "cannot be written: %1").value();
        QVERIFY(!isDiskFull(other) && !isWriteError(other));
        QVERIFY(isDiskFull(errorOf("/dev/full", m_part)));
    }
    void foldersAreMade()
    {
        QTemporaryDir folder;
        const std::string path = folder.filePath("a/b/ch\xC3\xAAne/").toStdString() + "\xEA";
        // Qt knows no such names: it could not remove them.
        const auto remover =
            qScopeGuard([&folder] { std::filesystem::remove_all(folder.filePath("a").toStdString()); });
        for (int i = 0; i < 2; ++i) { // made, and there already
            const auto made = makeFolder(path);
            QVERIFY2(made, test::why(made));
        }
        QVERIFY(writeFile(path + "/x", "1"));
        for (const std::string& bad : {path + "/x", path + "/x/y"}) {
            const auto made = makeFolder(bad);
            QVERIFY(!made);
            QCOMPARE(made.error().message(), bad + ": the folder cannot be made: Not a directory");
        }
        QVERIFY(!makeFolder("/sys/ramure"));
    }
    void oldFilesSurviveEveryError()
    {
        test::checkNothingLost([](const QString& folder, int version) {
            const std::string text(700'000, version == 0 ? 'a' : 'b'); // some writes
            return writeFile(folder.toStdString() + "/x", text);
        });
    }
    void filesThatBelongTogetherComeTogether()
    {
        test::checkNothingLost([](const QString& folder, int version) -> Expected<void> {
            std::vector<FileWriter> files;
            for (const char* name : {"/one", "/two", "/three"}) {
                auto file = FileWriter::open(folder.toStdString() + name);
                if (!file)
                    return fail(file.error());
                file->append(version == 0 ? "old" : "new");
                files.push_back(std::move(*file));
            }
            return FileWriter::commitTogether({&files[0], &files[1], &files[2]});
        });
    }
    void folderThatVanishes()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("gone/x");
        QVERIFY(QDir(folder.path()).mkdir("gone"));
        auto out = FileWriter::open(path.toStdString());
        QVERIFY(out);
        out->append("text");
        QVERIFY(QDir(folder.filePath("gone")).removeRecursively());
        const auto written = out->commit();
        QVERIFY(!written);
        QCOMPARE(written.error().message(),
                 path.toStdString() + ": cannot be written: No such file or directory");
    }
    void fileSystemsWithoutExchange()
    {
        QTemporaryDir folder;
        const std::string path = folder.filePath("x").toStdString();
        const FileCalls before = fileCalls();
        fileCalls().rename = [](const char* from, const char* to, unsigned flags) {
            errno = EINVAL;
            return flags == 0 ? std::rename(from, to) : -1;
        };
        const bool written = writeFile(path, "old") && writeFile(path, "new");
        fileCalls() = before;
        QVERIFY(written);
        QCOMPARE(test::fileBytes(folder.filePath("x")), QByteArray("new"));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 1);
    }
    void syncingWhatOthersWrote()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("x");
        const auto missing = syncFile(path.toStdString());
        QVERIFY(!missing);
        QCOMPARE(missing.error().message(),
                 path.toStdString() + ": cannot be written: No such file or directory");
        test::writeBytes(path, "settings");
        QVERIFY(syncFile(path.toStdString()));
        for (const int call : {1, 2, 3, 4}) { // opened and synced: the file, its folder
            const test::FailingDisk disk(call, EIO);
            QVERIFY(!syncFile(path.toStdString()));
            QVERIFY(disk.hasFailed());
        }
    }
    void cancelLeavesTheOldFile()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("x.obj");
        test::writeBytes(path, "old");
        std::stop_source source;
        source.request_stop();
        Progress progress;
        progress.stop = source.get_token();
        const auto obj = writeObj(path.toStdString(), {&m_part, 1}, progress);
        QVERIFY(!obj);
        QCOMPARE(obj.error().code, ErrorCode::Cancelled);
        QVERIFY(!writePly(path.toStdString(), {&m_part, 1}, {}, progress));
        QCOMPARE(test::fileBytes(path), QByteArray("old"));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 1);
    }
    void linksAreFollowedAndPermissionsKept()
    {
        QTemporaryDir folder;
        const QString target = folder.filePath("target.obj");
        test::writeBytes(target, "old");
        QVERIFY(QFile::setPermissions(target, QFile::ReadOwner | QFile::WriteOwner));
        QVERIFY(QFile::link(target, folder.filePath("link.obj")));
        QVERIFY(writeObj(folder.filePath("link.obj").toStdString(), {&m_part, 1}));
        QVERIFY(QFileInfo(folder.filePath("link.obj")).isSymLink());
        QVERIFY(test::fileBytes(target).startsWith("# Ramure"));
        QVERIFY(!(QFile::permissions(target) & (QFile::ReadGroup | QFile::ReadOther)));
    }
    void devicesAreWrittenDirectly()
    {
        QVERIFY(writeObj("/dev/null", {&m_part, 1}));
        QVERIFY(!QFileInfo(QStringLiteral("/dev/null")).isFile());
        QVERIFY(!QFileInfo::exists(QStringLiteral("/dev/null.mtl")));
    }
    void longTextsPassThroughTheBuffer()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("long");
        std::string text(3'000'000, 'x');
        for (std::size_t i = 0; i < text.size(); ++i)
            text[i] = static_cast<char>('a' + i % 23);
        auto out = FileWriter::open(path.toStdString());
        QVERIFY(out);
        out->append(text);
        QVERIFY(!QFileInfo::exists(path)); // not before the commit
        QVERIFY(out->commit());
        QCOMPARE(test::fileBytes(path).toStdString(), text);
    }
};

RAMURE_SUITE(TestFileWriter)

} // namespace tst_file_writer

#include "tst_file_writer.moc"
