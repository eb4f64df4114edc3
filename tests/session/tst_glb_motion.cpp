#include "core/evaluate/evaluator.h"
#include "core/io/formats/file_format.h"
#include "core/io/formats/glb/glb_motion.h"
#include "core/math/random.h"
#include "core/presets/presets.h"
#include "core/qt/session/export/exporter.h"
#include "core/scene/demo_scenes.h"
#include "tests/core/io/io_support.h"
#include <QTemporaryDir>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace tst_glb_motion {

using namespace ramure;
using glb::Json;

namespace {

/// The file as a program plays it that knows nothing of ours: linear blends of joints.
struct Played
{
    Json json;
    QByteArray bin;
    std::size_t key = 0;

    template <class T> std::vector<T> values(const Json& accessor) const
    {
        const Json& from = json["accessors"][accessor.get<std::size_t>()];
        const Json& view = json["bufferViews"][from["bufferView"].get<std::size_t>()];
        std::vector<T> out(from["count"].get<std::size_t>());
        std::memcpy(out.data(), bin.constData() + view["byteOffset"].get<qsizetype>(),
                    out.size() * sizeof(T));
        return out;
    }
    template <int size>
    glm::vec<size, double> part(std::size_t node, const char* path, double otherwise) const
    {
        glm::vec<size, double> out(otherwise);
        if (json.contains("animations"))
            for (const Json& channel : json["animations"][0]["channels"])
                if (channel["target"]["node"] == node && channel["target"]["path"] == path) {
                    const Json& sampler =
                        json["animations"][0]["samplers"][channel["sampler"].get<std::size_t>()];
                    return glm::vec<size, double>(values<glm::vec<size, float>>(sampler["output"])[key]);
                }
        if (json["nodes"][node].contains(path))
            for (int k = 0; k < size; ++k)
                out[k] = json["nodes"][node][path][std::size_t(k)].get<double>();
        return out;
    }
    glm::dmat4 worldOf(std::size_t node) const
    {
        const Json& own = json["nodes"][node];
        glm::dmat4 place(1.0);
        if (own.contains("matrix")) {
            place = glm::make_mat4(own["matrix"].get<std::vector<double>>().data());
        } else {
            const glm::dvec4 turn =
                own.contains("rotation") ? part<4>(node, "rotation", 0.0) : glm::dvec4(0, 0, 0, 1);
            place = glm::translate(place, part<3>(node, "translation", 0.0)) *
                    glm::mat4_cast(glm::normalize(glm::dquat(turn.w, turn.x, turn.y, turn.z)));
            place = glm::scale(place, part<3>(node, "scale", 1.0));
        }
        for (std::size_t i = 0; i < json["nodes"].size(); ++i)
            if (const Json& above = json["nodes"][i];
                above.contains("children") && std::ranges::count(above["children"], Json(node)) > 0)
                return worldOf(i) * place;
        return place;
    }
    std::size_t nodeNamed(const std::string& name) const
    {
        for (std::size_t i = 0; i < json["nodes"].size(); ++i)
            if (json["nodes"][i]["name"] == name && json["nodes"][i].contains("mesh"))
                return i;
        qFatal("no %s", name.c_str());
    }
    std::vector<glm::dvec3> pointsOf(const std::string& name) const
    {
        const std::size_t node = nodeNamed(name);
        const Json& primitive =
            json["meshes"][json["nodes"][node]["mesh"].get<std::size_t>()]["primitives"][0];
        const auto positions = values<glm::vec3>(primitive["attributes"]["POSITION"]);
        std::vector<glm::dvec3> out;
        if (!json["nodes"][node].contains("skin")) {
            const glm::dmat4 world = worldOf(node);
            for (const glm::vec3& p : positions)
                out.emplace_back(world * glm::dvec4(p, 1.0));
            return out;
        }
        const Json& skin = json["skins"][json["nodes"][node]["skin"].get<std::size_t>()];
        const auto binds = values<glm::mat4>(skin["inverseBindMatrices"]);
        std::vector<glm::dmat4> joints;
        for (std::size_t i = 0; i < binds.size(); ++i)
            joints.push_back(worldOf(skin["joints"][i].get<std::size_t>()) * glm::dmat4(binds[i]));
        const auto which = values<glm::u16vec4>(primitive["attributes"]["JOINTS_0"]);
        const auto weights = values<glm::vec4>(primitive["attributes"]["WEIGHTS_0"]);
        for (std::size_t i = 0; i < positions.size(); ++i) {
            glm::dvec3 sum(0.0);
            for (int k = 0; k < 4; ++k)
                sum +=
                    double(weights[i][k]) * glm::dvec3(joints[which[i][k]] * glm::dvec4(positions[i], 1.0));
            out.push_back(sum);
        }
        return out;
    }
};

} // namespace

/// Clips: what another program plays is what our own pose is.
class TestGlbMotion : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    Expected<Played> written(const Scene& scene, const ExportOptions& options, double seconds) const
    {
        const std::string file = m_folder.filePath(QStringLiteral("t.glb")).toStdString();
        TreePipeline pipeline;
        Evaluator evaluator(pipelineSource(pipeline), scene.timeline());
        if (auto done = exportScene(evaluator.at(scene, seconds), options, file); !done)
            return fail(done.error());
        const QByteArray bytes = test::fileBytes(QString::fromStdString(file));
        std::uint32_t text = 0;
        std::memcpy(&text, bytes.constData() + 12, sizeof text);
        return Played{Json::parse(bytes.mid(20, text).toStdString()), bytes.mid(28 + text)};
    }
    /// The greatest distance of a vertex from where the file of that moment has it.
    double worst(const Scene& scene, ExportOptions options, const std::vector<double>& seconds,
                 const std::string& name) const
    {
        std::vector<Played> single;
        for (const double time : seconds)
            single.push_back(*written(scene, options, time));
        options.clip.assign(seconds.begin() + 1, seconds.end());
        Played clip = *written(scene, options, seconds.front());
        double most = 0.0;
        for (clip.key = 0; clip.key < seconds.size(); ++clip.key) {
            const auto played = clip.pointsOf(name), wanted = single[clip.key].pointsOf(name);
            if (played.size() != wanted.size())
                qFatal("other vertices");
            for (std::size_t i = 0; i < played.size(); ++i)
                most = std::max(most, glm::distance(played[i], wanted[i]));
        }
        return most;
    }
    static ExportOptions plain()
    {
        ExportOptions options;
        options.write.mapSize = 0;
        return options;
    }
    static Scene tinyTree()
    {
        Node tree;
        tree.id = 1;
        tree.kind = NodeKind::Tree;
        tree.name = "Tree";
        tree.params = *presetParams("TinyTree");
        tree.params.skin.method = SkinMethod::Linear;
        tree.params.tree.translation = {2, 0, 1};
        return *Scene::fromNodes({tree});
    }

    /// In a row.
    static Scene trees(int count)
    {
        std::vector<Node> row;
        for (int i = 0; i < count; ++i) {
            Node tree = tinyTree().nodes().front();
            tree.id = static_cast<NodeId>(i + 1);
            tree.name =
                "branches_" + std::to_string(i + 1); // the only mesh of a node has the name of the node
            tree.params.tree.translation = {3.0 * i, 0.0, 1.0};
            tree.params.tree.rotation.y = i;
            row.push_back(tree);
        }
        return *Scene::fromNodes(row);
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void equalTreesAreInItOnce_data()
    {
        QTest::addColumn<double>("seconds");
        QTest::addColumn<bool>("instances");
        QTest::addColumn<bool>("compressed");
        QTest::newRow("at rest") << 0.0 << false << false;
        QTest::newRow("in the wind, compressed") << 0.5 << false << true;
        QTest::newRow("instances of leaves") << 0.0 << true << false;
    }
    void equalTreesAreInItOnce()
    {
        QFETCH(const double, seconds);
        QFETCH(const bool, instances);
        ExportOptions options = plain();
        options.texture = true;
        options.instances = instances;
        QFETCH(const bool, compressed);
        options.write.compressed = compressed;
        const auto one = written(trees(1), options, seconds), three = written(trees(3), options, seconds);
        QVERIFY2(one && three, test::why(three));
        QCOMPARE(three->json["meshes"].size(), one->json["meshes"].size());
        QCOMPARE(three->bin.size(), one->bin.size());
        for (const std::string part : {"branches", "leaves", "fruit"})
            for (int i = 0; i < 3; ++i) {
                const std::size_t node = three->nodeNamed(part + "_" + std::to_string(i + 1));
                QVERIFY(three->json["nodes"][node]["mesh"] ==
                        three->json["nodes"][three->nodeNamed(part + "_1")]["mesh"]);
                QCOMPARE(three->worldOf(node)[3], glm::dvec4(3.0 * i, 0.0, 1.0, 1.0));
            }
    }
    void treesThatDifferAreApart()
    {
        Scene scene = trees(4);
        scene.find(2)->params.bark.family = BarkFamily::Corky;
        scene.find(3)->params.foliage.seed = 2;
        scene.find(4)->params.physics.windStrength = 3.0;
        const auto at = [&](double seconds) {
            const auto glb = written(scene, plain(), seconds);
            return [=](const char* name) { return glb->json["nodes"][glb->nodeNamed(name)]["mesh"]; };
        };
        const auto still = at(0.0), blown = at(0.5);
        QVERIFY(still("branches_2") != still("branches_1") && still("leaves_2") == still("leaves_1"));
        QVERIFY(still("branches_3") == still("branches_1") && still("leaves_3") != still("leaves_1"));
        QVERIFY(still("branches_4") == still("branches_1") && still("leaves_4") == still("leaves_1"));
        QVERIFY(blown("branches_4") != blown("branches_1") && blown("leaves_4") != blown("leaves_1"));
    }
    void treesThatMoveAreApart()
    {
        ExportOptions options = plain();
        options.clip = {0.5};
        const auto clip = written(trees(2), options, 0.0);
        QVERIFY2(clip, test::why(clip));
        QCOMPARE(clip->json["skins"].size(), std::size_t(2));
        QVERIFY(clip->json["nodes"][clip->nodeNamed("branches_1")]["mesh"] !=
                clip->json["nodes"][clip->nodeNamed("branches_2")]["mesh"]);
    }

    void instancesDoNotMove()
    {
        ExportOptions options = plain();
        options.instances = true;
        options.clip = {1.0};
        const auto done = written(tinyTree(), options, 0.0);
        QVERIFY(!done);
        QCOMPARE(done.error().code, ErrorCode::Invalid);
    }
    void fewJointsAreTheThickestAndWhatCarriesThem()
    {
        Random random(4, RandomStream::Test);
        for (int round = 0; round < 200; ++round) {
            std::vector<ExportBone> bones;
            const Index count = 1 + random.below(60);
            for (Index i = 0; i < count; ++i)
                bones.push_back({i == 0 || random.below(9) == 0 ? noIndex : random.below(i),
                                 random.below(5) == 0 ? 0.0 : random.range(0.01, 1.0)});
            const std::size_t limit = random.below(40);
            const glb::Joints joints = glb::jointsOf(bones, bones.size(), limit);
            QVERIFY(limit == 0 || joints.bones.size() <= limit);
            QVERIFY(!joints.bones.empty() && std::ranges::is_sorted(joints.bones));
            for (Index i = 0; i < bones.size(); ++i) {
                const Index own = joints.bones[joints.jointOf[i]];
                if (std::ranges::binary_search(joints.bones, i)) {
                    QCOMPARE(own, i);
                    QVERIFY(bones[i].parent == noIndex ||
                            std::ranges::binary_search(joints.bones, bones[i].parent));
                } else if (bones[i].parent != noIndex) {
                    QCOMPARE(own, joints.bones[joints.jointOf[bones[i].parent]]);
                }
            }
            const glb::Joints all = glb::jointsOf({}, bones.size(), limit);
            QCOMPARE(all.bones.size(), bones.size());
        }
    }
    void treesMoveAsOurs()
    {
        ExportOptions options = plain();
        options.write.joints = 0;
        const double off = worst(tinyTree(), options, {0.0, 0.25, 0.5, 1.0}, "branches");
        QVERIFY2(off < 3e-5, qPrintable(QString::number(off))); // of 3.4 m: 1e-5 of its height
        const double fruit = worst(tinyTree(), options, {0.0, 0.5}, "fruit");
        QVERIFY2(fruit < 3e-5, qPrintable(QString::number(fruit)));
    }
    void armsMoveAsOurs()
    {
        Scene scene = *demoScene("Arm");
        for (const Node& node : scene.nodes())
            scene.find(node.id)->params.skin.method = SkinMethod::Linear;
        const double off = worst(scene, plain(), {0.0, 0.5, 1.0, 2.0}, "Arm");
        QVERIFY2(off < 1e-5, qPrintable(QString::number(off)));
    }
    void nodesMoveAsTheirTracks()
    {
        const Scene scene = *demoScene("MovingTree");
        const double off = worst(scene, plain(), {0.0, 0.5, 1.0}, scene.nodes().back().name);
        QVERIFY2(off < 1e-5, qPrintable(QString::number(off)));
    }
    void fewerJointsAreTold()
    {
        ExportOptions options = plain();
        options.clip = {0.5, 1.0};
        options.write.joints = 12;
        std::vector<Error> notes;
        options.write.tell = [&notes](const Error& note) { notes.push_back(note); };
        const auto clip = written(tinyTree(), options, 0.0);
        QVERIFY2(clip, test::why(clip));
        QCOMPARE(clip->json["skins"].size(), std::size_t(1)); // of all three meshes
        QVERIFY(clip->json["skins"][0]["joints"].size() <= 12);
        QCOMPARE(notes.size(), std::size_t(1));
        QVERIFY(notes[0].message().find("Tree: 12 joints") != std::string::npos);
    }
    void whatRestsHasNoKeys()
    {
        Node box;
        box.id = 1;
        box.kind = NodeKind::Primitive;
        box.name = "Box";
        ExportOptions options = plain();
        options.clip = {1.0};
        const auto clip = written(*Scene::fromNodes({box}), options, 0.0);
        QVERIFY2(clip, test::why(clip));
        QVERIFY(!clip->json.contains("animations") && !clip->json.contains("skins"));
    }
};

RAMURE_SUITE(TestGlbMotion)

} // namespace tst_glb_motion

#include "tst_glb_motion.moc"
