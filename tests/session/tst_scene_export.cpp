#include "core/evaluate/evaluator.h"
#include "core/presets/presets.h"
#include "core/qt/session/export/exporter.h"
#include "core/qt/session/motion/sequence.h"
#include "core/rig/arm/arm_chain.h"
#include "core/scene/arm_demo.h"
#include "core/surface/proof/validate.h"
#include "tests/support/flat_export.h"
#include "tests/support/solids.h"
#include "tests/support/suite.h"

#include <QFile>
#include <QTemporaryDir>
#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

namespace tst_scene_export {

using namespace ramure;

namespace {

Node nodeOf(NodeKind kind, NodeId id, std::string name)
{
    Node node;
    node.id = id;
    node.kind = kind;
    node.name = std::move(name);
    if (kind == NodeKind::Mesh)
        node.mesh = SharedValue<TriangleMesh>(test::box({-1, 0, -1}, {1, 2, 1}));
    if (kind == NodeKind::Tree) {
        node.params = *presetParams("SmallTree");
        node.params.grammar.iterations = 4;
        node.params.foliage.leavesCutoff = 0.6;
    }
    return node;
}

Expected<TreeResult> noTrees(const Node& node, Stage, const Progress&)
{
    return fail(ErrorCode::Invalid, "%1 is no tree", {node.name});
}

const TriangleMesh* meshOf(const FlatScene& set, const std::string& name)
{
    for (const MeshPart& part : set.parts())
        if (part.name == name)
            return part.mesh;
    return nullptr;
}

double farthest(const TriangleMesh& mesh, const glm::dvec3& from)
{
    double most = 0.0;
    for (const glm::vec3& p : mesh.positions)
        most = std::max(most, glm::distance(glm::dvec3(p), from));
    return most;
}

double nearest(const TriangleMesh& mesh, const glm::dvec3& to)
{
    double least = std::numeric_limits<double>::max();
    for (const glm::vec3& p : mesh.positions)
        least = std::min(least, glm::distance(glm::dvec3(p), to));
    return least;
}

} // namespace

/// Arms, terrains, primitives and imported meshes in files.
class TestSceneExport : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void badNodesAreNamed()
    {
        Node arm = nodeOf(NodeKind::Arm, 1, "Crane");
        arm.params.joints[1].length = -1.0;
        auto set = test::flatExport(Evaluator(noTrees).at(*Scene::fromNodes({arm})), {});
        QVERIFY(!set);
        QCOMPARE(set.error().path, std::string("Crane: joints[1].length"));
        arm = nodeOf(NodeKind::Arm, 1, "Crane");
        arm.params.armSkin.radius = 0.0;
        QCOMPARE(test::flatExport(Evaluator(noTrees).at(*Scene::fromNodes({arm})), {}).error().path,
                 std::string("Crane: armSkin.radius"));
        TriangleMesh lost;
        lost.positions = {{0, 0, 0}, {1, 0, 0}};
        lost.triangles = {{0, 1, 7}};
        arm = nodeOf(NodeKind::Arm, 1, "Crane");
        arm.mesh = SharedValue<TriangleMesh>(lost);
        QCOMPARE(test::flatExport(Evaluator(noTrees).at(*Scene::fromNodes({arm})), {}).error().path,
                 std::string("Crane: mesh"));
        Node land = nodeOf(NodeKind::Terrain, 1, "Land");
        land.params.terrain.size = -2.0;
        QCOMPARE(test::flatExport(Evaluator(noTrees).at(*Scene::fromNodes({land})), {}).error().path,
                 std::string("Land: terrain.size"));
        land.params.terrain.size = 2.0;
        land.params.tree.scale.x = 0.0;
        QCOMPARE(test::flatExport(Evaluator(noTrees).at(*Scene::fromNodes({land})), {}).error().path,
                 std::string("Land: tree.scale"));
        for (const double bad : {std::numeric_limits<double>::quiet_NaN(), 1e9})
            QVERIFY(!test::flatExport(
                Evaluator(noTrees).at(*Scene::fromNodes({nodeOf(NodeKind::Arm, 1, "A")}), bad), {}));
        QVERIFY(!test::flatExport(Evaluator(noTrees).at(*Scene::fromNodes({nodeOf(NodeKind::Group, 1, "G")})),
                                  {}));
    }

    void everyNodeIsAnObjectWithItsName()
    {
        const auto scene = Scene::fromNodes(
            {nodeOf(NodeKind::Tree, 1, "Oak"), nodeOf(NodeKind::Arm, 2, "Crane"),
             nodeOf(NodeKind::Terrain, 3, "Land"), nodeOf(NodeKind::Primitive, 4, "Box"),
             nodeOf(NodeKind::Primitive, 5, "Box"), nodeOf(NodeKind::Mesh, 6, "leaves"),
             nodeOf(NodeKind::Primitive, 7, "Box_2"), nodeOf(NodeKind::Group, 8, "Nothing")});
        TreePipeline pipeline;
        const auto set = test::flatExport(Evaluator(pipelineSource(pipeline)).at(*scene), {});
        QVERIFY(set);
        std::vector<std::string> names;
        for (const MeshPart& part : set->parts())
            names.push_back(part.name);
        const std::vector<std::string> wanted{"branches", "leaves", "Crane",    "Land",
                                              "Box",      "Box_2",  "leaves_2", "Box_2_2"};
        if (!std::count(names.begin(), names.end(), "fruit")) // chance
            QCOMPARE(names.size(), wanted.size());
        names.erase(std::remove(names.begin(), names.end(), "fruit"), names.end());
        QCOMPARE(names, wanted);
        // Without the tree's parts nothing but the nodes is left.
        ExportOptions two;
        two.nodes = {3, 6};
        const auto chosen = test::flatExport(Evaluator(noTrees).at(*scene), two);
        QVERIFY(chosen);
        QCOMPARE(chosen->meshes.size(), std::size_t(2));
        QCOMPARE(chosen->meshes[1].name, std::string("leaves")); // no tree takes the name
    }

    void anArmStandsUprightWhereItsNodeIs()
    {
        Node arm = nodeOf(NodeKind::Arm, 1, "Crane");
        arm.params.arm.follows = false;
        arm.params.tree.translation = {10.0, 1.0, -3.0};
        arm.params.tree.scale = glm::dvec3(2.0);
        const auto set = test::flatExport(Evaluator(noTrees).at(*Scene::fromNodes({arm})), {});
        QVERIFY(set);
        const TriangleMesh& mesh = *meshOf(*set, "Crane");
        const auto report = validateMesh(mesh);
        QVERIFY(report && report->valid);
        QCOMPARE(report->components, Index(1));
        // The centre of its end is the tip: (x, z, -y) of the arm's own space, doubled and moved (SPEC C1).
        const glm::dvec3 tip = glm::dvec3(1.7177032, 3.4335330, -2.0079169) * 2.0 + glm::dvec3(10, 1, -3);
        QVERIFY(nearest(mesh, tip) < 1e-5);
        QVERIFY(nearest(mesh, {10.0, 1.0, -3.0}) < 1e-5);
    }

    void theSkinIsAsItIsAtTheTime()
    {
        Scene scene = armDemo();
        Node& arm = *scene.find(1);
        const glm::dvec3 target(arm.params.arm.target.x, arm.params.arm.target.z, -arm.params.arm.target.y);
        const auto at = [&scene](double seconds) {
            return *meshOf(*test::flatExport(Evaluator(noTrees).at(scene, seconds), {}), "Arm");
        };
        QVERIFY(nearest(at(0.0), target) > 0.5);
        QVERIFY(nearest(at(5.0), target) < 1e-3); // the centre of the end is the tip
        // It stands still where it does not follow.
        arm.params.arm.follows = false;
        QCOMPARE(at(5.0), at(0.0));
    }

    void aRunThatIsKeptGivesTheSame()
    {
        const Scene scene = armDemo();
        Evaluator kept;
        for (const double seconds : {0.5, 1.0, 0.25, 3.0, 0.0})
            QCOMPARE(*meshOf(*test::flatExport(kept.at(scene, seconds), {}), "Arm"),
                     *meshOf(*test::flatExport(Evaluator().at(scene, seconds), {}), "Arm"));
        // Another target is another run.
        Scene other = scene;
        other.find(1)->params.arm.target = {0.5, 0.5, 2.0};
        const auto joints = kept.joints(*other.find(1), 5.0);
        QVERIFY(joints);
        QVERIFY(glm::distance(ArmChain(*joints).tip(), glm::dvec3(0.5, 0.5, 2.0)) < 1e-3);
        EvaluatedScene turned = kept.at(other, 5.0);
        QVERIFY(turned.poseArms());
        QCOMPARE(turned.params(*other.find(1)).joints, *joints);
        QCOMPARE(turned.params(*other.find(2)), other.find(2)->params);
    }

    void anArmWithoutSkinIsItsJointsAndRods()
    {
        Node arm = nodeOf(NodeKind::Arm, 1, "Crane");
        arm.params.armSkin.shown = false;
        const auto set = test::flatExport(Evaluator(noTrees).at(*Scene::fromNodes({arm})), {});
        QVERIFY(set);
        const auto report = validateMesh(*meshOf(*set, "Crane"));
        QVERIFY(report && report->valid);
        QCOMPARE(report->components, Index(7)); // three joints, three rods, the tip
        QVERIFY(farthest(*meshOf(*set, "Crane"), glm::dvec3(0.0)) < 4.4 + 0.2);
    }

    /// What bends on its way is in the scene once, with its skin; nothing is flattened before a format asks.
    void aClipHasItsFramesOnTheSameMeshes()
    {
        Scene scene = armDemo();
        Node tree = nodeOf(NodeKind::Tree, 50, "Oak");
        tree.params.tree.translation = {3.0, 0.0, 0.0};
        QVERIFY(scene.insert({tree}, noNode, 0));
        TreePipeline pipeline;
        const auto source = pipelineSource(pipeline);
        ExportOptions options;
        options.texture = true;
        QVERIFY(!collectExport(Evaluator(source).at(scene, std::nan("")), options));
        options.clip = {0.5, std::nan("")};
        QVERIFY(!collectExport(Evaluator(source).at(scene), options));
        options.clip = {0.5, 1.5};
        Evaluator evaluator(source);
        const auto clip = collectExport(evaluator.at(scene), options);
        QVERIFY2(clip, test::why(clip));
        QCOMPARE(clip->nodes.size(), scene.nodes().size());
        QCOMPARE(clip->frames.size(), std::size_t(3));
        options.clip.clear();
        for (const std::size_t frame : {0, 1, 2}) {
            const ExportFrame& then = clip->frames[frame];
            const auto alone = test::flatExport(Evaluator(source).at(scene, then.seconds), options);
            QVERIFY(alone);
            const FlatScene flat = flattened(*clip, frame);
            QCOMPARE(flat.meshes.size(), alone->meshes.size());
            for (std::size_t i = 0; i < flat.meshes.size(); ++i) {
                const TriangleMesh &mesh = *flat.meshes[i].mesh, &other = *alone->meshes[i].mesh;
                QCOMPARE(flat.meshes[i].name, alone->meshes[i].name);
                QCOMPARE(flat.meshes[i].material, alone->meshes[i].material);
                QCOMPARE(mesh.uv, other.uv);
                if (then.seconds > 0.0)
                    QCOMPARE(mesh, other);
                for (std::size_t v = 0; v < mesh.positions.size(); ++v)
                    QVERIFY(glm::distance(mesh.positions[v], other.positions[v]) < 1e-5F);
            }
        }
        const auto skinned = [](const ExportMesh& mesh) { return mesh.skin != nullptr; };
        QVERIFY(std::ranges::count_if(clip->meshes, skinned) >= 3); // branches, leaves, the arm
    }

    void theSkeletonHasTheChain()
    {
        ExportOptions options;
        options.model = ExportModel::Skeleton;
        const auto set = collectExport(Evaluator(noTrees).at(armDemo()), options);
        QVERIFY(set && set->lines);
        QCOMPARE(set->lines->lines.size(), std::size_t(3));
        QVERIFY(glm::distance(set->lines->positions.back(), glm::vec3(1.7177032, 3.4335330, -2.0079169)) <
                1e-5F);
        QVERIFY(!test::flatExport(
            Evaluator(noTrees).at(*Scene::fromNodes({nodeOf(NodeKind::Terrain, 1, "L")})), options));
    }

    void sequencesFollowTheArm()
    {
        QTemporaryDir folder;
        const std::string file = QFile::encodeName(folder.filePath("arm.obj")).toStdString();
        QVERIFY(exportSequence(armDemo(), {}, {0, 48, 24}, noTrees, file));
        std::vector<QByteArray> frames;
        for (const std::int64_t frame : {0, 24, 48}) {
            QFile written(QFile::decodeName(numberedFile(file, frame).c_str()));
            QVERIFY(written.open(QIODevice::ReadOnly));
            frames.push_back(written.readAll());
            QVERIFY(frames.back().contains("\no Arm\n") && frames.back().contains("\no Terrain\n"));
        }
        QVERIFY(frames[0] != frames[1] && frames[1] != frames[2]);
        QVERIFY(estimatedFileBytes(armDemo(), {}, noTrees, file) > 100'000);
        QVERIFY(estimatedFileBytes(armDemo(), {}, noTrees, file) <
                static_cast<std::uint64_t>(frames[0].size()) * 2);
    }
};

RAMURE_SUITE(TestSceneExport)

} // namespace tst_scene_export

#include "tst_scene_export.moc"
