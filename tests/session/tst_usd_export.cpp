#include "core/evaluate/evaluator.h"
#include "core/io/formats/text/blender_scene.h"
#include "core/io/formats/usd/usd_layer.h"
#include "core/io/zip_file.h"
#include "core/presets/presets.h"
#include "core/qt/session/export/exporter.h"
#include "core/scene/demo_scenes.h"
#include "tests/core/io/io_support.h"
#include "tests/support/usd_rules.h"
#include <QTemporaryDir>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

namespace tst_usd_export {

using namespace ramure;

namespace {

const std::string awkward = "a \"tree\" {of [ours]}, #1\n\tChêne 橡\\ (x = 2)";

Node treeNode(NodeId id, const char* preset)
{
    Node tree;
    tree.id = id;
    tree.kind = NodeKind::Tree;
    tree.name = preset;
    tree.params = *presetParams(preset);
    return tree;
}

Scene sceneOf(std::vector<Node> nodes)
{
    auto scene = Scene::fromNodes(std::move(nodes));
    if (!scene)
        qFatal("%s", test::why(scene).constData());
    return std::move(*scene);
}

ExportOptions usual()
{
    ExportOptions options;
    options.texture = true;
    options.write.mapSize = 16;
    return options;
}

std::uint32_t wordAt(const QByteArray& bytes, qsizetype at)
{
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.constData() + at, sizeof word);
    return word;
}

/// The copies of one instancer, and the skeleton that moves them, as another program would play them.
struct Played
{
    std::vector<glm::dvec3> places;
    std::vector<std::string> joints, rides;        ///< of the skeleton; of copies
    std::vector<glm::dmat4> binds;                 ///< of joints
    std::vector<std::vector<glm::dmat4>> worlds{}; ///< of joints, per frame

    Played(const QByteArray& bytes, const char* instancer)
    {
        const auto layer = usd::parseLayer(test::view(bytes), "t.usda");
        const usd::Prim* copies = usd::primAt(layer->root, std::string("/Scene/TinyTree/") + instancer);
        const auto& numbers = copies->attribute("positions")->value->numbers;
        for (std::size_t i = 0; i < numbers.size(); i += 3)
            places.emplace_back(glm::make_vec3(&numbers[i]));
        const usd::Prim* skeleton = usd::primAt(layer->root, "/Scene/TinyTree/Body/Skeleton");
        if (!skeleton)
            return;
        rides = copies->attribute("primvars:unreal:naniteAssembly:bindJoints")->value->texts;
        joints = skeleton->attribute("joints")->value->texts;
        for (std::size_t j = 0; j < joints.size(); ++j)
            binds.emplace_back(
                glm::make_mat4(&skeleton->attribute("bindTransforms")->value->numbers[16 * j]));
        const usd::Prim* motion = skeleton->child("Animation");
        for (const auto& [code, turns] : motion->attribute("rotations")->samples)
            worlds.push_back(
                posed(turns->numbers, motion->attribute("translations")->samples.at(code)->numbers));
    }
    [[nodiscard]] std::size_t number(const std::string& joint) const
    {
        return static_cast<std::size_t>(std::ranges::find(joints, joint) - joints.begin());
    }
    [[nodiscard]] std::vector<glm::dmat4> posed(const std::vector<double>& turns,
                                                const std::vector<double>& moves) const
    {
        std::vector<glm::dmat4> out;
        for (std::size_t j = 0; j < joints.size(); ++j) {
            const glm::dquat turn(turns[4 * j], turns[4 * j + 1], turns[4 * j + 2], turns[4 * j + 3]);
            glm::dmat4 local = glm::mat4_cast(turn);
            local[3] = glm::dvec4(glm::make_vec3(&moves[3 * j]), 1.0);
            const std::size_t slash = joints[j].rfind('/');
            out.push_back(slash == std::string::npos ? local
                                                     : out[number(joints[j].substr(0, slash))] * local);
        }
        return out;
    }
    /// Where a copy is at a frame.
    [[nodiscard]] glm::dvec3 place(std::size_t copy, std::size_t frame) const
    {
        const std::size_t joint = number(rides[copy]);
        return worlds[frame][joint] * glm::inverse(binds[joint]) * glm::dvec4(places[copy], 1.0);
    }
};

} // namespace

/// USD on its way to files, before the rules of those who check it.
class TestUsdExport : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    TreePipeline m_pipeline;

    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    Expected<void> write(const Scene& scene, const ExportOptions& options, const char* name,
                         const Progress& progress = {})
    {
        Evaluator evaluator(pipelineSource(m_pipeline), scene.timeline());
        return exportScene(evaluator.at(scene, 0.0), options, path(name).toStdString(), progress);
    }
    [[nodiscard]] QByteArray text(const Scene& scene, const ExportOptions& options)
    {
        if (const auto done = write(scene, options, "t.usda"); !done)
            qFatal("%s", test::why(done).constData());
        return test::fileBytes(path("t.usda"));
    }
    test::UsdRules judged(const Scene& scene, const ExportOptions& options)
    {
        const QByteArray bytes = text(scene, options);
        const auto layer = usd::parseLayer(test::view(bytes), "t.usda");
        if (!layer)
            qFatal("%s", test::why(layer).constData());
        return test::usdRules(*layer, m_folder.path());
    }
    static std::string stateOf(const test::UsdRules& rules)
    {
        return rules.broken.join(QLatin1Char('\n')).toStdString();
    }
    static ExportOptions moving(int joints)
    {
        ExportOptions options = usual();
        options.write.joints = joints;
        for (int frame = 1; frame <= 4; ++frame)
            options.clip.push_back(frame / 8.0);
        return options;
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void whatIsRefused()
    {
        const Scene scene = sceneOf({treeNode(1, "TinyTree")});
        QVERIFY(!write(scene, usual(), "missing/t.usda"));
        QVERIFY(write(scene, usual(), "t.usda"));
        const QByteArray before = test::fileBytes(path("t.usda"));
        std::stop_source stop;
        stop.request_stop();
        for (const char* name : {"t.usda", "t.usdz"}) {
            const auto stopped = write(scene, usual(), name, Progress{stop.get_token(), {}});
            QVERIFY(!stopped && stopped.error().code == ErrorCode::Cancelled);
        }
        QCOMPARE(test::fileBytes(path("t.usda")), before);
        QVERIFY(!QFile::exists(path("t.usdz")));
        ExportOptions clip = moving(64);
        clip.instances = true;
        QVERIFY(!write(scene, clip, "t.glb")); // only USD says with which joints leaves go
    }
    void aTreeKeepsTheRules()
    {
        const auto rules = judged(sceneOf({treeNode(1, "TinyTree")}), usual());
        QVERIFY2(rules.broken.isEmpty(), stateOf(rules).c_str());
        QCOMPARE(rules.meshes, 3);
        QCOMPARE(rules.closed, 1);
        QVERIFY(rules.materials >= 4); // bark, its twigs, leaves, fruit
    }
    void aTreeThatMovesHasASkeleton_data()
    {
        QTest::addColumn<int>("joints");
        for (const int joints : {1, 3, 64, 0})
            QTest::newRow(qPrintable(QString::number(joints))) << joints;
    }
    void aTreeThatMovesHasASkeleton()
    {
        QFETCH(const int, joints);
        const auto rules = judged(sceneOf({treeNode(1, "TinyTree")}), moving(joints));
        QVERIFY2(rules.broken.isEmpty(), stateOf(rules).c_str());
        QCOMPARE(rules.skeletons, 1);
        QCOMPARE(rules.skins, 3);
    }
    void leavesOfATreeThatMovesAreAnAssembly()
    {
        ExportOptions options = moving(64);
        options.instances = true;
        const auto rules = judged(sceneOf({treeNode(1, "TinyTree")}), options);
        QVERIFY2(rules.broken.isEmpty(), stateOf(rules).c_str());
        QCOMPARE(rules.assemblies, 1);
        QCOMPARE(rules.instancers, 2);
        QVERIFY(text(sceneOf({treeNode(1, "TinyTree")}), options).contains("\"skeletalMesh\""));
        options.clip.clear();
        const auto still = judged(sceneOf({treeNode(1, "TinyTree")}), options);
        QVERIFY2(still.broken.isEmpty(), stateOf(still).c_str());
        QCOMPARE(still.assemblies, 1);
    }
    void leavesGoWithTheirJoints()
    {
        Node tree = treeNode(1, "TinyTree");
        tree.params.skin.method = SkinMethod::Rigid;
        tree.params.leaf.shape = LeafShape::Faithful; // of those nothing flutters
        const Scene scene = sceneOf({tree});
        ExportOptions options = moving(0);
        options.instances = true;
        const Played clip(text(scene, options), "leaves");
        options.clip.clear();
        Evaluator evaluator(pipelineSource(m_pipeline), scene.timeline());
        for (std::size_t frame = 0; frame <= 4; ++frame) {
            QVERIFY(
                exportScene(evaluator.at(scene, double(frame) / 8.0), options, path("t.usda").toStdString()));
            const Played still(test::fileBytes(path("t.usda")), "leaves");
            QCOMPARE(still.places.size(), clip.places.size());
            double most = 0.0;
            for (std::size_t i = 0; i < clip.places.size(); ++i)
                most = std::max(most, glm::distance(clip.place(i, frame), still.places[i]));
            QVERIFY2(most < 1e-4, qPrintable(QString::number(most)));
        }
    }
    void anOakOfInstancesIsSmall()
    {
        Node oak = treeNode(1, "EnglishOak1995");
        oak.params.mesh.targetTriangles = 60'000;
        ExportOptions options;
        options.instances = true;
        options.write.mapSize = 0;
        const QByteArray bytes = text(sceneOf({oak}), options);
        const auto layer = usd::parseLayer(test::view(bytes), "t.usda");
        const auto leaves = usd::primAt(layer->root, "/Scene/EnglishOak1995/leaves")->attribute("ids");
        QVERIFY(leaves->value->numbers.size() >= 50'000);
        QVERIFY2(bytes.size() < 200 * qsizetype(leaves->value->numbers.size()),
                 qPrintable(QString::number(bytes.size())));
    }
    void levelsAndSeasonsAreVariants()
    {
        ExportOptions options = usual();
        options.levels = {3, {5000, 1000, 200}};
        const auto levels = judged(sceneOf({treeNode(1, "TinyTree")}), options);
        QVERIFY2(levels.broken.isEmpty(), stateOf(levels).c_str());
        QCOMPARE(levels.variants, 3);
        options.clip = {0.25};
        const auto moves = judged(sceneOf({treeNode(1, "TinyTree")}), options);
        QVERIFY2(moves.broken.isEmpty(), stateOf(moves).c_str());
        options = usual();
        options.variants = true;
        for (const bool instances : {false, true}) {
            options.instances = instances;
            const auto seasons = judged(sceneOf({treeNode(1, "TinyTree"), treeNode(2, "TinyTree")}), options);
            QVERIFY2(seasons.broken.isEmpty(), stateOf(seasons).c_str());
            QCOMPARE(seasons.variants, 4);
        }
    }
    void equalTreesAreInItOnce()
    {
        std::vector<Node> row;
        for (NodeId id = 1; id <= 4; ++id) {
            row.push_back(treeNode(id, "TinyTree"));
            row.back().params.tree.translation.x = 4.0 * id;
        }
        const auto one = text(sceneOf({row.front()}), usual()).size(),
                   four = text(sceneOf(row), usual()).size();
        QVERIFY(four < one + 4000);
        const auto rules = judged(sceneOf(row), usual());
        QVERIFY2(rules.broken.isEmpty(), stateOf(rules).c_str());
        QCOMPARE(rules.meshes, 12);
        const auto read = readMeshFile(path("t.usda").toStdString());
        QVERIFY2(read, test::why(read));
        QVERIFY(read->objects.size() >= 12);
    }
    void everySpeciesKeepsTheRules()
    {
        ExportOptions options = usual();
        options.levels = {2, {5000, 1500}};
        options.levels.cards = true;
        int seen = 0;
        for (std::size_t i = 0; i < presets().size(); i += test::isSanitized ? 40 : 1) {
            const char* name = presets()[i].name;
            if (!write(sceneOf({treeNode(1, name)}), options, "t.usda"))
                continue; // so small a budget is refused
            const QByteArray bytes = test::fileBytes(path("t.usda"));
            const auto layer = usd::parseLayer(test::view(bytes), name);
            QVERIFY2(layer, test::why(layer));
            const auto rules = test::usdRules(*layer, m_folder.path());
            QVERIFY2(rules.broken.isEmpty(), (std::string(name) + "\n" + stateOf(rules)).c_str());
            ++seen;
        }
        QVERIFY(test::isSanitized || seen > 80);
    }
    void everythingElseKeepsTheRules()
    {
        for (const DemoScene& demo : demoScenes()) {
            const Scene scene = *demoScene(demo.name);
            ExportOptions options = usual();
            for (const bool moves : {false, true}) {
                if (moves)
                    options.clip = {0.5, 1.0};
                const auto rules = judged(scene, options);
                QVERIFY2(rules.broken.isEmpty(), (demo.name + ("\n" + stateOf(rules))).c_str());
            }
        }
    }
    void anyTextIsAName()
    {
        Node group;
        group.id = 1;
        group.name = awkward;
        std::vector<Node> nodes{group};
        for (NodeId id = 2; id < 6; ++id) {
            Node box;
            box.id = id;
            box.parent = 1;
            box.kind = NodeKind::Primitive;
            box.name = id == 5 ? std::string("9") : awkward;
            nodes.push_back(box);
        }
        Node camera;
        camera.id = 6;
        camera.parent = 1;
        camera.kind = NodeKind::Camera;
        camera.name = "Materials";
        camera.params.camera = {0.7, 2.8, 4.0};
        nodes.push_back(camera);
        const auto rules = judged(sceneOf(nodes), usual());
        QVERIFY2(rules.broken.isEmpty(), stateOf(rules).c_str());
        const auto back = importObjects(path("t.usda").toStdString());
        QVERIFY2(back, test::why(back));
        QCOMPARE(back->nodes.size(), nodes.size());
        QCOMPARE(back->nodes[0].name, awkward);
        QCOMPARE(back->nodes[1].name, awkward);
        const Node& seen = back->nodes.back();
        QVERIFY(seen.kind == NodeKind::Camera && std::abs(seen.params.camera.angleRad - 0.7) < 1e-5);
        QVERIFY(seen.params.camera.fStop == 2.8 && std::abs(seen.params.camera.focus - 4.0) < 1e-6);
    }
    void anySpaceIsReadBack_data()
    {
        QTest::addColumn<int>("up");
        QTest::addColumn<int>("unit");
        QTest::newRow("own") << int(UpAxis::Y) << 0;
        QTest::newRow("cm, Z up") << int(UpAxis::Z) << 1;
        QTest::newRow("feet") << int(UpAxis::Y) << 5;
    }
    void anySpaceIsReadBack()
    {
        QFETCH(const int, up);
        QFETCH(const int, unit);
        const Scene scene = sceneOf({treeNode(1, "TinyTree")});
        const auto heightOf = [&](const char* name) {
            const auto read = readMeshFile(path(name).toStdString());
            if (!read)
                qFatal("%s", test::why(read).constData());
            float high = 0.0F;
            for (const ReadObject& object : read->objects)
                for (const glm::vec3& p : object.mesh.positions)
                    high = std::max(high, p.y);
            return high;
        };
        ExportOptions options = usual();
        QVERIFY(write(scene, options, "plain.obj"));
        options.space = {static_cast<UpAxis>(up), static_cast<std::size_t>(unit), 1.0};
        for (const char* name : {"t.usda", "t.usdz"}) {
            QVERIFY(write(scene, options, name));
            QVERIFY(std::abs(heightOf(name) - heightOf("plain.obj")) < 1e-4F);
        }
    }
    void aPackageCanBeUsedWithoutACopy()
    {
        const Scene scene = sceneOf({treeNode(1, "TinyTree")});
        QVERIFY(write(scene, usual(), "t.usdz"));
        const QByteArray bytes = test::fileBytes(path("t.usdz"));
        int entries = 0;
        for (qsizetype at = 0; wordAt(bytes, at) == 0x04034b50; ++entries) {
            const auto halfAt = [&](qsizetype from) {
                return qsizetype(static_cast<unsigned char>(bytes[from])) |
                       qsizetype(static_cast<unsigned char>(bytes[from + 1])) << 8;
            };
            QCOMPARE(halfAt(at + 8), 0); // stored
            QCOMPARE(halfAt(at + 6) & 8, 0);
            const qsizetype data = at + 30 + halfAt(at + 26) + halfAt(at + 28);
            QCOMPARE(data % 64, 0);
            if (entries == 0)
                QVERIFY(bytes.mid(at + 30, halfAt(at + 26)) == "scene.usda" &&
                        bytes.mid(data).startsWith("#usda 1.0\n"));
            at = data + qsizetype(wordAt(bytes, at + 18));
        }
        QVERIFY(entries > 6);
        QVERIFY(write(scene, usual(), "again.usdz"));
        QVERIFY(test::fileBytes(path("again.usdz")) == bytes);
        const auto back = importObjects(path("t.usdz").toStdString());
        QVERIFY2(back, test::why(back));
        const auto bark = std::ranges::find_if(
            back->nodes, [](const Node& node) { return !node.params.surfacePictures.normal.empty(); });
        QVERIFY(bark != back->nodes.end());
        QVERIFY(QFile::exists(QString::fromStdString(bark->params.surfacePictures.colour)));
    }
};

RAMURE_SUITE(TestUsdExport)

} // namespace tst_usd_export

#include "tst_usd_export.moc"
