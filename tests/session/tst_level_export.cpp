#include "core/evaluate/evaluator.h"
#include "core/io/mesh_file.h"
#include "core/presets/presets.h"
#include "core/qt/session/export/exporter.h"
#include "tests/core/io/io_support.h"
#include "tests/support/shaped_tree.h"
#include <QTemporaryDir>
#include <nlohmann/json.hpp>

namespace tst_level_export {

using namespace ramure;
using Json = nlohmann::json;

namespace {

Scene sceneOf(const char* preset)
{
    Node tree;
    tree.id = 1;
    tree.kind = NodeKind::Tree;
    tree.name = "Tree";
    tree.params = *presetParams(preset);
    Node box;
    box.id = 2;
    box.kind = NodeKind::Primitive;
    box.name = "Box";
    auto scene = Scene::fromNodes({tree, box});
    if (!scene)
        qFatal("%s", test::why(scene).constData());
    return std::move(*scene);
}

ExportOptions levelled(std::vector<std::int64_t> budgets)
{
    ExportOptions options;
    options.texture = true;
    options.write.mapSize = 0;
    options.levels = {static_cast<std::int64_t>(budgets.size()), std::move(budgets)};
    return options;
}

Json jsonOf(const QByteArray& glb)
{
    std::uint32_t length = 0;
    std::memcpy(&length, glb.constData() + 12, sizeof length);
    return Json::parse(glb.mid(20, length).toStdString());
}

std::size_t trianglesOf(const Json& json, const std::string& ending)
{
    std::size_t count = 0;
    for (const Json& mesh : json["meshes"])
        if (mesh["name"].get<std::string>().ends_with(ending))
            count += json["accessors"][mesh["primitives"][0]["indices"].get<std::size_t>()]["count"]
                         .get<std::size_t>() /
                     3;
    return count;
}

const Json* nodeNamed(const Json& json, const std::string& name)
{
    for (const Json& node : json["nodes"])
        if (node["name"] == name)
            return &node;
    return nullptr;
}

} // namespace

/// Levels of detail on their way to files.
class TestLevelExport : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    TreePipeline m_pipeline;

    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    [[nodiscard]] Expected<void> write(const Scene& scene, const ExportOptions& options, const char* name,
                                       double seconds = 0.0)
    {
        Evaluator evaluator(pipelineSource(m_pipeline));
        return exportScene(evaluator.at(scene, seconds), options, path(name).toStdString());
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void whatIsRefused()
    {
        const Scene scene = sceneOf("TinyTree");
        ExportOptions options = levelled({2000, 500});
        options.instances = true;
        auto written = write(scene, options, "no.glb");
        QVERIFY2(!written && written.error().message().find("instances") != std::string::npos,
                 test::why(written));
        options = levelled({2000, 500});
        options.model = ExportModel::Rough;
        written = write(scene, options, "no.glb");
        QVERIFY2(!written && written.error().message().find("finished mesh") != std::string::npos,
                 test::why(written));
        options = levelled({2000, 0});
        written = write(scene, options, "no.glb");
        QCOMPARE(written.error().code, ErrorCode::Invalid);
        QVERIFY(QDir(m_folder.path()).isEmpty());
    }

    void cutsShowTheirWoodInEveryLevel()
    {
        Node tree;
        tree.id = 1;
        tree.kind = NodeKind::Tree;
        tree.name = "Tree";
        test::Shaped shaped;
        TreeEdit edit = test::editOf(EditOperation::Thickness, shaped.address[0]);
        edit.factor = 0.1;
        edit.below = true;
        QVERIFY(shaped.make(edit));
        edit = test::editOf(EditOperation::Cut, shaped.address[3]);
        edit.at = 0.5;
        QVERIFY(shaped.make(edit));
        shaped.params.sections = {16, 32}; // enough triangles for levels
        tree.params = shaped.params;
        ExportOptions options;
        options.write.mapSize = 0;
        options.levels = {2, {}};
        QVERIFY2(write(*Scene::fromNodes({tree}), options, "cut.glb"), "not written");
        const Json json = jsonOf(test::fileBytes(path("cut.glb")));
        for (const char* name : {"cuts_LOD0", "cuts_LOD1"}) {
            const Json* node = nodeNamed(json, name);
            QVERIFY2(node && node->contains("mesh"), name);
        }
    }

    /// Other nodes have no levels; what does not know the extension finds the finest alone in the scene.
    void aGlbHoldsThemAll()
    {
        QVERIFY2(write(sceneOf("SmallTree"), levelled({10'000, 2'500, 600}), "t.glb"), "not written");
        const Json json = jsonOf(test::fileBytes(path("t.glb")));
        QVERIFY(std::ranges::count(json["extensionsUsed"], Json("MSFT_lod")) == 1);
        QVERIFY(!json.contains("extensionsRequired"));
        const std::size_t wanted[] = {10'000, 2'500, 600};
        for (std::size_t level = 0; level < 3; ++level) {
            const double got = double(trianglesOf(json, "_LOD" + std::to_string(level)));
            QVERIFY(std::abs(got - double(wanted[level])) <= 0.02 * double(wanted[level]));
        }
        for (const char* part : {"branches", "leaves", "fruit"}) {
            const Json* finest = nodeNamed(json, std::string(part) + "_LOD0");
            QVERIFY(finest);
            const Json& ids = (*finest)["extensions"]["MSFT_lod"]["ids"];
            QCOMPARE(ids.size(), std::size_t(2));
            for (std::size_t i = 0; i < 2; ++i) {
                const std::size_t id = ids[i].get<std::size_t>();
                QCOMPARE(json["nodes"][id]["name"].get<std::string>(),
                         std::string(part) + "_LOD" + std::to_string(i + 1));
                QVERIFY(std::ranges::count(json["scenes"][0]["nodes"], Json(id)) == 0);
                for (const Json& node : json["nodes"])
                    QVERIFY(!node.contains("children") ||
                            std::ranges::count(node["children"], Json(id)) == 0);
            }
            const Json& coverage = (*finest)["extras"]["MSFT_screencoverage"];
            QCOMPARE(coverage.size(), std::size_t(3));
            QVERIFY(coverage[0].get<double>() >= coverage[1].get<double>() &&
                    coverage[1].get<double>() > 0.0);
            QCOMPARE(coverage[2].get<double>(), 0.0);
        }
        QVERIFY(!nodeNamed(json, "Box")->contains("extensions"));
    }

    void aGlbSaysWhenLevelsChange()
    {
        LevelOptions levels{3, {4'000, 1'000, 300}};
        const auto coverage = [&](double scale) {
            Scene scene = sceneOf("TinyTree");
            Node tree = *scene.find(1);
            tree.params.tree.scale = glm::dvec3(scale);
            ExportOptions options = levelled(levels.budgets);
            options.levels = levels;
            if (!write(*Scene::fromNodes({tree}), options, "s.glb"))
                qFatal("not written");
            const Json json = jsonOf(test::fileBytes(path("s.glb")));
            return (*nodeNamed(json, "branches_LOD0"))["extras"]["MSFT_screencoverage"]
                .get<std::vector<double>>();
        };
        const auto isNear = [](double one, double other) { return std::abs(one - other) <= 1e-6 * other; };
        const auto usual = coverage(1.0);
        levels.shares = {0.6, 0.3};
        QCOMPARE(coverage(3.0), usual); // of the picture, whatever the size
        levels.shares = {0.3, 0.1};
        const auto later = coverage(1.0);
        QVERIFY(isNear(later[0], usual[1]) && isNear(later[1], usual[1] / 9.0));
        levels.shares.clear();
        levels.distances = {20.0, 60.0};
        const auto near = coverage(1.0), large = coverage(3.0);
        QVERIFY(isNear(near[0], 9.0 * near[1]) && isNear(large[1], near[0]));
        levels.distances = {60.0, 20.0};
        ExportOptions options = levelled(levels.budgets);
        options.levels = levels;
        const auto written = write(sceneOf("TinyTree"), options, "no.glb");
        QVERIFY2(!written && written.error().message().find("must rise") != std::string::npos,
                 test::why(written));
    }

    void otherFormatsHaveNumberedFiles_data()
    {
        QTest::addColumn<QString>("ending");
        for (const char* ending : {"obj", "ply", "stl", "3mf"})
            QTest::newRow(ending) << QString::fromLatin1(ending);
    }
    void otherFormatsHaveNumberedFiles()
    {
        QFETCH(QString, ending);
        ExportOptions options = levelled({4'000, 1'000});
        options.nodes = {1};
        const QByteArray name = QByteArray("t.") + ending.toLatin1();
        QVERIFY(write(sceneOf("TinyTree"), options, name));
        QVERIFY(!QFile::exists(path(name)));
        const auto files = exportFiles(options, path(name).toStdString());
        QCOMPARE(files.size(), std::size_t(2));
        QCOMPARE(QString::fromStdString(files[1]), path("t_LOD1.") + ending);
        for (std::size_t i = 0; i < 2; ++i) {
            const auto mesh = readMeshFile(files[i]);
            QVERIFY2(mesh, test::why(mesh));
            const double wanted = double(options.levels.budgets[i]), got = double(mesh->joined().faceCount());
            QVERIFY2(std::abs(got - wanted) <= 0.02 * wanted + 1.0, QByteArray::number(got));
        }
    }
    void namesOfLevels()
    {
        QCOMPARE(levelFile("a/t.obj", 0), std::string("a/t_LOD0.obj"));
        QCOMPARE(levelFile("a.b/t", 3), std::string("a.b/t_LOD3"));
        QCOMPARE(exportFiles({}, "t.obj"), std::vector<std::string>{"t.obj"});
        QCOMPARE(exportFiles(levelled({500, 100}), "t.glb"), std::vector<std::string>{"t.glb"});
    }

    /// One skeleton for all; each level has a skin on it, and at its second moment stands where the wind has
    /// it.
    void levelsMove()
    {
        ExportOptions options = levelled({6'000, 1'500});
        options.clip = {2.5, 3.0};
        QVERIFY(write(sceneOf("SilverBirch1995"), options, "wind.glb", 2.0));
        const Json json = jsonOf(test::fileBytes(path("wind.glb")));
        QCOMPARE(json["skins"].size(), std::size_t(1));
        for (const char* name : {"branches_LOD0", "branches_LOD1", "leaves_LOD0", "leaves_LOD1"}) {
            const Json* node = nodeNamed(json, name);
            QVERIFY(node && node->contains("skin"));
        }
        const Scene scene = sceneOf("SilverBirch1995");
        Evaluator evaluator(pipelineSource(m_pipeline));
        options.clip.clear();
        const auto rest = collectExport(evaluator.at(scene), options);
        const auto moved = collectExport(evaluator.at(scene, 3.0), options);
        QVERIFY(rest && moved);
        const FlatScene still = flattened(levelOf(*rest, 1)), blown = flattened(levelOf(*moved, 1));
        QCOMPARE(still.meshes.size(), blown.meshes.size());
        QCOMPARE(still.meshes[0].mesh->triangles, blown.meshes[0].mesh->triangles);
        QVERIFY(still.meshes[0].mesh->positions != blown.meshes[0].mesh->positions);
    }

    /// The billboard stands in the place of all parts, with its pictures and where it fades in; formats
    /// without pictures have none.
    void theBillboardIsTheLastLevel()
    {
        const Scene scene = sceneOf("SmallTree");
        ExportOptions options = levelled({3'000, 800});
        options.levels.cards = options.levels.billboard = true;
        options.write.mapSize = 128;
        QCOMPARE(exportFiles(options, "tree.obj").size(), std::size_t(3));
        QCOMPARE(exportFiles(options, "tree.stl").size(), std::size_t(2));
        QCOMPARE(exportFiles(options, "tree.glb").size(), std::size_t(1));
        QVERIFY(write(scene, options, "billboard.glb"));
        const Json json = jsonOf(test::fileBytes(path("billboard.glb")));
        QCOMPARE(trianglesOf(json, "billboard_LOD2"), std::size_t(6));
        const Json* bark = nodeNamed(json, "branches_LOD0");
        QVERIFY(bark);
        const Json& ids = (*bark)["extensions"]["MSFT_lod"]["ids"];
        QCOMPARE(ids.size(), std::size_t(2));
        const Json& last = json["nodes"][ids[1].get<std::size_t>()];
        QCOMPARE(last["name"].get<std::string>(), std::string("billboard_LOD2"));
        const Json& fade = last["extras"]["fade"];
        QVERIFY(fade["screenHeight"][0].get<double>() > fade["screenHeight"][1].get<double>());
        QVERIFY(fade["metres"][0].get<double>() < fade["metres"][1].get<double>());
        const Json& mesh = json["meshes"][last["mesh"].get<std::size_t>()];
        const Json& material = json["materials"][mesh["primitives"][0]["material"].get<std::size_t>()];
        QCOMPARE(material["name"].get<std::string>(), std::string("billboard"));
        QCOMPARE(material["alphaMode"].get<std::string>(), std::string("MASK"));
        options.write.mapSize = 0; // without pictures there are no cards
        QCOMPARE(exportFiles(options, "tree.obj").size(), std::size_t(2));
    }

    /// Each level as a file, and what bodies bump into in the first.
    void engineFilesHaveTheirNames()
    {
        const Scene scene = sceneOf("SmallTree");
        ExportOptions options = levelled({3'000, 800});
        options.levelFiles = true;
        options.collision = CollisionNames::Unreal;
        QVERIFY(write(scene, options, "unreal.glb"));
        QVERIFY(!QFile::exists(path("unreal.glb")));
        const Json first = jsonOf(test::fileBytes(path("unreal_LOD0.glb"))),
                   second = jsonOf(test::fileBytes(path("unreal_LOD1.glb")));
        QVERIFY(nodeNamed(first, "branches_LOD0") && nodeNamed(first, "UCX_branches_LOD0_00"));
        QVERIFY(nodeNamed(second, "branches_LOD1") && !nodeNamed(second, "UCX_branches_LOD0_00"));
        QVERIFY(!(*nodeNamed(first, "branches_LOD0")).contains("extensions"));
        options.levelFiles = false;
        options.levels = {};
        options.collision = CollisionNames::Godot;
        QVERIFY(write(scene, options, "godot.glb"));
        QVERIFY(nodeNamed(jsonOf(test::fileBytes(path("godot.glb"))), "branches_00-convcolonly"));
    }
};

RAMURE_SUITE(TestLevelExport)

} // namespace tst_level_export

#include "tst_level_export.moc"
