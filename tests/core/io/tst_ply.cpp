#include "core/base/version.h"
#include "tests/core/io/io_support.h"
#include <QTemporaryDir>
#include <QtEndian>

namespace tst_ply {

using namespace ramure;

namespace {

std::string header(const char* format, const std::string& rest)
{
    return "ply\nformat " + std::string(format) + " 1.0\n" + rest + "end_header\n";
}

const std::string plainVertex = "property float x\nproperty float y\nproperty float z\n";
const std::string faceList = "property list uchar int vertex_indices\n";
const std::string triangleHeader = "element vertex 3\n" + plainVertex + "element face 1\n" + faceList;

Error errorOf(const std::string& bytes)
{
    const auto mesh = parsePly(bytes, "f.ply");
    if (mesh)
        qFatal("read without an error");
    return mesh.error();
}

TriangleMesh read(const std::string& bytes)
{
    const auto mesh = parsePly(bytes, "folder/f.ply");
    if (!mesh)
        qFatal("%s", test::why(mesh).constData());
    return mesh->objects.front().mesh;
}

/// Appends a number in either order of bytes.
template <class T> void put(std::string& to, T value, bool bigEndian)
{
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    if (bigEndian)
        std::reverse(bytes, bytes + sizeof(T));
    to.append(bytes, sizeof(T));
}

} // namespace

class TestPly : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;

    std::string path(const char* name) const { return m_folder.filePath(name).toStdString(); }

private slots:
    void init() { test::failOnAnyWarning(); }

    void badHeaders_data()
    {
        QTest::addColumn<QString>("header");
        QTest::addColumn<QString>("message");
        const auto row = [](const char* name, const std::string& text, const char* message) {
            QTest::newRow(name) << QString::fromStdString(text) << QString(message);
        };
        row("empty", "", "f.ply:1: not a PLY file: it does not begin with \"ply\"");
        row("other", "solid x\n", "f.ply:1: not a PLY file: it does not begin with \"ply\"");
        row("no end", "ply\nformat ascii 1.0\n", "f.ply:3: the header has no end");
        row("no format", "ply\nelement vertex 0\nend_header\n", "f.ply:3: the header states no format");
        row("format", "ply\nformat binary 1.0\n", "f.ply:2: unknown format \"binary\"");
        row("count", "ply\nformat ascii 1.0\nelement vertex -3\n",
            "f.ply:3: \"-3\" is no number of elements");
        row("count 2", "ply\nformat ascii 1.0\nelement vertex 99999999999999999999\n",
            "f.ply:3: \"99999999999999999999\" is no number of elements");
        row("lost property", "ply\nformat ascii 1.0\nproperty float x\n",
            "f.ply:3: a property before the first element");
        row("type", "ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\n",
            "f.ply:4: unknown type of property \"x\"");
        row("float count", "ply\nformat ascii 1.0\nelement face 1\nproperty list float int vertex_indices\n",
            "f.ply:4: unknown type of property \"vertex_indices\"");
        row("twice", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float x\n",
            "f.ply:5: two properties \"x\"");
        row("two elements", "ply\nformat ascii 1.0\nelement vertex 1\nelement vertex 1\n",
            "f.ply:4: two elements \"vertex\"");
        row("prose", "ply\nonce upon\n", "f.ply:2: not a line of a PLY header: \"once\"");
        row("four billion",
            header("binary_little_endian", "element vertex 4000000000\n" + plainVertex) + "abc",
            "f.ply:3: the file is too short for 4000000000 elements \"vertex\"");
        row("more than any file",
            header("ascii", "element vertex 18446744073709551615\n" + plainVertex) + "1 2 3",
            "f.ply:3: the file is too short for 18446744073709551615 elements \"vertex\"");
        row("faces",
            header("ascii", "element vertex 1\n" + plainVertex + "element face 4000000000\n" + faceList) +
                "1 2 3\n",
            "f.ply:7: the file is too short for 4000000000 elements \"face\"");
        row("no vertices", header("ascii", "element face 0\n" + faceList),
            "f.ply:6: the file holds no vertices");
        row("no x", header("ascii", "element vertex 1\nproperty float y\nproperty float z\n") + "1 2\n",
            "f.ply:7: vertices without x, y and z");
        row("list as x",
            header("ascii",
                   "element vertex 1\nproperty list uchar float x\nproperty float y\nproperty float z\n") +
                "1 1 2 3\n",
            "f.ply:8: vertices without x, y and z");
        row("float faces",
            header("ascii", "element vertex 1\n" + plainVertex +
                                "element face 1\nproperty list uchar float vertex_indices\n") +
                "1 2 3\n3 0 0 0\n",
            "f.ply:10: the faces' vertices are no list of integers");
    }
    void badHeaders()
    {
        QFETCH(QString, header);
        QFETCH(QString, message);
        QCOMPARE(QString::fromStdString(errorOf(header.toStdString()).message()), message);
    }
    void badText_data()
    {
        QTest::addColumn<QString>("body");
        QTest::addColumn<QString>("message");
        QTest::newRow("number") << "0 0 0\n1 b 0\n0 1 0\n3 0 1 2\n"
                                << "f.ply:11: a number expected, found \"b\"";
        QTest::newRow("letters") << "0 0 0\n1 0x 0\n0 1 0\n3 0 1 2\n"
                                 << "f.ply:11: a number expected, found \"0x\"";
        QTest::newRow("nan") << "0 0 0\n1 0 0\n0 nan 0\n3 0 1 2\n"
                             << "f.ply:12: vertex 2 is not a finite number";
        QTest::newRow("huge") << "0 0 0\n1 0 0\n0 1e39 0\n3 0 1 2\n"
                              << "f.ply:12: vertex 2 is not a finite number";
        QTest::newRow("end") << "0 0 0\n1 0 0\n0 1 0\n3 0 1"
                             << "f.ply:14: the file ends within element 0 of \"face\"";
        QTest::newRow("range") << "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"
                               << "f.ply:13: vertex 3 does not exist (there are 3)";
        QTest::newRow("negative") << "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"
                                  << "f.ply:13: vertex -1 does not exist (there are 3)";
        QTest::newRow("corners") << "0 0 0\n1 0 0\n0 1 0\n2 0 1\n"
                                 << "f.ply:13: face 0 has fewer than three corners";
        QTest::newRow("list") << "0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n"
                              << "f.ply:13: a list of -3 values";
        QTest::newRow("fraction") << "0 0 0\n1 0 0\n0 1 0\n3 0 1.5 2\n"
                                  << "f.ply:13: a number expected, found \"1.5\"";
    }
    void badText()
    {
        QFETCH(QString, body);
        QFETCH(QString, message);
        QCOMPARE(
            QString::fromStdString(errorOf(header("ascii", triangleHeader) + body.toStdString()).message()),
            message);
    }
    void badBytes()
    {
        for (const bool big : {false, true}) {
            const std::string head =
                header(big ? "binary_big_endian" : "binary_little_endian", triangleHeader);
            std::string body;
            for (const float f : {0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f})
                put(body, f, big);
            const auto face = [&](int corners, int last) {
                std::string out = body;
                out += static_cast<char>(corners);
                for (const int i : {0, 1, last})
                    put(out, i, big);
                return out;
            };
            QCOMPARE(read(head + face(3, 2)).triangles.front(), glm::uvec3(0, 1, 2));
            QCOMPARE(errorOf(head + face(3, 3)).message(), "f.ply: byte " + std::to_string(head.size() + 49) +
                                                               ": vertex 3 does not exist (there are 3)");
            QCOMPARE(errorOf(head + face(3, -1)).code, ErrorCode::Invalid);
            QCOMPARE(errorOf(head + face(2, 2)).plain(), std::string("face 0 has fewer than three corners"));
            QCOMPARE(errorOf(head + face(4, 2)).plain(),
                     std::string("the file ends within element 0 of \"face\""));
            QCOMPARE(errorOf(head + face(3, 2).substr(0, 48)).plain(),
                     std::string("the file ends within element 0 of \"face\""));
            std::string nan;
            put(nan, std::numeric_limits<float>::quiet_NaN(), big);
            QCOMPARE(errorOf(head + face(3, 2).replace(16, 4, nan)).message(),
                     "f.ply: byte " + std::to_string(head.size() + 24) + ": vertex 1 is not a finite number");
        }
    }
    void hugePromisesTakeNoMemory()
    {
        // Elements without properties take no room, however many are promised.
        const std::string text =
            header("ascii", "element vertex 3\n" + plainVertex +
                                "element ghost 18446744073709551615\nelement face 1\n" + faceList);
        QCOMPARE(read(text + "1 2 3\n0 0 0\n0 1 0\n3 0 1 2\n").vertexCount(), 3u);
        // A list that promises more than is left.
        const std::string list =
            header("binary_little_endian", "element vertex 1\n" + plainVertex +
                                               "element face 1\nproperty list uint int vertex_indices\n");
        std::string body;
        for (int i = 0; i < 3; ++i)
            put(body, 0.0f, false);
        put(body, 4'000'000'000u, false);
        QCOMPARE(errorOf(list + body + "xxxx").plain(),
                 std::string("the file ends within element 0 of \"face\""));
    }
    void everyTypeOfProperty()
    {
        for (const char* type : {"char", "uchar", "short", "ushort", "int", "uint", "float", "double", "int8",
                                 "uint8", "int16", "uint16", "int32", "uint32", "float32", "float64"}) {
            const QByteArray name(type);
            std::string head =
                "element vertex 3\ncomment none\nobj_info none\nproperty " + name.toStdString() +
                " x\nproperty double extra\nproperty list uchar short many\nproperty " + name.toStdString() +
                " y\nproperty " + name.toStdString() +
                " z\nelement strange 2\nproperty list ushort double d\nelement face 1\nproperty uchar "
                "flag\nproperty list ushort " +
                (name.startsWith("float") || name == "double" ? std::string("int") : name.toStdString()) +
                " vertex_index\n";
            const std::string text =
                header("ascii", head) + "0 9 2 7 7 0 0\n1 9 0 0 0\n0 9 1 5 1 0\n2 1.5 2.5\n0\n7 3 0 1 2\n";
            const TriangleMesh ascii = read(text);
            QCOMPARE(ascii.positions[2], glm::vec3(0, 1, 0));
            QCOMPARE(ascii.triangles[0], glm::uvec3(0, 1, 2));
            for (const bool big : {false, true}) {
                std::string body;
                const auto scalar = [&](int value) {
                    if (name == "double" || name == "float64")
                        put(body, double(value), big);
                    else if (name.startsWith("float"))
                        put(body, float(value), big);
                    else if (name.contains("16") || name.contains("short"))
                        put(body, static_cast<std::int16_t>(value), big);
                    else if (name.contains("32") || name.contains("int"))
                        name.contains("8") ? put(body, static_cast<std::int8_t>(value), big)
                                           : put(body, value, big);
                    else
                        put(body, static_cast<std::int8_t>(value), big);
                };
                const int positions[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
                for (int v = 0; v < 3; ++v) {
                    scalar(positions[v][0]);
                    put(body, 9.0, big);
                    body += static_cast<char>(v);
                    for (int i = 0; i < v; ++i)
                        put(body, static_cast<std::int16_t>(7), big);
                    scalar(positions[v][1]);
                    scalar(positions[v][2]);
                }
                put(body, static_cast<std::uint16_t>(1), big);
                put(body, 1.5, big);
                put(body, static_cast<std::uint16_t>(0), big);
                body += static_cast<char>(7);
                put(body, static_cast<std::uint16_t>(3), big);
                for (int i = 0; i < 3; ++i) {
                    if (name.startsWith("float") || name == "double")
                        put(body, i, big);
                    else
                        scalar(i);
                }
                const TriangleMesh binary =
                    read(header(big ? "binary_big_endian" : "binary_little_endian", head) + body);
                QVERIFY(test::sameBits(binary.positions, ascii.positions));
                QVERIFY(binary.triangles == ascii.triangles);
            }
        }
    }
    void polygonsFacesFirstAndWindowsLineEnds()
    {
        const std::string text =
            "ply\r\nformat ascii 1.0\r\nelement face 1\r\nproperty list uchar int vertex_indices\r\n"
            "element vertex 5\r\nproperty float x\r\nproperty float y\r\nproperty float z\r\n"
            "end_header\r\n5 0 1 2 3 4\r\n0 0 0\r\n1 0 0\r\n1 1 0\r\n0 1 0\r\n-1 0.5 0\r\n";
        const std::vector<glm::uvec3> expected = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
        QVERIFY(read(text).triangles == expected);
        QVERIFY(read(text.substr(0, text.size() - 2)).triangles == expected);
    }
    void notesSayWhatIsSkipped()
    {
        const std::string head = "element vertex 3\n" + plainVertex +
                                 "property float quality\nelement edge 2\n" +
                                 "property int vertex1\nproperty int vertex2\nelement face 1\n" + faceList +
                                 "property uchar flag\n";
        const auto mesh = parsePly(
            header("ascii", head) + "1 2 3 0.5\n0 0 0 0\n0 1 0 0\n0 0\n0 0\n3 0 1 2 7\nmore\n", "f.ply");
        QVERIFY2(mesh, test::why(mesh));
        const std::vector<std::string> expected = {
            "2 elements \"edge\" skipped", "line 21: text behind the last element",
            "vertex properties skipped: quality", "face properties skipped: flag"};
        QVERIFY(mesh->notes == expected);
        QCOMPARE(mesh->objects[0].name, std::string("f"));
    }
    void cancelStops()
    {
        std::stop_source source;
        source.request_stop();
        Progress progress;
        progress.stop = source.get_token();
        const std::string text = header("ascii", triangleHeader) + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
        const auto mesh = parsePly(text, "f.ply", progress);
        QVERIFY(!mesh);
        QCOMPARE(mesh.error().code, ErrorCode::Cancelled);
    }

    void headersAndTextAreAsStated()
    {
        TriangleMesh branches;
        branches.positions = {{0, 0.5f, 1}};
        branches.normals = {{0, 0, 1}};
        branches.branch = {7};
        branches.level = {noIndex};
        TriangleMesh leaves = branches;
        leaves.branch = leaves.level = {};
        leaves.positions.push_back({1, 1, 1});
        leaves.normals.push_back({0, 1, 0});
        leaves.triangles = {{0, 1, 0}};
        const MeshPart parts[] = {{"branches", &branches, barkMaterial()},
                                  {"leaves", &leaves, leavesMaterial()}};
        QVERIFY(writePly(path("a.ply"), parts, {.ascii = true}));
        QCOMPARE(
            test::fileBytes(m_folder.filePath("a.ply")),
            QByteArray(
                "ply\nformat ascii 1.0\ncomment Ramure " RAMURE_VERSION
                "\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float "
                "nx\nproperty float ny\nproperty float nz\nproperty uchar red\nproperty uchar "
                "green\nproperty uchar blue\nproperty uint branch\nproperty int level\nelement face "
                "1\nproperty list uchar int vertex_indices\nend_header\n"
                "0 0.5 1 0 0 1 139 90 43 7 -1\n0 0.5 1 0 0 1 58 95 11 4294967295 -1\n"
                "1 1 1 0 1 0 58 95 11 4294967295 -1\n3 1 2 1\n"));
        const TriangleMesh back = read(test::fileBytes(m_folder.filePath("a.ply")).toStdString());
        const std::vector<Index> ids = {7, noIndex, noIndex};
        QVERIFY(back.branch == ids);
        QCOMPARE(back.level[0], noIndex);
    }
    void linesOfASkeleton()
    {
        const LinePart lines{"skeleton", {{0, 0, 0}, {0, 1, 0}}, {{0, 1}}};
        for (const bool ascii : {false, true}) {
            QVERIFY(writePlyLines(path("lines.ply"), lines, {ascii}));
            QVERIFY(test::fileBytes(m_folder.filePath("lines.ply")).contains("element edge 1\n"));
            // No surface, so that nobody could see it.
            const auto back = readMeshFile(path("lines.ply"));
            QVERIFY(!back);
            QCOMPARE(back.error().message(),
                     path("lines.ply") +
                         ": the file holds 2 points and no faces: there is no surface to read");
        }
    }
    void coloursOfVerticesAreThoseOfTriangles()
    {
        const std::string head = "element vertex 3\n" + plainVertex +
                                 "property uchar red\nproperty uchar green\nproperty uchar blue\nelement "
                                 "face 1\n" +
                                 faceList;
        const TriangleMesh mesh =
            read(header("ascii", head) + "0 0 0 9 9 9\n1 0 0 9 9 9\n0 1 0 9 9 9\n3 0 1 2\n");
        QCOMPARE(mesh.colours, std::vector<glm::u8vec3>{glm::u8vec3(9)});
        // Where one is missing there are none.
        QVERIFY(read(header("ascii", "element vertex 3\n" + plainVertex +
                                         "property uchar red\nproperty uchar green\nproperty uchar grey\n" +
                                         "element face 1\n" + faceList) +
                     "0 0 0 9 9 9\n1 0 0 9 9 9\n0 1 0 9 9 9\n3 0 1 2\n")
                    .colours.empty());
    }
    /// Of triangles that share corners too: what was read is written as it was, byte by byte.
    void coloursRoundTrip()
    {
        std::mt19937 random(14);
        for (int round = 0; round < 40; ++round) {
            TriangleMesh mesh = test::randomMesh(random, round % 2 == 0);
            for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
                mesh.colours.emplace_back(random() % 256, random() % 256, random() % 256);
            const Material material = applesMaterial();
            const MeshPart part{"part", &mesh, material};
            for (const bool ascii : {false, true}) {
                QVERIFY(writePly(path("colours.ply"), {&part, 1}, {ascii}));
                const auto back = readMeshFile(path("colours.ply"));
                QVERIFY2(back, test::why(back));
                const MeshPart again{"part", &back->objects[0].mesh, material};
                QVERIFY(writePly(path("again.ply"), {&again, 1}, {ascii}));
                QCOMPARE(test::fileBytes(m_folder.filePath("again.ply")),
                         test::fileBytes(m_folder.filePath("colours.ply")));
            }
        }
    }
    void randomMeshesRoundTrip()
    {
        std::mt19937 random(13);
        for (int round = 0; round < 300; ++round) {
            const TriangleMesh mesh = test::randomMesh(random, round % 2 == 0);
            const MeshPart part{"part", &mesh, applesMaterial()};
            for (const bool ascii : {false, true}) {
                QVERIFY(writePly(path("round.ply"), {&part, 1}, {ascii}));
                const auto back = readMeshFile(path("round.ply"));
                QVERIFY2(back, test::why(back));
                const TriangleMesh& other = back->objects[0].mesh;
                QVERIFY(test::sameBits(other.positions, mesh.positions));
                QVERIFY(test::sameBits(other.normals, mesh.normals));
                QVERIFY(other.triangles == mesh.triangles);
                QVERIFY(other.branch == mesh.branch);
                QVERIFY(other.level == mesh.level);
            }
        }
    }
};

RAMURE_SUITE(TestPly)

} // namespace tst_ply

#include "tst_ply.moc"
