#include "core/evaluate/evaluator.h"
#include "core/io/formats/glb/glb_packed.h"
#include "core/presets/presets.h"
#include "core/qt/session/export/exporter.h"
#include "tests/core/io/io_support.h"
#include "tests/support/wind_preview.h"
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <QTemporaryDir>
#include <bit>
#include <cmath>
#include <meshoptimizer.h>

namespace tst_wind_export {

using namespace ramure;
using glb::Json;

namespace {

Scene sceneOf(const char* preset, std::int64_t triangles = 0)
{
    Node tree;
    tree.id = 1;
    tree.kind = NodeKind::Tree;
    tree.name = "Tree";
    tree.params = *presetParams(preset);
    tree.params.mesh.targetTriangles = triangles;
    auto scene = Scene::fromNodes({tree});
    if (!scene)
        qFatal("%s", test::why(scene).constData());
    return std::move(*scene);
}

ExportOptions optionsOf(WindProfile profile)
{
    ExportOptions options;
    options.write.mapSize = 0;
    options.wind = profile;
    return options;
}

/// A GLB taken apart without the program's help.
struct Glb
{
    Json json;
    QByteArray bin;

    static Glb read(const QString& path)
    {
        const QByteArray bytes = test::fileBytes(path);
        std::uint32_t length = 0;
        std::memcpy(&length, bytes.constData() + 12, sizeof length);
        return {Json::parse(bytes.mid(20, length).toStdString()), bytes.mid(28 + length)};
    }
    /// The bytes of a view, unpacked where they are packed.
    [[nodiscard]] std::string bytesOf(const Json& view) const
    {
        if (!view.contains("extensions"))
            return bin.mid(view["byteOffset"].get<int>(), view["byteLength"].get<int>()).toStdString();
        const Json& packed = view["extensions"]["EXT_meshopt_compression"];
        const auto count = packed["count"].get<std::size_t>(),
                   stride = packed["byteStride"].get<std::size_t>();
        std::string out(count * stride, '\0');
        meshopt_decodeVertexBuffer(out.data(), count, stride,
                                   reinterpret_cast<const unsigned char*>(bin.constData()) +
                                       packed["byteOffset"].get<std::size_t>(),
                                   packed["byteLength"].get<std::size_t>());
        const std::string filter = packed.value("filter", "NONE");
        if (filter == "OCTAHEDRAL")
            meshopt_decodeFilterOct(out.data(), count, stride);
        if (filter == "EXPONENTIAL")
            meshopt_decodeFilterExp(out.data(), count, stride);
        return out;
    }
    /// Components as numbers, as a reader of glTF sees them.
    [[nodiscard]] std::vector<glm::dvec4> column(const Json& mesh, const char* name) const
    {
        const Json& attributes = mesh["primitives"][0]["attributes"];
        if (!attributes.contains(name))
            return {};
        const Json& accessor = json["accessors"][attributes[name].get<std::size_t>()];
        const Json& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
        const std::string bytes = bytesOf(view);
        const int type = accessor["componentType"].get<int>();
        const std::string shape = accessor["type"];
        const std::size_t parts = static_cast<std::size_t>(shape.back() - '0');
        const std::size_t size = type == 5126 ? 4 : type == 5120 ? 1 : 2;
        const std::size_t stride = view.value("byteStride", parts * size);
        std::vector<glm::dvec4> out(accessor["count"].get<std::size_t>(), glm::dvec4(0.0));
        for (std::size_t i = 0; i < out.size(); ++i)
            for (std::size_t k = 0; k < parts; ++k)
                out[i][static_cast<int>(k)] = numberAt(bytes.data() + i * stride + k * size, type);
        return out;
    }

private:
    static double numberAt(const char* at, int type)
    {
        const auto as = [at](auto number) {
            std::memcpy(&number, at, sizeof number);
            return double(number);
        };
        switch (type) {
        case 5120:
            return std::max(as(std::int8_t()) / 127.0, -1.0);
        case 5122:
            return std::max(as(std::int16_t()) / 32767.0, -1.0);
        case 5123:
            return as(std::uint16_t()) / 65535.0;
        default:
            return as(float());
        }
    }
};

struct Texture
{
    int width = 0, height = 0;
    std::vector<glm::vec4> pixels;

    static Texture read(const QString& path)
    {
        Imf::InputFile file(path.toStdString().c_str());
        const Imath::Box2i box = file.header().dataWindow();
        Texture out{box.max.x + 1, box.max.y + 1, {}};
        out.pixels.resize(std::size_t(out.width) * std::size_t(out.height));
        Imf::FrameBuffer buffer;
        const char* names[] = {"R", "G", "B", "A"};
        for (int k = 0; k < 4; ++k)
            buffer.insert(names[k],
                          Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&out.pixels[0][k]),
                                     sizeof(glm::vec4), sizeof(glm::vec4) * std::size_t(out.width)));
        file.setFrameBuffer(buffer);
        file.readPixels(0, out.height - 1);
        return out;
    }
    [[nodiscard]] glm::dvec4 at(int index) const { return pixels.at(std::size_t(index)); }
};

// What shaders do, from their published text.

double curve(double x)
{
    return x * x * (3.0 - 2.0 * x);
}
double frac(double x)
{
    return x - std::floor(x);
}
double triangle(double x)
{
    return std::abs(frac(x + 0.5) * 2.0 - 1.0);
}
/// vWavesSum of an edge (x) and of a branch (y).
glm::dvec2 wavesSum(double vertexPhase, double branchPhase, double seconds)
{
    const double in[4] = {seconds + vertexPhase, seconds + vertexPhase, seconds + branchPhase,
                          seconds + branchPhase};
    const double rates[4] = {1.975, 0.793, 0.375, 0.193};
    double wave[4];
    for (int i = 0; i < 4; ++i)
        wave[i] = curve(triangle(frac(in[i] * rates[i]) * 2.0 - 1.0));
    return {wave[0] + wave[1], wave[2] + wave[3]};
}

glm::dvec3 crysisShader(glm::dvec3 p, glm::dvec3 n, const glm::dvec4& colour, const Json& extras,
                        const WindNow& now)
{
    p = {p.x, -p.z, p.y};
    n = {n.x, -n.z, n.y};
    const glm::dvec2 wind = now.strength * glm::dvec2(now.direction.x, -now.direction.z);
    const double branchAmp = now.strength * extras["branchAmp"].get<double>(),
                 detailAmp = now.strength * extras["detailAmp"].get<double>(), phase = colour.g;
    const glm::dvec2 sum = wavesSum(glm::dot(p, glm::dvec3(phase)), phase, now.seconds);
    p += glm::dvec3(sum.x, sum.x, sum.y) *
         glm::dvec3(colour.r * detailAmp * n.x, colour.r * detailAmp * n.y, (1.0 - colour.b) * branchAmp);
    const double length = glm::length(p);
    double factor = p.z * extras["bendScale"].get<double>() + 1.0;
    factor *= factor;
    factor = factor * factor - factor;
    glm::dvec3 bent = p;
    bent.x += wind.x * factor;
    bent.y += wind.y * factor;
    p = length > 0.0 ? glm::normalize(bent) * length : p;
    return {p.x, p.z, -p.y};
}

/// As Unity's reader of glTF has it: X and v turned round.
glm::dvec3 unityShader(glm::dvec3 p, glm::dvec3 n, const glm::dvec4& colour, glm::dvec2 uv,
                       const WindNow& now)
{
    p.x = -p.x;
    n.x = -n.x;
    uv.y = 1.0 - uv.y;
    const glm::dvec4 parameters(colour.r, colour.g, uv.x, uv.y);
    const glm::dvec4 wind(now.strength * glm::dvec3(-now.direction.x, now.direction.y, now.direction.z),
                          now.strength);
    const double branchPhase = parameters.x;
    const glm::dvec2 sum =
        wavesSum(glm::dot(p, glm::dvec3(parameters.y + branchPhase)), branchPhase, now.seconds);
    glm::dvec3 bend = parameters.y * 0.1 * n;
    bend.y = parameters.w * 0.3;
    p += (glm::dvec3(sum.x, sum.y, sum.x) * bend + glm::dvec3(wind) * sum.y * parameters.w) * wind.w;
    p += parameters.z * glm::dvec3(wind);
    p.x = -p.x;
    return p;
}

int unpackedIndex(float packed)
{
    const auto bits = std::bit_cast<std::uint32_t>(packed);
    const std::uint32_t half =
        ((bits >> 16U) & 0x8000U) | (((bits >> 23U) & 0xFFU) - 127U + 15U) << 10U | ((bits >> 13U) & 0x3FFU);
    return static_cast<int>(half) - 1024;
}

glm::dvec3 rotateAboutAxis(const glm::dvec3& axis, double turns, const glm::dvec3& pivot, const glm::dvec3& p)
{
    const glm::dvec3 closest = pivot + axis * glm::dot(axis, p - pivot), u = p - closest,
                     v = glm::cross(axis, u);
    const double angle = turns * 2.0 * M_PI;
    return closest + u * std::cos(angle) + v * std::sin(angle) - p;
}

/// PivotPainter2FoliageShader, in the engine's space and centimetres.
glm::dvec3 pivotShader(const glm::dvec3& metres, const glm::dvec2& uv, const Texture& pivots,
                       const Texture& axes, const WindNow& now)
{
    const PivotMotion motion;
    const glm::dvec3 p = 100.0 * glm::dvec3(metres.x, metres.z, metres.y),
                     wind(now.direction.x, now.direction.z, now.direction.y);
    int chain[4], count = 0;
    int at = int(uv.x * pivots.width) + int(uv.y * pivots.height) * pivots.width;
    for (;; ++count) {
        if (count == 4)
            qFatal("a chain of more than four");
        chain[count] = at;
        const int parent = unpackedIndex(pivots.pixels[std::size_t(at)].a);
        if (parent == at)
            break;
        at = parent;
    }
    glm::dvec3 offset(0.0);
    for (int i = 0; i <= count; ++i) {
        const glm::dvec4 pivotTexel = pivots.at(chain[i]), axisTexel = axes.at(chain[i]);
        const glm::dvec3 pivot(pivotTexel), axis = glm::dvec3(axisTexel) * 2.0 - 1.0;
        const double extent = std::max(8.0, axisTexel.a * 2048.0), ahead = glm::dot(wind, axis);
        const glm::dvec3 tip = pivot + axis * extent;
        const double gust = gustAt(now.seconds * motion.speed + glm::dot(wind, tip) / motion.worldScale,
                                   now.seconds * motion.across +
                                       glm::dot(glm::dvec3(-wind.y, wind.x, 0.0), tip) / motion.worldScale);
        const double shelter = (ahead + motion.shelterBias) * motion.shelterScale;
        const double dampened =
            std::clamp(glm::dot(p - pivot, glm::normalize(axis)) / (motion.falloff * extent), 0.0, 1.0);
        const double turns =
            now.strength * motion.turns[count - i] * (motion.gustOffset + gust) * shelter * dampened;
        const glm::dvec3 about =
            glm::cross(axis, wind + std::pow(std::max(ahead, 0.0), 5.0) * glm::dvec3(0.0, 0.0, -0.2));
        if (glm::length(about) >= 1e-3)
            offset += rotateAboutAxis(glm::normalize(about), turns, pivot, p);
    }
    const glm::dvec3 out = (p + offset) / 100.0;
    return {out.x, out.z, out.y};
}

glm::dvec3 plainShader(const glm::dvec3& p, const glm::dvec3& n, const glm::dvec4& wind, const WindNow& now)
{
    const double turn = 2.0 * M_PI;
    return p +
           now.strength * (now.direction * (wind.y + wind.z * std::sin(turn * (0.5 * now.seconds + wind.x))) +
                           n * wind.w * std::sin(turn * (2.0 * now.seconds + wind.x)));
}

/// What the program knows of a tree before it writes it.
struct Known
{
    TreeResult result;
    WindTree tree;
    ExportScene scene;
    std::vector<std::vector<WindVertex>> vertices; ///< per mesh
    WindSettings settings;
    WindElements elements;
};

Known knownOf(const Scene& scene, const ExportOptions& options)
{
    TreePipeline pipeline;
    Evaluator evaluator(pipelineSource(pipeline));
    auto collected = collectExport(evaluator.at(scene), options);
    auto result = pipeline.evaluate(scene.nodes().front().params);
    if (!collected || !result)
        qFatal("%s", test::why(collected).constData());
    Known out{*result, windTree(*result->skeleton, *result->simplified), std::move(*collected), {}, {}, {}};
    std::vector<WindLeaf> leaves;
    for (const ExportMesh& mesh : out.scene.meshes)
        if (mesh.name == "leaves")
            leaves = windLeaves(*mesh.mesh, result->foliage->leaves);
    out.elements = *windElements(out.tree, leaves);
    for (const ExportMesh& mesh : out.scene.meshes) {
        const bool areLeaves = mesh.name == "leaves", areApples = mesh.name == "fruit";
        auto vertices = areLeaves   ? windOfItems(out.tree, *mesh.mesh, result->foliage->leaves, true)
                        : areApples ? windOfItems(out.tree, *mesh.mesh, result->foliage->apples, false)
                                    : windOfBark(out.tree, *mesh.mesh);
        for (std::size_t v = 0; v < vertices.size(); ++v)
            vertices[v].element =
                areLeaves ? out.elements.ofLeaf[v / (vertices.size() / result->foliage->leaves.size())]
                          : out.elements.ofStem[out.tree.stemOf[mesh.mesh->branch[v]]];
        out.vertices.push_back(std::move(vertices));
    }
    const std::vector<std::span<const WindVertex>> all(out.vertices.begin(), out.vertices.end());
    out.settings = windSettings(out.tree, all);
    return out;
}

/// By vertex of the file, that of the mesh.
std::vector<Index> fromOf(const TriangleMesh& mesh, bool textured, bool compressed)
{
    glb::Vertices vertices = glb::verticesOf(mesh, textured);
    if (compressed)
        glb::packedTriangles(vertices);
    return vertices.from;
}

constexpr double leastHeight = 1e-6;

} // namespace

/// Wind data of games: the shaders of their engines, fed with our files, move a tree as our preview does.
class TestWindExport : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    Expected<void> write(const Scene& scene, const ExportOptions& options, const char* name,
                         double seconds = 0.0) const
    {
        TreePipeline pipeline;
        Evaluator evaluator(pipelineSource(pipeline));
        return exportScene(evaluator.at(scene, seconds), options, path(name).toStdString());
    }
    /// m: the farthest that the engine has a vertex from where the preview has it; and the farthest it moved.
    [[nodiscard]] std::pair<double, double> farthest(const Known& known, WindProfile profile,
                                                     bool compressed) const
    {
        const Glb file = Glb::read(path("t.glb"));
        Texture pivots, axes;
        if (profile == WindProfile::PivotPainter) {
            pivots = Texture::read(path("t_pivots.exr"));
            axes = Texture::read(path("t_axes.exr"));
        }
        double most = 0.0, moved = 0.0;
        for (std::size_t m = 0; m < known.scene.meshes.size(); ++m) {
            const ExportMesh& mesh = known.scene.meshes[m];
            const Json& json = file.json["meshes"][m];
            const bool textured = profile == WindProfile::Unity || profile == WindProfile::PivotPainter;
            const auto from = fromOf(*mesh.mesh, textured, compressed);
            const auto places = file.column(json, "POSITION"), normals = file.column(json, "NORMAL"),
                       colours = file.column(json, "COLOR_0"), uv = file.column(json, "TEXCOORD_1"),
                       numbers = file.column(json, "_WIND");
            if (from.size() != places.size() || normals.size() != places.size())
                qFatal("other vertices");
            const std::size_t step = std::max<std::size_t>(1, places.size() / 4000);
            for (std::size_t v = 0; v < places.size(); v += step)
                for (const WindNow& now :
                     {WindNow{{1.0, 0.0, 0.0}, 0.3, 0.0}, WindNow{{0.6, 0.0, 0.8}, 1.0, 1.37},
                      WindNow{{-0.8, 0.0, 0.6}, 1.0, 12.9}, WindNow{{0.0, 0.0, -1.0}, 0.7, 47.1}}) {
                    const glm::dvec3 p(places[v]), n = glm::normalize(glm::dvec3(normals[v]));
                    const glm::dvec3 engine =
                        profile == WindProfile::Crysis
                            ? crysisShader(p, n, colours[v], json["extras"]["wind"], now)
                        : profile == WindProfile::Unity
                            ? unityShader(p, n, colours[v], glm::dvec2(uv[v]), now)
                        : profile == WindProfile::PivotPainter
                            ? pivotShader(p, glm::dvec2(uv[v]), pivots, axes, now)
                            : plainShader(p, n, numbers[v], now);
                    const Index own = from[v];
                    const WindPlace rest{glm::dvec3(mesh.mesh->positions[own]),
                                         glm::dvec3(mesh.mesh->normals[own])};
                    const glm::dvec3 ours = windPreview(profile, rest, known.vertices[m][own], known.settings,
                                                        known.elements, now);
                    most = std::max(most, glm::distance(engine, ours));
                    moved = std::max(moved, glm::distance(ours, rest.position));
                }
        }
        return {most, moved};
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void refusals()
    {
        const Scene scene = sceneOf("TinyTree");
        const auto refused = [&](ExportOptions options, const char* name, const char* text,
                                 double seconds = 0.0) {
            const auto written = write(scene, options, name, seconds);
            return !written && test::why(written).contains(text) && !QFile::exists(path(name));
        };
        const ExportOptions plain = optionsOf(WindProfile::Plain);
        QVERIFY(refused(plain, "x.obj", "only a GLB holds wind data"));
        QVERIFY(refused(plain, "x.ply", "only a GLB holds wind data"));
        ExportOptions options = plain;
        options.model = ExportModel::Rough;
        QVERIFY(refused(options, "x.glb", "only the finished mesh has wind data"));
        options = plain;
        options.instances = true;
        QVERIFY(refused(options, "x.glb", "merged leaves"));
        options = plain;
        options.clip = {1.0};
        QVERIFY(refused(options, "x.glb", "exclude each other"));
        QVERIFY(refused(plain, "x.glb", "at rest", 1.0));
    }

    void packedIndices()
    {
        for (const Index index : {0U, 1U, 1023U, 1024U, 1500U, 2047U, 2049U, 29'999U, mostElements})
            QCOMPARE(unpackedIndex(packedIndex(index)), static_cast<int>(index));
    }

    void enginesAgree_data()
    {
        QTest::addColumn<QString>("preset");
        QTest::addColumn<int>("triangles");
        QTest::addColumn<bool>("compressed");
        for (const auto& [preset, triangles] : {std::pair("SmallTree", 0), std::pair("SilverBirch1995", 8000),
                                                std::pair("FanPalm", 0), std::pair("WinterOak", 0)}) {
            QTest::addRow("%s", preset) << preset << triangles << false;
            QTest::addRow("%s, compressed", preset) << preset << triangles << true;
        }
    }
    void enginesAgree()
    {
        QFETCH(const QString, preset);
        QFETCH(const int, triangles);
        QFETCH(const bool, compressed);
        const Scene scene = sceneOf(preset.toLatin1().constData(), triangles);
        const Known known = knownOf(scene, optionsOf(WindProfile::None));
        for (const WindProfileFacts& facts : windProfiles()) {
            ExportOptions options = optionsOf(facts.profile);
            options.write.compressed = compressed;
            const auto written = write(scene, options, "t.glb");
            QVERIFY2(written, test::why(written).constData());
            const auto [off, moved] = farthest(known, facts.profile, compressed);
            qInfo("%s, %s: within %.4f mm, moved %.3f m of %.2f m%s", qPrintable(preset), facts.name,
                  1000.0 * off, moved, known.tree.height,
                  known.elements.leavesGoAlong ? ", leaves go along" : "");
            QVERIFY2(off < 1e-3, facts.name);
            QVERIFY(moved > 0.01 * known.tree.height);
        }
    }

    void footStandsAndForksHold_data()
    {
        QTest::addColumn<QString>("preset");
        for (const char* preset : {"SmallTree", "WinterOak", "FanPalm"})
            QTest::newRow(preset) << preset;
    }
    /// No edge of the bark is stretched much: the ends of one go nearly the same way.
    void footStandsAndForksHold()
    {
        QFETCH(const QString, preset);
        const Known known = knownOf(sceneOf(preset.toLatin1().constData()), optionsOf(WindProfile::None));
        const ExportMesh& bark = known.scene.meshes.front();
        const TriangleMesh& mesh = *bark.mesh;
        const auto& vertices = known.vertices.front();
        double widest = 0.0;
        for (const glm::uvec3& t : mesh.triangles)
            for (int k = 0; k < 3; ++k) {
                const Index a = t[k], b = t[(k + 1) % 3];
                widest = std::max(widest,
                                  std::abs(double(vertices[a].sway) - double(vertices[b].sway)) -
                                      2.0 * branchSway * glm::distance(mesh.positions[a], mesh.positions[b]));
            }
        qInfo("%s: sway of neighbours differs by up to %.2f mm more than the slope of a branch says",
              qPrintable(preset), 1000.0 * widest);
        QVERIFY(widest < 0.01 * known.tree.height);
        const WindNow now{{0.6, 0.0, 0.8}, 1.0, 1.37};
        int atFoot = 0;
        double most = 0.0;
        for (Index v = 0; v < mesh.vertexCount(); ++v) {
            if (mesh.positions[v].y > known.tree.base + leastHeight)
                continue;
            ++atFoot;
            for (const WindProfileFacts& facts : windProfiles()) {
                const glm::dvec3 p(mesh.positions[v]);
                const glm::dvec3 to = windPreview(facts.profile, {p, glm::dvec3(mesh.normals[v])},
                                                  vertices[v], known.settings, known.elements, now);
                // What lies under the ground may turn with the trunk.
                const double depth = std::max(known.tree.base - double(mesh.positions[v].y), 0.0);
                most = std::max(most, glm::distance(p, to) - 0.2 * depth);
            }
        }
        qInfo("%s: %d vertices at the foot move by up to %g mm", qPrintable(preset), atFoot, 1000.0 * most);
        QVERIFY(atFoot > 2 && most < 1e-3);
    }

    void levelsShareTextures()
    {
        const Scene scene = sceneOf("SilverBirch1995");
        ExportOptions options = optionsOf(WindProfile::PivotPainter);
        options.levels = {2, {10'000, 2'500}};
        const auto written = write(scene, options, "l.glb");
        QVERIFY2(written, test::why(written).constData());
        const Glb file = Glb::read(path("l.glb"));
        const Texture pivots = Texture::read(path("l_pivots.exr")), axes = Texture::read(path("l_axes.exr"));
        int seen = 0, ownPivots = 0;
        for (const Json& mesh : file.json["meshes"]) {
            const auto uv = file.column(mesh, "TEXCOORD_1"), places = file.column(mesh, "POSITION");
            QCOMPARE(uv.size(), places.size());
            for (std::size_t v = 0; v < uv.size(); ++v) {
                const int at = int(uv[v].x * pivots.width) + int(uv[v].y * pivots.height) * pivots.width;
                const glm::dvec4 pivot = pivots.at(at);
                const glm::dvec3 foot(pivot.x, pivot.z, pivot.y);
                const int parent = unpackedIndex(float(pivot.a));
                const bool isLeaf = mesh["name"].get<std::string>().starts_with("leaves") && parent > 0 &&
                                    axes.at(at).a * 20.48 < 1.0;
                if (isLeaf) // of another tree, of another leaf
                    QVERIFY2(glm::distance(foot / 100.0, glm::dvec3(places[v])) < 2.0, "another pivot");
                ownPivots += isLeaf ? 1 : 0;
            }
            ++seen;
        }
        QCOMPARE(seen, 4);
        QVERIFY(ownPivots > 0);
    }
};

RAMURE_SUITE(TestWindExport)

} // namespace tst_wind_export

#include "tst_wind_export.moc"
