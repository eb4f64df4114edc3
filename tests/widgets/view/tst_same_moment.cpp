#include "core/evaluate/evaluator.h"
#include "core/qt/document/document.h"
#include "core/qt/session/jobs/recompute.h"
#include "core/qt/session/motion/player.h"
#include "core/rig/arm/arm_chain.h"
#include "core/scene/object_mesh.h"
#include "core/surface/mesh/transformed.h"
#include "tests/support/flat_export.h"
#include "tests/support/random_scene.h"
#include "tests/support/suite.h"
#include "widgets/view/moving_scene.h"
#include "widgets/view/render/scene_builder.h"

namespace tst_same_moment {

using namespace ramure;
using test::RandomScene;

namespace {

constexpr int patienceMs = test::patience(60'000);
constexpr NodeId still = RandomScene::still, windy = RandomScene::windy, arm = RandomScene::arm,
                 box = RandomScene::box;

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
                QVERIFY(now.transforms(node.id).geometry == now.transforms()[i].geometry);
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

RAMURE_SUITE(TestSameMoment)

} // namespace tst_same_moment

#include "tst_same_moment.moc"
