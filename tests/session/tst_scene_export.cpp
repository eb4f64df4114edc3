#include "core/params/presets.h"
#include "core/rig/arm/arm_chain.h"
#include "core/scene/arm_demo.h"
#include "core/session/exporter.h"
#include "core/session/moving_arms.h"
#include "core/session/sequence.h"
#include "core/surface/proof/validate.h"
#include "tests/support/solids.h"
#include "tests/support/suite.h"

#include <QFile>
#include <QTemporaryDir>
#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

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

const TriangleMesh* meshOf(const ExportSet& set, const std::string& name)
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
        auto set = collectExport(*Scene::fromNodes({arm}), {}, noTrees);
        QVERIFY(!set);
        QCOMPARE(set.error().path, std::string("Crane: joints[1].length"));
        arm = nodeOf(NodeKind::Arm, 1, "Crane");
        arm.params.armSkin.radius = 0.0;
        QCOMPARE(collectExport(*Scene::fromNodes({arm}), {}, noTrees).error().path,
                 std::string("Crane: armSkin.radius"));
        TriangleMesh lost;
        lost.positions = {{0, 0, 0}, {1, 0, 0}};
        lost.triangles = {{0, 1, 7}};
        arm = nodeOf(NodeKind::Arm, 1, "Crane");
        arm.mesh = SharedValue<TriangleMesh>(lost);
        QCOMPARE(collectExport(*Scene::fromNodes({arm}), {}, noTrees).error().path,
                 std::string("Crane: mesh"));
        Node land = nodeOf(NodeKind::Terrain, 1, "Land");
        land.params.terrain.size = -2.0;
        QCOMPARE(collectExport(*Scene::fromNodes({land}), {}, noTrees).error().path,
                 std::string("Land: terrain.size"));
        land.params.terrain.size = 2.0;
        land.params.tree.scale.x = 0.0;
        QCOMPARE(collectExport(*Scene::fromNodes({land}), {}, noTrees).error().path,
                 std::string("Land: tree.scale"));
        ExportOptions never;
        never.timeSeconds = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(!collectExport(*Scene::fromNodes({nodeOf(NodeKind::Arm, 1, "A")}), never, noTrees));
        ExportOptions late;
        late.timeSeconds = 1e9;
        QVERIFY(!collectExport(*Scene::fromNodes({nodeOf(NodeKind::Arm, 1, "A")}), late, noTrees));
        QVERIFY(!collectExport(*Scene::fromNodes({nodeOf(NodeKind::Group, 1, "G")}), {}, noTrees));
    }

    void everyNodeIsAnObjectWithItsName()
    {
        const auto scene = Scene::fromNodes(
            {nodeOf(NodeKind::Tree, 1, "Oak"), nodeOf(NodeKind::Arm, 2, "Crane"),
             nodeOf(NodeKind::Terrain, 3, "Land"), nodeOf(NodeKind::Primitive, 4, "Box"),
             nodeOf(NodeKind::Primitive, 5, "Box"), nodeOf(NodeKind::Mesh, 6, "leaves"),
             nodeOf(NodeKind::Primitive, 7, "Box_2"), nodeOf(NodeKind::Group, 8, "Nothing")});
        TreePipeline pipeline;
        const auto set = collectExport(*scene, {}, pipelineSource(pipeline));
        QVERIFY(set);
        std::vector<std::string> names;
        for (const MeshPart& part : set->parts())
            names.push_back(part.name);
        const std::vector<std::string> wanted{"branches", "leaves", "Crane",    "Land",
                                              "Box",      "Box_2",  "leaves_2", "Box_2_2"};
        if (!std::count(names.begin(), names.end(), "apples")) // chance
            QCOMPARE(names.size(), wanted.size());
        names.erase(std::remove(names.begin(), names.end(), "apples"), names.end());
        QCOMPARE(names, wanted);
        // Without the tree's parts nothing but the nodes is left.
        ExportOptions two;
        two.nodes = {3, 6};
        const auto chosen = collectExport(*scene, two, noTrees);
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
        const auto set = collectExport(*Scene::fromNodes({arm}), {}, noTrees);
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
        ExportOptions options;
        const auto tipAway = [&](double seconds) {
            options.timeSeconds = seconds;
            return nearest(*meshOf(*collectExport(scene, options, noTrees), "Arm"), target);
        };
        QVERIFY(tipAway(0.0) > 0.5);
        QVERIFY(tipAway(5.0) < 1e-3); // the centre of the end is the tip
        // It stands still where it does not follow.
        arm.params.arm.follows = false;
        options.timeSeconds = 0.0;
        const auto rest = collectExport(scene, options, noTrees);
        options.timeSeconds = 5.0;
        QCOMPARE(*meshOf(*collectExport(scene, options, noTrees), "Arm"), *meshOf(*rest, "Arm"));
    }

    void aRunThatIsKeptGivesTheSame()
    {
        const Scene scene = armDemo();
        MovingArms kept;
        for (const double seconds : {0.5, 1.0, 0.25, 3.0, 0.0}) {
            ExportOptions fresh;
            fresh.timeSeconds = seconds;
            ExportOptions going = fresh;
            going.arms = &kept;
            QCOMPARE(*meshOf(*collectExport(scene, going, noTrees), "Arm"),
                     *meshOf(*collectExport(scene, fresh, noTrees), "Arm"));
        }
        // Another target is another run.
        Scene other = scene;
        other.find(1)->params.arm.target = {0.5, 0.5, 2.0};
        const auto joints = kept.jointsAt(*other.find(1), 5.0);
        QVERIFY(joints);
        QVERIFY(glm::distance(ArmChain(*joints).tip(), glm::dvec3(0.5, 0.5, 2.0)) < 1e-3);
        const auto turned = kept.at(other, 5.0);
        QVERIFY(turned);
        QCOMPARE(turned->find(1)->params.joints, *joints);
        QCOMPARE(*turned->find(2), *other.find(2));
    }

    void anArmWithoutSkinIsItsJointsAndRods()
    {
        Node arm = nodeOf(NodeKind::Arm, 1, "Crane");
        arm.params.armSkin.shown = false;
        const auto set = collectExport(*Scene::fromNodes({arm}), {}, noTrees);
        QVERIFY(set);
        const auto report = validateMesh(*meshOf(*set, "Crane"));
        QVERIFY(report && report->valid);
        QCOMPARE(report->components, Index(7)); // three joints, three rods, the tip
        QVERIFY(farthest(*meshOf(*set, "Crane"), glm::dvec3(0.0)) < 4.4 + 0.2);
    }

    void theSkeletonHasTheChain()
    {
        ExportOptions options;
        options.model = ExportModel::Skeleton;
        const auto set = collectExport(armDemo(), options, noTrees);
        QVERIFY(set && set->lines);
        QCOMPARE(set->lines->lines.size(), std::size_t(3));
        QVERIFY(glm::distance(set->lines->positions.back(), glm::vec3(1.7177032, 3.4335330, -2.0079169)) <
                1e-5F);
        QVERIFY(!collectExport(*Scene::fromNodes({nodeOf(NodeKind::Terrain, 1, "L")}), options, noTrees));
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

QTEST_GUILESS_MAIN(TestSceneExport)
#include "tst_scene_export.moc"
