#include "core/qt/document/commands.h"
#include "core/qt/document/document.h"
#include "core/qt/document/project/project_file.h"
#include "core/scene/growth_spaces.h"
#include "core/scene/standing_ground.h"
#include "tests/support/suite.h"
#include <QTemporaryDir>

namespace tst_growth_document {

using namespace ramure;

/// Trees that grow around solids follow them through edits, undo and files.
class TestGrowthDocument : public QObject
{
    Q_OBJECT

    static Node node(NodeId id, NodeKind kind, const char* name)
    {
        Node made;
        made.id = id;
        made.kind = kind;
        made.name = name;
        if (kind == NodeKind::Tree)
            made.params.generator.kind = EditOperation::Colonisation;
        return made;
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void treesGrowAnewWhereSolidsChange()
    {
        Document document;
        const NodeId tree = *edit::insertNodes(document, {node(1, NodeKind::Tree, "Tree")}, noNode, 0);
        const NodeId other = *edit::insertNodes(document, {node(1, NodeKind::Tree, "Other")}, noNode, 0);
        QVERIFY(edit::setParam(document, {other}, *findParam("generator.kind"), EnumValue{"weber_penn"}));
        const NodeId box = *edit::insertNodes(document, {node(1, NodeKind::Primitive, "Box")}, tree, 0);
        const Scene before = document.scene();
        const auto space = [&] { return document.scene().find(tree)->params.colonisation.space; };
        QVERIFY(space().hash == 0);

        std::vector<NodeId> regrown;
        connect(&document, &Document::changed, this, [&](const Change& change) {
            if (change.has(changeParams) && change.firstStale == Stage::Skeleton)
                regrown.insert(regrown.end(), change.nodes.begin(), change.nodes.end());
        });
        QVERIFY(edit::setParam(document, {box}, *findParam("solid.growth"), EnumValue{"obstacle"}));
        QCOMPARE(regrown, std::vector<NodeId>{tree});
        QCOMPARE(document.shapeRevision(tree), document.revision());
        const GrowthSpaceLink around = space();
        QVERIFY(around.hash != 0);

        QVERIFY(edit::setParam(document, {box}, *findParam("tree.translation"), glm::dvec3(3, 1, 0)));
        QVERIFY(!(space() == around));
        document.undo();
        QVERIFY(space() == around);
        QCOMPARE(regrown.size(), std::size_t(3));
        QVERIFY(edit::removeNodes(document, {box}));
        QVERIFY(space().hash == 0);
        document.undo();
        QVERIFY(space() == around);
        document.undo();
        QVERIFY(document.scene() == before);

        regrown.clear();
        QVERIFY(edit::setParam(document, {box}, *findParam("surface.color"), glm::dvec3(1, 0, 0)));
        QVERIFY(edit::setNodeVisible(document, {box}, false));
        QVERIFY(regrown.empty()); // nothing that matters to growth
    }
    /// The trunk of a tree that fills a solid is as thick as that is high, and its ground is measured around.
    void groundsFollowTheSolids()
    {
        std::vector<Node> nodes{node(1, NodeKind::Tree, "Tree"), node(2, NodeKind::Primitive, "Crown"),
                                node(3, NodeKind::Terrain, "Hill")};
        nodes[0].params.colonisation.envelope = CrownEnvelope::Solid;
        nodes[0].params.mesh.roots = 4;
        nodes[1].parent = 1;
        nodes[1].params.growthRole = GrowthRole::Envelope;
        Document document;
        document.reset(*Scene::fromNodes(nodes), {});
        const StandingGround before = document.scene().find(1)->params.ground;
        QVERIFY(before.hash != 0);
        QVERIFY(edit::setParam(document, {2}, *findParam("tree.translation"), glm::dvec3(0, 5, 0)));
        QVERIFY(!(document.scene().find(1)->params.ground == before));
        QVERIFY(staleGrounds(document.scene()).empty());
        document.undo();
        QVERIFY(document.scene().find(1)->params.ground == before);
    }
    /// Of trees that grow by years, what one says of its crown concerns the others; its leaves do not.
    void neighboursFollowEachOther()
    {
        Document document;
        std::vector<Node> trees{node(1, NodeKind::Tree, "One"), node(2, NodeKind::Tree, "Two")};
        for (Node& tree : trees) {
            tree.params.generator.kind = EditOperation::Growth;
            tree.params.growth.neighbours = true;
        }
        trees[1].params.tree.translation.x = 3.0;
        document.reset(*Scene::fromNodes(trees), {});
        const auto link = [&](NodeId id) { return document.scene().find(id)->params.growth.space; };
        const GrowthSpaceLink one = link(1), two = link(2);
        QCOMPARE(one.neighbours.size(), std::size_t(1));
        QVERIFY(edit::setParam(document, {2}, *findParam("foliage.leavesDensity"), std::int64_t(3)));
        QVERIFY(link(1) == one && link(2) == two);
        QVERIFY(edit::setParam(document, {2}, *findParam("growth.height"), 5.0));
        QCOMPARE(link(1).neighbours.front().height, 5.0);
        QVERIFY(edit::setParam(document, {2}, *findParam("tree.translation"), glm::dvec3(4, 0, 0)));
        QCOMPARE(link(1).neighbours.front().foot.x, 4.0);
        QCOMPARE(link(2).neighbours.front().foot.x, -4.0);
        document.undo();
        document.undo();
        document.undo();
        QVERIFY(link(1) == one && link(2) == two);
    }
    /// Vertices are looked at when a mesh is made, not at every edit.
    void aMeshKnowsItsShape()
    {
        TriangleMesh ball;
        ball.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        ball.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
        const SharedValue<TriangleMesh> mesh(ball), same(ball);
        QVERIFY(!(mesh == SharedValue<TriangleMesh>()) && SharedValue<TriangleMesh>().hash() == 0);
        QVERIFY(mesh == same && mesh.pointer() != same.pointer());
        QCOMPARE(mesh.hash(), hashOf(ball));
        ball.positions[0].x = 0.25f;
        const SharedValue<TriangleMesh> other(ball);
        QVERIFY(other.hash() != mesh.hash() && !(other == mesh));

        Document document;
        Node solid = node(2, NodeKind::Mesh, "Solid");
        solid.mesh = mesh;
        solid.params.growthRole = GrowthRole::Obstacle;
        const auto openWith = [&](const SharedValue<TriangleMesh>& wanted) {
            solid.mesh = wanted;
            document.reset(*Scene::fromNodes({node(1, NodeKind::Tree, "Tree"), solid}), {});
            return document.scene().find(1)->params.colonisation.space;
        };
        const GrowthSpaceLink link = openWith(mesh);
        QVERIFY(link.hash != 0 && link.space());
        QVERIFY(openWith(same) == link);
        QVERIFY(!(openWith(other) == link));
        QVERIFY(openWith(SharedValue<TriangleMesh>(TriangleMesh())).hash == 0);
    }
    void filesKnowTheSolidsAlone()
    {
        Document document;
        const NodeId tree = *edit::insertNodes(document, {node(1, NodeKind::Tree, "Tree")}, noNode, 0);
        const NodeId ball = *edit::insertNodes(document, {node(1, NodeKind::Primitive, "Ball")}, tree, 0);
        QVERIFY(edit::setParam(document, {ball}, *findParam("solid.growth"), EnumValue{"envelope"}));
        QVERIFY(edit::setParam(document, {tree}, *findParam("colonisation.envelope"), EnumValue{"solid"}));
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("tree.ramure"));
        QVERIFY(saveProjectFile(document.project(), file));
        const auto read = loadProjectFile(file);
        QVERIFY(read && read->scene == document.scene());
        QVERIFY(read->scene.find(tree)->params.colonisation.space.space());
        Scene bare = read->scene;
        bare.find(tree)->params.colonisation.space = {};
        Document opened;
        opened.reset(bare, file);
        QVERIFY(opened.scene() == document.scene());
    }
};

RAMURE_SUITE(TestGrowthDocument)

} // namespace tst_growth_document

#include "tst_growth_document.moc"
