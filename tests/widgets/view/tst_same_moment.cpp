#include "core/document/document.h"
#include "core/evaluate/evaluator.h"
#include "core/params/presets.h"
#include "core/rig/arm/arm_chain.h"
#include "core/scene/object_mesh.h"
#include "core/session/player.h"
#include "core/session/recompute.h"
#include "core/surface/mesh/transformed.h"
#include "tests/support/flat_export.h"
#include "tests/support/suite.h"
#include "widgets/view/moving_scene.h"
#include "widgets/view/render/scene_builder.h"
#include <random>

using namespace ramure;

namespace {

constexpr int patienceMs = 60'000;
constexpr NodeId group = 1, still = 2, windy = 3, arm = 4, box = 5;

/// A random scene: a keyed group with two trees, one in a wind that changes; an arm that follows; a box that
/// turns and grows.
struct RandomScene
{
    explicit RandomScene(unsigned seed)
        : random(seed)
    {
    }
    double number(double from, double to) { return std::uniform_real_distribution(from, to)(random); }
    NodeAnimation::TrackPtr track(double from, double to)
    {
        Key first, last;
        first.value = number(from, to);
        last.time = ticksOf(2.0);
        last.value = number(from, to);
        return std::make_shared<const AnyTrack>(*Track::fromKeys({first, last}));
    }
    Node node(NodeId id, NodeKind kind, NodeId parent = noNode)
    {
        Node made;
        made.id = id;
        made.parent = parent;
        made.kind = kind;
        made.name = std::to_string(id);
        if (kind == NodeKind::Tree)
            made.params = *presetParams("TinyTree");
        made.params.tree.translation = {number(-3.0, 3.0), 0.0, number(-3.0, 3.0)};
        made.params.tree.rotation.y = number(-2.0, 2.0);
        made.params.physics.windStrength = number(0.5, 3.0);
        return made;
    }
    Scene make()
    {
        const auto param = [](const char* key, std::uint8_t component = 0) {
            return Channel{ChannelPart::Parameter, component, paramId(*findParam(key))};
        };
        std::vector<Node> nodes{node(group, NodeKind::Group), node(still, NodeKind::Tree, group),
                                node(windy, NodeKind::Tree, group), node(arm, NodeKind::Arm, group),
                                node(box, NodeKind::Primitive)};
        nodes[0].animation.set({ChannelPart::GlobalTranslation, 0, 0}, track(-2.0, 2.0));
        nodes[1].animation.set({ChannelPart::LocalTranslation, 1, 0}, track(-1.0, 1.0));
        nodes[2].animation.set(param("physics.windStrength"), track(0.0, 4.0));
        nodes[3].params.arm.follows = true;
        nodes[3].params.arm.target = {number(0.2, 1.5), number(-1.0, 1.0), number(0.5, 2.0)};
        nodes[3].animation.set(param("arm.target", 1), track(-1.0, 1.0));
        nodes[4].animation.set(param("primitive.radius"), track(0.2, 1.0));
        nodes[4].animation.set({ChannelPart::GlobalTranslation, 2, 0}, track(-2.0, 2.0));
        Scene scene = *Scene::fromNodes(nodes);
        scene.setTimeline({24.0, 0, 47, PlayLoop::Loop, number(0.0, 1.0) < 0.7});
        return scene;
    }

    std::mt19937 random;
};

} // namespace

/// Player, viewport and files show the same moment of the same scene, to the bit.
class TestSameMoment : public QObject
{
    Q_OBJECT
private:
    /// The meshes of one node in a picture where they stand in the world, marks aside.
    static std::vector<TriangleMesh> seen(const RenderScene& picture, NodeId node)
    {
        std::vector<TriangleMesh> meshes;
        for (const MeshItem& item : posed(picture).meshes)
            if (item.node == node && !item.isMark)
                meshes.push_back(transformed(*item.mesh, item.world));
        return meshes;
    }
    static void compareTree(const RenderScene& picture, EvaluatedScene& now, NodeId node)
    {
        ExportOptions options;
        options.nodes = {node};
        const auto files = test::flatExport(now, options);
        QVERIFY(files);
        const std::vector<TriangleMesh> shown = seen(picture, node);
        QCOMPARE(files->meshes.size(), shown.size());
        for (std::size_t i = 0; i < shown.size(); ++i)
            QVERIFY2(files->meshes[i].mesh->positions == shown[i].positions, files->meshes[i].name.c_str());
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void everybodySeesTheSame_data()
    {
        QTest::addColumn<unsigned>("seed");
        for (const unsigned seed : {1U, 2U, 3U})
            QTest::addRow("%u", seed) << seed;
    }
    void everybodySeesTheSame()
    {
        QFETCH(unsigned, seed);
        RandomScene made(seed);
        Document document;
        Recompute recompute(&document);
        recompute.setRest(0);
        Player player(&document);
        document.reset(made.make(), {});
        QVERIFY(recompute.waitForFull(patienceMs));
        const Scene& scene = document.scene();
        const auto resultOf = [&document](NodeId id) {
            const NodeResult* result = document.result(id);
            return result ? &result->tree : nullptr;
        };
        TreePipeline pipeline;
        Evaluator evaluator(pipelineSource(pipeline), scene.timeline());
        SceneBuilder builder;
        for (const qint64 frame : {qint64(made.number(1.0, 20.0)), qint64(47),
                                   qint64(made.number(26.0, 46.0)), qint64(made.number(1.0, 20.0))}) {
            player.seek(frame);
            QVERIFY(player.waitForIdle(patienceMs));
            const MotionFrame& motion = *player.motion();
            QCOMPARE(motion.frame, frame);
            SceneView view;
            view.timeSeconds = player.timeSeconds();
            const RenderScene picture = MovingScene().moved(builder.build(scene, resultOf, view), motion);
            EvaluatedScene now = evaluator.at(scene, player.timeSeconds());
            QVERIFY(now.poseArms());
            for (std::size_t i = 0; i < scene.nodes().size(); ++i) {
                const Node& node = scene.nodes()[i];
                QVERIFY(motion.geometryOf(scene, node.id) == now.transforms()[i].geometry);
                QVERIFY(now.transforms(node).geometry == now.transforms()[i].geometry);
            }
            for (const NodeId tree : {still, windy}) {
                QVERIFY(motion.of(tree)->moves());
                compareTree(picture, now, tree);
            }
            const std::vector<ArmJoint>& joints = now.params(*scene.find(arm)).joints;
            QCOMPARE(motion.of(arm)->arm->angles, armAngles(joints));
            std::vector<RigidTransform> bones;
            ArmChain(joints).pose(bones);
            for (const MeshItem& item : picture.meshes) {
                if (item.node == arm && !item.isMark)
                    QVERIFY(*item.motion.bones == bones);
                if (item.node == box)
                    QVERIFY(item.mesh->positions ==
                            objectMesh(*scene.find(box), now.params(*scene.find(box)))->positions);
            }
        }
    }
};

QTEST_MAIN(TestSameMoment)

#include "tst_same_moment.moc"
