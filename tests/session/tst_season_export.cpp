#include "core/qt/session/export/season_export.h"

#include "core/evaluate/evaluator.h"
#include "core/presets/presets.h"
#include "core/qt/session/export/exporter.h"
#include "tests/core/io/io_support.h"
#include <QTemporaryDir>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>

namespace tst_season_export {

using namespace ramure;
using Json = nlohmann::json;

namespace {

Scene sceneOn(double day, LeafShape shape = LeafShape::Maple)
{
    Node tree;
    tree.id = 1;
    tree.kind = NodeKind::Tree;
    tree.name = "Tree";
    tree.params = *presetParams("TinyTree");
    tree.params.leaf.shape = shape;
    tree.params.season.day = day;
    tree.params.foliage.applesProbability = 0.0;
    auto scene = Scene::fromNodes({tree});
    if (!scene)
        qFatal("%s", test::why(scene).constData());
    return std::move(*scene);
}

Json jsonOf(const QByteArray& glb)
{
    std::uint32_t length = 0;
    std::memcpy(&length, glb.constData() + 12, sizeof length);
    return Json::parse(glb.mid(20, length).toStdString());
}

const Json& meshNamed(const Json& json, const std::string& name)
{
    for (const Json& mesh : json["meshes"])
        if (mesh["name"] == name)
            return mesh;
    qFatal("no mesh %s", name.c_str());
}

} // namespace

/// A year on its way to files.
class TestSeasonExport : public QObject
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
    Json glbOf(const Scene& scene, const ExportOptions& options)
    {
        const auto written = write(scene, options, "t.glb");
        if (!written)
            qFatal("%s", test::why(written).constData());
        return jsonOf(test::fileBytes(path("t.glb")));
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void treesWithoutLeavesOrWithFaithfulOnesHaveNoVariants()
    {
        ExportOptions options;
        options.variants = true;
        QVERIFY(!glbOf(sceneOn(0.0, LeafShape::Faithful), options).contains("extensions"));
        options.parts = exportBranches;
        QVERIFY(!glbOf(sceneOn(200.0), options).contains("extensions"));
        // A day in winter: there is nothing to write.
        options.variants = false;
        options.parts = exportLeaves;
        QVERIFY(!write(sceneOn(20.0), options, "none.glb"));
    }

    /// Cards have pictures of the leaves of one day.
    void levelsHaveOneDay()
    {
        ExportOptions options;
        options.variants = true;
        options.levels.count = 2;
        const auto refused = write(sceneOn(200.0), options, "levels.glb");
        QVERIFY(!refused);
        QCOMPARE(QString::fromStdString(refused.error().path), QStringLiteral("variants"));
        QVERIFY(write(sceneOn(200.0), options, "levels.obj")); // which has none anyway
        options.variants = false;
        QVERIFY(write(sceneOn(200.0), options, "levels.glb"));
    }

    void aTreeThatMovesOnADayHasNoVariants()
    {
        ExportOptions options;
        options.variants = true;
        options.clip = {0.0, 0.5};
        const auto refused = write(sceneOn(200.0), options, "clip.glb");
        QVERIFY(!refused);
        QVERIFY(refused.error().path.find("season.day") != std::string::npos);
        QVERIFY(write(sceneOn(0.0), options, "clip.glb"));
    }

    void aDayIsWritten()
    {
        ExportOptions options;
        const Json summer = glbOf(sceneOn(200.0), options), autumn = glbOf(sceneOn(305.0), options);
        const auto through = [](const Json& json) {
            for (const Json& material : json["materials"])
                if (material["name"] == "leaves_maple")
                    return material["extensions"]["KHR_materials_diffuse_transmission"]
                                   ["diffuseTransmissionColorFactor"];
            return Json();
        };
        QVERIFY(through(summer)[1].get<double>() > through(summer)[0].get<double>());
        QVERIFY(through(autumn)[0].get<double>() > through(autumn)[1].get<double>());
        QVERIFY(!summer.contains("extensions"));
        // The mean colour and its filter in an .mtl.
        QVERIFY(write(sceneOn(305.0), options, "t.obj"));
        const QByteArray mtl = test::fileBytes(path("t.mtl"));
        QVERIFY(mtl.contains("newmtl leaves_maple") && mtl.contains("\nTf "));
    }

    void fourSeasonsStandInOneFile()
    {
        ExportOptions options;
        options.variants = true;
        Json all[2];
        for (const double day : {0.0, 305.0}) { // whatever the day
            const Json json = all[day > 0.0 ? 1 : 0] = glbOf(sceneOn(day), options);
            const Json& names = json["extensions"]["KHR_materials_variants"]["variants"];
            QCOMPARE(names.size(), std::size_t(4));
            QCOMPARE(names[0]["name"].get<std::string>(), std::string("spring"));
            QCOMPARE(names[3]["name"].get<std::string>(), std::string("winter"));
            const Json& leaves = meshNamed(json, "leaves")["primitives"][0];
            const Json& mappings = leaves["extensions"]["KHR_materials_variants"]["mappings"];
            std::set<std::size_t> materials;
            for (const Json& each : mappings)
                materials.insert(each["material"].get<std::size_t>());
            QCOMPARE(materials.size(), std::size_t(4));
            QCOMPARE(leaves["material"], mappings[1]["material"]); // summer, if nobody chooses
            const Json& winter = json["materials"][mappings[3]["material"].get<std::size_t>()];
            QCOMPARE(winter["alphaMode"].get<std::string>(), std::string("MASK"));
            QCOMPARE(winter["pbrMetallicRoughness"]["baseColorFactor"][3].get<double>(), 0.0);
            const Json& phase = json["accessors"][leaves["attributes"]["_SEASON"].get<std::size_t>()];
            QCOMPARE(phase["type"].get<std::string>(), std::string("SCALAR"));
            QCOMPARE(phase["count"],
                     json["accessors"][leaves["attributes"]["POSITION"].get<std::size_t>()]["count"]);
        }
        QVERIFY(meshNamed(all[0], "leaves") == meshNamed(all[1], "leaves"));
    }

    void instancesHaveTheirPhases()
    {
        ExportOptions options;
        options.variants = options.instances = true;
        const Json json = glbOf(sceneOn(200.0), options);
        QVERIFY(json["extensions"].contains("KHR_materials_variants"));
        bool found = false;
        for (const Json& node : json["nodes"])
            if (node.contains("extensions") && node["extensions"].contains("EXT_mesh_gpu_instancing")) {
                const Json& attributes = node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
                QVERIFY(attributes.contains("_SEASON"));
                const auto count = [&](const char* name) {
                    return json["accessors"][attributes[name].get<std::size_t>()]["count"].get<int>();
                };
                QCOMPARE(count("_SEASON"), count("TRANSLATION"));
                found = true;
            }
        QVERIFY(found);
    }
};

RAMURE_SUITE(TestSeasonExport)

} // namespace tst_season_export

#include "tst_season_export.moc"
