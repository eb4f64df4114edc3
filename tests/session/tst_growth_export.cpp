#include "core/qt/session/export/growth_export.h"

#include "core/evaluate/evaluator.h"
#include "core/presets/presets.h"
#include "core/qt/session/export/exporter.h"
#include "tests/core/io/io_support.h"
#include <QTemporaryDir>
#include <cstring>
#include <nlohmann/json.hpp>

namespace tst_growth_export {

using namespace ramure;
using Json = nlohmann::json;

namespace {

Scene sceneOf(const char* preset, double age)
{
    Node tree;
    tree.id = 1;
    tree.kind = NodeKind::Tree;
    tree.name = "Tree";
    tree.params = *presetParams(preset);
    tree.params.growth.age = age;
    auto scene = Scene::fromNodes({tree});
    if (!scene)
        qFatal("%s", test::why(scene).constData());
    return std::move(*scene);
}

ExportOptions growing()
{
    ExportOptions options;
    options.growthFrom = 1.0;
    options.growthTriangles = 6'000;
    options.growthKeys = 5;
    options.texture = true;
    options.write.mapSize = 16;
    return options;
}

template <class Value> Value valueAt(const QByteArray& bytes, std::size_t at)
{
    Value value{};
    std::memcpy(&value, bytes.constData() + at, sizeof value);
    return value;
}

} // namespace

/// Growing trees on their way to files.
class TestGrowthExport : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    TreePipeline m_pipeline;

    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    Expected<void> write(const Scene& scene, const ExportOptions& options, const char* name)
    {
        Evaluator evaluator(pipelineSource(m_pipeline));
        return exportScene(evaluator.at(scene, 0.0), options, path(name).toStdString());
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void otherFormatsAndOptionsAreRefused()
    {
        const Scene oak = sceneOf("EnglishOak", 8.0);
        const auto refused = [&](ExportOptions options, const char* name) {
            const auto written = write(oak, options, name);
            return !written && written.error().path == "growth" && !QFile::exists(path(name));
        };
        QVERIFY(refused(growing(), "t.ply"));
        QVERIFY(refused(growing(), "t.stl"));
        ExportOptions options = growing();
        options.instances = true;
        QVERIFY(refused(options, "t.glb"));
        options = growing();
        options.levels.count = 2;
        QVERIFY(refused(options, "t.glb"));
        options = growing();
        options.model = ExportModel::Rough;
        QVERIFY(refused(options, "t.glb"));
        QVERIFY(!write(sceneOf("SmallTree", 8.0), growing(), "t.glb"));
        QVERIFY(!QFile::exists(path("t.glb")));
    }

    void aGlbHasKeyShapes()
    {
        std::string told;
        ExportOptions options = growing();
        options.write.tell = [&](const Error& note) { told += note.message(); };
        QVERIFY(write(sceneOf("EnglishOak", 12.0), options, "t.glb"));
        QVERIFY2(told.find("5 key shapes") != std::string::npos, told.c_str());
        const QByteArray glb = test::fileBytes(path("t.glb"));
        const Json json = Json::parse(glb.mid(20, valueAt<std::uint32_t>(glb, 12)).toStdString());
        const Json& bark = json["meshes"][0];
        QCOMPARE(bark["name"].get<std::string>(), std::string("branches"));
        QCOMPARE(bark["primitives"][0]["targets"].size(), std::size_t(4));
        QCOMPARE(bark["extras"]["targetNames"][0].get<std::string>(), std::string("1 years"));
        QVERIFY(bark["extensions"].contains("EXT_mesh_manifold"));
        QCOMPARE(json["meshes"].size(), std::size_t(6)); // and leaves of five ages
        QCOMPARE(json["animations"][0]["channels"].size(), std::size_t(6));
        const Json& sampler = json["animations"][0]["samplers"][0];
        const Json& times = json["accessors"][sampler["input"].get<std::size_t>()];
        QCOMPARE(times["count"].get<int>(), 5);
        QCOMPARE(times["max"][0].get<float>(), 2.2F); // eleven years, five a second
        QCOMPARE(json["accessors"][sampler["output"].get<std::size_t>()]["count"].get<int>(), 20);
    }

    /// The mesh beside it has the points in their order, and the last sample is the mesh itself.
    void aPointCacheHasTheSamePoints()
    {
        ExportOptions options = growing();
        options.parts = exportBranches;
        QVERIFY(write(sceneOf("EnglishOak", 12.0), options, "t.pc2"));
        const QByteArray bytes = test::fileBytes(path("t.pc2"));
        QVERIFY(bytes.startsWith("POINTCACHE2"));
        const auto points = valueAt<std::int32_t>(bytes, 16);
        const auto samples = valueAt<std::int32_t>(bytes, 28);
        QCOMPARE(samples, 5);
        QCOMPARE(bytes.size(), qsizetype(32) + qsizetype(12) * points * samples);
        const auto mesh = readMeshFile(path("t.obj").toStdString());
        QVERIFY2(mesh, test::why(mesh).constData());
        const std::vector<glm::vec3>& rest = mesh->objects[0].mesh.positions;
        QCOMPARE(std::size_t(points), rest.size());
        const std::size_t last = 32 + 12 * std::size_t(points) * std::size_t(samples - 1);
        for (std::size_t v = 0; v < rest.size(); ++v)
            QVERIFY(glm::distance(valueAt<glm::vec3>(bytes, last + 12 * v), rest[v]) < 1e-5F);
    }

    void usdHasPointsOverTime()
    {
        QVERIFY(write(sceneOf("EnglishOak", 12.0), growing(), "t.usda"));
        const QByteArray text = test::fileBytes(path("t.usda"));
        QCOMPARE(text.count("point3f[] points.timeSamples"), 6);
        QCOMPARE(text.count("normal3f[] normals.timeSamples"), 1);
        QVERIFY(text.contains("endTimeCode = 52.8")); // eleven years, five a second, 24 frames a second
        const auto read = readMeshFile(path("t.usda").toStdString());
        QVERIFY2(read, test::why(read).constData());
    }

    /// A clip is a cache, too.
    void aTreeInTheWindIsAPointCache()
    {
        ExportOptions options;
        options.parts = exportBranches;
        options.clip = {0.25, 0.5};
        QVERIFY(write(sceneOf("TinyTree", 8.0), options, "wind.pc2"));
        const QByteArray bytes = test::fileBytes(path("wind.pc2"));
        QCOMPARE(valueAt<std::int32_t>(bytes, 28), 3);
        QCOMPARE(valueAt<float>(bytes, 24), 6.0F); // frames at 24 a second
    }
};

RAMURE_SUITE(TestGrowthExport)

} // namespace tst_growth_export

#include "tst_growth_export.moc"
