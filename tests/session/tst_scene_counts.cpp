#include "core/presets/presets.h"
#include "core/qt/session/export/scene_counts.h"
#include "core/scene/kinds/node_kinds.h"
#include "tests/support/flat_export.h"
#include "tests/support/solids.h"
#include "tests/support/suite.h"

namespace tst_scene_counts {

using namespace ramure;

/// What the status bar counts is what an export writes.
class TestSceneCounts : public QObject
{
    Q_OBJECT

private:
    static Node nodeOf(NodeKind kind, NodeId id)
    {
        Node node;
        node.id = id;
        node.kind = kind;
        node.name = "Node " + std::to_string(id);
        if (kind == NodeKind::Mesh)
            node.mesh = SharedValue<TriangleMesh>(test::box({-1, 0, -1}, {1, 2, 1}));
        if (kind == NodeKind::Tree)
            node.params = *presetParams("TinyTree");
        return node;
    }
    static PartCount exported(const Scene& scene, TreePipeline& pipeline)
    {
        PartCount count;
        const auto set = test::flatExport(Evaluator(pipelineSource(pipeline)).at(scene), {});
        for (const FlatScene::Entry& entry : set->meshes) {
            count.vertices += entry.mesh->vertexCount();
            count.faces += entry.mesh->faceCount();
        }
        return count;
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void everyPartCountsAsItIsExported()
    {
        Scene scene = *Scene::fromNodes({nodeOf(NodeKind::Tree, 1), nodeOf(NodeKind::Arm, 2),
                                         nodeOf(NodeKind::Terrain, 3), nodeOf(NodeKind::Primitive, 4),
                                         nodeOf(NodeKind::Mesh, 5), nodeOf(NodeKind::Tree, 6)});
        TreePipeline pipeline;
        SceneCounter counter;
        const auto count = [&] { return counter.count(scene, {}, pipelineSource(pipeline)); };
        SceneCounts counts = count();
        QVERIFY(counts.complete);
        QVERIFY(counts.total() == exported(scene, pipeline));
        QVERIFY(counts.of(ScenePart::Branches).faces > 0);
        for (const NodeKindRow* row : nodeKinds())
            QCOMPARE(counts.of(row->kind).faces > 0, isShape(row->kind));
        // What is hidden is not written; what hangs below it neither.
        scene.find(6)->visible = scene.find(2)->visible = false;
        const SceneCounts fewer = count();
        QVERIFY(fewer.total() == exported(scene, pipeline));
        QCOMPARE(2 * fewer.of(ScenePart::Branches).faces, counts.of(ScenePart::Branches).faces);
        QCOMPARE(fewer.of(NodeKind::Arm).faces, std::uint64_t(0));
        // A shape that changes is counted anew, one that moves as before.
        scene.find(3)->params.terrain.divisions /= 2;
        scene.find(4)->params.tree.translation = {1.0, 2.0, 3.0};
        counts = count();
        QVERIFY(counts.total() == exported(scene, pipeline));
        QVERIFY(counts.of(NodeKind::Terrain).faces < fewer.of(NodeKind::Terrain).faces);
    }

    void treesWithoutAResultAreSaid()
    {
        const Scene scene = *Scene::fromNodes({nodeOf(NodeKind::Tree, 1), nodeOf(NodeKind::Mesh, 2)});
        const SceneCounts counts = SceneCounter().count(
            scene, {}, [](const Node&, Stage, const Progress&) { return fail(ErrorCode::Invalid, "later"); });
        QVERIFY(!counts.complete);
        QCOMPARE(counts.total().faces, std::uint64_t(12));
    }
};

RAMURE_SUITE(TestSceneCounts)

} // namespace tst_scene_counts

#include "tst_scene_counts.moc"
