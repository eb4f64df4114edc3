#include "core/io/formats/text/blender_scene.h"
#include "core/io/formats/text/material_file.h"
#include "tests/core/io/io_support.h"
#include <QDir>
#include <QTemporaryDir>
#include <sys/stat.h>
#include <thread>

namespace tst_material_file {

using namespace ramure;

namespace {

/// Two triangles of two materials that share an edge, and one without any.
const QByteArray threeFaces = "mtllib own.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                              "f 1 2 4\nusemtl red\nf 1 2 3\nusemtl blue one\nf 1 3 4\n";

constexpr glm::u8vec3 red{255, 0, 0}, blue{0, 51, 255}, plain{184, 184, 184};

bool notes(const std::vector<std::string>& list, const char* part)
{
    return std::any_of(list.begin(), list.end(),
                       [part](const std::string& note) { return note.find(part) != std::string::npos; });
}

} // namespace

/// Colours of mesh files, from their materials.
class TestMaterialFile : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    [[nodiscard]] QString path(const char* name) const
    {
        return m_folder.filePath(QString::fromLatin1(name));
    }
    Expected<ReadMesh> read(const char* name) const { return readMeshFile(path(name).toStdString()); }

private slots:
    void init()
    {
        test::failOnAnyWarning();
        QDir(m_folder.path()).removeRecursively();
        QVERIFY(QDir().mkpath(m_folder.path()));
    }

    void badLinesAreNoted_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("cut") << QByteArray("newmtl red\nKd 1 0");
        QTest::newRow("nothing") << QByteArray("newmtl red\nKd\n");
        QTest::newRow("nan") << QByteArray("newmtl red\nKd nan 0 0\n");
        QTest::newRow("infinite") << QByteArray("newmtl red\nKd 1e999 0 0\n");
        QTest::newRow("a word") << QByteArray("newmtl red\nKd spectral red.rfl\n");
        QTest::newRow("four") << QByteArray("newmtl red\nKd 1 0 0 1\n");
        QTest::newRow("decimal commas") << QByteArray("newmtl red\nKd 1,0 0,0 0,0\n");
    }
    void badLinesAreNoted()
    {
        QFETCH(const QByteArray, text);
        const MaterialColours found = parseMaterials(test::view(text), "own.mtl");
        QVERIFY(found.colours.empty());
        QCOMPARE(found.notes.size(), std::size_t(1));
        QVERIFY2(notes(found.notes, "own.mtl, line 2: Kd"), found.notes[0].c_str());
    }
    void whatIsNoMaterialFileHasNoColours()
    {
        QByteArray zeros(300, '\0');
        QVERIFY(parseMaterials(test::view(zeros), "x").colours.empty());
        QVERIFY(parseMaterials("", "x").notes.empty());
        QVERIFY(parseMaterials("\r\n\r\n# Kd 1 0 0\nKdd 1 0 0", "x").notes.empty());
        QByteArray flood;
        for (int i = 0; i < 1000; ++i)
            flood += "Kd x\n";
        QVERIFY(parseMaterials(test::view(flood), "x").notes.size() <= 20);
    }
    void picturesAreNamedOnceForEachMaterial()
    {
        const auto found = parseMaterials("NEWMTL a\nKD 1 0 0\nMAP_KD a.webp\nmap_Bump n.png\nnorm n.png\n"
                                          "newmtl b\nmap_d b.dds\n",
                                          "x.mtl");
        const std::vector<std::string> expected{
            "x.mtl, line 3: the picture \"a.webp\" is not read, nor is \"n.png\"",
            "x.mtl, line 7: the picture \"b.dds\" is not read"};
        QVERIFY(found.notes == expected);
        QVERIFY(found.colours.at("a") == glm::u8vec3(255, 0, 0));
    }
    void coloursAreHeldToBytes()
    {
        const auto found =
            parseMaterials("newmtl a b\r\n\tKd 2 -1 0.2\r\nnewmtl grey\nKd 0.5\nnewmtl grey\nKd 1", "x");
        QVERIFY(found.notes.empty());
        QVERIFY(found.colours.at("a b") == glm::u8vec3(255, 0, 51));
        QVERIFY(found.colours.at("grey") == glm::u8vec3(255)); // the last counts
    }

    void missingMaterialFilesAreNamed()
    {
        test::writeBytes(path("three.obj"), threeFaces);
        auto mesh = read("three.obj");
        QVERIFY2(mesh, test::why(mesh));
        QVERIFY(mesh->joined().colours.empty());
        QVERIFY(notes(mesh->notes, "line 1: the material file \"own.mtl\" cannot be read"));
        // Folders and pipes are no files, and nobody waits for them.
        QVERIFY(QDir().mkdir(path("own.mtl")));
        mesh = read("three.obj");
        QVERIFY(mesh && notes(mesh->notes, "own.mtl"));
        QVERIFY(QDir().rmdir(path("own.mtl")));
        QCOMPARE(::mkfifo(path("own.mtl").toStdString().c_str(), 0600), 0);
        mesh = read("three.obj");
        QVERIFY(mesh && notes(mesh->notes, "own.mtl"));
        // Without a material file nothing is missed.
        test::writeBytes(path("plain.obj"), QByteArray(threeFaces).replace("mtllib own.mtl\n", ""));
        mesh = read("plain.obj");
        QVERIFY(mesh && mesh->notes.empty() && mesh->joined().colours.empty());
    }
    void pipesAreReadOnce()
    {
        QCOMPARE(::mkfifo(path("pipe.obj").toStdString().c_str(), 0600), 0);
        std::thread writer([this] { test::writeBytes(path("pipe.obj"), threeFaces); });
        const auto mesh = read("pipe.obj");
        writer.join();
        QVERIFY2(mesh, test::why(mesh));
        QCOMPARE(mesh->joined().faceCount(), Index(3));
    }
    void filesAreFoundBesideTheObject_data()
    {
        QTest::addColumn<QByteArray>("named");
        QTest::addColumn<QString>("at");
        QTest::newRow("beside") << QByteArray("own.mtl") << "own.mtl";
        QTest::newRow("with blanks") << QByteArray("my own.mtl") << "my own.mtl";
        QTest::newRow("of several") << QByteArray("no.mtl  own.mtl") << "own.mtl";
        QTest::newRow("below") << QByteArray("sub\\own.mtl") << "sub/own.mtl";
        QTest::newRow("outside") << QByteArray("../other/own.mtl") << "../other/own.mtl";
        QTest::newRow("of another machine") << QByteArray("C:\\art\\own.mtl") << "own.mtl";
    }
    void filesAreFoundBesideTheObject()
    {
        QFETCH(const QByteArray, named);
        QFETCH(const QString, at);
        QVERIFY(QDir().mkpath(path("trees/sub")) && QDir().mkpath(path("other")));
        test::writeBytes(path("trees/three.obj"), QByteArray(threeFaces).replace("own.mtl", named));
        test::writeBytes(m_folder.filePath(QStringLiteral("trees/") + at),
                         "newmtl red\nKd 1 0 0\nnewmtl blue one\nKd 0 0.2 1\n");
        const auto mesh = read("trees/three.obj");
        QVERIFY2(mesh, test::why(mesh));
        QVERIFY2(mesh->notes.empty(), mesh->notes.empty() ? "" : mesh->notes[0].c_str());
        QCOMPARE(mesh->objects.size(), std::size_t(1));
        const TriangleMesh& found = mesh->objects[0].mesh;
        QCOMPARE(found.vertexCount(), Index(4)); // nothing is split where colours meet
        QVERIFY((found.colours == std::vector<glm::u8vec3>{plain, red, blue}));
    }

    void objectsKeepTheirs()
    {
        test::writeBytes(path("two.obj"),
                         "mtllib own.mtl\no A\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl red\nf 1 2 3\n"
                         "o B\nv 0 0 1\nf 1 2 4\nusemtl none\nf 2 3 4\n");
        test::writeBytes(path("own.mtl"), "newmtl red\nKd 1 0 0\n");
        const auto mesh = read("two.obj");
        QVERIFY2(mesh, test::why(mesh));
        QVERIFY(mesh->objects[0].mesh.colours == std::vector<glm::u8vec3>{red});
        QVERIFY((mesh->objects[1].mesh.colours == std::vector<glm::u8vec3>{red, plain}));
        QVERIFY((mesh->joined().colours == std::vector<glm::u8vec3>{red, red, plain}));
        QCOMPARE(mesh->notes.size(), std::size_t(1));
        QVERIFY(notes(mesh->notes, "the material \"none\" has no colour"));
    }

    void facesAreWrittenWithTheirColours()
    {
        TriangleMesh mesh;
        mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
        mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}};
        mesh.colours = {red, red, blue};
        const std::vector<MeshPart> parts{{"a", &mesh, barkMaterial()}};
        QVERIFY(writeObj(path("out.obj").toStdString(), parts));
        const QByteArray obj = test::fileBytes(path("out.obj"));
        QCOMPARE(obj.count("usemtl "), 2);
        QVERIFY(!test::fileBytes(path("out.mtl")).contains("bark"));
        const auto again = read("out.obj");
        QVERIFY2(again, test::why(again));
        QVERIFY(again->joined().colours == mesh.colours);
        QVERIFY(again->joined().triangles == mesh.triangles);
        for (const bool ascii : {true, false}) {
            QVERIFY(writePly(path("out.ply").toStdString(), parts, {ascii}));
            QVERIFY(test::fileBytes(path("out.ply"))
                        .contains(ascii ? "0 51 255" : QByteArray("\x00\x33\xff", 3)));
        }
    }

    /// However colours follow each other, a viewer changes its material once for each.
    void materialsStandTogether()
    {
        TriangleMesh mesh;
        for (int i = 0; i < 300; ++i) {
            const auto first = static_cast<Index>(mesh.positions.size());
            for (const glm::vec3& p : {glm::vec3(0, 0, i), glm::vec3(1, 0, i), glm::vec3(0, 1, i)}) {
                mesh.positions.push_back(p);
                mesh.uv.emplace_back(p.x, p.z);
            }
            mesh.triangles.emplace_back(first, first + 1, first + 2);
            mesh.colours.push_back(i % 3 == 0 ? red : i % 3 == 1 ? blue : plain);
        }
        for (const bool isTextured : {true, false}) {
            if (!isTextured)
                mesh.uv.clear();
            const std::vector<MeshPart> parts{{"a", &mesh, barkMaterial()}, {"b", &mesh, barkMaterial()}};
            QVERIFY(writeObj(path("out.obj").toStdString(), parts));
            QCOMPARE(test::fileBytes(path("out.obj")).count("usemtl "), 6);
            QCOMPARE(test::fileBytes(path("out.mtl")).count("newmtl "), 3);
            const auto back = read("out.obj");
            QVERIFY2(back, test::why(back));
            // The same triangles with the same colours and texture, those of a material in their order.
            for (const ReadObject& object : back->objects) {
                int number = 0;
                for (std::size_t t = 0; t < object.mesh.triangles.size(); ++t, number += 3) {
                    number = number >= 300 ? number % 3 + 1 : number;
                    const glm::uvec3& corners = object.mesh.triangles[t];
                    QCOMPARE(object.mesh.positions[corners.x], glm::vec3(0, 0, number));
                    QVERIFY(object.mesh.colours[t] == mesh.colours[std::size_t(number)]);
                    if (isTextured)
                        QCOMPARE(object.mesh.uv[corners.y], glm::vec2(1, number));
                }
            }
        }
    }

    void oneColourIsThatOfTheNode()
    {
        test::writeBytes(path("three.obj"), threeFaces);
        test::writeBytes(path("own.mtl"), "newmtl red\nKd 1 0 0\nnewmtl blue one\nKd 0 0.2 1\n");
        auto made = importBlender(path("three.obj").toStdString());
        QVERIFY2(made && made->notes.empty(), test::why(made));
        QVERIFY(made->nodes[0].params.surface.color == glm::dvec3(1.0));
        QCOMPARE(made->nodes[0].mesh->colours.size(), std::size_t(3));
        test::writeBytes(path("one.obj"),
                         "mtllib own.mtl\nusemtl blue one\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
        made = importBlender(path("one.obj").toStdString());
        QVERIFY2(made && made->notes.empty(), test::why(made));
        QVERIFY(made->nodes[0].params.surface.color == glm::dvec3(blue) / 255.0);
        QVERIFY(made->nodes[0].mesh->colours.empty());
    }
};

RAMURE_SUITE(TestMaterialFile)

} // namespace tst_material_file

#include "tst_material_file.moc"
