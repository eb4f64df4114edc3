#include "core/surface/foliage/place_foliage.h"
#include "tests/support/preset_trees.h"
#include "tests/support/suite.h"
#include "widgets/view/render/crowd/mesh_copies.h"
#include "widgets/view/render/light/crown_light.h"
#include <algorithm>

namespace tst_mesh_copies {

using namespace ramure;

namespace {

glm::vec3 placed(const MeshCopy& copy, const glm::vec3& point)
{
    return copy.position +
           glm::quat(copy.turn.w, copy.turn.x, copy.turn.y, copy.turn.z) * (copy.size * point);
}

} // namespace

/// Copies are drawn in place of the merged mesh: they must be that mesh. The light in a crown is found from
/// them.
class TestMeshCopies : public QObject
{
    Q_OBJECT

    Skeleton m_skeleton;
    Foliage m_foliage;

private slots:
    void initTestCase()
    {
        m_skeleton = test::presetSkeleton({.name = "SmallTree", .iterations = 6}).value_or(Skeleton{});
        LeafParams leaf;
        leaf.shape = LeafShape::Linden;
        m_foliage = placeFoliage(m_skeleton, {}, leaf, {}, 0.5).value_or(Foliage{});
        QVERIFY(m_foliage.leaves.size() > 50);
    }
    void init() { test::failOnAnyWarning(); }
    void nothingIsCopiedOfNothing()
    {
        QVERIFY(leafCopies({}, 0.5, FoliageModel::Fine).copies.empty());
        QVERIFY(appleCopies({}, 0.5, FoliageModel::Rough).copies.empty());
        QVERIFY(leafCopies(m_foliage, 0.5, FoliageModel::Fine, {false}).copies.empty());
        QVERIFY(crownLight({}, 0.5).light.empty());
        Foliage one = m_foliage;
        one.leaves.resize(1); // in a box without a size
        QVERIFY(crownLight(one, 0.5).light.empty());
    }
    void togetherTheyAreTheMergedMesh()
    {
        const TriangleMesh merged = buildLeaves(m_skeleton, m_foliage, 0.5, FoliageModel::Fine);
        const MeshCopies made = leafCopies(m_foliage, 0.5, FoliageModel::Fine);
        QCOMPARE(std::size_t(made.faces().count) * made.copies.size(), merged.triangles.size());
        Index all = 0;
        for (const LeafDetail how : {LeafDetail::All, LeafDetail::Few, LeafDetail::Least}) {
            QCOMPARE(made.faces(how).from, all);
            all += made.faces(how).count;
        }
        QCOMPARE(made.shape.faceCount(), all);
        QVERIFY(made.faces(LeafDetail::Few).count < made.faces().count);
        QCOMPARE(made.faces(LeafDetail::Least).count, 2u);
        for (std::size_t i = 0; i < made.copies.size(); ++i)
            for (Index f = 0; f < made.faces().count; ++f) {
                const std::size_t face = made.pieceOf(i) * made.faces().count + f;
                for (int corner = 0; corner < 3; ++corner) {
                    const Index vertex = made.shape.triangles[f][corner];
                    const Index other = merged.triangles[face][corner];
                    QVERIFY(glm::distance(placed(made.copies[i], made.shape.positions[vertex]),
                                          merged.positions[other]) < 1e-5f);
                    QCOMPARE(made.copies[i].branch, merged.branch[other]);
                    const glm::vec3 colour =
                        glm::vec3(made.colours[vertex]) * glm::vec3(made.copies[i].tint) / 255.0f;
                    const glm::vec3 away = glm::abs(colour - glm::vec3(merged.colours[face]));
                    QVERIFY(std::max({away.r, away.g, away.b}) < 2.0f);
                }
            }
    }
    /// From far away a shoot still has a card for each of its leaves, and is as large as one of them is seen.
    void shootsStayLeavesFromFarAway()
    {
        LeafParams leaf;
        leaf.shape = LeafShape::Linden;
        const auto reachOf = [&](std::int64_t perShoot) {
            leaf.perShoot = perShoot;
            const Foliage foliage = placeFoliage(m_skeleton, {}, leaf, {}, 0.5).value_or(Foliage{});
            const MeshCopies made = leafCopies(foliage, 0.5, FoliageModel::Fine);
            if (perShoot > 1) { // two triangles a leaf, and three of the stem
                const Index least = made.faces(LeafDetail::Least).count;
                if (least != Index(2 * perShoot) + 3)
                    qWarning("%u triangles", least);
            }
            return made.reach;
        };
        const float single = reachOf(1);
        for (const std::int64_t perShoot : {2, 5, 12})
            QVERIFY(std::abs(reachOf(perShoot) / single - 1.0F) < 0.35F);
    }
    void theFirstOnesAreSpreadOverTheTree()
    {
        const MeshCopies made = leafCopies(m_foliage, 0.5, FoliageModel::Fine);
        const std::size_t count = made.copies.size(), some = 10;
        std::vector<std::size_t> first;
        for (std::size_t i = 0; i < some; ++i)
            first.push_back(made.pieceOf(i));
        std::ranges::sort(first);
        for (std::size_t i = 1; i < some; ++i)
            QVERIFY(first[i] - first[i - 1] < 3 * count / some);
    }
    void aCrownIsDarkInsideAndLooksOutside()
    {
        const CrownLight crown = crownLight(m_foliage, 0.5);
        const std::size_t cells =
            std::size_t(crown.cells.x) * std::size_t(crown.cells.y) * std::size_t(crown.cells.z);
        QCOMPARE(crown.light.size(), cells);
        const auto darkest =
            std::ranges::min_element(crown.light, {}, [](const glm::u8vec4& c) { return c.a; });
        const glm::u8vec4 corner = crown.light.back(); // above, in the free air
        QVERIFY(corner.a > 200 && darkest->a < 160);
        QVERIFY(corner.r > 128 && corner.g > 128 && corner.b > 128); // outwards
        for (const FoliageItem& leaf : m_foliage.leaves) {
            const glm::dvec3 at(crown.place * glm::dvec4(leaf.position, 1.0));
            QVERIFY(glm::all(glm::greaterThan(at, glm::dvec3(0.0))) &&
                    glm::all(glm::lessThan(at, glm::dvec3(1.0))));
        }
    }
};

RAMURE_SUITE(TestMeshCopies)

} // namespace tst_mesh_copies

#include "tst_mesh_copies.moc"
