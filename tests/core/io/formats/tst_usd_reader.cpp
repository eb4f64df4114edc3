#include "core/io/formats/file_format.h"
#include "core/io/formats/text/blender_scene.h"
#include "core/io/formats/usd/usd_layer.h"
#include "core/io/zip_file.h"
#include "core/surface/mesh/normals.h"
#include "tests/core/io/io_support.h"
#include "tests/support/solids.h"
#include <QDir>
#include <QTemporaryDir>

namespace tst_usd_reader {

using namespace ramure;

namespace {

/// As other programs write it: other names, polygons, operations, a material of one colour.
QByteArray foreign()
{
    return test::fileBytes(QStringLiteral(RAMURE_TEST_DATA "/foreign.usda"));
}

struct Damage
{
    const char* name;
    const char *what, *with; ///< the first place of a text, and what stands there then
};

constexpr Damage damages[] = {
    {"another header", "#usda 1.0", "#usd text"},
    {"no brace", "def Scope \"Looks\"\n    {", "def Scope \"Looks\"\n"},
    {"an index too large", "[0, 1, 2, 3, 0, 3, 4]", "[0, 1, 2, 3, 0, 3, 5]"},
    {"a negative index", "[0, 1, 2, 3, 0, 3, 4]", "[0, 1, 2, 3, 0, -1, 4]"},
    {"an index less", "[0, 1, 2, 3, 0, 3, 4]", "[0, 1, 2, 3, 0, 3]"},
    {"a face of two corners", "[4, 3]", "[4, 2]"},
    {"a point of two numbers", "(100, 100, 0)", "(100, 100)"},
    {"no number", "(100, 100, 0)", "(100, nan, 0)"},
    {"a huge number", "(100, 100, 0)", "(100, 1e999, 0)"},
    {"a text without an end", "upAxis = \"Z\"", "upAxis = \"Z"},
    {"coordinates too few", "(0, 1), (0.5, 0.5)]", "(0, 1)]"},
    {"a type that there is not", "point3f[]", "pointy[]"},
    {"a list of another type",
     "point3f[] points = [(0, 0, 0), (100, 0, 0), (100, 100, 0), (0, 100, 0), (-50, 50, 0)]",
     "float2[] points = [(0, 0)]"},
    {"two of one name", "def Camera \"Eye\"", "def Camera \"Looks\""},
    {"a name that is none", "\"Quad\"", "\"a quad\""},
    {"a path without an end", "</World/Looks/Red>", "</World/Looks/Red"},
    {"a prim that there is not", "references = </World/Quad>", "references = </World/Quat>"},
    {"an unknown operation", "double3 xformOp:translate", "float xformOp:translate"},
    {"no unit", "metersPerUnit = 0.01", "metersPerUnit = -1"},
    {"no axis", "\"Z\"", "\"X\""},
    {"a comma too few", "(0, 0, 0), (100, 0, 0)", "(0, 0, 0) (100, 0, 0)"},
};

} // namespace

/// USD as text, of other programs and broken.
class TestUsdReader : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    std::string file(const char* name, const QByteArray& bytes) const
    {
        const QString path = m_folder.filePath(QLatin1String(name));
        test::writeBytes(path, bytes);
        return path.toStdString();
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void damagedFilesAreRefused_data()
    {
        QTest::addColumn<int>("number");
        for (int i = 0; i < int(std::size(damages)); ++i)
            QTest::newRow(damages[i].name) << i;
    }
    void damagedFilesAreRefused()
    {
        QFETCH(const int, number);
        const Damage& damage = damages[number];
        QByteArray bytes = foreign();
        const auto at = bytes.indexOf(damage.what);
        QVERIFY(at >= 0);
        bytes.replace(at, qsizetype(std::strlen(damage.what)), damage.with);
        const std::string path = file("bad.usda", bytes);
        const auto read = readMeshFile(path);
        const auto nodes = importObjects(path);
        QVERIFY(!read && !nodes);
        QCOMPARE(read.error().file, path);
        QVERIFY2(!read.error().plain().empty() && nodes.error().plain() == read.error().plain(),
                 test::why(nodes));
        const bool isOfStage = number == 18 || number == 19; // of no line
        QVERIFY2(isOfStage || read.error().line > 0, test::why(read));
    }
    void anyEndIsAnEnd()
    {
        const QByteArray bytes = foreign();
        for (qsizetype end = 0; end + 3 < bytes.size(); end += 7) {
            const auto layer = usd::parseLayer(test::view(bytes.left(end)), "cut");
            QVERIFY2(!layer || end < 200, qPrintable(QString::number(end)));
        }
        const QByteArray deep = "#usda 1.0\n" + QByteArray("def \"a\" {").repeated(100'000);
        QCOMPARE(usd::parseLayer(test::view(deep), "deep").error().code, ErrorCode::Limit);
        const QByteArray brackets = "#usda 1.0\n( a = " + QByteArray("[").repeated(100'000);
        QVERIFY(!usd::parseLayer(test::view(brackets), "brackets"));
        const QByteArray circle = "#usda 1.0\ndef \"a\" ( references = </a> ) { def \"b\" ( references = "
                                  "</a> ) { def Mesh \"m\" { } } }";
        const auto endless = importObjects(file("circle.usda", circle));
        QVERIFY(!endless && endless.error().code == ErrorCode::Limit);
    }
    void packagesThatAreNone()
    {
        QCOMPARE(readMeshFile(file("no.usdz", "PK is no package")).error().code, ErrorCode::Syntax);
        const std::string path = m_folder.filePath(QStringLiteral("binary.usdz")).toStdString();
        QVERIFY(writeZip(path, std::vector<ZipEntry>{{"a.usdc", "PXR-USDC", false}}));
        QCOMPARE(readMeshFile(path).error().code, ErrorCode::Version);
        QCOMPARE(readMeshFile(file("binary.usda", "PXR-USDC and so on")).error().code, ErrorCode::Version);
    }
    void filesThatAreOnlyPartsSayWhatTheyLack()
    {
        for (const char* text : {"#usda 1.0\n( subLayers = [ @./far.usda@ ] )\ndef Xform \"a\" { }",
                                 "#usda 1.0\ndef \"a\" ( prepend payload = @./far.usda@</b> ) { }"}) {
            const auto read = readMeshFile(file("part.usda", text));
            QVERIFY(!read && read.error().args.front() == "./far.usda");
        }
        // A class that is not there is none that is missed.
        QVERIFY(readMeshFile(file(
            "class.usda", foreign().replace("references = </World/Quad>", "inherits = </_class_Quad>"))));
    }
    void simpleShapesAreMeshes()
    {
        const auto boxOf = [&](const char* text) {
            const auto read =
                readMeshFile(file("shape.usda", QByteArray("#usda 1.0\n( metersPerUnit = 1 )\n") + text));
            if (!read)
                qFatal("%s", test::why(read).constData());
            glm::vec3 low(1e9F), high(-1e9F);
            for (const glm::vec3& p : read->objects.at(0).mesh.positions) {
                low = glm::min(low, p);
                high = glm::max(high, p);
            }
            return std::pair(low, high);
        };
        QCOMPARE(boxOf("def Cube \"a\" { }"), std::pair(glm::vec3(-1.0F), glm::vec3(1.0F)));
        const auto [low, high] = boxOf("def Cylinder \"a\" { double radius = 0.5 double height = 4 }");
        QVERIFY(std::abs(low.z + 2.0F) < 1e-6F && std::abs(high.z - 2.0F) < 1e-6F && high.x <= 0.5F);
        QVERIFY(boxOf("def Sphere \"a\" { double radius = 3 }").second.y > 2.9F);
        QVERIFY(!readMeshFile(file("shape.usda", "#usda 1.0\ndef Cone \"a\" { double radius = 0 }")));
    }
    void otherFilesAreFollowed()
    {
        QVERIFY(QDir(m_folder.path()).mkpath(QStringLiteral("parts/deep")));
        const QByteArray mesh = "{ int[] faceVertexCounts = [3] int[] faceVertexIndices = [0, 1, 2] "
                                "point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)] }";
        file("parts/part.usda", "#usda 1.0\n( defaultPrim = \"P\" subLayers = [ @./deep/more.usda@ ] )\n"
                                "def Xform \"P\" { def Mesh \"m\" " +
                                    mesh +
                                    "def \"copy\" ( references = </P/m> ) { }\n"
                                    "def \"lost\" ( references = @./binary.usdc@ ) { } }");
        file("parts/deep/more.usda", "#usda 1.0\ndef Mesh \"Alone\" " + mesh);
        file("parts/binary.usdc", "PXR-USDC");
        const std::string whole =
            file("whole.usda", "#usda 1.0\n( metersPerUnit = 1 subLayers = [ @./parts/deep/more.usda@ ] )\n"
                               "def \"A\" ( references = @./parts/part.usda@ ) { }\n"
                               "def \"B\" ( prepend payload = @./parts/part.usda@</P/m> ) { }\n"
                               "def \"C\" ( references = @./whole.usda@</B> ) { }");
        const auto read = readMeshFile(whole);
        QVERIFY2(read, test::why(read));
        QCOMPARE(read->objects.size(), std::size_t(5)); // m, copy, B, C and Alone
        QVERIFY(std::ranges::any_of(read->notes, [](const auto& note) {
            return note.find("parts/binary.usdc") != std::string::npos;
        }));
    }
    void aFileOfAnotherProgram()
    {
        const auto nodes = importObjects(file("foreign.usda", foreign()));
        QVERIFY2(nodes, test::why(nodes));
        QCOMPARE(nodes->nodes.size(), std::size_t(3));
        QCOMPARE(nodes->nodes[0].name, std::string("World"));
        const Node& quad = nodes->nodes[1];
        QCOMPARE(quad.mesh->triangles.size(), std::size_t(3));
        QCOMPARE(quad.mesh->uvTriangles.size(), std::size_t(3));
        QVERIFY(quad.params.surface.color == glm::dvec3(1.0, 0.0, 0.0));
        const Node& eye = nodes->nodes[2];
        QVERIFY(eye.kind == NodeKind::Camera && std::abs(eye.params.camera.angleRad - 0.471) < 1e-3);
        QVERIFY(nodes->notes.size() >= 4); // another file, a lamp, subdivision, what is hidden
        const auto read = readMeshFile(file("foreign.usda", foreign()));
        QVERIFY2(read, test::why(read));
        QCOMPARE(read->objects.size(), std::size_t(1));
        // 2 m up; a quarter turn puts what was along x along y of the file, which is -z here.
        const glm::vec3 corner = read->objects[0].mesh.positions[1];
        QVERIFY2(glm::distance(corner, glm::vec3(0.0F, 2.0F, -2.0F)) < 1e-5F, "another place");
    }
    void whatIsWrittenIsRead()
    {
        std::mt19937 random(7);
        for (int run = 0; run < test::runs(40); ++run) {
            TriangleMesh mesh = test::box({0, 0, 0}, {1, 1, 1});
            for (glm::vec3& p : mesh.positions)
                p = p * 3.0F + glm::vec3(float(random() % 1000), float(random() % 1000), 0.25F) / 7.0F;
            computeNormals(mesh);
            const bool hasColours = random() % 2 == 0;
            for (std::size_t i = 0; i < mesh.triangles.size() && hasColours; ++i)
                mesh.colours.emplace_back(random() % 256, random() % 256, random() % 256);
            const std::string path = file("own.usda", "");
            const auto format = findFormat(path, FormatUse::Write);
            const ExportScene scene = sceneOfMeshes({{"thing", mesh, {}}}, Material{"grey", {40, 50, 60}});
            QVERIFY((*format)->write(path, scene, {.mapSize = 16}, {}));
            const auto back = readMeshFile(path);
            QVERIFY2(back, test::why(back));
            const TriangleMesh& own = back->objects.front().mesh;
            QVERIFY(own.positions == mesh.positions && own.triangles == mesh.triangles);
            for (std::size_t i = 0; i < own.colours.size(); ++i) {
                const glm::ivec3 wanted = hasColours ? glm::ivec3(mesh.colours[i]) : glm::ivec3(40, 50, 60);
                for (int k = 0; k < 3; ++k)
                    QVERIFY(std::abs(own.colours[i][k] - wanted[k]) <= 1);
            }
        }
    }
};

RAMURE_SUITE(TestUsdReader)

} // namespace tst_usd_reader

#include "tst_usd_reader.moc"
