#include "widgets/view/render/tree_ground.h"

#include "core/presets/presets.h"
#include "core/scene/growth_spaces.h"
#include "tests/support/suite.h"
#include "widgets/view/render/scene_builder.h"
#include <algorithm>
#include <cmath>
#include <map>

namespace tst_tree_ground {

using namespace ramure;

namespace {

Node oakOn(NodeId id, double slope)
{
    Node node;
    node.id = id;
    node.kind = NodeKind::Tree;
    node.name = "Oak";
    node.params = *presetParams("EnglishOak");
    node.params.growth.age = 20.0;
    node.params.growth.slope = slope;
    return node;
}

RenderScene built(std::vector<Node> nodes, const SceneView& view = {})
{
    Scene scene = *Scene::fromNodes(std::move(nodes));
    linkGrowthSpaces(scene);
    TreePipeline pipeline;
    std::map<NodeId, TreeResult> results;
    for (const Node& node : scene.nodes())
        if (node.kind == NodeKind::Tree)
            results[node.id] = *pipeline.evaluate(node.params, Stage::Foliage);
    SceneBuilder builder;
    return builder.build(
        scene,
        [&](NodeId id) {
            const auto at = results.find(id);
            return at == results.end() ? nullptr : &at->second;
        },
        view);
}

const MeshItem* itemIn(const RenderScene& scene, std::string_view name)
{
    const auto found =
        std::ranges::find_if(scene.meshes, [&](const MeshItem& item) { return item.material.name == name; });
    return found == scene.meshes.end() ? nullptr : &*found;
}

} // namespace

class TestTreeGround : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void levelGroundHasNoHill()
    {
        const RenderScene scene = built({oakOn(1, 0.0)});
        QVERIFY(!itemIn(scene, "hillside"));
        QCOMPARE(scene.ground, 0.0);
        QCOMPARE(scene.feet.size(), std::size_t(1));
    }

    /// The slope of a tree alone is there to be seen, and is no part of the tree.
    void slopesAreSeen()
    {
        const RenderScene scene = built({oakOn(1, 0.5)});
        const MeshItem* hill = itemIn(scene, "hillside");
        QVERIFY(hill && !hill->pickable && !hill->framed && hill->isMark);
        QVERIFY(scene.ground < -0.1);
        QVERIFY(scene.feet.empty()); // its litter lies on it
        for (const glm::vec3& p : hill->mesh->positions)
            QVERIFY(std::isfinite(p.y));
        QCOMPARE(hill->mesh->colours.size(), hill->mesh->triangles.size());
    }

    /// Grass stands around trees on roots, on their slope too; a switch hides it, and lines have none.
    void treesOnRootsStandInGrass()
    {
        for (const double slope : {0.0, 0.5}) {
            const RenderScene scene = built({oakOn(1, slope)});
            const MeshItem* grass = itemIn(scene, "grass");
            QVERIFY(grass && grass->isGround && grass->isMark && !grass->pickable && !grass->framed);
            QVERIFY(itemIn(scene, "fallen leaves"));
            QVERIFY(!scene.box.empty());
            SceneView bare;
            bare.meadow = false;
            QVERIFY(!itemIn(built({oakOn(1, slope)}, bare), "grass"));
            SceneView lines;
            lines.mode = DisplayMode::Skeleton;
            QVERIFY(!itemIn(built({oakOn(1, slope)}, lines), "grass"));
        }
        Node rootless = oakOn(1, 0.0);
        rootless.params.mesh.roots = 0;
        QVERIFY(!itemIn(built({rootless}), "grass"));
    }

    void twoTreesAndTerrainsHaveNone()
    {
        Node other = oakOn(2, 0.3);
        other.params.tree.translation.x = 20.0;
        const RenderScene two = built({oakOn(1, 0.5), other});
        QVERIFY(!itemIn(two, "hillside"));
        QCOMPARE(two.ground, 0.0);
        Node terrain;
        terrain.id = 2;
        terrain.kind = NodeKind::Terrain;
        terrain.name = "Hills";
        terrain.params.terrain.depth = 0.5;
        const RenderScene standing = built({oakOn(1, 0.5), terrain});
        QVERIFY(!itemIn(standing, "hillside"));
        QVERIFY(standing.ground < -0.4); // under the block
    }

    /// Near the foot it is the plane itself, further out it runs into the level ground; it looks up
    /// everywhere.
    void hillsidesAreThePlane()
    {
        for (const double grade : {0.0, 0.2, 0.8, 2.0})
            for (const double reach : {0.01, 0.7, 30.0}) {
                const GroundPlane ground{0.3, {0.6 * grade, -0.8 * grade}};
                const glm::dvec3 foot(1.0, 0.0, -2.0);
                const TriangleMesh hill = hillsideUnder(ground, foot, reach);
                const double base = hillsideBase(ground, foot, reach);
                QCOMPARE(hill.normals.size(), hill.positions.size());
                double far = 0.0;
                for (std::size_t i = 0; i < hill.positions.size(); ++i) {
                    const glm::dvec3 at(hill.positions[i]);
                    const double away = std::hypot(at.x - foot.x, at.z - foot.z);
                    far = std::max(far, away);
                    if (away < 1.6 * reach)
                        QVERIFY(std::abs(ground.above(at)) < 1e-4 * (1.0 + reach));
                    QVERIFY(hill.normals[i].y > 0.0F);
                }
                for (const glm::vec3& p : hill.positions)
                    if (std::hypot(double(p.x) - foot.x, double(p.z) - foot.z) > 0.999 * far)
                        QVERIFY(double(p.y) < base);
            }
    }
};

RAMURE_SUITE(TestTreeGround)

} // namespace tst_tree_ground

#include "tst_tree_ground.moc"
