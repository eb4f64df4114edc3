#include "core/io/formats/file_format.h"
#include "core/io/formats/glb/glb_parts.h"
#include "core/math/random.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/surface/bark/bark_maps.h"
#include "core/surface/foliage/foliage_texture.h"
#include "core/surface/mesh/transformed.h"
#include "core/surface/proof/validate.h"
#include "tests/core/io/io_support.h"
#include "tests/support/solids.h"
#include <QImage>
#include <QTemporaryDir>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <limits>

namespace tst_glb_format {

using namespace ramure;
using glb::Json;

namespace {

/// A file taken apart again, without the program's help.
struct Glb
{
    Json json;
    QByteArray bin;

    template <class T> std::vector<T> values(const Json& accessor) const
    {
        const Json& from = json["accessors"][accessor.get<std::size_t>()];
        const Json& view = json["bufferViews"][from["bufferView"].get<std::size_t>()];
        const auto count = from["count"].get<std::size_t>();
        if (count * sizeof(T) != view["byteLength"].get<std::size_t>())
            qFatal("a view of another size");
        std::vector<T> out(count);
        std::memcpy(out.data(), bin.constData() + view["byteOffset"].get<qsizetype>(), count * sizeof(T));
        return out;
    }
    /// With the vertices that the extension makes one.
    std::vector<Index> closedIndices(const Json& mesh) const
    {
        const Json& extension = mesh["extensions"]["EXT_mesh_manifold"];
        auto indices = values<Index>(extension["manifoldPrimitive"]["indices"]);
        if (extension.contains("mergeIndices")) {
            const auto places = values<Index>(extension["mergeIndices"]);
            const auto merged = values<Index>(extension["mergeValues"]);
            for (std::size_t i = 0; i < places.size(); ++i) {
                if (i > 0 && places[i] <= places[i - 1])
                    qFatal("not in their order");
                indices[places[i]] = merged[i];
            }
        }
        return indices;
    }
    /// Of a node, by the matrices above it.
    glm::dmat4 worldOf(std::size_t node) const
    {
        glm::dmat4 place(1.0);
        if (const Json& own = json["nodes"][node]; own.contains("matrix"))
            place = glm::make_mat4(own["matrix"].get<std::vector<double>>().data());
        for (std::size_t i = 0; i < json["nodes"].size(); ++i)
            if (const Json& above = json["nodes"][i];
                above.contains("children") && std::ranges::count(above["children"], Json(node)) > 0)
                return worldOf(i) * place;
        return place;
    }
    std::size_t nodeNamed(const char* name) const
    {
        const Json& nodes = json["nodes"];
        const auto found =
            std::ranges::find_if(nodes, [&](const Json& node) { return node["name"] == name; });
        return static_cast<std::size_t>(found - nodes.begin());
    }
};

std::uint32_t wordAt(const QByteArray& bytes, qsizetype at)
{
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.constData() + at, sizeof word);
    return word;
}

Glb parsed(const QByteArray& bytes)
{
    const qsizetype text = wordAt(bytes, 12);
    if (!bytes.startsWith("glTF") || wordAt(bytes, 4) != 2 ||
        wordAt(bytes, 8) != std::uint32_t(bytes.size()) || text % 4 != 0 ||
        wordAt(bytes, 20 + text) != std::uint32_t(bytes.size() - 28 - text))
        qFatal("no GLB");
    return {Json::parse(bytes.mid(20, text).toStdString()), bytes.mid(28 + text)};
}

std::shared_ptr<const TriangleMesh> shared(TriangleMesh mesh)
{
    return std::make_shared<const TriangleMesh>(std::move(mesh));
}

} // namespace

class TestGlbFormat : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    [[nodiscard]] Expected<void> write(const ExportScene& scene, const WriteOptions& options = {},
                                       const char* name = "t.glb", const Progress& progress = {}) const
    {
        const std::string file = path(name).toStdString();
        return (*findFormat(file, FormatUse::Write))->write(file, scene, options, progress);
    }
    [[nodiscard]] Glb written(const ExportScene& scene, const WriteOptions& options = {}) const
    {
        if (const auto done = write(scene, options); !done)
            qFatal("%s", done.error().message().c_str());
        return parsed(test::fileBytes(path("t.glb")));
    }
    static ExportScene sceneOf(TriangleMesh mesh, const Material& material = barkMaterial())
    {
        return sceneOfMeshes({{"thing", std::move(mesh), {}}}, material);
    }
    /// With the pictures of its bark around it.
    static TriangleMesh texturedTree()
    {
        NodeParams params = *presetParams("TinyTree");
        TreePipeline pipeline;
        const auto tree = pipeline.evaluate(params, Stage::Mesh, {});
        if (!tree)
            qFatal("%s", test::why(tree).constData());
        TriangleMesh mesh = tree->branches->mesh;
        const auto texture = tree->texture->coordinates(params.texture, {});
        wear(mesh, **texture);
        return mesh;
    }
    static Material furrowed()
    {
        BarkParams bark;
        bark.family = BarkFamily::Furrowed;
        return barkMaterial(bark);
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void whatIsRefused()
    {
        ExportScene scene = sceneOf(test::box({0, 0, 0}, {1, 1, 1}));
        QVERIFY(write(scene));
        const QByteArray before = test::fileBytes(path("t.glb"));
        scene.space.up = UpAxis::Z;
        const auto turned = write(scene);
        QVERIFY(!turned && turned.error().file.ends_with("t.glb"));
        scene.space = {};
        QVERIFY(!write(scene, {}, "missing/t.glb"));
        for (const float bad : {std::numeric_limits<float>::quiet_NaN(), HUGE_VALF}) {
            TriangleMesh mesh = test::box({0, 0, 0}, {1, 1, 1});
            mesh.positions[3].y = bad;
            const auto done = write(sceneOf(std::move(mesh)));
            QVERIFY(!done);
            QCOMPARE(done.error().message(),
                     path("t.glb").toStdString() + ": a coordinate of thing is not a finite number");
        }
        std::stop_source stop;
        stop.request_stop();
        const auto stopped = write(scene, {}, "t.glb", Progress{stop.get_token(), {}});
        QCOMPARE(stopped.error().code, ErrorCode::Cancelled);
        QCOMPARE(test::fileBytes(path("t.glb")), before);
    }
    void picturesThatCannotStandInIt_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<ErrorCode>("code");
        QTest::newRow("missing") << QByteArray() << ErrorCode::Io;
        QTest::newRow("no picture") << QByteArray("BM, of another program") << ErrorCode::Invalid;
    }
    void picturesThatCannotStandInIt()
    {
        QFETCH(const QByteArray, bytes);
        QFETCH(const ErrorCode, code);
        const QString picture = path("own.bmp");
        QFile::remove(picture);
        if (!bytes.isEmpty())
            test::writeBytes(picture, bytes);
        TriangleMesh mesh = texturedTree();
        Material material = furrowed();
        for (std::string PictureParams::*part : {&PictureParams::colour, &PictureParams::opacity}) {
            material.pictures = {};
            material.pictures.*part = picture.toStdString();
            const auto done = write(sceneOf(mesh, material), {.mapSize = 16});
            QVERIFY(!done);
            QVERIFY2(done.error().code == code && done.error().file == picture.toStdString(),
                     test::why(done));
        }
    }

    void closedMeshesAreToldToBe()
    {
        const TriangleMesh mesh = texturedTree();
        const Glb glb = written(sceneOf(mesh, furrowed()), {.mapSize = 16});
        const Json& made = glb.json["meshes"][0];
        const auto positions = glb.values<glm::vec3>(made["primitives"][0]["attributes"]["POSITION"]);
        QVERIFY(positions.size() > mesh.positions.size()); // parted along the seams of the bark
        const auto proofOf = [&positions](const std::vector<Index>& indices) {
            TriangleMesh read;
            read.positions = positions;
            for (std::size_t i = 0; i < indices.size(); i += 3)
                read.triangles.emplace_back(indices[i], indices[i + 1], indices[i + 2]);
            return *validateMesh(read);
        };
        const MeshReport whole = proofOf(glb.closedIndices(made)), ours = *validateMesh(mesh);
        QCOMPARE(whole.boundaryEdges + whole.nonManifoldEdges + whole.inconsistentEdges, Index(0));
        QCOMPARE(whole.components, ours.components);
        QCOMPARE(whole.faces, ours.faces);
        QVERIFY(std::abs(whole.volume - ours.volume) < 1e-9 * ours.volume);
        const auto parted = glb.values<Index>(made["primitives"][0]["indices"]);
        QVERIFY(proofOf(parted).boundaryEdges > 0);
        for (std::size_t i = 0; i < parted.size(); ++i)
            QVERIFY(positions[parted[i]] == mesh.positions[mesh.triangles[i / 3][int(i % 3)]]);
        QVERIFY(glb.json["extensionsUsed"].dump().find("EXT_mesh_manifold") != std::string::npos);
    }
    void openMeshesAreNot()
    {
        TriangleMesh mesh = test::box({0, 0, 0}, {1, 1, 1});
        mesh.triangles.pop_back();
        const Glb glb = written(sceneOf(std::move(mesh)));
        QVERIFY(!glb.json["meshes"][0].contains("extensions") && !glb.json.contains("extensionsUsed"));
    }
    void cornersKeepTheirPlaceInThePicture()
    {
        const TriangleMesh mesh = texturedTree();
        const Glb glb = written(sceneOf(mesh, furrowed()), {.mapSize = 16});
        const Json& primitive = glb.json["meshes"][0]["primitives"][0];
        const auto uv = glb.values<glm::vec2>(primitive["attributes"]["TEXCOORD_0"]);
        const auto normals = glb.values<glm::vec3>(primitive["attributes"]["NORMAL"]);
        const auto tangents = glb.values<glm::vec4>(primitive["attributes"]["TANGENT"]);
        const auto indices = glb.values<Index>(primitive["indices"]);
        for (std::size_t i = 0; i < indices.size(); ++i) {
            const glm::vec2 own = mesh.uv[mesh.uvTriangles[i / 3][int(i % 3)]];
            QVERIFY(uv[indices[i]] == glm::vec2(own.x, 1.0F - own.y));
            const glm::vec4& t = tangents[indices[i]];
            QVERIFY(std::abs(glm::length(glm::vec3(t)) - 1.0F) < 1e-5F && std::abs(t.w) == 1.0F);
            QVERIFY(std::abs(glm::dot(glm::vec3(t), normals[indices[i]])) < 1e-5F);
        }
    }
    /// On a square whose picture stands upright: x of normals to the right, y up.
    void tangentsGoWhereThePictureGoes()
    {
        glb::Vertices square;
        square.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
        square.normals.assign(4, {0, 0, 1});
        square.uv = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
        square.indices = {0, 1, 2, 0, 2, 3};
        glb::addTangents(square);
        for (const glm::vec4& tangent : square.tangents)
            QCOMPARE(tangent, glm::vec4(1, 0, 0, 1));
        square.tangents.clear();
        for (glm::vec2& uv : square.uv) // mirrored
            uv.x = 1.0F - uv.x;
        glb::addTangents(square);
        for (const glm::vec4& tangent : square.tangents)
            QCOMPARE(tangent, glm::vec4(-1, 0, 0, -1));
    }
    void materialsBringTheirPictures()
    {
        const Glb glb = written(sceneOf(texturedTree(), furrowed()), {.mapSize = 16});
        const Json& material = glb.json["materials"][0];
        const Json& pbr = material["pbrMetallicRoughness"];
        QVERIFY(pbr.contains("baseColorTexture") && pbr.contains("metallicRoughnessTexture"));
        QVERIFY(material.contains("normalTexture") && material.contains("occlusionTexture"));
        QCOMPARE(glb.json["images"].size(), std::size_t(4));
        for (const Json& image : glb.json["images"]) {
            const Json& view = glb.json["bufferViews"][image["bufferView"].get<std::size_t>()];
            const auto bytes =
                glb.bin.mid(view["byteOffset"].get<qsizetype>(), view["byteLength"].get<qsizetype>());
            QCOMPARE(QImage::fromData(bytes).size(), QSize(16, 16));
        }
        const Glb plain = written(sceneOf(texturedTree(), furrowed()), {.mapSize = 0});
        QVERIFY(!plain.json.contains("images"));
        QVERIFY(plain.json["materials"][0]["pbrMetallicRoughness"].contains("baseColorFactor"));
    }
    void ownPicturesTakeTheirPlace()
    {
        QImage colour(8, 4, QImage::Format_RGB32), opacity(4, 4, QImage::Format_Grayscale8);
        colour.fill(QColor(200, 100, 50));
        opacity.fill(0);
        opacity.setPixelColor(0, 0, Qt::white); // of the upper left
        QVERIFY(colour.save(path("colour.png")) && opacity.save(path("opacity.png")) &&
                colour.save(path("normal.jpg")));
        Material material = furrowed();
        material.pictures.colour = path("colour.png").toStdString();
        material.pictures.opacity = path("opacity.png").toStdString();
        material.pictures.normal = path("normal.jpg").toStdString();
        const Glb glb = written(sceneOf(texturedTree(), material), {.mapSize = 16});
        const Json& made = glb.json["materials"][0];
        QVERIFY(made["alphaMode"] == Json("MASK"));
        const auto image = [&](const Json& texture) {
            const auto source = glb.json["textures"][texture["index"].get<std::size_t>()]["source"];
            const Json& from = glb.json["images"][source.get<std::size_t>()];
            const Json& view = glb.json["bufferViews"][from["bufferView"].get<std::size_t>()];
            return std::pair(from["mimeType"].get<std::string>(),
                             QImage::fromData(glb.bin.mid(view["byteOffset"].get<qsizetype>(),
                                                          view["byteLength"].get<qsizetype>())));
        };
        const auto [type, masked] = image(made["pbrMetallicRoughness"]["baseColorTexture"]);
        QCOMPARE(masked.size(), QSize(8, 4));
        QCOMPARE(masked.pixelColor(1, 0), QColor(200, 100, 50, 255));
        QCOMPARE(masked.pixelColor(2, 0).alpha(), 0);
        QCOMPARE(masked.pixelColor(1, 3).alpha(), 0);
        QCOMPARE(image(made["normalTexture"]).first, std::string("image/jpeg"));
    }
    void coloursAreLinear()
    {
        TriangleMesh mesh = test::box({0, 0, 0}, {1, 1, 1});
        mesh.colours.assign(mesh.triangles.size(), {255, 0, 0});
        mesh.colours[0] = {188, 188, 188};
        const Glb glb = written(sceneOf(mesh));
        const Json& primitive = glb.json["meshes"][0]["primitives"][0];
        const auto colours = glb.values<glm::u16vec4>(primitive["attributes"]["COLOR_0"]);
        const auto indices = glb.values<Index>(primitive["indices"]);
        QVERIFY(std::abs(colours[indices[0]].x / 65535.0 - 0.5028864) < 1e-4);
        QCOMPARE(colours[indices[3]], glm::u16vec4(65535, 0, 0, 65535));
        QVERIFY(!glb.json["materials"][0]["pbrMetallicRoughness"].contains("baseColorFactor"));
        QVERIFY(glb.json["meshes"][0].contains("extensions")); // parted by colour, and closed all the same
    }

    /// The midribs of a palm are green, its trunk has the colour of its picture; the mesh stays closed.
    void thinWoodHasAColourOfItsOwn()
    {
        BarkParams palm;
        palm.family = BarkFamily::PalmScars;
        TriangleMesh mesh = test::box({0, 0, 0}, {1, 1, 1});
        mesh.radius.assign(mesh.positions.size(), 0.3F);
        mesh.radius[0] = 0.01F;
        const Glb glb = written(sceneOf(mesh, barkMaterial(palm)));
        const Json& primitive = glb.json["meshes"][0]["primitives"][0];
        const auto colours = glb.values<glm::u16vec4>(primitive["attributes"]["COLOR_0"]);
        const auto places = glb.values<glm::vec3>(primitive["attributes"]["POSITION"]);
        for (std::size_t i = 0; i < colours.size(); ++i) {
            const glm::vec3 worn = glm::mix(glm::vec3(1.0F), weatheredBark, barkWeather(places[i]));
            const glm::vec3 bare = glm::vec3(colours[i]) / (worn * worn);
            if (places[i] == mesh.positions[0])
                QVERIFY(std::abs(bare.g - 65535.0F) < 4.0F && bare.r < 60000.0F && bare.b < 40000.0F);
            else
                QVERIFY(glm::length(bare - glm::vec3(65535.0F)) < 4.0F && colours[i].a == 65535);
        }
        QVERIFY(glb.json["meshes"][0].contains("extensions"));
        Material own = barkMaterial(palm);
        own.pictures.colour = "palm.png";
        const Glb plain = written(sceneOf(mesh, own), {.mapSize = 0});
        QVERIFY(!plain.json["meshes"][0]["primitives"][0]["attributes"].contains("COLOR_0"));
    }
    /// Limbs of a pine are redder than its foot: what the picture is multiplied by lets through more red than
    /// blue.
    void limbsOfAPineAreRed()
    {
        BarkParams pine;
        pine.family = BarkFamily::Plated;
        TriangleMesh mesh = test::box({0, 0, 0}, {1, 1, 1});
        mesh.radius.assign(mesh.positions.size(), 0.07F);
        const Glb glb = written(sceneOf(mesh, barkMaterial(pine)));
        const Json& primitive = glb.json["meshes"][0]["primitives"][0];
        for (const glm::u16vec4& c : glb.values<glm::u16vec4>(primitive["attributes"]["COLOR_0"]))
            QVERIFY(c.r > 0 && float(c.b) < 0.8F * float(c.r));
    }

    void nodesStandInEachOther()
    {
        ExportScene scene = sceneOf(test::box({0, 0, 0}, {1, 1, 1}));
        scene.nodes = {{"Group"}, {"Hidden"}, {"Tree", 0}};
        scene.meshes[0].node = 2;
        const glm::dmat4 group = glm::translate(glm::dmat4(1.0), {1, 2, 3}),
                         tree = glm::rotate(group, 0.7, {0.6, 0.0, 0.8}), own = glm::scale(tree, {2, 1, 0.5});
        scene.frames[0].transforms = {{group, group}, {glm::dmat4(9.0), glm::dmat4(9.0)}, {tree, own}};
        scene.frames[0].bones.resize(3);
        const Glb glb = written(scene);
        QCOMPARE(glb.json["nodes"].size(), std::size_t(3)); // of what has no mesh there is nothing
        const auto isAt = [&](const char* name, const glm::dmat4& place) {
            const glm::dmat4 off = glb.worldOf(glb.nodeNamed(name)) - place;
            return std::ranges::all_of(std::span(glm::value_ptr(off), 16),
                                       [](double x) { return std::abs(x) < 1e-12; });
        };
        QVERIFY(isAt("Group", group) && isAt("Tree", tree) && isAt("thing", own));
        QVERIFY(glb.json["scenes"][0]["nodes"] == Json::array({glb.nodeNamed("Group")}));
        // An object of one mesh in its own place is one node.
        const Glb alone = written(sceneOf(test::box({0, 0, 0}, {1, 1, 1})));
        QVERIFY(alone.json["nodes"] == Json::array({{{"name", "thing"}, {"mesh", 0}}}));
    }
    void copiesStandWhereTheMergedMeshHasThem()
    {
        ExportScene scene;
        scene.nodes = {{"Tree"}};
        scene.frames.push_back({0.0, std::vector<NodeTransforms>(1), {nullptr}});
        materialIn(scene, leavesMaterial(LeafShape::Birch));
        const TriangleMesh shape = test::box({0, 0, 0}, {0.1F, 0.3F, 0.02F});
        ExportCopies& copies = scene.copies.emplace_back();
        copies.name = "leaves";
        copies.shape = shared(shape);
        Random random(3, RandomStream::Test);
        for (int i = 0; i < 50; ++i) {
            glm::dmat4 place =
                glm::translate(glm::dmat4(1.0), {random.range(-3, 3), random.range(0, 9), 1.0});
            place = glm::rotate(place, random.range(0, 6),
                                glm::normalize(glm::dvec3(random.range(-1, 1), 0.3, 0.2)));
            copies.copies.push_back({glm::scale(place, glm::dvec3(random.range(0.5, 2.0))), glm::vec3(0.5F)});
        }
        const Glb glb = written(scene);
        const std::size_t node = glb.nodeNamed("leaves");
        const Json& attributes =
            glb.json["nodes"][node]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
        QVERIFY(glb.json["extensionsRequired"] == Json::array({"EXT_mesh_gpu_instancing"}));
        const auto places = glb.values<glm::vec3>(attributes["TRANSLATION"]);
        const auto turns = glb.values<glm::vec4>(attributes["ROTATION"]);
        const auto sizes = glb.values<glm::vec3>(attributes["SCALE"]);
        QCOMPARE(glb.values<glm::vec3>(attributes["_COLOR_0"]).size(), copies.copies.size());
        for (std::size_t i = 0; i < places.size(); ++i)
            for (const glm::vec3& p : shape.positions) {
                const glm::quat turn(turns[i].w, turns[i].x, turns[i].y, turns[i].z);
                const glm::vec3 there = places[i] + turn * (sizes[i] * p);
                const glm::dvec3 wanted = copies.copies[i].place * glm::dvec4(p, 1.0);
                QVERIFY(glm::length(glm::dvec3(there) - wanted) < 1e-5);
            }
    }
    void linesAreLines()
    {
        ExportScene scene;
        scene.frames.emplace_back();
        scene.lines = LinePart{"skeleton", {{0, 0, 0}, {0, 1, 0}, {1, 2, 0}}, {{0, 1}, {1, 2}}};
        const Glb glb = written(scene);
        const Json& primitive = glb.json["meshes"][0]["primitives"][0];
        QVERIFY(primitive["mode"] == Json(1));
        QVERIFY(glb.json["accessors"][primitive["indices"].get<std::size_t>()]["count"] == Json(4));
    }

    void accessorsSayTheirBounds()
    {
        const Glb glb = written(sceneOf(test::torus(40, 12)));
        const Json& primitive = glb.json["meshes"][0]["primitives"][0];
        const Json& accessor = glb.json["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
        glm::vec3 low(9.0F), high(-9.0F);
        for (const glm::vec3& p : glb.values<glm::vec3>(primitive["attributes"]["POSITION"])) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
        for (int k = 0; k < 3; ++k) {
            QCOMPARE(accessor["min"][std::size_t(k)].get<float>(), low[k]);
            QCOMPARE(accessor["max"][std::size_t(k)].get<float>(), high[k]);
        }
        for (const Json& view : glb.json["bufferViews"])
            QVERIFY(view["byteOffset"].get<std::size_t>() % 4 == 0 &&
                    view["byteOffset"].get<qsizetype>() + view["byteLength"].get<qsizetype>() <=
                        glb.bin.size());
    }
    void theSameSceneIsTheSameFile()
    {
        ExportScene scene = sceneOf(texturedTree(), furrowed());
        scene.nodes[0].name = "\xFF no text"; // of a file that was no UTF-8
        QVERIFY(write(scene, {.mapSize = 16}, "a.glb") && write(scene, {.mapSize = 16}, "b.glb"));
        QCOMPARE(test::fileBytes(path("a.glb")), test::fileBytes(path("b.glb")));
        QVERIFY(!parsed(test::fileBytes(path("a.glb"))).json["nodes"].empty());
    }
};

RAMURE_SUITE(TestGlbFormat)

} // namespace tst_glb_format

#include "tst_glb_format.moc"
