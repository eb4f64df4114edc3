// Meshes as other programs write them, in every format that has them.
#include "core/io/formats/text/blender_scene.h"
#include "core/io/zip_file.h"
#include "core/surface/proof/validate.h"
#include "tests/core/io/io_support.h"
#include <QTemporaryDir>
#include <algorithm>
#include <glm/geometric.hpp>

namespace tst_foreign_meshes {

using namespace ramure;

namespace {

struct Solid
{
    std::vector<glm::dvec3> positions;
    std::vector<std::vector<Index>> faces;

    /// Fans: of convex faces alone.
    [[nodiscard]] std::vector<glm::uvec3> triangles() const
    {
        std::vector<glm::uvec3> out;
        for (const auto& face : faces)
            for (std::size_t k = 2; k < face.size(); ++k)
                out.emplace_back(face[0], face[k - 1], face[k]);
        return out;
    }
};

/// An outline in the plane of x and y, from z = 0 to 1.
Solid prism(const std::vector<glm::dvec2>& outline)
{
    Solid out;
    const auto n = static_cast<Index>(outline.size());
    std::vector<Index> low, high;
    for (Index i = 0; i < n; ++i) {
        low.insert(low.begin(), i);
        high.push_back(i + n);
        out.faces.push_back({i, (i + 1) % n, (i + 1) % n + n, i + n});
    }
    out.faces.insert(out.faces.end(), {low, high});
    for (const double z : {0.0, 1.0})
        for (const glm::dvec2& p : outline)
            out.positions.emplace_back(p, z);
    return out;
}

Solid cubeAt(const glm::dvec3& corner)
{
    Solid out = prism({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    for (glm::dvec3& p : out.positions)
        p += corner;
    return out;
}

QByteArray number(double value)
{
    return QByteArray::number(value, 'f', 6);
}

QByteArray lineOf(const glm::dvec3& p)
{
    return number(p.x) + ' ' + number(p.y) + ' ' + number(p.z);
}

QByteArray objOf(const Solid& solid)
{
    QByteArray out;
    for (const glm::dvec3& p : solid.positions)
        out += "v " + lineOf(p) + '\n';
    for (const auto& face : solid.faces) {
        out += 'f';
        for (const Index i : face)
            out += ' ' + QByteArray::number(i + 1);
        out += '\n';
    }
    return out;
}

QByteArray plyHead(const Solid& solid, const char* format, const char* type = "double")
{
    QByteArray out = QByteArray("ply\nformat ") + format + " 1.0\nelement vertex " +
                     QByteArray::number(qsizetype(solid.positions.size())) + '\n';
    for (const char* axis : {"x", "y", "z"})
        out += QByteArray("property ") + type + ' ' + axis + '\n';
    return out + "element face " + QByteArray::number(qsizetype(solid.faces.size())) +
           "\nproperty list uchar int vertex_indices\nend_header\n";
}

QByteArray plyTextOf(const Solid& solid)
{
    QByteArray out = plyHead(solid, "ascii");
    for (const glm::dvec3& p : solid.positions)
        out += lineOf(p) + '\n';
    for (const auto& face : solid.faces) {
        out += QByteArray::number(qsizetype(face.size()));
        for (const Index i : face)
            out += ' ' + QByteArray::number(i);
        out += '\n';
    }
    return out;
}

template <class T> void put(QByteArray& to, T value, bool isBig = false)
{
    QByteArray bytes(reinterpret_cast<const char*>(&value), sizeof value);
    if (isBig)
        std::reverse(bytes.begin(), bytes.end());
    to += bytes;
}

template <class T> QByteArray plyBytesOf(const Solid& solid, bool isBig)
{
    QByteArray out = plyHead(solid, isBig ? "binary_big_endian" : "binary_little_endian",
                             sizeof(T) == 8 ? "double" : "float");
    for (const glm::dvec3& p : solid.positions)
        for (int axis = 0; axis < 3; ++axis)
            put(out, static_cast<T>(p[axis]), isBig);
    for (const auto& face : solid.faces) {
        out += static_cast<char>(face.size());
        for (const Index i : face)
            put(out, i, isBig);
    }
    return out;
}

QByteArray stlTextOf(const Solid& solid)
{
    QByteArray out("solid s\n");
    for (const glm::uvec3& t : solid.triangles()) {
        out += "facet normal 0 0 0\nouter loop\n";
        for (int k = 0; k < 3; ++k)
            out += "vertex " + lineOf(solid.positions[t[k]]) + '\n';
        out += "endloop\nendfacet\n";
    }
    return out + "endsolid s\n";
}

QByteArray stlBytesOf(const Solid& solid)
{
    QByteArray out(80, ' ');
    put(out, static_cast<std::uint32_t>(solid.triangles().size()));
    for (const glm::uvec3& t : solid.triangles()) {
        out += QByteArray(12, '\0');
        for (int k = 0; k < 3; ++k)
            put(out, glm::vec3(solid.positions[t[k]]));
        out += QByteArray(2, '\0');
    }
    return out;
}

QByteArray modelOf(const Solid& solid)
{
    QByteArray out("<model unit=\"meter\"><resources><object id=\"1\"><mesh><vertices>");
    for (const glm::dvec3& p : solid.positions)
        out += "<vertex x=\"" + number(p.x) + "\" y=\"" + number(p.y) + "\" z=\"" + number(p.z) + "\"/>";
    out += "</vertices><triangles>";
    for (const glm::uvec3& t : solid.triangles())
        out += "<triangle v1=\"" + QByteArray::number(t.x) + "\" v2=\"" + QByteArray::number(t.y) +
               "\" v3=\"" + QByteArray::number(t.z) + "\"/>";
    return out + "</triangles></mesh></object></resources><build><item objectid=\"1\"/></build></model>";
}

bool hasNote(const std::vector<std::string>& notes, const char* part)
{
    return std::ranges::any_of(
        notes, [part](const std::string& note) { return note.find(part) != std::string::npos; });
}

} // namespace

class TestForeignMeshes : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;

    std::string path(const char* name) const { return m_folder.filePath(QLatin1String(name)).toStdString(); }
    Expected<ReadMesh> read(const QString& ending, const QByteArray& bytes) const
    {
        const QString file = m_folder.filePath("f." + ending);
        if (ending == "3mf") {
            if (!writeZip(file.toStdString(),
                          std::vector<ZipEntry>{{"3D/3dmodel.model", bytes.toStdString(), true}}))
                qFatal("no archive");
        } else
            test::writeBytes(file, bytes);
        return readMeshFile(file.toStdString());
    }
    ReadMesh readWell(const QString& ending, const QByteArray& bytes) const
    {
        auto mesh = read(ending, bytes);
        if (!mesh)
            qFatal("%s", test::why(mesh).constData());
        return std::move(*mesh);
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void pointsAlone_data()
    {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("reason");
        Solid points = cubeAt({0, 0, 0});
        points.faces.clear();
        const QString reason = "the file holds 8 points and no faces: there is no surface to read";
        QTest::newRow("obj") << "obj" << objOf(points) << reason;
        QTest::newRow("ply") << "ply" << plyTextOf(points) << reason;
        QTest::newRow("ply, float") << "ply" << plyBytesOf<float>(points, false) << reason;
        QTest::newRow("ply, big") << "ply" << plyBytesOf<double>(points, true) << reason;
        QTest::newRow("ply without faces")
            << "ply"
            << plyTextOf(points).replace("element face 0\nproperty list uchar int vertex_indices\n", "")
            << reason;
        QTest::newRow("stl") << "stl" << stlBytesOf(points) << "the file holds no triangles";
        QTest::newRow("stl, text") << "stl" << stlTextOf(points) << "the file holds no triangles";
        QTest::newRow("3mf") << "3mf" << modelOf(points) << "the file holds no mesh to print";
    }
    void pointsAlone()
    {
        QFETCH(const QString, ending);
        QFETCH(const QByteArray, bytes);
        QFETCH(const QString, reason);
        const auto mesh = read(ending, bytes);
        QVERIFY(!mesh);
        QCOMPARE(QString::fromStdString(mesh.error().plain()), reason);
        QCOMPARE(mesh.error().file, path(qPrintable("f." + ending)));
        QVERIFY(!importObjects(mesh.error().file));
    }
    /// An object that only other objects hang on is a group.
    void pointsOfASceneAreAGroup()
    {
        test::writeBytes(QString::fromStdString(path("curve.obj")),
                         "v 0 0 0\nv 1 0 0\nl 1 2\nTRANSFORM 1 0 0 2 0 1 0 0 0 0 1 0 0 0 0 1\n");
        const auto scene = importObjects(path("curve.obj"));
        QVERIFY2(scene, test::why(scene));
        QCOMPARE(scene->nodes[0].kind, NodeKind::Group);
        QVERIFY(scene->notes[0].message().find("points without faces") != std::string::npos);
    }

    void concavePolygons_data()
    {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<QByteArray>("bytes");
        const Solid letter =
            prism({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1.5, 1}, {1, 1}, {1, 3}, {0, 3}});
        const QByteArray obj = objOf(letter), ply = plyTextOf(letter);
        QTest::newRow("obj") << "obj" << obj;
        const qsizetype faces = obj.indexOf('f');
        QTest::newRow("obj, faces first") << "obj" << obj.mid(faces) + obj.left(faces);
        QTest::newRow("ply") << "ply" << ply;
        QTest::newRow("ply, float") << "ply" << plyBytesOf<float>(letter, false);
        QTest::newRow("ply, big") << "ply" << plyBytesOf<double>(letter, true);
    }
    void concavePolygons()
    {
        QFETCH(const QString, ending);
        QFETCH(const QByteArray, bytes);
        const ReadMesh mesh = readWell(ending, bytes);
        QVERIFY(mesh.notes.empty());
        const auto report = validateMesh(mesh.objects[0].mesh);
        QVERIFY(report && report->valid);
        QCOMPARE(report->degenerateFaces, Index(0));
        QVERIFY(std::abs(report->volume - 7.0) < 1e-6);
        double area = 0.0;
        for (const glm::uvec3& t : mesh.objects[0].mesh.triangles) {
            const auto& p = mesh.objects[0].mesh.positions;
            area += 0.5 * double(glm::length(glm::cross(p[t.y] - p[t.x], p[t.z] - p[t.x])));
        }
        QVERIFY(std::abs(area - 30.0) < 1e-4); // faces that overlap would have more
    }
    void textureGoesWithThePolygon()
    {
        const char* corners[] = {"0 0", "3 0", "3 3", "2 3", "2 1", "1 1", "1 3", "0 3"};
        QByteArray obj, face("f"),
            ply("ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty "
                "float y\nproperty float z\nelement face 1\nproperty list uchar int "
                "vertex_indices\nproperty list uchar float texcoord\nend_header\n"),
            indices("8"), uv(" 16");
        for (int i = 0; i < 8; ++i) {
            obj += QByteArray("v ") + corners[i] + " 0\nvt " + corners[i] + "\n";
            face += ' ' + QByteArray::number(i + 1) + '/' + QByteArray::number(i + 1);
            ply += QByteArray(corners[i]) + " 0\n";
            indices += ' ' + QByteArray::number(i);
            uv += QByteArray(" ") + corners[i];
        }
        for (const ReadMesh& read : {readWell("obj", obj + face), readWell("ply", ply + indices + uv)}) {
            const TriangleMesh& mesh = read.objects[0].mesh;
            QCOMPARE(mesh.uv.size(), std::size_t(8));
            for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
                for (int k = 0; k < 3; ++k) {
                    const Index place =
                        mesh.uvTriangles.empty() ? mesh.triangles[t][k] : mesh.uvTriangles[t][k];
                    QCOMPARE(mesh.uv[place], glm::vec2(mesh.positions[mesh.triangles[t][k]]));
                }
        }
    }
    void polygonsThatCrossThemselvesAreNoted()
    {
        const QByteArray bow("v 0 0 0\nv 4 0 0\nv 1 2 0\nv 3 2 0\nv 0 1 0\nf 1 2 3 4 5\n");
        QVERIFY(hasNote(readWell("obj", bow).notes, "1 polygons cross themselves"));
    }
    void stripsOfTriangles()
    {
        const QByteArray ply("ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
                             "property float z\nelement tristrips 1\nproperty list int int vertex_indices\n"
                             "end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n9 0 1 2 3 -1 2 3 4 5\n");
        const std::vector<glm::uvec3> expected{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}};
        QVERIFY(readWell("ply", ply).objects[0].mesh.triangles == expected);
        const auto wrong = read("ply", QByteArray(ply).replace("-1 2", "-2 2"));
        QVERIFY(!wrong && wrong.error().plain().find("vertex -2 does not exist") == 0);
    }

    void farFromTheOrigin_data()
    {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<glm::dvec3>("corner");
        const glm::dvec3 survey(512345.678, 4601234.567, 123.456), round(262144, 1048576, 128);
        QTest::newRow("obj") << "obj" << objOf(cubeAt(survey)) << survey;
        QTest::newRow("obj, other system") << "obj" << objOf(cubeAt(survey)).replace("\n", "\r") << survey;
        QTest::newRow("ply") << "ply" << plyTextOf(cubeAt(survey)) << survey;
        QTest::newRow("ply, double") << "ply" << plyBytesOf<double>(cubeAt(survey), false) << survey;
        QTest::newRow("ply, big") << "ply" << plyBytesOf<double>(cubeAt(survey), true) << survey;
        // Single precision holds these in the file itself.
        QTest::newRow("ply, float") << "ply" << plyBytesOf<float>(cubeAt(round), false) << round;
        QTest::newRow("stl") << "stl" << stlBytesOf(cubeAt(round)) << round;
        QTest::newRow("stl, text") << "stl" << stlTextOf(cubeAt(survey)) << survey;
        QTest::newRow("3mf") << "3mf" << modelOf(cubeAt(survey))
                             << glm::dvec3(survey.x, survey.z, -survey.y - 1);
    }
    void farFromTheOrigin()
    {
        QFETCH(const QString, ending);
        QFETCH(const QByteArray, bytes);
        QFETCH(const glm::dvec3, corner);
        const ReadMesh mesh = readWell(ending, bytes);
        QVERIFY(hasNote(mesh.notes, "far from the origin"));
        const auto report = validateMesh(mesh.objects[0].mesh);
        QVERIFY(report && report->valid && std::abs(report->volume - 1.0) < 1e-5);
        glm::dvec3 low(1e30);
        for (const glm::vec3& p : mesh.objects[0].mesh.positions) {
            QVERIFY(glm::length(p) < 100.0F);
            low = glm::min(low, mesh.origin + glm::dvec3(p));
        }
        QVERIFY(glm::distance(low, corner) < 1e-5);
        const auto scene = importObjects(path(qPrintable("f." + ending)));
        QVERIFY2(scene, test::why(scene));
        QVERIFY(std::ranges::any_of(scene->notes, [](const Note& note) {
            return note.message().find("was subtracted from them") != std::string::npos;
        }));
        QCOMPARE(scene->nodes[0].params.tree, PlacementParams());
    }
    void nearTheOriginNothingIsMoved()
    {
        for (const glm::dvec3& corner : {glm::dvec3(0.0), glm::dvec3(40, 0, -60)})
            for (const ReadMesh& mesh :
                 {readWell("obj", objOf(cubeAt(corner))), readWell("stl", stlTextOf(cubeAt(corner)))}) {
                QVERIFY(mesh.notes.empty());
                QCOMPARE(mesh.origin, glm::dvec3(0.0));
            }
    }
    /// Objects of one folder stand to each other as before; what says where it stands stays there.
    void objectsOfOneImportMoveTogether()
    {
        const QTemporaryDir folder;
        test::writeBytes(folder.filePath("a.obj"), objOf(cubeAt({500'003, 0, 4'600'000})));
        test::writeBytes(folder.filePath("b.obj"), objOf(cubeAt({500'041, 0, 4'600'000})));
        const auto scene = importObjects(folder.path().toStdString());
        QVERIFY2(scene, test::why(scene));
        const auto lowest = [&](std::size_t node) {
            float low = 1e30F;
            for (const glm::vec3& p : scene->nodes[node].mesh->positions)
                low = std::min(low, p.x);
            return double(low) + scene->nodes[node].params.tree.translation.x;
        };
        QCOMPARE(scene->nodes.size(), std::size_t(3));
        QCOMPARE(lowest(2) - lowest(1), 38.0);
        test::writeBytes(QString::fromStdString(path("placed.obj")),
                         objOf(cubeAt({500'003, 0, 0})) + "TRANSFORM 1 0 0 2 0 1 0 0 0 0 1 0 0 0 0 1\n");
        const auto placed = importObjects(path("placed.obj"));
        QVERIFY2(placed, test::why(placed));
        QCOMPARE(placed->nodes[0].params.tree.translation, glm::dvec3(2, 0, 0));
        QCOMPARE(placed->nodes[0].params.local.translation.x + double(placed->nodes[0].mesh->positions[0].x),
                 500'003.0);
    }

    void colours_data()
    {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<QByteArray>("bytes");
        const auto obj = [](const QByteArray& colour) {
            return QByteArray("v 0 0 0 C\nv 1 0 0 C\nv 0 1 0 C\nf 1 2 3\n").replace("C", colour);
        };
        QTest::newRow("obj") << "obj" << obj("1 0.2 0");
        QTest::newRow("obj, alpha") << "obj" << obj("1 0.2 0 0.5");
        QTest::newRow("obj, bytes") << "obj" << obj("255 51 0");
        QTest::newRow("obj, capitals") << "obj" << obj("1 0.2 0").toUpper();
        QTest::newRow("obj of ZBrush") << "obj" << obj("") + "#MRGB ffff3300ffff3300ffff3300\n";
        const auto ply = [](const char* type, const QByteArray& colour, bool ofFaces = false,
                            const char* prefix = "") {
            QByteArray properties;
            for (const char* name : {"red", "green", "blue"})
                properties += QByteArray("property ") + type + ' ' + prefix + name + '\n';
            QByteArray out("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                           "property float z\nVelement face 1\nproperty list uchar int vertex_indices\nF"
                           "end_header\n0 0 0v\n1 0 0v\n0 1 0v\n3 0 1 2f\n");
            out.replace("V", ofFaces ? "" : properties).replace("F", ofFaces ? properties : "");
            out.replace("0v", "0 " + (ofFaces ? QByteArray() : colour));
            return out.replace("2f", "2 " + (ofFaces ? colour : QByteArray()));
        };
        for (const bool ofFaces : {false, true})
            for (const auto& [type, colour] :
                 {std::pair{"uchar", "255 51 0"}, std::pair{"ushort", "65535 13107 0"},
                  std::pair{"float", "1 0.2 0"}, std::pair{"double", "1 0.2 0"},
                  std::pair{"float", "255 51 0"}, std::pair{"int", "255 51 0"}})
                QTest::addRow("ply, %s %s of %s", type, colour, ofFaces ? "faces" : "vertices")
                    << "ply" << ply(type, colour, ofFaces);
        QTest::newRow("ply, other names") << "ply" << ply("uchar", "255 51 0", false, "diffuse_");
        const QByteArray triangle(
            "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/>"
            "<vertex x=\"0\" y=\"1\" z=\"0\"/></vertices><triangles><triangle v1=\"0\" v2=\"1\" "
            "v3=\"2\" T/></triangles></mesh></object></resources><build><item objectid=\"1\"/>"
            "</build></model>");
        QTest::newRow("3mf, of the object")
            << "3mf"
            << "<model><resources><basematerials id=\"7\"><base name=\"a\" displaycolor=\"#000000\"/><base "
               "name=\"b\" "
               "displaycolor=\"#FF3300FF\"/></basematerials><object id=\"1\" pid=\"7\" pindex=\"1\">" +
                   QByteArray(triangle).replace("T", "");
        QTest::newRow("3mf, of the triangle") << "3mf"
                                              << "<model xmlns:m=\"m\"><resources><m:colorgroup "
                                                 "id=\"7\"><m:color color=\"#FF3300\"/></m:colorgroup>"
                                                 "<object id=\"1\">" +
                                                     QByteArray(triangle).replace("T", "pid=\"7\" p1=\"0\"");
    }
    void colours()
    {
        QFETCH(const QString, ending);
        QFETCH(const QByteArray, bytes);
        const ReadMesh mesh = readWell(ending, bytes);
        QVERIFY(mesh.objects[0].mesh.colours == std::vector<glm::u8vec3>{glm::u8vec3(255, 51, 0)});
        const auto scene = importObjects(path(qPrintable("f." + ending)));
        QVERIFY2(scene, test::why(scene));
        QCOMPARE(scene->nodes[0].params.surface.color, glm::dvec3(1.0, 0.2, 0.0));
    }
    /// White vertices are what nobody painted: materials say more. A painted face says more than its corners.
    void whichColoursCount()
    {
        test::writeBytes(QString::fromStdString(path("own.mtl")), "newmtl red\nKd 1 0 0\n");
        const QByteArray obj(
            "mtllib own.mtl\nv 0 0 0 1 1 1\nv 1 0 0 1 1 1\nv 0 1 0 1 1 W\nusemtl red\nf 1 2 3\n");
        QCOMPARE(readWell("obj", QByteArray(obj).replace("W", "1")).objects[0].mesh.colours[0],
                 glm::u8vec3(255, 0, 0));
        QCOMPARE(readWell("obj", QByteArray(obj).replace("W", "0")).objects[0].mesh.colours[0],
                 glm::u8vec3(255, 255, 170));
    }

    void normals_data()
    {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<bool>("areLeftOut");
        QTest::addColumn<QString>("note");
        const QByteArray four("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n");
        const auto row = [](const char* name, const char* ending, const QByteArray& bytes, bool areLeftOut,
                            const char* note) {
            QTest::newRow(name) << QString(ending) << bytes << areLeftOut << QString(note);
        };
        row("0", "obj", four + "vn 0 0 1\nf 1//0 2//0 3//0\n", true,
            "line 6: normal 0 does not exist (there are 1)");
        row("none", "obj", four + "f 1//1 2//2 3//3\n", true,
            "line 5: normal 3 does not exist (there are 0)");
        row("beyond", "obj", four + "vn 0 0 1\nf 1//1 2//1 3//7\n", true, "line 6: normal 7 does not exist");
        row("before", "obj", four + "vn 0 0 1\nf 1//1 2//1 3//-2\n", true,
            "line 6: normal -2 does not exist");
        row("zero", "obj", four + "vn 0 0 0\nf 1//1 2//1 3//1\n", false,
            "3 vertices have a normal of length 0");
        row("NaN", "obj", four + "vn 0 nan 0\nf 1//1 2//1 3//1\n", false, "line 5: not three finite numbers");
        row("NaN of Windows", "obj", four + "vn -1.#IND 0 0\nf 1//1 2//1 3//1\n", false,
            "line 5: not three finite");
        row("cut off", "obj", four + "vn 0 1\nf 1//1 2//1 3//1\n", false, "line 5: not three finite numbers");
        const QByteArray ply(
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
            "z\nproperty float nx\nproperty float ny\nproperty float nz\nelement face 1\nproperty list "
            "uchar int vertex_indices\nend_header\n0 0 0 0 0 1\n1 0 0 N\n0 1 0 0 0 1\n3 0 1 2\n");
        row("ply, zero", "ply", QByteArray(ply).replace("N", "0 0 0"), false,
            "1 vertices have a normal of length 0");
        row("ply, NaN", "ply", QByteArray(ply).replace("N", "nan 0 inf"), false, "1 vertices have a normal");
    }
    void normals()
    {
        QFETCH(const QString, ending);
        QFETCH(const QByteArray, bytes);
        QFETCH(const bool, areLeftOut);
        QFETCH(const QString, note);
        const ReadMesh mesh = readWell(ending, bytes);
        QCOMPARE(mesh.objects[0].mesh.faceCount(), Index(1));
        QVERIFY2(hasNote(mesh.notes, qPrintable(note)), mesh.notes.empty() ? "" : mesh.notes[0].c_str());
        QCOMPARE(mesh.objects[0].mesh.normals.empty(), areLeftOut);
        if (!areLeftOut)
            for (const Index v : {0, 1, 2})
                QCOMPARE(mesh.objects[0].mesh.normals[v], glm::vec3(0, 0, 1));
    }

    /// Whatever system and program wrote it, a file of text is the same file.
    void textOfEverySystem_data()
    {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<QByteArray>("text");
        const Solid letter = prism({{0, 0}, {3, 0}, {3, 3}, {0.5, 1}});
        QTest::newRow("obj") << "obj"
                             << "# up z, unit cm, scale 2\nmtllib own.mtl\nusemtl red\n" + objOf(letter);
        QTest::newRow("ply") << "ply" << plyTextOf(letter);
        QTest::newRow("stl") << "stl" << stlTextOf(cubeAt({0, 0, 0}));
        QTest::newRow("Blender's") << "obj" << objOf(letter) + "TRANSFORM 1 0 0 2 0 1 0 3 0 0 1 4 0 0 0 1\n";
        QTest::newRow("animation") << "animation"
                                   << QByteArray("0,LINEAR,0,0,0,0,0,0,1,1,1,1\n"
                                                 "1,CONSTANT,2,0,0,0,0,0,1,1,1,1\n");
    }
    void textOfEverySystem()
    {
        QFETCH(const QString, ending);
        QFETCH(const QByteArray, text);
        const QByteArray materials("newmtl red\nKd 1 0 0\nmap_Kd bark.webp\n");
        const auto nodeOf = [&](const QByteArray& bytes, const QByteArray& ofMaterials) {
            test::writeBytes(m_folder.filePath("own.mtl"), ofMaterials);
            test::writeBytes(m_folder.filePath("g." + ending), bytes);
            auto scene = importObjects(path(qPrintable("g." + ending)));
            return scene ? scene->nodes[0] : (qInfo("%s", test::why(scene).constData()), Node());
        };
        const auto utf16 = [](const QByteArray& bytes) {
            const QString wide = QChar(0xFEFF) + QString::fromLatin1(bytes);
            return QByteArray(reinterpret_cast<const char*>(wide.utf16()), 2 * wide.size());
        };
        const Node plain = nodeOf(text, materials);
        QVERIFY(plain.id != noNode);
        using Change = std::function<QByteArray(QByteArray)>;
        const Change changes[] = {
            [](QByteArray t) { return t.replace("\n", "\r\n"); },
            [](QByteArray t) { return t.replace("\n", "\r"); },
            [](QByteArray t) {
                return t.replace(t.indexOf('\n') + 1, t.size(),
                                 t.mid(t.indexOf('\n') + 1).replace("\n", "\r"));
            },
            [](const QByteArray& t) { return "\xEF\xBB\xBF" + t; },
            [](const QByteArray& t) { return t + "\x1A"; },
            [](const QByteArray& t) { return t + QByteArray(300, '\0'); },
            utf16,
            [&](const QByteArray& t) { return utf16(t).mid(2); }, // without the mark
        };
        for (const Change& change : changes) {
            // Only the first line of a PLY says how all its lines end.
            if (ending == "ply" && &change == &changes[2])
                continue;
            const Node other = nodeOf(change(text), change(materials));
            QVERIFY2(other == plain, QByteArray::number(&change - changes));
        }
        // File spaces and names of materials are as they are written.
        if (!text.startsWith('#')) {
            QVERIFY(nodeOf(text.toUpper(), materials) == plain);
            QVERIFY(nodeOf(text.toLower(), materials) == plain);
        }
    }
    void bytesBehindTheEnd()
    {
        const Solid cube = cubeAt({0, 0, 0});
        const QByteArray rest("rest of a block");
        QVERIFY(hasNote(readWell("ply", plyBytesOf<float>(cube, false) + rest).notes,
                        "15 bytes behind the last element"));
        QVERIFY(hasNote(readWell("ply", plyBytesOf<double>(cube, true) + rest).notes,
                        "15 bytes behind the last element"));
        QVERIFY(hasNote(readWell("ply", plyTextOf(cube) + rest).notes, "text behind the last element"));
        QByteArray stl = stlBytesOf(cube);
        QVERIFY(hasNote(readWell("stl", stl + rest).notes, "15 bytes behind the last triangle"));
        stl.replace(0, 5, "solid");
        QVERIFY(hasNote(readWell("stl", stl + rest).notes, "15 bytes behind the last triangle"));
        stl[84 + 48] = 7;
        QVERIFY(hasNote(readWell("stl", stl).notes, "1 triangles have colours of their own: left out"));
        QVERIFY(hasNote(readWell("stl", stlTextOf(cube) + rest).notes, "text behind the last solid"));
        QVERIFY(hasNote(readWell("obj", objOf(cube) + QByteArray(9, '\0')).notes, "9 bytes of padding"));
    }
};

RAMURE_SUITE(TestForeignMeshes)

} // namespace tst_foreign_meshes

#include "tst_foreign_meshes.moc"
