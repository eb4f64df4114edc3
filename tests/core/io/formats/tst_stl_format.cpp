#include "core/io/formats/file_format.h"
#include "core/surface/proof/validate.h"
#include "tests/core/io/io_support.h"
#include <QTemporaryDir>

namespace tst_stl_format {

using namespace ramure;

namespace {

QByteArray binary(std::uint32_t count, std::span<const float> floats)
{
    QByteArray out(80, ' ');
    out.append(reinterpret_cast<const char*>(&count), sizeof count);
    for (std::size_t i = 0; i < floats.size(); i += 12) {
        out.append(reinterpret_cast<const char*>(&floats[i]), 48);
        out.append(2, '\0');
    }
    return out;
}

constexpr const char* oneTriangle = "solid a b\r\n  facet normal 0 0 1\r\n    outer loop\r\n"
                                    "      vertex 0 0 0\r\n      vertex 1.5 0 0\r\n"
                                    "      vertex 0 1e0 0\r\n    endloop\r\n  endfacet\r\nendsolid\r\n";

} // namespace

class TestStlFormat : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;

    QString path(const char* name = "t.stl") const { return m_folder.filePath(name); }
    Expected<ReadMesh> read(const QByteArray& bytes) const
    {
        test::writeBytes(path(), bytes);
        return readMeshFile(path().toStdString());
    }
    Expected<void> write(const TriangleMesh& mesh, const char* name = "t.stl",
                         const WriteOptions& options = {}, const Progress& progress = {}) const
    {
        const std::string file = path(name).toStdString();
        return (*findFormat(file, FormatUse::Write))
            ->write(file, sceneOfMeshes({{"thing", mesh, {}}}, barkMaterial()), options, progress);
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void brokenFiles_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("message");
        const float nan = std::numeric_limits<float>::quiet_NaN();
        const std::array<float, 12> bad{0, 0, 1, 0, 0, 0, nan, 0, 0, 0, 1, 0};
        QTest::newRow("empty") << QByteArray() << "too short for an STL file";
        QTest::newRow("short") << QByteArray("solids") << "1: not a line of an STL file: \"solids\"";
        QTest::newRow("cut off") << binary(2, bad) << "the size is not that of 2 triangles";
        QTest::newRow("four billion")
            << binary(0xFFFFFFFFU, bad) << "the size is not that of 4294967295 triangles";
        QTest::newRow("no number") << binary(1, bad) << "triangle 0 is not of finite numbers";
        QTest::newRow("none") << binary(0, {}) << "the file holds no triangles";
        QTest::newRow("text, none") << QByteArray("solid\nendsolid\n") << "the file holds no triangles";
        QTest::newRow("text, no end")
            << QByteArray("solid\nfacet normal 0 0 1") << "2: the file ends within a solid";
        QTest::newRow("word") << QByteArray("solid x\nfacett\n")
                              << "2: not a line of an STL file: \"facett\"";
        QTest::newRow("letters") << QByteArray("solid x\nvertex 0 y 1\n")
                                 << "2: a number expected, found \"y 1\"";
        QTest::newRow("nan") << QByteArray("solid x\nvertex 0 nan 1\n")
                             << "2: a number expected, found \"nan 1\"";
        QTest::newRow("two numbers") << QByteArray("solid x\nvertex 0 1\n\n")
                                     << "2: a number expected, found \"\"";
        QTest::newRow("two corners") << QByteArray(
                                            "solid x\nouter loop\nvertex 0 0 1\nvertex 0 1 1\nendloop\n")
                                     << "5: three vertices a loop expected";
    }
    void brokenFiles()
    {
        QFETCH(const QByteArray, bytes);
        QFETCH(const QString, message);
        const auto mesh = read(bytes);
        QVERIFY(!mesh);
        const QString told = QString::fromStdString(mesh.error().message());
        QVERIFY2(told.endsWith(message), qPrintable(told));
        QVERIFY(told.startsWith(path()));
    }
    void missingFile() { QCOMPARE(readMeshFile("missing.stl").error().code, ErrorCode::Io); }
    void noNumberIsWritten()
    {
        TriangleMesh mesh = test::tetrahedron();
        QVERIFY(write(mesh));
        const QByteArray before = test::fileBytes(path());
        mesh.positions[2].y = std::numeric_limits<float>::infinity();
        QCOMPARE(write(mesh).error().code, ErrorCode::Invalid);
        std::stop_source stop;
        stop.request_stop();
        QCOMPARE(write(test::tetrahedron(), "t.stl", {}, {stop.get_token(), {}}).error().code,
                 ErrorCode::Cancelled);
        QCOMPARE(test::fileBytes(path()), before);
        QVERIFY(!write(test::tetrahedron(), "missing/t.stl"));
    }
    void text()
    {
        const auto mesh = read(oneTriangle);
        QVERIFY2(mesh, test::why(mesh));
        QCOMPARE(mesh->objects.size(), std::size_t(1));
        QCOMPARE(mesh->objects[0].name, std::string("t"));
        QCOMPARE(mesh->objects[0].mesh.positions,
                 (std::vector<glm::vec3>{{0, 0, 0}, {1.5, 0, 0}, {0, 1, 0}}));
    }
    void bytesAsTheFormatSays()
    {
        QVERIFY(write(test::tetrahedron()));
        const QByteArray bytes = test::fileBytes(path());
        QCOMPARE(bytes.size(), 84 + 4 * 50);
        QVERIFY(!bytes.startsWith("solid"));
        QCOMPARE(bytes.mid(80, 4), QByteArray("\4\0\0\0", 4));
        std::array<float, 12> first{};
        std::memcpy(first.data(), bytes.constData() + 84, sizeof first);
        QCOMPARE(first, (std::array<float, 12>{0, 0, -1, 0, 0, 0, 0, 1, 0, 1, 0, 0}));
        QCOMPARE(bytes.mid(84 + 48, 2), QByteArray(2, '\0'));
        QVERIFY(write(test::tetrahedron(), "again.stl"));
        QCOMPARE(test::fileBytes(path("again.stl")), bytes);
    }
    /// Corners that are written apart are one vertex again, -0 and 0 too.
    void thereAndBack()
    {
        TriangleMesh mesh = test::tetrahedron();
        mesh.positions[1].y = -0.0F;
        QVERIFY(write(mesh));
        const auto back = readMeshFile(path().toStdString());
        QVERIFY2(back, test::why(back));
        const auto report = validateMesh(back->objects[0].mesh);
        QVERIFY(report && report->valid);
        QCOMPARE(report->vertices, Index(4));
        QCOMPARE(report->volume, 1.0 / 6.0);
    }
    void theSpaceComesBack()
    {
        FileSpace space;
        space.up = UpAxis::Z;
        space.unit = 2;
        const std::string file = path().toStdString();
        ExportScene scene = sceneOfMeshes({{"thing", test::tetrahedron(), {}}}, barkMaterial());
        scene.space = space;
        WriteOptions options;
        options.comment = space.comment();
        QVERIFY((*findFormat(file, FormatUse::Write))->write(file, scene, options, {}));
        const auto back = readMeshFile(file);
        QVERIFY2(back, test::why(back));
        float most = 0.0F;
        for (const glm::vec3& p : back->objects[0].mesh.positions)
            most = std::max({most, p.x, p.y, p.z});
        QCOMPARE(most, 1.0F);
    }
};

RAMURE_SUITE(TestStlFormat)

} // namespace tst_stl_format

#include "tst_stl_format.moc"
