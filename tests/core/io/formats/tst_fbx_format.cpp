#include "core/io/formats/file_format.h"

#include "tests/core/io/io_support.h"
#include "tests/support/suite.h"
#include <QFile>
#include <QTemporaryDir>
#include <thread>

namespace tst_fbx_format {

using namespace ramure;

namespace {

ExportScene triangle()
{
    ReadObject object;
    object.name = "triangle";
    object.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    object.mesh.normals.assign(3, {0, 0, 1});
    object.mesh.triangles = {{0, 1, 2}};
    std::vector<ReadObject> objects;
    objects.push_back(std::move(object));
    return sceneOfMeshes(std::move(objects), Material{});
}

} // namespace

/// Stand-ins for Blender; the real one is among the clients.
class TestFbxFormat : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    QByteArray m_path;

    void standIn(const QByteArray& script)
    {
        QFile file(m_folder.filePath(QStringLiteral("blender")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray("#!/bin/sh\n") + script + "\n");
        file.close();
        QVERIFY(file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
        qputenv("PATH", m_folder.path().toLocal8Bit() + ':' + m_path);
    }
    [[nodiscard]] QString target() const { return m_folder.filePath(QStringLiteral("t.fbx")); }
    Expected<void> write(const Progress& progress = {})
    {
        const std::string path = target().toStdString();
        return (*findFormat(path, FormatUse::Write))->write(path, triangle(), {}, progress);
    }

private slots:
    void init()
    {
        test::failOnAnyWarning();
        m_path = qgetenv("PATH");
        QFile::remove(target());
        QFile::remove(m_folder.filePath(QStringLiteral("blender")));
    }
    void cleanup() { qputenv("PATH", m_path); }

    void withoutBlenderItSaysSo()
    {
        qputenv("PATH", m_folder.path().toLocal8Bit());
        const auto written = write();
        QVERIFY(!written);
        QVERIFY(written.error().message().find("not installed") != std::string::npos);
    }

    void itsErrorIsTold_data()
    {
        QTest::addColumn<QByteArray>("script");
        QTest::addColumn<QString>("told");
        QTest::newRow("fails") << QByteArray("echo 'Error: no such thing'; echo Blender quit; exit 1")
                               << "no such thing";
        QTest::newRow("writes nothing") << QByteArray("echo all is well") << "all is well";
        QTest::newRow("crashes") << QByteArray("echo Writing; kill -11 $$") << "Writing";
    }
    /// The old file stays.
    void itsErrorIsTold()
    {
        QFETCH(const QByteArray, script);
        QFETCH(const QString, told);
        QFile old(target());
        QVERIFY(old.open(QIODevice::WriteOnly) && old.write("old") == 3);
        old.close();
        standIn(script);
        const auto written = write();
        QVERIFY(!written);
        QVERIFY2(QString::fromStdString(written.error().message()).contains(told),
                 test::why(written).constData());
        QCOMPARE(test::fileBytes(target()), QByteArray("old"));
    }

    /// It gets a GLB, and how many frames at which rate there are.
    void whatItWritesIsTheFile()
    {
        standIn(
            "while [ \"$1\" != -- ]; do shift; done; head -c 4 \"$2\" > \"$3\"; echo \" $4 $5\" >> \"$3\"");
        const auto written = write();
        QVERIFY2(written, test::why(written).constData());
        QCOMPARE(test::fileBytes(target()), QByteArray("glTF 1 24\n"));
    }

    void canBeCancelled()
    {
        const QString begun = m_folder.filePath(QStringLiteral("begun"));
        standIn("echo > " + begun.toLocal8Bit() + "; sleep 1000");
        std::stop_source stop;
        std::jthread later([&] {
            while (!QFile::exists(begun))
                std::this_thread::yield();
            stop.request_stop();
        });
        const auto written = write({stop.get_token(), {}});
        QVERIFY(!written);
        QCOMPARE(written.error().code, ErrorCode::Cancelled);
        QVERIFY(!QFile::exists(target()));
    }
};

RAMURE_SUITE(TestFbxFormat)

} // namespace tst_fbx_format

#include "tst_fbx_format.moc"
