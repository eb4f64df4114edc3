#include "core/base/version.h"
#include "tests/core/io/io_support.h"
#include <QTemporaryDir>
#include <limits>

namespace tst_obj_writer {

using namespace ramure;

class TestObjWriter : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;

    std::string path(const char* name) const { return m_folder.filePath(name).toStdString(); }

private slots:
    void init() { test::failOnAnyWarning(); }

    void nonFiniteNumbersAreRefused()
    {
        for (const float bad : {std::numeric_limits<float>::quiet_NaN(), HUGE_VALF, -HUGE_VALF}) {
            TriangleMesh mesh = test::tetrahedron();
            mesh.positions[2].z = bad;
            const MeshPart part{"branches", &mesh, barkMaterial()};
            const auto obj = writeObj(path("bad.obj"), {&part, 1});
            QVERIFY(!obj);
            QCOMPARE(obj.error().code, ErrorCode::Invalid);
            QCOMPARE(obj.error().message(),
                     path("bad.obj") + ": vertex 2 of branches is not a finite number");
            QVERIFY(!writePly(path("bad.ply"), {&part, 1}, {}));
            QVERIFY(!QFile::exists(m_folder.filePath("bad.obj")));
        }
    }
    void textIsAsStated()
    {
        TriangleMesh branches;
        branches.positions = {{0, 0, 0}, {1, -0.5f, 0}, {0, 1, 1e-7f}};
        branches.normals = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
        branches.triangles = {{0, 1, 2}};
        TriangleMesh leaves = branches;
        leaves.normals.clear();
        const MeshPart parts[] = {{"branches", &branches, barkMaterial()},
                                  {"leaves", &leaves, leavesMaterial()},
                                  {"apples\n", &branches, applesMaterial()}};
        QVERIFY(writeObj(path("tree 1.obj"), parts));
        QCOMPARE(test::fileBytes(m_folder.filePath("tree 1.obj")),
                 QByteArray("# Ramure " RAMURE_VERSION "\nmtllib tree 1.mtl\n"
                            "o branches\nv 0 0 0\nv 1 -0.5 0\nv 0 1 1e-07\nvn 0 0 1\nvn 0 1 0\nvn 1 0 0\n"
                            "usemtl bark\ns 1\nf 1//1 2//2 3//3\n"
                            "o leaves\nv 0 0 0\nv 1 -0.5 0\nv 0 1 1e-07\nusemtl leaves\nf 4 5 6\n"
                            "o apples_\nv 0 0 0\nv 1 -0.5 0\nv 0 1 1e-07\nvn 0 0 1\nvn 0 1 0\nvn 1 0 0\n"
                            "usemtl fruit\ns 1\nf 7//4 8//5 9//6\n"));
        QCOMPARE(
            test::fileBytes(m_folder.filePath("tree 1.mtl")),
            QByteArray(
                "# Ramure " RAMURE_VERSION "\n# Kd in sRGB\n"
                "\nnewmtl bark\nKd 0.54509807 0.3529412 0.16862746\nKs 0 0 0\nillum 1\n"
                "\nnewmtl leaves\n# seen from both sides\nKd 0.22745098 0.37254903 0.043137256\nKs 0.2 "
                "0.2 0.2\nNs 30\nillum 2\n"
                "\nnewmtl fruit\nKd 0.37254903 0.043137256 0.043137256\nKs 0.2 0.2 0.2\nNs 30\nillum 2\n"));
    }
    void oneMaterialOfSeveralParts()
    {
        const TriangleMesh mesh = test::tetrahedron();
        const MeshPart parts[] = {{"a", &mesh, barkMaterial()}, {"b", &mesh, barkMaterial()}};
        QVERIFY(writeObj(path("two.obj"), parts));
        QCOMPARE(test::fileBytes(m_folder.filePath("two.mtl")).count("newmtl"), 1);
    }
    void linesOfASkeleton()
    {
        const LinePart lines{"skeleton", {{0, 0, 0}, {0, 1, 0}, {0.5f, 2, 0}}, {{0, 1}, {1, 2}}};
        QVERIFY(writeObjLines(path("lines.obj"), lines));
        QCOMPARE(test::fileBytes(m_folder.filePath("lines.obj")),
                 QByteArray("# Ramure " RAMURE_VERSION
                            "\no skeleton\nv 0 0 0\nv 0 1 0\nv 0.5 2 0\nl 1 2\nl 2 3\n"));
    }
    void progressRises()
    {
        TriangleMesh mesh;
        mesh.positions.resize(300'000);
        mesh.triangles.resize(100'000, {0, 1, 2});
        const MeshPart part{"branches", &mesh, barkMaterial()};
        std::vector<double> seen;
        Progress progress;
        progress.onFraction = [&](double fraction) { seen.push_back(fraction); };
        QVERIFY(writeObj(path("long.obj"), {&part, 1}, progress));
        QVERIFY(seen.size() >= 4);
        QVERIFY(std::is_sorted(seen.begin(), seen.end()));
        QCOMPARE(seen.back(), 1.0);
    }
    void randomMeshesRoundTrip()
    {
        std::mt19937 random(11);
        for (int round = 0; round < 300; ++round) {
            std::vector<TriangleMesh> meshes;
            for (unsigned i = 0; i <= random() % 3; ++i)
                meshes.push_back(test::randomMesh(random, random() % 2 == 0));
            std::vector<MeshPart> parts;
            for (std::size_t i = 0; i < meshes.size(); ++i)
                parts.push_back({"part " + std::to_string(i), &meshes[i], barkMaterial()});
            QVERIFY(writeObj(path("round.obj"), parts));
            const auto back = readMeshFile(path("round.obj"));
            QVERIFY2(back, test::why(back));
            QCOMPARE(back->objects.size(), meshes.size());
            for (std::size_t i = 0; i < meshes.size(); ++i) {
                const ReadObject& object = back->objects[i];
                QCOMPARE(object.name, parts[i].name);
                QVERIFY(test::sameBits(object.mesh.positions, meshes[i].positions));
                QVERIFY(object.mesh.triangles == meshes[i].triangles);
                // Normals come back where faces carry them, for the vertices in faces.
                if (!object.mesh.normals.empty() && !meshes[i].normals.empty())
                    for (const glm::uvec3& t : meshes[i].triangles)
                        QCOMPARE(object.mesh.normals[t.x], meshes[i].normals[t.x]);
            }
        }
    }
    void normalsRoundTrip()
    {
        std::mt19937 random(12);
        for (int round = 0; round < 100; ++round) {
            const TriangleMesh mesh = test::randomMesh(random, true);
            const MeshPart part{"part", &mesh, barkMaterial()};
            QVERIFY(writeObj(path("normals.obj"), {&part, 1}));
            const auto back = readMeshFile(path("normals.obj"));
            QVERIFY2(back, test::why(back));
            if (!mesh.triangles.empty())
                QVERIFY(test::sameBits(back->objects[0].mesh.normals, mesh.normals));
        }
    }
};

RAMURE_SUITE(TestObjWriter)

} // namespace tst_obj_writer

#include "tst_obj_writer.moc"
