#include "core/io/formats/file_format.h"
#include "core/io/formats/glb/glb_reader.h"
#include "core/rig/arm/arm_chain.h"
#include "core/scene/world_transforms.h"
#include "core/surface/mesh/transformed.h"
#include "core/surface/proof/validate.h"
#include "tests/core/io/io_support.h"
#include "tests/support/solids.h"
#include <QTemporaryDir>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <nlohmann/json.hpp>

namespace tst_glb_reader {

using namespace ramure;
using Json = nlohmann::json;

namespace {

void appendWord(QByteArray& to, std::uint32_t word)
{
    to.append(reinterpret_cast<const char*>(&word), sizeof word);
}

QByteArray glbOf(QByteArray text, QByteArray binary)
{
    while (text.size() % 4 != 0)
        text.append(' ');
    while (binary.size() % 4 != 0)
        binary.append('\0');
    QByteArray out("glTF");
    appendWord(out, 2);
    appendWord(out, static_cast<std::uint32_t>(28 + text.size() + binary.size()));
    appendWord(out, static_cast<std::uint32_t>(text.size()));
    out += "JSON" + text;
    appendWord(out, static_cast<std::uint32_t>(binary.size()));
    return out + QByteArray("BIN\0", 4) + binary;
}

/// A file with one triangle, its numbers in the binary part.
struct Triangle
{
    Json json = Json::parse(R"({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"name": "Leaf", "mesh": 0, "translation": [1, 2, 3]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "buffers": [{"byteLength": 48}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 12}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3},
                      {"bufferView": 1, "componentType": 5125, "type": "SCALAR", "count": 3}]})");
    std::vector<float> places{0, 0, 0, 1, 0, 0, 0, 1, 0};
    std::vector<std::uint32_t> corners{0, 1, 2};

    [[nodiscard]] QByteArray binary() const
    {
        return QByteArray(reinterpret_cast<const char*>(places.data()), 36) +
               QByteArray(reinterpret_cast<const char*>(corners.data()), 12);
    }
    [[nodiscard]] QByteArray bytes() const { return glbOf(QByteArray::fromStdString(json.dump()), binary()); }
};

/// The same triangles at the same corners, whatever the order of the vertices.
bool isSameSurface(const TriangleMesh& a, const TriangleMesh& b, float tolerance)
{
    if (a.triangles.size() != b.triangles.size() || a.positions.size() != b.positions.size())
        return false;
    for (std::size_t t = 0; t < a.triangles.size(); ++t)
        for (int k = 0; k < 3; ++k)
            if (glm::distance(a.positions[a.triangles[t][k]], b.positions[b.triangles[t][k]]) > tolerance)
                return false;
    return true;
}

} // namespace

/// Files made by hand, those that the program writes, and those that are broken.
class TestGlbReader : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    [[nodiscard]] std::string path(const char* name) const
    {
        return m_folder.filePath(QLatin1String(name)).toStdString();
    }
    [[nodiscard]] Expected<ReadMesh> read(const QByteArray& bytes) const
    {
        test::writeBytes(QString::fromStdString(path("t.glb")), bytes);
        return readGlb(path("t.glb"), {});
    }
    [[nodiscard]] Expected<BlenderImport> imported(const QByteArray& bytes) const
    {
        test::writeBytes(QString::fromStdString(path("t.glb")), bytes);
        return importGlb(path("t.glb"), {}, {});
    }
    [[nodiscard]] bool isRefused(const QByteArray& bytes, const char* word) const
    {
        const auto mesh = read(bytes);
        const auto scene = imported(bytes);
        if (mesh || scene) {
            qInfo("read all the same; %s was expected", word);
            return false;
        }
        const bool isSaid = mesh.error().message().find(word) != std::string::npos &&
                            mesh.error().file.ends_with("t.glb") && scene.error().file.ends_with("t.glb");
        if (!isSaid)
            qInfo("%s", mesh.error().message().c_str());
        return isSaid;
    }
    [[nodiscard]] Expected<void> write(const ExportScene& scene, const WriteOptions& options = {}) const
    {
        return (*findFormat(path("w.glb"), FormatUse::Write))->write(path("w.glb"), scene, options, {});
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void whatIsNoGlb()
    {
        QVERIFY(!readGlb(path("missing.glb"), {}));
        QVERIFY(isRefused("", "no GLB"));
        QVERIFY(isRefused("glTF", "no GLB"));
        QVERIFY(isRefused(QByteArray(400, 'x'), "no GLB"));
        QByteArray bytes = Triangle().bytes();
        bytes[4] = 1;
        QVERIFY(isRefused(bytes, "version 1"));
        QVERIFY(isRefused(glbOf("{\"asset\":", {}), "JSON"));
        QVERIFY(isRefused(glbOf("[]", {}), "JSON"));
        QVERIFY(isRefused(glbOf("{}", {}), "shows no"));
    }

    /// However a file is cut, it is refused and nothing is read beyond its end.
    void everyCutIsRefused()
    {
        const QByteArray bytes = Triangle().bytes();
        for (qsizetype size = 0; size < bytes.size(); ++size)
            QVERIFY2(!read(bytes.left(size)), qPrintable(QString::number(size)));
    }

    void hugePartsAreRefusedBeforeTheyAreRead()
    {
        // As a data URI of a gigabyte: the head says it.
        QByteArray bytes = Triangle().bytes();
        const std::uint32_t size = 1'100'000'000;
        std::memcpy(bytes.data() + 12, &size, sizeof size);
        QVERIFY(isRefused(bytes, "MiB"));
        Triangle file;
        file.json["accessors"][0] = {{"componentType", 5126}, {"type", "VEC3"}, {"count", 4'000'000'000}};
        QVERIFY(isRefused(file.bytes(), "accessors[0]"));
        file = {};
        file.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0},
                                                                                {"byteLength", 36},
                                                                                {"byteStride", 256},
                                                                                {"count", 8'000'000},
                                                                                {"mode", "ATTRIBUTES"}};
        QVERIFY(isRefused(file.bytes(), "bufferViews[0]"));
        file.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]["count"] = 900'000'000'000;
        QVERIFY(isRefused(file.bytes(), "bufferViews[0]"));
    }

    void whatIsWrongInsideIsNamed_data()
    {
        QTest::addColumn<QString>("at");
        QTest::addColumn<QString>("value");
        QTest::addColumn<QByteArray>("word");
        const auto row = [](const char* at, const char* value, const char* word) {
            QTest::newRow(at) << QString(at) << QString(value) << QByteArray(word);
        };
        row("/nodes/0/mesh", "7", "meshes[7]");
        row("/nodes/0/children", "[0]", "top");
        row("/nodes/0/children/0", "5", "nodes[0].children");
        row("/nodes/0/translation", "[1, 2]", "nodes[0].translation");
        row("/nodes/0/matrix", "[1]", "nodes[0].matrix");
        row("/scenes/0/nodes", "[0, 0]", "scenes[0].nodes");
        row("/scene", "3", "scenes[3]");
        row("/meshes/0/primitives/0/attributes/POSITION", "9", "accessors[9]");
        row("/meshes/0/primitives/0/indices", "0", "accessors[0]");
        row("/meshes/0/primitives/0/material", "2", "materials[2]");
        row("/accessors/0/count", "4", "accessors[0]");
        row("/accessors/0/byteOffset", "1000", "accessors[0]");
        row("/accessors/0/componentType", "1", "accessors[0]");
        row("/accessors/0/bufferView", "8", "bufferViews[8]");
        row("/accessors/1/sparse", R"({"count": 2})", "sparse");
        row("/bufferViews/0/byteLength", "1e12", "bufferViews[0]");
        row("/bufferViews/0/byteStride", "4", "accessors[0]");
        row("/bufferViews/0/buffer", "1", "buffers[1]");
        row("/buffers/0/byteLength", "4800", "buffers[0]");
        row("/buffers/0/uri", "\"other.bin\"", "buffers[0]");
        row("/buffers/0/uri", "\"data:;base64,!!!!\"", "buffers[0]");
        row("/extensionsRequired", "[\"KHR_draco_mesh_compression\"]", "KHR_draco_mesh_compression");
    }
    void whatIsWrongInsideIsNamed()
    {
        QFETCH(QString, at);
        QFETCH(QString, value);
        QFETCH(QByteArray, word);
        Triangle file;
        file.json[Json::json_pointer(at.toStdString())] = Json::parse(value.toStdString());
        QVERIFY(isRefused(file.bytes(), word.constData()));
    }

    void brokenNumbersAreRefused()
    {
        Triangle file;
        file.places[4] = std::numeric_limits<float>::quiet_NaN();
        QVERIFY(isRefused(file.bytes(), "not finite"));
        file = {};
        file.corners[1] = 3;
        QVERIFY(isRefused(file.bytes(), "does not exist"));
    }

    /// Normals, texture and colours are no reason to refuse a mesh.
    void whatIsWrongWithTheLookIsNoted_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("accessor");
        QTest::addColumn<QByteArray>("word");
        const auto row = [](const char* name, const char* accessor, const char* word) {
            QTest::addRow("%s of %s", name, accessor)
                << QString(name) << QString(accessor) << QByteArray(word);
        };
        const char* zeros = R"({"componentType": 5126, "type": "VEC3", "count": 3})";
        const char* bits = R"({"bufferView": 2, "componentType": 5126, "type": "VEC3", "count": 3})";
        for (const char* name : {"NORMAL", "TEXCOORD_0", "COLOR_0"}) {
            row(name, "null", "accessors[2]");
            row(name, R"({"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 2})",
                std::string_view(name) == "TEXCOORD_0" ? "2 numbers" : "not as many");
        }
        row("NORMAL", zeros, "3 vertices have a normal of length 0");
        row("NORMAL", bits, "3 vertices have a normal of length 0 or of no numbers");
        row("COLOR_0", bits, "COLOR_0: a number is not finite");
        row("TEXCOORD_0", R"({"bufferView": 2, "componentType": 5126, "type": "VEC2", "count": 3})",
            "TEXCOORD_0: a number is not finite");
    }
    void whatIsWrongWithTheLookIsNoted()
    {
        QFETCH(QString, name);
        QFETCH(QString, accessor);
        QFETCH(QByteArray, word);
        Triangle file;
        file.json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 48}, {"byteLength", 36}});
        file.json["buffers"][0]["byteLength"] = 84;
        file.json["accessors"].push_back(Json::parse(accessor.toStdString()));
        file.json["meshes"][0]["primitives"][0]["attributes"][name.toStdString()] = 2;
        const QByteArray bytes =
            glbOf(QByteArray::fromStdString(file.json.dump()), file.binary() + QByteArray(36, '\xFF'));
        const auto mesh = read(bytes);
        QVERIFY2(mesh, test::why(mesh));
        QCOMPARE(mesh->notes.size(), std::size_t(1));
        QVERIFY2(mesh->notes[0].find(word.toStdString()) != std::string::npos, mesh->notes[0].c_str());
        for (const glm::vec3& n : mesh->objects[0].mesh.normals)
            QCOMPARE(n, glm::vec3(0, 0, 1));
        QVERIFY(mesh->objects[0].mesh.uv.empty());
        const auto scene = imported(bytes);
        QVERIFY2(scene, test::why(scene));
        QVERIFY(scene->notes[0].message().find(word.toStdString()) != std::string::npos);
    }
    /// The mesh comes without pictures that cannot be read, and a note names each.
    void picturesThatCannotBeRead_data()
    {
        QTest::addColumn<QString>("extension");
        QTest::addColumn<QString>("image");
        QTest::addColumn<QByteArray>("named");
        for (const char* extension :
             {"EXT_texture_webp", "KHR_texture_basisu", "EXT_texture_avif", "MSFT_texture_dds"}) {
            QTest::addRow("%s", extension)
                << extension << R"({"name": "bark", "bufferView": 0, "mimeType": "image/webp"})"
                << QByteArray("\"bark\" is neither");
            QTest::addRow("%s, elsewhere", extension) << extension << R"({"uri": "bark.webp"})"
                                                      << QByteArray("\"bark.webp\" stands in another file");
        }
        QTest::newRow("without a name")
            << "EXT_texture_webp"
            << R"({"bufferView": 0, "mimeType": "image/webp"})" << QByteArray("images[0], image/webp");
    }
    void picturesThatCannotBeRead()
    {
        QFETCH(const QString, extension);
        QFETCH(const QString, image);
        QFETCH(const QByteArray, named);
        Triangle file;
        file.json["extensionsRequired"] = {extension.toStdString()};
        file.json["images"] = Json::array({Json::parse(image.toStdString())});
        file.json["textures"] = {{{"extensions", {{extension.toStdString(), {{"source", 0}}}}}}};
        file.json["materials"] = {
            {{"pbrMetallicRoughness",
              {{"baseColorTexture", {{"index", 0}}}, {"baseColorFactor", {1, 0, 0, 1}}}}}};
        file.json["meshes"][0]["primitives"][0]["material"] = 0;
        QVERIFY(read(file.bytes()));
        const auto scene = imported(file.bytes());
        QVERIFY2(scene, test::why(scene));
        QCOMPARE(scene->nodes[0].mesh->faceCount(), Index(1));
        QCOMPARE(scene->nodes[0].params.surface.color, glm::dvec3(1, 0, 0));
        QVERIFY(scene->nodes[0].params.surfacePictures.isEmpty());
        QVERIFY2(scene->notes[0].message().find(named.toStdString()) != std::string::npos,
                 scene->notes[0].message().c_str());
    }
    void pointsAloneAreRefused()
    {
        Triangle file;
        file.json["meshes"][0]["primitives"][0]["mode"] = 0;
        QVERIFY(!read(file.bytes()));
        const auto scene = imported(file.bytes());
        QVERIFY(!scene);
        QCOMPARE(scene.error().plain(),
                 std::string("the meshes of the file have no triangles: there is no surface to read"));
        // Beside something else they are a note.
        file.json["meshes"].push_back(Triangle().json["meshes"][0]);
        file.json["nodes"].push_back({{"mesh", 1}});
        file.json["scenes"][0]["nodes"] = {0, 1};
        const auto both = imported(file.bytes());
        QVERIFY2(both, test::why(both));
        QVERIFY(both->notes[0].message().find("points and lines are left out") != std::string::npos);
    }
    void farNodesKeepTheirShape()
    {
        Triangle file;
        file.json["nodes"][0]["translation"] = {512345.678, 4601234.567, 0};
        const auto mesh = read(file.bytes());
        QVERIFY2(mesh, test::why(mesh));
        QVERIFY(mesh->notes.back().find("far from the origin") != std::string::npos);
        const std::vector<glm::vec3>& p = mesh->objects[0].mesh.positions;
        QVERIFY(glm::distance(p[1] - p[0], glm::vec3(1, 0, 0)) < 1e-5F);
        QVERIFY(glm::distance(mesh->origin + glm::dvec3(p[0]), glm::dvec3(512345.678, 4601234.567, 0)) <
                1e-5);
        // Where its own numbers are far, its own position takes them.
        file = {};
        for (std::size_t i = 0; i < 9; i += 3)
            file.places[i] += 500'000.0F;
        const auto scene = imported(file.bytes());
        QVERIFY2(scene, test::why(scene));
        QCOMPARE(scene->nodes[0].params.tree.translation, glm::dvec3(1, 2, 3));
        QCOMPARE(scene->nodes[0].params.local.translation.x + double(scene->nodes[0].mesh->positions[0].x),
                 500'000.0);
        QVERIFY(scene->notes[0].message().find("far from the origin") != std::string::npos);
    }
    void bytesBehindTheEndAndZerosForBlanks()
    {
        const TriangleMesh plain = read(Triangle().bytes())->objects[0].mesh;
        const auto behind = read(Triangle().bytes() + "more than a chunk's head");
        QVERIFY2(behind, test::why(behind));
        QCOMPARE(behind->objects[0].mesh, plain);
        QCOMPARE(behind->notes, std::vector<std::string>{"24 bytes behind the end of the file"});
        QByteArray text = QByteArray::fromStdString(Triangle().json.dump());
        const auto zeros = read(glbOf(text + QByteArray(8, '\0'), Triangle().binary()));
        QVERIFY2(zeros, test::why(zeros));
        const auto marked = read(glbOf("\xEF\xBB\xBF" + text, Triangle().binary()));
        QVERIFY2(marked, test::why(marked));
        QCOMPARE(marked->objects[0].mesh, plain);
    }

    /// Any byte of the JSON may be anything: an answer or an error, never more.
    void anyOtherByteIsAnAnswerOrAnError()
    {
        const QByteArray bytes = Triangle().bytes();
        std::mt19937 random(5);
        for (int round = 0; round < 1000; ++round) {
            QByteArray broken = bytes;
            for (int i = 0; i < 1 + round % 3; ++i)
                broken[static_cast<qsizetype>(random() % static_cast<unsigned>(broken.size()))] =
                    round % 2 ? static_cast<char>(random()) : "0123456789[]{},:\"-"[random() % 18];
            if (const auto mesh = read(broken); mesh)
                QVERIFY(!mesh->objects.empty());
            (void)imported(broken);
        }
    }

    void aTriangleStandsWhereItsNodeSays()
    {
        const auto mesh = read(Triangle().bytes());
        QVERIFY2(mesh, test::why(mesh));
        QCOMPARE(mesh->objects.size(), std::size_t(1));
        QCOMPARE(mesh->objects[0].name, std::string("Leaf"));
        QCOMPARE(mesh->objects[0].mesh.positions[1], glm::vec3(2, 2, 3));
        const auto scene = imported(Triangle().bytes());
        QVERIFY2(scene, test::why(scene));
        QCOMPARE(scene->nodes.size(), std::size_t(1));
        QCOMPARE(scene->nodes[0].params.tree.translation, glm::dvec3(1, 2, 3));
        QCOMPARE(scene->nodes[0].mesh->positions[1], glm::vec3(1, 0, 0));
    }

    /// In the JSON as text, small numbers, strips, and values that only some elements have.
    void everyFormOfTheSameTriangle()
    {
        const TriangleMesh plain = read(Triangle().bytes())->objects[0].mesh;
        Triangle text;
        text.json["buffers"][0]["uri"] =
            "data:application/octet-stream;base64," + text.binary().toBase64().toStdString();
        QCOMPARE(read(glbOf(QByteArray::fromStdString(text.json.dump()), {}))->objects[0].mesh, plain);
        Triangle strip;
        strip.json["meshes"][0]["primitives"][0]["mode"] = 5;
        QCOMPARE(read(strip.bytes())->objects[0].mesh, plain);
        strip.json["meshes"][0]["primitives"][0].erase("indices");
        strip.json["meshes"][0]["primitives"][0]["mode"] = 6;
        const TriangleMesh fan = read(strip.bytes())->objects[0].mesh;
        QCOMPARE(fan.triangles[0], glm::uvec3(0, 1, 2)); // or turned on: one of the three
        Triangle sparse;
        sparse.places = {0, 0, 0, 1, 0, 0, 0, 0, 0};
        sparse.corners = {2, 0x3F800000, 0}; // place 2, and the value 1
        sparse.json["meshes"][0]["primitives"][0].erase("indices");
        sparse.json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 0}, {"byteLength", 36}});
        sparse.json["accessors"][0]["sparse"] = {{"count", 1},
                                                 {"indices", {{"bufferView", 1}, {"componentType", 5121}}},
                                                 {"values", {{"bufferView", 2}, {"byteOffset", 4}}}};
        QCOMPARE(read(sparse.bytes())->objects[0].mesh.positions[2], glm::vec3(1, 2, 4));
    }

    void aMeshWithoutCopiesIsNotThere()
    {
        Triangle file;
        file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = Json::object();
        QVERIFY(!read(file.bytes()));
        const auto scene = imported(file.bytes());
        QVERIFY2(scene, test::why(scene));
        QCOMPARE(scene->nodes[0].kind, NodeKind::Group);
    }

    void copiesHaveTheirColours()
    {
        Triangle file;
        file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
            {"TRANSLATION", 0}, {"_COLOR_0", 0}}; // (0 0 0), (1 0 0), (0 1 0)
        const auto done = read(file.bytes());
        QVERIFY2(done, test::why(done));
        const TriangleMesh mesh = done->joined();
        QCOMPARE(mesh.positions.size(), std::size_t(9));
        QCOMPARE(mesh.colours, (std::vector<glm::u8vec3>{{0, 0, 0}, {255, 0, 0}, {0, 255, 0}}));
        file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["_COLOR_0"] =
            1; // no colours
        const auto refused = read(file.bytes());
        QVERIFY(!refused && test::why(refused).contains("accessors[1]: 3 numbers"));
    }

    void aMirroredNodeTurnsItsTriangles()
    {
        Triangle file;
        file.json["nodes"][0]["scale"] = {1, 1, 0}; // flat
        const auto flat = imported(file.bytes());
        QVERIFY2(flat, test::why(flat));
        QVERIFY(flat->notes[0].message().find("Leaf") != std::string::npos);
        QCOMPARE(flat->nodes[0].mesh->positions[0], glm::vec3(1, 2, 3));
        QCOMPARE(flat->nodes[0].params.tree, PlacementParams());
    }

    void camerasKeepTheirAngle()
    {
        Triangle file;
        file.json["cameras"] =
            Json::parse(R"([{"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.1}},
                                               {"type": "orthographic"}])");
        file.json["nodes"].push_back({{"name", "Eye"}, {"camera", 0}, {"translation", {0, 1, 5}}});
        file.json["nodes"].push_back({{"name", "Flat"}, {"camera", 1}});
        file.json["scenes"][0]["nodes"] = {0, 1, 2};
        const auto scene = imported(file.bytes());
        QVERIFY2(scene, test::why(scene));
        QCOMPARE(scene->nodes.size(), std::size_t(4)); // below one group
        QCOMPARE(scene->nodes[2].kind, NodeKind::Camera);
        QCOMPARE(scene->nodes[2].params.camera.angleRad, 0.7);
        QCOMPARE(scene->nodes[3].params.camera.angleRad, CameraParams().angleRad);
        QCOMPARE(scene->notes.size(), std::size_t(1));
    }

    void movesBecomeKeys()
    {
        Triangle file;
        file.json["animations"] = Json::parse(R"([{"samplers": [{"input": 2, "output": 3}],
            "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}])");
        file.json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 48}, {"byteLength", 32}});
        file.json["accessors"].push_back(
            {{"bufferView", 2}, {"componentType", 5126}, {"type", "SCALAR"}, {"count", 2}});
        file.json["accessors"].push_back(
            {{"bufferView", 2}, {"byteOffset", 8}, {"componentType", 5126}, {"type", "VEC3"}, {"count", 2}});
        file.json["buffers"][0]["byteLength"] = 80;
        const std::vector<float> keys{0, 2, 1, 1, 1, 1, 5, 1};
        const QByteArray bytes =
            glbOf(QByteArray::fromStdString(file.json.dump()),
                  file.binary() + QByteArray(reinterpret_cast<const char*>(keys.data()), 32));
        const auto scene = imported(bytes);
        QVERIFY2(scene, test::why(scene));
        const glm::dmat4 half = transformAt(scene->nodes[0].animation, ChannelPart::GlobalTranslation, 1.0);
        QCOMPARE(glm::dvec3(half[3]), glm::dvec3(1, 3, 1));
        QVERIFY(scene->keyCount > 0 && scene->timeline.lastFrame >= 48);
    }

    /// What the program writes it reads again, one closed surface as before, packed or not.
    void ownFilesComeBack_data()
    {
        QTest::addColumn<bool>("isPacked");
        QTest::newRow("plain") << false;
        QTest::newRow("compressed") << true;
    }
    void ownFilesComeBack()
    {
        QFETCH(bool, isPacked);
        TriangleMesh mesh = test::box({0, 0, 0}, {1, 2, 3});
        // Texture that parts every corner, and two colours.
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            mesh.colours.push_back(t % 2 ? glm::u8vec3(200, 30, 40) : glm::u8vec3(10, 90, 250));
            const auto first = static_cast<Index>(mesh.uv.size());
            mesh.uv.insert(mesh.uv.end(), {{0.25F, 0.0F}, {1.0F, 0.5F}, {0.0F, float(t) / 16.0F}});
            mesh.uvTriangles.emplace_back(first, first + 1, first + 2);
        }
        Material plain;
        plain.name = "plain";
        WriteOptions options;
        options.compressed = isPacked;
        QVERIFY(write(sceneOfMeshes({{"Box", mesh, {}}}, plain), options));
        const auto back = readMeshFile(path("w.glb"));
        QVERIFY2(back, test::why(back));
        const TriangleMesh& box = back->objects[0].mesh;
        const auto report = validateMesh(box);
        QVERIFY(report && report->boundaryEdges == 0 && report->nonManifoldEdges == 0);
        QCOMPARE(box.positions.size(), mesh.positions.size());
        QCOMPARE(box.colours.size(), mesh.triangles.size());
        if (isPacked) // triangles in another order
            return;
        QVERIFY(isSameSurface(box, mesh, 0.0F));
        QCOMPARE(box.colours, mesh.colours);
        const auto scene = importObjects(path("w.glb"));
        QVERIFY2(scene, test::why(scene));
        QVERIFY(isSameSurface(*scene->nodes.back().mesh, mesh, 0.0F));
    }

    void cancelled()
    {
        test::writeBytes(QString::fromStdString(path("t.glb")), Triangle().bytes());
        std::stop_source stop;
        stop.request_stop();
        Progress progress;
        progress.stop = stop.get_token();
        QCOMPARE(readGlb(path("t.glb"), progress).error().code, ErrorCode::Cancelled);
        QCOMPARE(importGlb(path("t.glb"), {}, progress).error().code, ErrorCode::Cancelled);
    }
};

RAMURE_SUITE(TestGlbReader)

} // namespace tst_glb_reader

#include "tst_glb_reader.moc"
