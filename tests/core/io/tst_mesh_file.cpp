#include "tests/core/io/io_support.h"
#include <QTemporaryDir>
#include <filesystem>

namespace tst_mesh_file {

using namespace ramure;

namespace {

/// What goes wrong with files: they end early, bytes change, pieces are lost or come twice, numbers grow.
QByteArray damaged(QByteArray bytes, std::mt19937& random)
{
    const auto below = [&](qsizetype n) {
        return static_cast<qsizetype>(random() % static_cast<unsigned long>(n));
    };
    for (unsigned times = 1 + random() % 4; times > 0 && !bytes.isEmpty(); --times)
        switch (random() % 7) {
        case 0:
            bytes.truncate(below(bytes.size() + 1));
            break;
        case 1:
            bytes[below(bytes.size())] = static_cast<char>(random());
            break;
        case 2:
            bytes.remove(below(bytes.size()), 1 + below(20));
            break;
        case 3: {
            const QByteArray piece = bytes.mid(below(bytes.size()), 1 + below(40));
            bytes.insert(below(bytes.size()), piece);
            break;
        }
        case 4:
            bytes.insert(below(bytes.size()), QByteArray::number(qulonglong(random()) * random()));
            break;
        case 5: {
            static const char* const words[] = {"nan", "inf", "-1", "1e999",      "\\\n",
                                                "\r",  "/",   "0",  "4294967295", "list"};
            bytes.insert(below(bytes.size()), words[random() % 10]);
            break;
        }
        default:
            for (qsizetype i = below(bytes.size()), end = std::min(i + 1 + below(30), bytes.size()); i < end;
                 ++i)
                bytes[i] = static_cast<char>(random());
            break;
        }
    return bytes;
}

/// Read or refused with a reason; what is read holds together.
void readAnything(const QByteArray& bytes, bool isObj)
{
    // An exact copy without anything behind it: a sanitizer sees every step beyond the end.
    const std::vector<char> exact(bytes.begin(), bytes.end());
    const std::string_view text(exact.data(), exact.size());
    const auto mesh = isObj ? parseObj(text, "f") : parsePly(text, "f");
    if (!mesh) {
        QVERIFY(*mesh.error().text != '\0');
        return;
    }
    QVERIFY(!mesh->objects.empty());
    for (const ReadObject& object : mesh->objects) {
        for (const glm::uvec3& t : object.mesh.triangles)
            QVERIFY(std::max({t.x, t.y, t.z}) < object.mesh.vertexCount());
        QVERIFY(object.mesh.normals.empty() || object.mesh.normals.size() == object.mesh.positions.size());
    }
    const TriangleMesh joined = mesh->joined();
    for (const glm::uvec3& t : joined.triangles)
        QVERIFY(std::max({t.x, t.y, t.z}) < joined.vertexCount());
}

} // namespace

class TestMeshFile : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;

    QByteArray sample(std::mt19937& random, int kind)
    {
        const TriangleMesh meshes[] = {test::randomMesh(random, kind != 3), test::randomMesh(random, true)};
        const MeshPart parts[] = {{"one", &meshes[0], barkMaterial()}, {"two", &meshes[1], leavesMaterial()}};
        const QString path = m_folder.filePath("sample");
        if (kind == 0 || kind == 3) {
            if (!writeObj(path.toStdString(), parts))
                qFatal("not written");
        } else if (!writePly(path.toStdString(), parts, {kind == 1})) {
            qFatal("not written");
        }
        return test::fileBytes(path);
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void unknownEnding()
    {
        const auto mesh = readMeshFile("a.dae");
        QVERIFY(!mesh);
        QCOMPARE(mesh.error().code, ErrorCode::Unknown);
        QCOMPARE(mesh.error().message(), std::string("a.dae: unknown file ending \".dae\": .obj, .ply, .glb, "
                                                     ".usda, .usdz, .stl, .3mf, .png, .exr can be read"));
        QVERIFY(!readMeshFile("a"));
    }
    void missingFileAndFolder()
    {
        const auto missing = readMeshFile(m_folder.filePath("none.obj").toStdString());
        QVERIFY(!missing);
        QCOMPARE(missing.error().code, ErrorCode::Io);
        QCOMPARE(missing.error().args[0], std::string("No such file or directory"));
        std::filesystem::create_directory(m_folder.filePath("folder.ply").toStdString());
        const auto folder = readMeshFile(m_folder.filePath("folder.ply").toStdString());
        QVERIFY(!folder);
        QCOMPARE(folder.error().args[0], std::string("Is a directory"));
    }
    void endingsInCapitals()
    {
        test::writeBytes(m_folder.filePath("A.OBJ"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3");
        const auto mesh = readMeshFile(m_folder.filePath("A.OBJ").toStdString());
        QVERIFY2(mesh, test::why(mesh));
        QCOMPARE(mesh->objects[0].name, std::string("A"));
    }
    void emptyFiles()
    {
        for (const char* name : {"empty.obj", "empty.ply"}) {
            test::writeBytes(m_folder.filePath(name), "");
            QVERIFY(!readMeshFile(m_folder.filePath(name).toStdString()));
        }
    }
    void joinedFillsWhatPartsLack()
    {
        ReadMesh mesh;
        mesh.objects = {{"a", test::tetrahedron(), {}}, {"b", test::tetrahedron(), {}}};
        mesh.objects[1].mesh.branch = {1, 2, 3, 4};
        const TriangleMesh joined = mesh.joined();
        QCOMPARE(joined.vertexCount(), 8u);
        QCOMPARE(joined.triangles[4], glm::uvec3(4, 6, 5));
        QCOMPARE(joined.branch[0], noIndex);
        QCOMPARE(joined.branch[7], 4u);
        QVERIFY(joined.normals.empty());
    }
    void randomBytes()
    {
        std::mt19937 random(5);
        for (int round = 0; round < 500; ++round) {
            QByteArray bytes(static_cast<qsizetype>(random() % 300), '\0');
            for (char& c : bytes)
                c = static_cast<char>(random());
            readAnything(bytes, true);
            readAnything(bytes, false);
            readAnything("ply\nformat binary_little_endian 1.0\n" + bytes, false);
            readAnything("v 0 0 0\n" + bytes, true);
        }
    }
    void damagedFilesAreReadOrRefused()
    {
        std::mt19937 random(6);
        for (int round = 0; round < 2000; ++round) {
            const int kind = round % 4;
            const QByteArray bytes = sample(random, kind);
            readAnything(damaged(bytes, random), kind == 0 || kind == 3);
        }
    }
    void everyTruncationOfAFile()
    {
        std::mt19937 random(8);
        for (int kind = 0; kind < 4; ++kind) {
            const QByteArray bytes = sample(random, kind).left(4000);
            for (qsizetype length = 0; length < bytes.size(); ++length)
                readAnything(bytes.left(length), kind == 0 || kind == 3);
        }
    }
};

RAMURE_SUITE(TestMeshFile)

} // namespace tst_mesh_file

#include "tst_mesh_file.moc"
