#include "core/scene/standing_ground.h"

#include "core/pipeline/stage_hashes.h"
#include "core/presets/presets.h"
#include "core/scene/growth_spaces.h"
#include "core/surface/primitives/terrain.h"
#include "tests/support/suite.h"
#include <cmath>
#include <limits>

namespace tst_standing_ground {

using namespace ramure;

namespace {

Node node(NodeId id, NodeKind kind, const glm::dvec3& at = glm::dvec3(0.0))
{
    Node out;
    out.id = id;
    out.kind = kind;
    out.name = "Node";
    out.params.tree.translation = at;
    return out;
}

Node tree(const glm::dvec3& at = glm::dvec3(0.0))
{
    Node out = node(1, NodeKind::Tree, at);
    out.params = presetParams("EnglishOak").value();
    out.params.tree.translation = at;
    return out;
}

/// As steep as it is turned.
Node tilted(double aboutZ)
{
    Node out = node(2, NodeKind::Terrain);
    out.params.terrain.height = 0.0;
    out.params.tree.rotation.z = aboutZ;
    return out;
}

Node rock(GrowthRole role, const glm::dvec3& size, const glm::dvec3& at)
{
    Node out = node(3, NodeKind::Primitive, at);
    out.params.primitive.shape = PrimitiveShape::Box;
    out.params.primitive.size = size;
    out.params.growthRole = role;
    return out;
}

std::optional<GroundPlane> groundIn(std::vector<Node> nodes)
{
    Scene scene = *Scene::fromNodes(std::move(nodes));
    linkGrowthSpaces(scene);
    return scene.nodes().front().params.ground.nearby();
}

} // namespace

class TestStandingGround : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void whatCannotBeStoodOnIsNoGround()
    {
        QVERIFY(!groundIn({tree()}));
        QVERIFY(!groundIn({tree({0, 5, 0}), tilted(0.0)}));
        QVERIFY(!groundIn({tree({900, 0, 0}), tilted(0.0)}));
        QVERIFY(!groundIn({tree(), tilted(0.5 * 3.14159265358979)})); // it stands on its edge
        Node wrong = tilted(0.0);
        wrong.params.terrain.size = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(!groundIn({tree(), wrong}));
        Node flat = tilted(0.3);
        flat.params.tree.scale = {1.0, 0.0, 1.0};
        (void)groundIn({tree(), flat});
        QVERIFY(!groundIn({tree(), rock(GrowthRole::None, {4, 2, 4}, {0, -1, 0})}));
        QVERIFY(!groundIn({tree(), rock(GrowthRole::Envelope, {4, 2, 4}, {0, -1, 0})}));
        Node bare = tree();
        bare.params.mesh.roots = 0;
        QVERIFY(!groundIn({bare, tilted(0.3)}));
    }

    void terrainsAreGround()
    {
        for (const double turn : {-0.6, 0.0, 0.3, 0.9}) {
            const auto ground = groundIn({tree(), tilted(turn)});
            QVERIFY(ground);
            QVERIFY(std::abs(ground->height) < 1e-9);
            QVERIFY2(std::abs(ground->grade.x - std::tan(turn)) < 1e-6,
                     qPrintable(QString::number(ground->grade.x)));
            QVERIFY(std::abs(ground->grade.y) < 1e-6);
        }
        const auto aside = groundIn({tree({1.0, 0.7, 2.0}), tilted(0.6)});
        QVERIFY(aside && std::abs(aside->height - (std::tan(0.6) - 0.7)) < 1e-6);
    }

    /// On hills it is the plane that they are near the foot.
    void hillsAreMetWhereTheyAre()
    {
        Node hills = node(2, NodeKind::Terrain, {0.3, -0.1, 0.2});
        const auto heights = TerrainHeights::of(hills.params.terrain);
        QVERIFY(heights);
        const double x = 1.7, z = -2.1, y = heights->at(x, z) - 0.1;
        const auto ground = groundIn({tree({x + 0.3, y, z + 0.2}), hills});
        QVERIFY(ground);
        QVERIFY2(std::abs(ground->height) < 1e-9, qPrintable(QString::number(ground->height)));
        const double slope = (heights->at(x + 0.6, z) - heights->at(x - 0.6, z)) / 1.2;
        QVERIFY2(std::abs(ground->grade.x - slope) < 0.25, qPrintable(QString::number(ground->grade.x)));
    }

    void rocksAreGround()
    {
        const auto ground = groundIn({tree(), rock(GrowthRole::Obstacle, {4, 2, 4}, {0, -1.05, 0})});
        QVERIFY(ground);
        QVERIFY(std::abs(ground->height + 0.05) < 1e-6);
        QCOMPARE(ground->grade, glm::dvec2(0.0));
        // On the very edge of a cliff what is not there counts for nothing.
        const auto edge = groundIn({tree(), rock(GrowthRole::Obstacle, {4, 2, 4}, {-1.99, -1.0, 0})});
        QVERIFY(edge && std::abs(edge->grade.x) < 1e-6);
        // Of several the nearest.
        const auto nearest =
            groundIn({tree(), tilted(0.3), rock(GrowthRole::Obstacle, {4, 2, 4}, {0, -1.1, 0})});
        QVERIFY(nearest && std::abs(nearest->grade.x - std::tan(0.3)) < 1e-6);
    }

    /// What the scene says goes before the slope that a tree grows on, and only the mesh is made anew.
    void theSceneGoesFirst()
    {
        Node own = tree();
        own.params.growth.slope = 0.4;
        own.params.growth.slopeDirection = 0.0; // falls along X
        const auto alone = groundOf(own.params);
        QVERIFY(alone && std::abs(alone->grade.x + std::tan(0.4)) < 1e-12 && alone->grade.y == 0.0);
        own.params.growth.slopeDirection = 1.5707963267948966; // against Z
        QVERIFY(std::abs(groundOf(own.params)->grade.y - std::tan(0.4)) < 1e-9);
        Scene scene = *Scene::fromNodes({own, tilted(0.2)});
        QCOMPARE(staleGrounds(scene).size(), std::size_t(1));
        const StageHashes before(scene.nodes().front().params);
        linkGrowthSpaces(scene);
        QVERIFY(staleGrounds(scene).empty());
        const NodeParams& linked = scene.nodes().front().params;
        QVERIFY(std::abs(groundOf(linked)->grade.x - std::tan(0.2)) < 1e-6);
        const StageHashes after(linked);
        QCOMPARE(after[Stage::Skeleton], before[Stage::Skeleton]);
        QVERIFY(after[Stage::Mesh] != before[Stage::Mesh]);
        scene.find(2)->params.tree.translation.y = -50.0;
        linkGrowthSpaces(scene);
        QVERIFY(!scene.nodes().front().params.ground.nearby());
        NodeParams level;
        QVERIFY(!groundOf(level));
    }
};

RAMURE_SUITE(TestStandingGround)

} // namespace tst_standing_ground

#include "tst_standing_ground.moc"
