#include "core/generators/colonisation/colonisation.h"
#include "core/generators/colonisation/crown_shape.h"
#include "core/generators/colonisation/growth_space.h"
#include "core/pipeline/stage_hashes.h"
#include "core/scene/growth_spaces.h"
#include "tests/support/suite.h"
#include <cmath>

namespace tst_growth_spaces {

using namespace ramure;

namespace {

Node tree(NodeId id)
{
    Node node;
    node.id = id;
    node.kind = NodeKind::Tree;
    node.name = "Tree";
    node.params.generator.kind = EditOperation::Colonisation;
    node.params.colonisation.points = 600;
    node.params.colonisation.surface = 0.0;
    return node;
}

Node box(NodeId id, NodeId parent, GrowthRole role, const glm::dvec3& size, const glm::dvec3& at)
{
    Node node;
    node.id = id;
    node.parent = parent;
    node.kind = NodeKind::Primitive;
    node.name = "Box";
    node.params.primitive.shape = PrimitiveShape::Box;
    node.params.primitive.size = size;
    node.params.growthRole = role;
    node.params.tree.translation = at;
    return node;
}

Scene linked(std::vector<Node> nodes)
{
    Scene scene = *Scene::fromNodes(std::move(nodes));
    linkGrowthSpaces(scene);
    return scene;
}

ColonisationParams crown(const Scene& scene)
{
    return scene.nodes().front().params.colonisation;
}

bool isIn(const glm::dvec3& point, const glm::dvec3& centre, const glm::dvec3& size, double slack = 0.0)
{
    const glm::dvec3 off = glm::abs(point - centre) - 0.5 * size;
    return std::max({off.x, off.y, off.z}) <= slack;
}

} // namespace

class TestGrowthSpaces : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void whatCannotBeFilledIsNamed_data()
    {
        QTest::addColumn<int>("wrong");
        QTest::addColumn<QString>("message");
        QTest::newRow("nothing there") << 0 << "below the tree stands no solid";
        QTest::newRow("not below the tree") << 1 << "below the tree stands no solid";
        QTest::newRow("open") << 2 << "Box is not closed";
        QTest::newRow("below the ground") << 3 << "Box lies below the foot";
        QTest::newRow("out of sight") << 4 << "comes within sight";
        QTest::newRow("walled in") << 5 << "leave no room";
    }
    void whatCannotBeFilledIsNamed()
    {
        QFETCH(int, wrong);
        QFETCH(QString, message);
        std::vector<Node> nodes{tree(1)};
        nodes[0].params.colonisation.envelope = CrownEnvelope::Solid;
        const glm::dvec3 at = wrong == 3 ? glm::dvec3(0, -5, 0) : glm::dvec3(wrong == 4 ? 50 : 0, 4, 0);
        if (wrong > 0)
            nodes.push_back(box(2, wrong == 1 ? noNode : 1, GrowthRole::Envelope, {3, 3, 3}, at));
        if (wrong == 2)
            nodes[1].params.primitive.shape = PrimitiveShape::Plane;
        if (wrong == 5)
            nodes.push_back(box(3, noNode, GrowthRole::Obstacle, {4, 4, 4}, at));
        const auto grown = growColonisation(crown(linked(std::move(nodes))), 1);
        QVERIFY(!grown);
        QCOMPARE(grown.error().code, ErrorCode::Invalid);
        QVERIFY2(QString::fromStdString(grown.error().message()).contains(message),
                 grown.error().message().c_str());
        QVERIFY(grown.error().path.starts_with("colonisation."));
    }
    void treesFillTheSolidBelowThem()
    {
        const glm::dvec3 size(4, 2, 6), centre(0.5, 4, 0);
        std::vector<Node> nodes{tree(1), box(2, 1, GrowthRole::Envelope, size, centre)};
        nodes[0].params.colonisation.envelope = CrownEnvelope::Solid;
        nodes[1].visible = false; // counts all the same
        const Scene scene = linked(nodes);
        QCOMPARE(crown(scene).space.top(), 5.0);
        const auto points = crownPoints(crown(scene), 1);
        QCOMPARE(points->size(), std::size_t(600));
        glm::dvec3 mean(0.0);
        for (const glm::dvec3& point : *points) {
            QVERIFY(isIn(point, centre, size));
            mean += point / 600.0;
        }
        QVERIFY(glm::length(mean - centre) < 0.25);
        ColonisationParams skin = crown(scene);
        skin.surface = 1.0;
        const auto onSkin = *crownPoints(skin, 1);
        for (const glm::dvec3& point : onSkin)
            QVERIFY(isIn(point, centre, size, 1e-5) && !isIn(point, centre, size - 1e-5));
        QVERIFY(growColonisation(crown(scene), 1)->size() > 100);

        nodes[1].params.tree.scale = {-1, 1, 1}; // its faces look inward now
        QCOMPARE(crownPoints(crown(linked(nodes)), 1)->size(), std::size_t(600));
        // The tree's own place changes nothing: what is below it moves with it.
        nodes[0].params.tree.translation = {10, 0, -3};
        nodes[0].params.tree.rotation = {0, 1, 0};
        const auto moved = *crownPoints(crown(linked(nodes)), 1);
        for (const glm::dvec3& point : moved)
            QVERIFY(isIn(point, centre, size, 1e-4));
    }
    void noBranchGrowsThroughAnObstacle_data()
    {
        QTest::addColumn<int>("shape");
        QTest::newRow("box") << int(PrimitiveShape::Box);
        QTest::newRow("wall") << int(PrimitiveShape::Plane);
        QTest::newRow("sphere") << int(PrimitiveShape::Sphere);
    }
    void noBranchGrowsThroughAnObstacle()
    {
        QFETCH(int, shape);
        std::vector<Node> nodes{tree(1), box(2, noNode, GrowthRole::Obstacle, {2, 6, 2}, {1.6, 4, 0})};
        nodes[0].params.colonisation.points = 3000;
        nodes[0].params.colonisation.smoothing = 0.0;
        PrimitiveParams& obstacle = nodes[1].params.primitive;
        obstacle.shape = PrimitiveShape(shape);
        obstacle.radius = 1.2;
        if (obstacle.shape == PrimitiveShape::Plane) {
            obstacle.size = {12, 1, 12};
            obstacle.axis = PrimitiveAxis::X;
        }
        const Scene scene = linked(nodes);
        const auto grown = growColonisation(crown(scene), 1);
        QVERIFY2(grown, grown ? "" : grown.error().message().c_str());
        const auto link = crown(scene).space;
        const GrowthSpace& space = *link.space();
        Index past = 0;
        for (Index i = 0; i < grown->size(); ++i) {
            QVERIFY(!space.blocks(grown->p1[i]));
            QVERIFY(!space.blocks(grown->p0[i], grown->p1[i]));
            past += grown->p1[i].x > 1.7;
        }
        const auto alone = growColonisation(tree(1).params.colonisation, 1);
        QVERIFY(alone->size() > 50);
        // Around the box and the sphere, of which more is free; behind the wall is nothing.
        QCOMPARE(past > 0, obstacle.shape != PrimitiveShape::Plane);
    }
    void linksFollowTheScene()
    {
        std::vector<Node> nodes{tree(1), box(2, noNode, GrowthRole::Obstacle, {1, 1, 1}, {1, 3, 0})};
        Scene scene = linked(nodes);
        QVERIFY(staleGrowthSpaces(scene).empty());
        const GrowthSpaceLink before = crown(scene).space;
        const auto hash = [&scene] { return StageHashes(scene.nodes().front().params)[Stage::Skeleton]; };
        const std::uint64_t grownBefore = hash();

        scene.find(2)->params.surface.color = {1, 0, 0};
        scene.find(2)->visible = false;
        QVERIFY(staleGrowthSpaces(scene).empty());
        scene.find(2)->params.tree.translation.x += 0.5;
        QCOMPARE(staleGrowthSpaces(scene).size(), std::size_t(1));
        linkGrowthSpaces(scene);
        QVERIFY(!(crown(scene).space == before) && hash() != grownBefore);
        scene.find(2)->params.tree.translation.x -= 0.5;
        linkGrowthSpaces(scene);
        QVERIFY(crown(scene).space == before && hash() == grownBefore);

        scene.find(1)->params.generator.kind = EditOperation::WeberPenn;
        linkGrowthSpaces(scene);
        QVERIFY(!crown(scene).space.space());
        scene.find(1)->params.generator.kind = EditOperation::Colonisation;
        scene.find(2)->params.growthRole = GrowthRole::None;
        linkGrowthSpaces(scene);
        QVERIFY(crown(scene).space == GrowthSpaceLink());
    }
    /// Trees that grow by years shade each other where they ask for it, in whatever order the scene has them.
    void neighboursShadeEachOther()
    {
        const auto growing = [](NodeId id, double x) {
            Node node = tree(id);
            node.params.generator.kind = EditOperation::Growth;
            node.params.tree.translation = {x, 0.0, 0.0};
            node.params.growth.neighbours = true;
            return node;
        };
        std::vector<Node> nodes{growing(1, 0.0), growing(2, 3.0), growing(3, -4.0), growing(4, 900.0),
                                tree(5)};
        nodes[1].params.growth.neighbours = false;
        const Scene scene = linked(nodes);
        const auto linkOf = [](const Scene& all, NodeId id) { return all.find(id)->params.growth.space; };
        const GrowthSpaceLink first = linkOf(scene, 1);
        QCOMPARE(first.neighbours.size(), std::size_t(2));
        QCOMPARE(first.neighbours[0].foot.x, 3.0);
        QCOMPARE(first.neighbours[1].foot.x, -4.0);
        QVERIFY(first.hash != 0 && !first.space());
        QVERIFY(linkOf(scene, 2) == GrowthSpaceLink());
        QVERIFY(linkOf(scene, 4) == GrowthSpaceLink());
        std::ranges::reverse(nodes);
        QVERIFY(linkOf(linked(nodes), 1) == first);

        Scene moved = scene;
        moved.find(3)->params.tree.translation.z = 1.0;
        QVERIFY(staleGrowthSpaces(moved).contains(1));
        moved.find(3)->params.growth.age = 90.0; // they were planted in the same year, whatever is shown
        linkGrowthSpaces(moved);
        QVERIFY(staleGrowthSpaces(moved).empty());
        moved.find(1)->params.growth.neighbours = false;
        linkGrowthSpaces(moved);
        QVERIFY(linkOf(moved, 1) == GrowthSpaceLink());
    }
    void searchingForPointsCanBeStopped()
    {
        std::vector<Node> nodes{tree(1), box(2, 1, GrowthRole::Envelope, {3, 3, 3}, {0, 3, 0})};
        nodes[0].params.colonisation.envelope = CrownEnvelope::Solid;
        nodes[0].params.colonisation.points = 1'000'000;
        std::stop_source stop;
        stop.request_stop();
        const auto points = crownPoints(crown(linked(std::move(nodes))), 1, {stop.get_token(), {}});
        QCOMPARE(points.error().code, ErrorCode::Cancelled);
    }
};

RAMURE_SUITE(TestGrowthSpaces)

} // namespace tst_growth_spaces

#include "tst_growth_spaces.moc"
