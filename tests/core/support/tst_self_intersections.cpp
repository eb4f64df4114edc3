#include "tests/support/self_intersections.h"
#include "tests/support/solids.h"
#include "tests/support/suite.h"

namespace tst_self_intersections {

using namespace ramure;
using namespace ramure::test;

/// Hand-made meshes whose intersecting pairs can be counted by eye.
class TestSelfIntersections : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }
    void soundMeshesHaveNone();
    void crossingBoxes();
    void touchingBoxesCount();
    void nestedBoxesDoNotMeet();
    void oneSharedVertex_data();
    void oneSharedVertex();
    void sharedEdge_data();
    void sharedEdge();
    void sharedFaceCounts();
    void hairsBreadthIsDecidedExactly();
    void kinds();
    void firstBandBelongsToTheChild();
    void whereSiblingsMeetTheClosestKindCounts();
    void repairsMoveChildren();
};

namespace {

TriangleMesh soup(std::vector<glm::vec3> positions, std::vector<glm::uvec3> triangles)
{
    TriangleMesh mesh;
    mesh.positions = std::move(positions);
    mesh.triangles = std::move(triangles);
    return mesh;
}

/// Two triangles through each other, the first of branches \p a, the second of branches \p b.
TriangleMesh crossing(std::vector<Index> a, const std::vector<Index>& b)
{
    TriangleMesh mesh = soup({{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}, {0, -1, 0}, {0, 1, 0}, {0.1f, 1, 0.5f}},
                             {{0, 1, 2}, {3, 4, 5}});
    mesh.branch = std::move(a);
    mesh.branch.insert(mesh.branch.end(), b.begin(), b.end());
    return mesh;
}

} // namespace

void TestSelfIntersections::soundMeshesHaveNone()
{
    QVERIFY(findSelfIntersections({}).pairs.empty());
    QVERIFY(findSelfIntersections(box({0, 0, 0}, {1, 2, 3})).pairs.empty());
    QVERIFY(findSelfIntersections(torus(40, 20)).pairs.empty());
}

void TestSelfIntersections::crossingBoxes()
{
    // A rod of square section pierces two opposite sides of a box, away from their diagonals: each of its
    // four sides (two triangles each) meets one triangle of each pierced side; a rod side's diagonal lets
    // both triangles pass or not.
    const TriangleMesh rod = box({-1, 0.6f, 0.2f}, {2, 0.7f, 0.3f});
    const TriangleMesh mesh = joined(box({0, 0, 0}, {1, 1, 1}), rod);
    const SelfIntersections found = findSelfIntersections(mesh);
    QCOMPARE(found.pairs.size(),
             std::size_t(2 * 8)); // 2 pierced sides x 4 rod sides x 2 triangles at the diagonal
    QCOMPARE(found.same, 16u);
    for (const IntersectingPair& pair : found.pairs)
        QVERIFY(pair.first < 12 && pair.second >= 12);
}

void TestSelfIntersections::touchingBoxesCount()
{
    QVERIFY(findSelfIntersections(joined(box({0, 0, 0}, {1, 1, 1}), box({1, 0.25f, 0.25f}, {2, 0.5f, 0.5f})))
                .same > 0);
    QVERIFY(findSelfIntersections(joined(box({0, 0, 0}, {1, 1, 1}), box({1.0001f, 0, 0}, {2, 1, 1})))
                .pairs.empty());
}

void TestSelfIntersections::nestedBoxesDoNotMeet()
{
    QVERIFY(
        findSelfIntersections(joined(box({0, 0, 0}, {4, 4, 4}), box({1, 1, 1}, {2, 2, 2}))).pairs.empty());
}

void TestSelfIntersections::oneSharedVertex_data()
{
    QTest::addColumn<float>("height");
    QTest::addColumn<float>("reach");
    QTest::addColumn<Index>("expected");
    QTest::newRow("apart beyond the vertex") << 1.0f << 2.0f << 0u;
    QTest::newRow("the second pierces the first") << -1.0f << 1.0f << 1u;
    QTest::newRow("the second ends on the first") << 0.0f << 1.0f << 1u;
    QTest::newRow("the first ends inside the second") << -1.0f << 3.0f << 1u;
}

void TestSelfIntersections::oneSharedVertex()
{
    QFETCH(float, height);
    QFETCH(float, reach);
    QFETCH(Index, expected);
    // The first lies in y = 0 and opens along +X from the shared vertex; the second stands up from it, its
    // lower corner at `height` below or above the first.
    const TriangleMesh mesh = soup(
        {{0, 0, 0}, {2, 0, -2}, {2, 0, 2}, {reach, 1.5f, 0}, {reach, height, 0.1f}}, {{0, 1, 2}, {0, 3, 4}});
    QCOMPARE(findSelfIntersections(mesh).same, expected);
}

void TestSelfIntersections::sharedEdge_data()
{
    QTest::addColumn<glm::vec3>("apex");
    QTest::addColumn<Index>("expected");
    QTest::newRow("flat, other side") << glm::vec3(0, 0, -1) << 0u;
    QTest::newRow("folded, not flat") << glm::vec3(0, 1e-6f, 1) << 0u;
    QTest::newRow("folded flat") << glm::vec3(0.25f, 0, 0.5f) << 1u;
}

void TestSelfIntersections::sharedEdge()
{
    QFETCH(glm::vec3, apex);
    QFETCH(Index, expected);
    const TriangleMesh mesh = soup({{-1, 0, 0}, {1, 0, 0}, {0, 0, 1}, apex}, {{0, 1, 2}, {1, 0, 3}});
    QCOMPARE(findSelfIntersections(mesh).same, expected);
}

void TestSelfIntersections::sharedFaceCounts()
{
    TriangleMesh mesh = soup({{-1, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 2}});
    QCOMPARE(findSelfIntersections(mesh).same, 1u);
}

void TestSelfIntersections::hairsBreadthIsDecidedExactly()
{
    // The last bit of a float decides whether the point touches the triangle's plane.
    const float one = 1.0f, above = std::nextafter(1.0f, 2.0f);
    for (const auto& [y, expected] : {std::pair{one, 1u}, {above, 0u}}) {
        const TriangleMesh mesh =
            soup({{-1, one, -1}, {1, one, -1}, {0, one, 1}, {0, y, 0}, {0, 2, 0}, {0.1f, 2, 0}},
                 {{0, 1, 2}, {3, 4, 5}});
        QCOMPARE(findSelfIntersections(mesh).same, expected);
    }
}

void TestSelfIntersections::kinds()
{
    // 0 root; 1, 2 its children; 3 child of 1; 4 another root
    const std::vector<Index> parent{noIndex, 0, 0, 1, noIndex};
    const auto count = [&](Index a, Index b) {
        const SelfIntersections found = findSelfIntersections(crossing({a, a, a}, {b, b, b}), parent);
        return std::array<Index, 4>{found.same, found.siblings, found.parentChild, found.far};
    };
    const std::array<Index, 4> same{1, 0, 0, 0}, siblings{0, 1, 0, 0}, parentChild{0, 0, 1, 0},
        far{0, 0, 0, 1};
    QVERIFY(count(2, 2) == same);
    QVERIFY(count(1, 2) == siblings);
    QVERIFY(count(1, 3) == parentChild);
    QVERIFY(count(3, 1) == parentChild);
    QVERIFY(count(0, 3) == far);
    QVERIFY(count(2, 3) == far);
    QVERIFY(count(0, 4) == far); // two roots are no siblings
}

void TestSelfIntersections::firstBandBelongsToTheChild()
{
    const std::vector<Index> parent{noIndex, 0, 0, 1};
    QCOMPARE(findSelfIntersections(crossing({0, 0, 1}, {2, 2, 2}), parent).siblings, 1u);
    QCOMPARE(findSelfIntersections(crossing({0, 1, 1}, {0, 0, 1}), parent).same, 1u);
    QCOMPARE(findSelfIntersections(crossing({0, 0, 1}, {3, 1, 1}), parent).parentChild, 1u);
    QCOMPARE(findSelfIntersections(crossing({0, 0, 0}, {0, 0, 2}), parent).parentChild, 1u);
}

void TestSelfIntersections::whereSiblingsMeetTheClosestKindCounts()
{
    const std::vector<Index> parent{noIndex, 0, 0, 1, 2};
    QCOMPARE(findSelfIntersections(crossing({1, 2, 2}, {1, 1, 1}), parent).same, 1u);
    QCOMPARE(findSelfIntersections(crossing({1, 2, 2}, {3, 3, 3}), parent).parentChild, 1u);
    QCOMPARE(findSelfIntersections(crossing({3, 3, 3}, {4, 4, 4}), parent).far, 1u);
}

void TestSelfIntersections::repairsMoveChildren()
{
    Skeleton s;
    const glm::dvec3 o(0.0);
    s.add(noIndex, o, o, 1, 1); // 0
    s.add(0, o, o, 1, 1);       // 1, contracted into 0
    s.add(1, o, o, 1, 1);       // 2
    s.add(1, o, o, 1, 1);       // 3, merged into 2
    s.add(3, o, o, 1, 1);       // 4
    s.add(1, o, o, 1, 1);       // 5, chained behind 3
    const std::vector<RepairNote> notes{{SkeletonRepair::ZeroLengthContracted, 1, 0},
                                        {SkeletonRepair::SiblingsMerged, 3, 2},
                                        {SkeletonRepair::SiblingChained, 5, 3},
                                        {SkeletonRepair::RadiusClamped, 4, noIndex}};
    const std::vector<Index> parent = repairedParents(s, notes);
    QCOMPARE(parent[2], 0u);
    QCOMPARE(parent[4], 2u);
    QCOMPARE(parent[5], 2u);
    QCOMPARE(parent[0], noIndex);
    QCOMPARE(repairedParents(s, {}), s.parent);
}

RAMURE_SUITE(TestSelfIntersections)

} // namespace tst_self_intersections

#include "tst_self_intersections.moc"
