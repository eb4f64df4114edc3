#include "core/base/version.h"
#include "core/surface/bark/bark_maps.h"
#include "tests/core/io/io_support.h"
#include <QTemporaryDir>
#include <limits>

namespace tst_texture_files {

using namespace ramure;

/// Texture coordinates in files: split there, while positions stay as they are.
class TestTextureFiles : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;

    std::string path(const char* name) const { return m_folder.filePath(name).toStdString(); }

private slots:
    void init() { test::failOnAnyWarning(); }

    void nonFiniteCoordinatesAreRefused()
    {
        for (const float bad : {std::numeric_limits<float>::quiet_NaN(), HUGE_VALF}) {
            TriangleMesh mesh = textured();
            mesh.uv[3].y = bad;
            const MeshPart part{"branches", &mesh, barkMaterial()};
            const auto obj = writeObj(path("bad.obj"), {&part, 1});
            QVERIFY(!obj);
            QCOMPARE(obj.error().message(),
                     path("bad.obj") + ": a texture coordinate of branches is not a finite number");
            QVERIFY(!writePly(path("bad.ply"), {&part, 1}, {}));
            QVERIFY(!QFile::exists(m_folder.filePath("bad.obj")));
        }
    }
    void objHasThemInLinesOfTheirOwn()
    {
        const TriangleMesh mesh = textured();
        TriangleMesh leaf;
        leaf.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        leaf.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
        leaf.triangles = {{0, 1, 2}};
        leaf.uv = {{0, 0}, {1, 0}, {0, 1}};
        const MeshPart parts[] = {{"branches", &mesh, barkMaterial()}, {"leaves", &leaf, leavesMaterial()}};
        QVERIFY(writeObj(path("tree.obj"), parts));
        QCOMPARE(test::fileBytes(m_folder.filePath("tree.obj")),
                 QByteArray("# Ramure " RAMURE_VERSION "\nmtllib tree.mtl\n"
                            "o branches\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                            "vt 0 0\nvt 1 0\nvt 0 1\nvt 0.5 0.25\nvt 2 -3\nusemtl bark\n"
                            "f 1/1 3/3 2/2\nf 1/1 2/2 4/4\nf 1/1 4/5 3/3\nf 2/2 3/3 4/4\n"
                            "o leaves\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                            "vn 0 0 1\nvn 0 0 1\nvn 0 0 1\nusemtl leaves\ns 1\nf 5/6/1 6/7/2 7/8/3\n"));
    }
    void plyHasThemPerFace()
    {
        const TriangleMesh mesh = textured();
        const MeshPart part{"branches", &mesh, barkMaterial()};
        QVERIFY(writePly(path("tree.ply"), {&part, 1}, {true}));
        QCOMPARE(test::fileBytes(m_folder.filePath("tree.ply")),
                 QByteArray("ply\nformat ascii 1.0\ncomment Ramure " RAMURE_VERSION "\n"
                            "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                            "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                            "element face 4\nproperty list uchar int vertex_indices\n"
                            "property list uchar float texcoord\nend_header\n"
                            "0 0 0 139 90 43\n1 0 0 139 90 43\n0 1 0 139 90 43\n0 0 1 139 90 43\n"
                            "3 0 2 1 6 0 0 0 1 1 0\n3 0 1 3 6 0 0 1 0 0.5 0.25\n"
                            "3 0 3 2 6 0 0 2 -3 0 1\n3 1 2 3 6 1 0 0 1 0.5 0.25\n"));
        QVERIFY(writePly(path("binary.ply"), {&part, 1}, {false}));
        const QByteArray bytes = test::fileBytes(m_folder.filePath("binary.ply"));
        const qsizetype header = bytes.indexOf("end_header\n") + 11;
        QCOMPARE(bytes.size() - header, qsizetype(4 * (12 + 3) + 4 * (1 + 12 + 1 + 24)));
    }
    /// A part without them: the file cannot say so per part, and has none.
    void plyNeedsThemOfAll()
    {
        const TriangleMesh mesh = textured(), plain = test::tetrahedron();
        const MeshPart parts[] = {{"branches", &mesh, barkMaterial()}, {"leaves", &plain, leavesMaterial()}};
        QVERIFY(writePly(path("mixed.ply"), parts, {true}));
        QVERIFY(!test::fileBytes(m_folder.filePath("mixed.ply")).contains("texcoord"));
    }

    /// Thin wood has its own material in an OBJ and its own colour in a PLY.
    void barkIsAsOldAsTheWoodIsThick()
    {
        BarkParams birch;
        birch.family = BarkFamily::Ringed;
        const glm::u8vec3 young = youngColour(birch), old = meanColour(birch);
        TriangleMesh mesh = textured();
        mesh.radius = {0.001F, 0.001F, 0.001F, 1.0F}; // one triangle is young all over
        const MeshPart part{"branches", &mesh, barkMaterial(birch)};
        QVERIFY(writeObj(path("aged.obj"), {&part, 1}, {}, {.mapSize = 0}));
        const QByteArray obj = test::fileBytes(m_folder.filePath("aged.obj"));
        QCOMPARE(obj.count("\nf "), 4);
        QVERIFY(obj.endsWith("usemtl bark_ringed_young\nf 1/1 3/3 2/2\n"));
        QCOMPARE(obj.count("usemtl bark_ringed\n"), 1);
        const auto read = readMeshFile(path("aged.obj"));
        QVERIFY(read && read->objects[0].mesh.colours.size() == 4);
        QCOMPARE(read->objects[0].mesh.colours.back(), young);
        QVERIFY(writePly(path("aged.ply"), {&part, 1}, {true}));
        const QByteArray ply = test::fileBytes(m_folder.filePath("aged.ply"));
        const auto line = [](const char* place, const glm::u8vec3& c) {
            return QByteArray(place) + ' ' + QByteArray::number(c.r) + ' ' + QByteArray::number(c.g) + ' ' +
                   QByteArray::number(c.b) + '\n';
        };
        const auto worn = [](const glm::u8vec3& colour, const glm::vec3& place) {
            return glm::u8vec3(
                glm::vec3(colour) * glm::mix(glm::vec3(1.0F), weatheredBark, barkWeather(place)) + 0.5F);
        };
        QVERIFY(ply.contains(line("\n1 0 0", worn(young, {1, 0, 0}))));
        QVERIFY(ply.contains(line("\n0 0 1", worn(old, {0, 0, 1}))));
        MeshPart own = part; // a picture of one's own is for all of it
        own.material.pictures.colour = "bark.png";
        QVERIFY(writePly(path("own.ply"), {&own, 1}, {true}));
        QVERIFY(
            !test::fileBytes(m_folder.filePath("own.ply")).contains(line("\n1 0 0", worn(young, {1, 0, 0}))));
    }

    void bothAreReadBack_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<bool>("ascii");
        QTest::newRow("obj") << "back.obj" << true;
        QTest::newRow("ply text") << "text.ply" << true;
        QTest::newRow("ply binary") << "binary.ply" << false;
    }
    void bothAreReadBack()
    {
        QFETCH(QString, file);
        QFETCH(bool, ascii);
        const TriangleMesh first = textured();
        TriangleMesh second = textured();
        second.uvTriangles.clear();
        second.uv.resize(second.positions.size());
        second.uv[0] = {1.0f / 3.0f, -1e-7f};
        const MeshPart parts[] = {{"branches", &first, barkMaterial()},
                                  {"leaves", &second, leavesMaterial()}};
        const std::string name = path(qPrintable(file));
        const auto written = file.endsWith("obj") ? writeObj(name, parts) : writePly(name, parts, {ascii});
        QVERIFY(written);
        const auto read = readMeshFile(name);
        QVERIFY2(read, read ? "" : read.error().message().c_str());
        QVERIFY(read->notes.empty());
        const TriangleMesh joined = read->joined();
        QCOMPARE(joined.triangles.size(), std::size_t(8));
        QCOMPARE(joined.uvTriangles.size(), std::size_t(8));
        for (std::size_t t = 0; t < 8; ++t) {
            const TriangleMesh& mesh = t < 4 ? first : second;
            const glm::uvec3 corners = t < 4 ? first.uvTriangles[t] : second.triangles[t - 4];
            for (int k = 0; k < 3; ++k)
                QCOMPARE(joined.uv[joined.uvTriangles[t][k]], mesh.uv[corners[k]]);
        }
        if (file.endsWith("obj")) {
            QCOMPARE(read->objects[0].mesh.uv, first.uv);
            QCOMPARE(read->objects[0].mesh.uvTriangles, first.uvTriangles);
            QCOMPARE(read->objects[1].mesh.uv, second.uv);
            QVERIFY(read->objects[1].mesh.uvTriangles.empty());
        }
    }
    void whatCannotBeUsedIsLeftOut_data()
    {
        QTest::addColumn<QByteArray>("lines");
        QTest::addColumn<bool>("kept");
        QTest::addColumn<QByteArray>("note");
        const QByteArray three = "vt 0 0\nvt 1 0 0\nvt 0 1\n";
        QTest::newRow("good") << three + "f 1/1 2/2 3/3\n" << true << QByteArray();
        QTest::newRow("from the end") << three + "f 1/-3 2/-2 3/-1\n" << true << QByteArray();
        QTest::newRow("later") << "f 1/1 2/2 3/3\n" + three << true << QByteArray();
        QTest::newRow("polygon") << three + "f 1/1 2/2 3/3 2/2\n" << true << QByteArray();
        QTest::newRow("one corner without") << three + "f 1/1 2/2 3\n" << false << QByteArray();
        QTest::newRow("one face without") << three + "f 1/1 2/2 3/3\nf 1 2 3\n" << false << QByteArray();
        QTest::newRow("one number") << QByteArray("vt 0\nvt 1\nvt 2\nf 1/1 2/2 3/3\n") << false
                                    << QByteArray(
                                           "line 4: not two finite numbers: texture coordinates left out");
        QTest::newRow("infinite") << "vt 1e99 0\n" + three + "f 1/1 2/2 3/3\n"
                                  << false
                                  << QByteArray(
                                         "line 4: not two finite numbers: texture coordinates left out");
        QTest::newRow("none such") << three + "f 1/1 2/2 3/9\n"
                                   << false << QByteArray("texture coordinates that do not exist: left out");
        QTest::newRow("unused") << "vt 7\n" + three + "f 1 2 3\n" << false << QByteArray();
    }
    void whatCannotBeUsedIsLeftOut()
    {
        QFETCH(QByteArray, lines);
        QFETCH(bool, kept);
        QFETCH(QByteArray, note);
        const QByteArray text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + lines;
        const auto read = parseObj(test::view(text), "t.obj");
        QVERIFY2(read, read ? "" : read.error().message().c_str());
        const TriangleMesh& mesh = read->objects[0].mesh;
        QCOMPARE(!mesh.uv.empty(), kept);
        if (kept)
            QCOMPARE(mesh.uv[1], glm::vec2(1, 0));
        else
            QVERIFY(mesh.uvTriangles.empty());
        QCOMPARE(QByteArray::fromStdString(read->notes.empty() ? std::string() : read->notes.front()), note);
    }
    void plyFacesWithoutNumbersHaveNone()
    {
        const QByteArray head =
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
            "property float z\nelement face 2\nproperty list uchar int vertex_indices\n"
            "property list uchar float texcoord\nend_header\n0 0 0\n1 0 0\n0 1 0\n";
        const QByteArray good = "3 0 1 2 6 0 0 1 0 0 1\n";
        QVERIFY(!parsePly(test::view(head + good + good), "t.ply")->objects[0].mesh.uv.empty());
        for (const char* bad : {"3 0 1 2 0\n", "3 0 1 2 4 0 0 1 0\n"}) {
            const QByteArray text = head + good + bad;
            const auto read = parsePly(test::view(text), "t.ply");
            QVERIFY2(read, read ? "" : read.error().message().c_str());
            QVERIFY(read->objects[0].mesh.uv.empty() && read->objects[0].mesh.uvTriangles.empty());
            QCOMPARE(read->notes.size(), std::size_t(1));
        }
    }

private:
    static TriangleMesh textured()
    {
        TriangleMesh mesh = test::tetrahedron();
        mesh.uv = {{0, 0}, {1, 0}, {0, 1}, {0.5f, 0.25f}, {2, -3}};
        mesh.uvTriangles = {{0, 2, 1}, {0, 1, 3}, {0, 4, 2}, {1, 2, 3}};
        return mesh;
    }
};

RAMURE_SUITE(TestTextureFiles)

} // namespace tst_texture_files

#include "tst_texture_files.moc"
