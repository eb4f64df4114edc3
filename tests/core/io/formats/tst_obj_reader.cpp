#include "core/io/formats/text/obj_scan.h"
#include "tests/core/io/io_support.h"
#include <QTemporaryDir>

namespace tst_obj_reader {

using namespace ramure;

namespace {

Error errorOf(const std::string& text)
{
    const auto mesh = parseObj(text, "f.obj");
    if (mesh)
        qFatal("read without an error: %s", text.c_str());
    return mesh.error();
}

ReadMesh read(const std::string& text)
{
    auto mesh = parseObj(text, "folder/f.obj");
    if (!mesh)
        qFatal("%s", test::why(mesh).constData());
    return *mesh;
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

} // namespace

class TestObjReader : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void badInput_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("message");
        const auto row = [](const char* name, const QString& text, const char* message) {
            QTest::newRow(name) << text << QString(message);
        };
        const QString four = QString::fromStdString(square);
        row("empty", "", "f.obj: the file holds no vertices");
        row("only comments", "# a\n# b", "f.obj: the file holds no vertices");
        row("too few numbers", "v 0 0 0\nv 1 2\n", "f.obj:2: three numbers expected, found \"\"");
        row("no number", "v 0 a 0\n", "f.obj:1: three numbers expected, found \"a 0\"");
        row("letters behind", "v 0 0 0x\n", "f.obj:1: three numbers expected, found \"0x\"");
        row("nothing", "v 0 0 0\nv\n", "f.obj:2: three numbers expected, found \"\"");
        row("nan", "v 0 0 0\n\nv 0 nan 0\n", "f.obj:3: \"nan 0\" is not a finite number");
        row("inf", "v -inf 0 0\n", "f.obj:1: \"-inf 0 0\" is not a finite number");
        row("huge", "v 0 0 1e99\n", "f.obj:1: \"1e99\" is not a finite number");
        row("two corners", four + "f 1 2\n", "f.obj:5: a face of fewer than three corners");
        row("index 0", four + "f 1 2 0\n", "f.obj:5: vertex 0 does not exist (there are 4)");
        row("index too large", four + "f 1 2 5\nv", "f.obj:6: three numbers expected, found \"\"");
        row("index too large at the end", four + "f 1 2 5", "f.obj:5: vertex 5 does not exist (there are 4)");
        row("negative too large", four + "f 1 2 -5", "f.obj:5: vertex -5 does not exist (there are 4)");
        row("overflowing index", four + "f 1 2 99999999999999999999999",
            "f.obj:5: vertex 1000000000000000 does not exist (there are 4)");
        row("bad corner", four + "f 1 2 3/x",
            "f.obj:5: a corner v, v/vt, v//vn or v/vt/vn expected, found \"3/x\"");
        row("corner with a point", four + "f 1 2 3.5",
            "f.obj:5: a corner v, v/vt, v//vn or v/vt/vn expected, found \"3.5\"");
        row("points alone", four, "f.obj: the file holds 4 points and no faces: there is no surface to read");
        row("lines", four + "l 1 2",
            "f.obj: the file holds 4 points and no faces: there is no surface to read");
        row("binary", QString("v 0 0 0\n") + QChar(1) + "\n", "f.obj:2: not a line of an OBJ file: \"?\"");
        row("prose", "v 0 0 0\n\"Once, upon a time\n",
            "f.obj:2: not a line of an OBJ file: \"\"Once, upon a time\"");
    }
    void badInput()
    {
        QFETCH(QString, text);
        QFETCH(QString, message);
        QCOMPARE(QString::fromStdString(errorOf(text.toStdString()).message()), message);
        // The same place with the line ends of another system.
        const QString windows = QString(text).replace("\n", "\r\n");
        QCOMPARE(QString::fromStdString(errorOf(windows.toStdString()).message()), message);
    }
    /// A file in blocks of any size gives what the text gives as a whole: the same mesh, the same error.
    void blocksAreTheText_data()
    {
        badInput_data();
        const auto row = [](const char* name, const QString& text) { QTest::newRow(name) << text << ""; };
        const QString four = "v 0.5 -1.25 0\nv 1 0 0\nv 1 1.0000001 0\nv 0 1 0\n";
        const QString normals = "vn 0.0 0.0 1.0\nvn 0 1 0\nvn 1 0 0\nvn 0.6 0.8 0.0\n";
        row("good", "\xEF\xBB\xBF# c\n" + four + normals + "f 1//1 2//2 3//3\nf 1//1 3//3 4//4\n");
        row("without normals", four + "f 1 2 3\r\nf 1 3 4");
        row("not parallel", four + normals + "f 1//1 2//2 3//3\nf 1//1 3//4 4//4\n");
        row("more normals", four + normals + "vn 1.0 0.0 0.0\nf 1//1 2//2 3//3\n");
        row("mixed", four + normals + "f 1//1 2//2 3//3\nf 1 3 4\n");
        row("polygons", four + normals + "f 1//1 2//2 3//3 4//4\nf 4//4 3//3 \\\n 2//2 1//2\n");
        row("continued", four + "f 1 \\\r\n 2 \\\n3\n# c \\\nf 1 2 4 # c\n");
        row("Macintosh", QString(four + "f 1 2 3\n").replace("\n", "\r"));
        row("mixed ends", four + "vn 0 0 1\r" + four + "f 1 2 3\r\rf 5 6 7\ncurv 1\r");
        row("padded", four + "f 1 2 3\n\x1A" + QString(50, QChar(0)));
        row("capitals",
            "O a\n" + QString(four).toUpper() + "VN 0 0 1\nVT 0 0\nF 1/1/1 2/1/1 3/1/1\nCURV 1\n");
        row("no such normals", four + "vn 0 0 1\nf 1//1 2//2 3//0\nf 1// 2// 3//\n");
        row("colours", "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1 1\nf 1 2 3\n");
        row("objects", "o a\n" + four + "f 1 2 3\no b\nf -4 -3 -1\ng x y\nf 2 3 4\ncurv2 1\n");
    }
    void blocksAreTheText()
    {
        QFETCH(QString, text);
        const QTemporaryDir folder;
        const QString path = folder.filePath("f.obj");
        const QByteArray bytes = text.toLatin1();
        test::writeBytes(path, bytes);
        const auto whole = reading::scanObj(test::view(bytes), path.toStdString(), {});
        for (const std::size_t size : {1u, 2u, 7u, 16u, 40u, 100u, 1u << 18}) {
            auto input = reading::InputFile::open(path.toStdString());
            QVERIFY2(input.has_value(), test::why(input));
            const auto lists = reading::scanObj(*input, path.toStdString(), {}, size);
            QCOMPARE(test::why(lists), test::why(whole));
            if (!lists)
                continue;
            QVERIFY(test::sameBits(lists->positions, whole->positions));
            QVERIFY(test::sameBits(lists->normals, whole->normals));
            QVERIFY(lists->triangles == whole->triangles && lists->notes == whole->notes);
            QVERIFY(test::sameBits(lists->colours, whole->colours));
            QVERIFY(lists->normalOf == whole->normalOf && lists->otherNormals == whole->otherNormals);
            QCOMPARE(lists->cornersWithoutNormal, whole->cornersWithoutNormal);
        }
    }
    void cancelStops()
    {
        std::stop_source source;
        source.request_stop();
        Progress progress;
        progress.stop = source.get_token();
        std::string text;
        for (int i = 0; i < 70'000; ++i)
            text += "v 0 0 0\n";
        const QTemporaryDir folder;
        test::writeBytes(folder.filePath("f.obj"), QByteArray::fromStdString(text));
        for (const auto& mesh : {parseObj(text, "f.obj", progress),
                                 readMeshFile(folder.filePath("f.obj").toStdString(), progress)}) {
            QVERIFY(!mesh);
            QCOMPARE(mesh.error().code, ErrorCode::Cancelled);
        }
    }
    void polygonsBecomeFans()
    {
        const ReadMesh mesh = read(square + "v 0.5 2 0\nf 1 2 3 5 4\n");
        QCOMPARE(mesh.objects.size(), std::size_t(1));
        QCOMPARE(mesh.objects[0].name, std::string("f"));
        const std::vector<glm::uvec3> expected = {{0, 1, 2}, {0, 2, 4}, {0, 4, 3}};
        QVERIFY(mesh.objects[0].mesh.triangles == expected);
    }
    void everyFormOfCorner()
    {
        const std::vector<glm::uvec3> expected = {{0, 1, 2}};
        for (const char* face : {"f 1 2 3", "f 1/1 2/2 3/3", "f 1//1 2//1 3//1", "f 1/1/1 2/2/1 3/3/1",
                                 "f -4 -3 -2", "f -4/-1/-1 -3/1/1 -2//-1", "f\t1  2\t3 ", "f 1 2 3 # a face",
                                 "f 1 \\\n2 \\\r\n 3", "f +1 +2 +3", "f 1// 2// 3//", "F 1/1/ 2/1/ 3/1/"}) {
            const ReadMesh mesh = read(square + "vt 0 0\nvn 0 0 1\n" + face);
            QVERIFY2(mesh.objects[0].mesh.triangles == expected, face);
        }
    }
    void facesMayComeBeforeTheirVertices()
    {
        const ReadMesh mesh = read("f 1//1 2//1 3//1\n" + square + "vn 0 0 1\n");
        QCOMPARE(mesh.objects[0].mesh.triangles.size(), std::size_t(1));
        QCOMPARE(mesh.objects[0].mesh.normals.size(), std::size_t(4));
        QCOMPARE(mesh.objects[0].mesh.normals[1], glm::vec3(0, 0, 1));
    }
    void oddButAllowed()
    {
        const ReadMesh mesh =
            read("\xEF\xBB\xBF# BOM\r\nmtllib a b.mtl\r\n  v 0 0 0 1\r\nv\t1 0 0 0.5 0.5 0.5\r\nv 1. "
                 ".5e0 -0\r\n\r\nusemtl x\r\ns off\r\nf 1 2 3\r\n# last line \\");
        QCOMPARE(mesh.objects[0].mesh.positions.size(), std::size_t(3));
        QCOMPARE(mesh.objects[0].mesh.positions[2], glm::vec3(1.0f, 0.5f, 0.0f));
        QCOMPARE(mesh.objects[0].mesh.triangles.size(), std::size_t(1));
        QVERIFY(mesh.notes.empty());
        QCOMPARE(read("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r").objects[0].mesh.faceCount(), 1u);
        QCOMPARE(read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 \\\n\\\n3\\").objects[0].mesh.faceCount(), 1u);
    }
    void whatIsSkippedIsNoted()
    {
        const std::string numbers = "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1";
        const std::vector<std::string> expected = {"line 6: TRANSFORM skipped"};
        QVERIFY(read(square + "f 1 2 3\nTRANSFORM " + numbers + "\n").notes == expected);
        QVERIFY(read(square + "f 1 2 3\nTRANSFORM\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n").notes == expected);
        // A seventeenth number is no part of it.
        QCOMPARE(errorOf(square + "TRANSFORM " + numbers + "\n5\n").line, 6);
        QCOMPARE(read(square + "l 1 2\nl 2 3\ncurv 0 1\nf 1 2 3").notes.size(), std::size_t(2));
        QCOMPARE(read(square + "l 1 2\nl 2 3\nf 1 2 3").notes[0], std::string("line 5: l skipped, 2 lines"));
    }
    void objectsAreKeptApart()
    {
        const ReadMesh mesh = read("v 9 9 9\no one\n" + square + "g inner\nf 2 3 4\nf -1 -2 -3\no two\n" +
                                   square + "f 6 7 8\no\no empty\n");
        QCOMPARE(mesh.objects.size(), std::size_t(3));
        QCOMPARE(mesh.objects[0].name, std::string("f")); // a vertex before the first object
        QCOMPARE(mesh.objects[0].mesh.vertexCount(), 1u);
        QCOMPARE(mesh.objects[1].name, std::string("one"));
        QCOMPARE(mesh.objects[1].mesh.vertexCount(), 4u);
        const std::vector<glm::uvec3> one = {{0, 1, 2}, {3, 2, 1}};
        QVERIFY(mesh.objects[1].mesh.triangles == one);
        QCOMPARE(mesh.objects[2].name, std::string("two"));
        const std::vector<glm::uvec3> two = {{0, 1, 2}};
        QVERIFY(mesh.objects[2].mesh.triangles == two);
        QVERIFY(mesh.objects[2].fileVertex.empty());
        const TriangleMesh joined = mesh.joined();
        QCOMPARE(joined.vertexCount(), 9u);
        QCOMPARE(joined.triangles[2], glm::uvec3(5, 6, 7));
    }
    void objectsThatShareVerticesJoinAgain()
    {
        const ReadMesh mesh = read(square + "g left\nf 1 2 3\ng right\nf 1 3 4\ng left\nf 4 3 2\n");
        QCOMPARE(mesh.objects.size(), std::size_t(2));
        QCOMPARE(mesh.objects[0].name, std::string("left"));
        QCOMPARE(mesh.objects[0].mesh.faceCount(), 2u);
        QCOMPARE(mesh.objects[1].mesh.vertexCount(), 3u);
        const TriangleMesh joined = mesh.joined();
        QCOMPARE(joined.vertexCount(), 4u);
        const std::vector<glm::uvec3> expected = {{0, 1, 2}, {3, 2, 1}, {0, 2, 3}};
        QVERIFY(joined.triangles == expected);
    }
    void manyGroupsOfOneFaceEach()
    {
        std::string text;
        for (int i = 0; i < 30'000; ++i)
            text += "v " + std::to_string(i) + " 0 0\n";
        for (int i = 0; i < 20'000; ++i)
            text += "g part" + std::to_string(i) + "\nf 1 30000 " + std::to_string(2 + i) + "\n";
        QCOMPARE(read(text).objects.size(), std::size_t(20'001)); // and the vertices that nobody uses
    }
    void normalsOfCornersBecomeNormalsOfVertices()
    {
        const ReadMesh same = read(square + "vn 0 0 1\nf 1//1 2//1 3//1\n");
        QCOMPARE(same.objects[0].mesh.normals[0], glm::vec3(0, 0, 1));
        QVERIFY(same.notes.empty());
        const ReadMesh differing = read(square + "vn 0 0 2\nvn 0 2 0\nf 1//1 2//1 3//1\nf 1//2 3//2 4//2\n");
        const float half = std::sqrt(0.5f);
        QVERIFY(glm::length(differing.objects[0].mesh.normals[0] - glm::vec3(0, half, half)) < 1e-6f);
        QCOMPARE(differing.objects[0].mesh.normals[1], glm::vec3(0, 0, 2));
        QCOMPARE(differing.notes[0], std::string("2 vertices with several normals: their mean is taken"));
        const ReadMesh opposite = read(square + "vn 0 0 1\nvn 0 0 -1\nf 1//1 2//1 3//1\nf 1//2 3//2 4//2\n");
        QCOMPARE(opposite.objects[0].mesh.normals[0], glm::vec3(0, 0, 1));
        const ReadMesh some = read(square + "vn 0 0 1\nf 1//1 2//1 3//1\nf 1 3 4\n");
        QVERIFY(some.objects[0].mesh.normals.empty());
        QCOMPARE(some.notes.size(), std::size_t(1));
    }
    /// No line may depend on where the text is cut into blocks.
    void everyLengthOfTail()
    {
        for (int length = 0; length < 60; ++length) {
            const std::string text =
                square + "f 1 2 3\n#" + std::string(std::size_t(length), '.') + "\\\nf 1 3 4";
            QCOMPARE(read(text).objects[0].mesh.faceCount(), 2u);
        }
    }
};

RAMURE_SUITE(TestObjReader)

} // namespace tst_obj_reader

#include "tst_obj_reader.moc"
