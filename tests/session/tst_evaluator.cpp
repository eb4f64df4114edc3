#include "core/evaluate/evaluator.h"
#include "core/presets/presets.h"
#include "core/qt/document/commands.h"
#include "core/qt/session/jobs/recompute.h"
#include "core/qt/session/motion/player.h"
#include "core/rig/pose/skin.h"
#include "tests/support/flat_export.h"
#include "tests/support/suite.h"
#include <cmath>
#include <limits>

namespace tst_evaluator {

using namespace ramure;

/// Trees at a time, for files: the same as what the player shows.
class TestEvaluator : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnAnyWarning(); }
    void badTimesAreErrors();
    void errorsOfTheRestAreHandedOn();
    void zeroIsRest();
    void partsMoveTogether();
    void itIsWhatThePlayerShows();
    void anyOrderOfTimes();
    void movedMeshesAreValid_data();
    void movedMeshesAreValid();
    void exportTakesIt();
    void textureStaysThatOfTheRest();
    void runsShareTheMemory();
};

static Node treeNode(const char* preset)
{
    Node node;
    node.id = 1;
    node.kind = NodeKind::Tree;
    node.name = preset;
    node.params = presetParams(preset).value_or(NodeParams{});
    return node;
}

/// However many trees move, all states together keep to the budget; one tree may have all of it.
void TestEvaluator::runsShareTheMemory()
{
    constexpr std::size_t budget = std::size_t(1) << 20;
    TreePipeline pipeline;
    Node node = treeNode("TinyTree");
    const auto play = [&](int trees) {
        Evaluator source(pipelineSource(pipeline), {}, budget);
        for (int frame = 1; frame <= 40; ++frame)
            for (int i = 0; i < trees; ++i) {
                node.id = NodeId(i + 1);
                const auto moved = source.tree(node, Stage::Foliage, 0.5 * frame);
                QTest::qVerify(moved.has_value(), "moved", test::why(moved), __FILE__, __LINE__);
            }
        return source.bytes();
    };
    const std::size_t one = play(1);
    QVERIFY2(one > budget / 4 && one <= budget, qPrintable(QString::number(one)));
    const std::size_t five = play(5);
    QVERIFY2(five > budget / 4 && five <= budget, qPrintable(QString::number(five)));
}

void TestEvaluator::badTimesAreErrors()
{
    TreePipeline pipeline;
    Evaluator source(pipelineSource(pipeline));
    const Node node = treeNode("TinyTree");
    for (const double time : {std::nan(""), std::numeric_limits<double>::infinity(), 1e12}) {
        const auto tree = source.tree(node, Stage::Foliage, time);
        QVERIFY(!tree);
        QCOMPARE(tree.error().code, ErrorCode::Invalid);
    }
}

void TestEvaluator::errorsOfTheRestAreHandedOn()
{
    TreePipeline pipeline;
    Evaluator source(pipelineSource(pipeline));
    Node node = treeNode("TinyTree");
    node.params.grammar.axiom.assign(1, '[');
    const auto tree = source.tree(node, Stage::Foliage, 1.0);
    QVERIFY(!tree);
    std::stop_source stop;
    stop.request_stop();
    const auto stopped = source.tree(treeNode("TinyTree"), Stage::Foliage, 1.0, {stop.get_token(), {}});
    QVERIFY(!stopped);
    QCOMPARE(stopped.error().code, ErrorCode::Cancelled);
}

void TestEvaluator::zeroIsRest()
{
    TreePipeline pipeline;
    Evaluator source(pipelineSource(pipeline));
    const Node node = treeNode("TinyTree");
    const auto rest = pipelineSource(pipeline)(node, Stage::Foliage, {});
    const auto now = source.tree(node, Stage::Foliage, 0.0);
    QVERIFY(rest && now);
    QCOMPARE(now->branches, rest->branches);
    const auto before = source.tree(node, Stage::Foliage, -3.0);
    QCOMPARE(before->branches, rest->branches);
}

/// Lengths stay; every end of a branch is where its parent's end is, in both skeletons.
void TestEvaluator::partsMoveTogether()
{
    TreePipeline pipeline;
    Evaluator source(pipelineSource(pipeline));
    const Node node = treeNode("SmallTree");
    const auto rest = pipelineSource(pipeline)(node, Stage::Foliage, {});
    const auto now = source.tree(node, Stage::Foliage, 1.5);
    QVERIFY(rest && now);
    const Skeleton& skeleton = now->simplified->skeleton;
    double moved = 0.0;
    for (Index b = 0; b < skeleton.size(); ++b) {
        const double length = rest->simplified->skeleton.length(b);
        QVERIFY(std::abs(skeleton.length(b) - length) < 1e-6 * length);
        if (skeleton.parent[b] != noIndex)
            QVERIFY(glm::length(skeleton.p0[b] - skeleton.p1[skeleton.parent[b]]) < 1e-9);
        moved = std::max(moved, glm::length(skeleton.p1[b] - rest->simplified->skeleton.p1[b]));
    }
    QVERIFY(moved > 0.05);
    QCOMPARE(now->skeleton->size(), rest->skeleton->size());
    for (Index b = 0; b < now->skeleton->size(); ++b)
        if (now->skeleton->parent[b] != noIndex)
            QVERIFY(glm::length(now->skeleton->p0[b] - now->skeleton->p1[now->skeleton->parent[b]]) < 1e-6);
    for (Index b = 0; b < skeleton.size(); ++b)
        QVERIFY(glm::length(now->sections->of(b).back().centre - skeleton.p1[b]) < 1e-9);
    QCOMPARE(now->leaves->triangles, rest->leaves->triangles);
}

void TestEvaluator::itIsWhatThePlayerShows()
{
    Document document;
    Recompute recompute(&document);
    recompute.setRest(0);
    Player player(&document);
    const Node node = treeNode("TinyTree");
    const auto id = edit::insertNodes(document, {node}, noNode, 0);
    QVERIFY(recompute.waitForFull(test::patience(20000)));
    player.seek(31);
    QVERIFY(player.waitForIdle(20000));
    const NodeMotion& shown = *player.motion()->of(*id);

    TreePipeline pipeline;
    Evaluator source(pipelineSource(pipeline));
    const auto now = source.tree(node, Stage::Foliage, player.timeSeconds());
    QVERIFY(now);
    const TriangleMesh meant = deformed(shown.mesh->mesh, *shown.branches, *shown.bones, shown.method);
    QVERIFY(now->branches->mesh == meant);
    QVERIFY(*now->leaves == deformed(*shown.leavesMesh, *shown.leaves, *shown.bones, shown.method));
}

void TestEvaluator::anyOrderOfTimes()
{
    TreePipeline pipeline;
    const Node node = treeNode("TinyTree");
    Evaluator ahead(pipelineSource(pipeline)), back(pipelineSource(pipeline));
    std::map<double, std::shared_ptr<const BranchMesh>> meshes;
    for (const double time : {0.3, 0.6, 0.9})
        meshes[time] = ahead.tree(node, Stage::Mesh, time)->branches;
    for (const double time : {0.9, 0.3, 0.6})
        QVERIFY(back.tree(node, Stage::Mesh, time)->branches->mesh == meshes[time]->mesh);
}

void TestEvaluator::movedMeshesAreValid_data()
{
    QTest::addColumn<QString>("preset");
    for (const char* preset : {"SmallTree", "FanTree", "TinyTree", "Fern2D"})
        QTest::newRow(preset) << preset;
}

void TestEvaluator::movedMeshesAreValid()
{
    QFETCH(QString, preset);
    TreePipeline pipeline;
    Evaluator source(pipelineSource(pipeline));
    const Node node = treeNode(qPrintable(preset));
    for (const double time : {0.5, 2.0}) {
        const auto now = source.tree(node, Stage::Mesh, time);
        QVERIFY(now);
        const MeshReport& report = *now->report;
        QCOMPARE(report.boundaryEdges + report.nonManifoldEdges + report.nonManifoldVertices +
                     report.inconsistentEdges + report.duplicateVertices + report.duplicateFaces,
                 Index(0));
        QVERIFY(report.valid);
    }
}

void TestEvaluator::exportTakesIt()
{
    Scene scene;
    QVERIFY(scene.insert({treeNode("TinyTree")}, noNode, 0));
    TreePipeline pipeline;
    Evaluator source(pipelineSource(pipeline));
    for (const ExportModel model : {ExportModel::Mesh, ExportModel::Rough, ExportModel::Skeleton}) {
        ExportOptions options;
        options.model = model;
        const auto rest = test::flatExport(source.at(scene, 0.0), options);
        const auto now = test::flatExport(source.at(scene, 1.0), options);
        QVERIFY(rest && now);
        QCOMPARE(now->meshes.size(), rest->meshes.size());
        for (std::size_t i = 0; i < now->meshes.size(); ++i) {
            QCOMPARE(now->meshes[i].mesh->triangles, rest->meshes[i].mesh->triangles);
            QVERIFY(now->meshes[i].mesh->positions != rest->meshes[i].mesh->positions);
        }
    }
}

void TestEvaluator::textureStaysThatOfTheRest()
{
    Scene scene;
    QVERIFY(scene.insert({treeNode("TinyTree")}, noNode, 0));
    TreePipeline pipeline;
    Evaluator source(pipelineSource(pipeline));
    ExportOptions options;
    options.texture = true;
    const auto rest = test::flatExport(source.at(scene, 0.0), options);
    const auto now = test::flatExport(source.at(scene, 1.0), options);
    QVERIFY(rest && now);
    QCOMPARE(now->meshes.size(), rest->meshes.size());
    for (std::size_t i = 0; i < now->meshes.size(); ++i) {
        const TriangleMesh &moved = *now->meshes[i].mesh, &still = *rest->meshes[i].mesh;
        QVERIFY(moved.positions != still.positions);
        QVERIFY(!moved.uv.empty());
        QVERIFY(moved.uv == still.uv && moved.uvTriangles == still.uvTriangles);
    }
    const Node& node = scene.nodes().front();
    const auto still = source.tree(node, Stage::Mesh, 0.0), moved = source.tree(node, Stage::Mesh, 1.0);
    QVERIFY(still && moved);
    QCOMPARE(moved->texture, still->texture); // computed once for both
    QVERIFY(moved->branches->mesh.positions != still->branches->mesh.positions);
}

RAMURE_SUITE(TestEvaluator)

} // namespace tst_evaluator

#include "tst_evaluator.moc"
