#include "core/surface/check/collisions.h"
#include "core/surface/check/mesh_analysis.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include "tests/support/preset_trees.h"
#include "tests/support/solids.h"
#include "tests/support/suite.h"
#include <cmath>
#include <glm/geometric.hpp>

namespace tst_collisions {

using namespace ramure;
using namespace ramure::test;

/// Where branches that collide do, and how deep; the analysis as a whole.
class TestCollisions : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }
    void contactsOfStraightTubes();
    void contactsOfTubesWithoutLength();
    void crossingTwigsAreFound();
    void presetsListTheDeepestFirst_data();
    void presetsListTheDeepestFirst();
    void meshesFromFilesHaveNoBranches();
    void cancelStops();
    void theSameOnAnyNumberOfThreads();
};

namespace {

BranchTube straight(const glm::dvec3& from, const glm::dvec3& to, double a0, double a1)
{
    return branchTube({from, to, to - from, to - from}, a0, a1);
}

/// A trunk, two boughs from it, and from each bough a twig; the twigs cross at (0, 3, 0) up to \p gap in z.
Skeleton crossingTwigs(double gap, double radius = 0.05)
{
    Skeleton s;
    s.add(noIndex, {0, 0, 0}, {0, 1, 0}, 0.1, 0.1);
    s.add(0, {0, 1, 0}, {-1, 2, 0}, 0.1, radius);
    s.add(0, {0, 1, 0}, {1, 2, gap}, 0.1, radius);
    s.add(1, {-1, 2, 0}, {1, 4, 0}, radius, radius);
    s.add(2, {1, 2, gap}, {-1, 4, gap}, radius, radius);
    return s;
}

Expected<MeshAnalysis> analysisOf(const Skeleton& skeleton, unsigned threads = 0)
{
    const auto built = buildBranchMesh(skeleton, {});
    return built ? analyseMesh(*built, skeleton, threads) : fail(built.error());
}

} // namespace

void TestCollisions::contactsOfStraightTubes()
{
    const BranchTube along = straight({-1, 0, 0}, {1, 0, 0}, 0.2, 0.2);
    const auto depth = [&](const BranchTube& other) { return tubeContact(along, other).depth; };
    QVERIFY(std::abs(depth(straight({0, -1, 0.25}, {0, 1, 0.25}, 0.1, 0.1)) - 0.05) < 1e-12);
    QVERIFY(std::abs(depth(straight({0, -1, 0}, {0, 1, 0}, 0.1, 0.1)) - 0.3) < 1e-12);
    QVERIFY(std::abs(depth(straight({-1, 1, 0}, {1, 1, 0}, 0.1, 0.1)) + 0.7) < 1e-12); // parallel
    QVERIFY(std::abs(depth(straight({2, 0, 0}, {3, 0, 0}, 0.1, 0.1)) + 0.7) < 1e-12);  // end to end
    const TubeContact cone = tubeContact(along, straight({0.5, 0.5, 0}, {0.5, 0.3, 0}, 0.0, 0.4));
    QVERIFY(std::abs(cone.depth - 0.3) < 1e-12);
    QVERIFY(glm::distance(cone.onFirst, glm::dvec3(0.5, 0, 0)) < 1e-12);
    QVERIFY(glm::distance(cone.onSecond, glm::dvec3(0.5, 0.3, 0)) < 1e-12);
    QVERIFY(std::abs(cone.radiusFirst - 0.2) < 1e-12 && std::abs(cone.radiusSecond - 0.4) < 1e-12);
}

void TestCollisions::contactsOfTubesWithoutLength()
{
    const BranchTube point = straight({0, 0, 0}, {0, 0, 0}, 0.1, 0.1);
    QVERIFY(std::abs(tubeContact(point, point).depth - 0.2) < 1e-12);
    const BranchTube tube = straight({1, -1, 0}, {1, 1, 0}, 0.1, 0.1);
    QVERIFY(std::abs(tubeContact(point, tube).depth + 0.8) < 1e-12);
    QVERIFY(std::abs(tubeContact(tube, point).depth + 0.8) < 1e-12);
}

void TestCollisions::crossingTwigsAreFound()
{
    const auto apart = analysisOf(crossingTwigs(0.2));
    QVERIFY2(apart, why(apart));
    QCOMPARE(apart->crossings.total(), std::uint64_t(0));
    QVERIFY(apart->collisions.empty());
    for (const double gap : {0.0, 0.03, 0.06}) {
        const auto found = analysisOf(crossingTwigs(gap));
        QVERIFY2(found, why(found));
        QCOMPARE(found->crossings.total(), found->crossings.count(ramure::PairKind::Far));
        QCOMPARE(found->collisions.size(), std::size_t(1));
        const Collision& collision = found->collisions.front();
        QCOMPARE(collision.first, Index(3));
        QCOMPARE(collision.second, Index(4));
        QCOMPARE(collision.facePairs, found->crossings.total());
        QVERIFY(std::abs(collision.depth - (0.1 - gap)) < 0.02); // curves that lean out a little
        // The curves mirror each other in the plane x = 0.
        QVERIFY(std::abs(collision.place.x) < 0.02 && std::abs(collision.place.z - gap / 2) < 0.02);
        QVERIFY(collision.place.y > 2.5 && collision.place.y < 4.0);
    }
}

void TestCollisions::presetsListTheDeepestFirst_data()
{
    QTest::addColumn<QString>("name");
    for (const char* name : {"TinyTree", "SmallTree", "FanTree", "Fern2D"})
        QTest::newRow(name) << name;
}

void TestCollisions::presetsListTheDeepestFirst()
{
    QFETCH(QString, name);
    const auto skeleton = presetSkeleton({name.toStdString()});
    const auto found = analysisOf(*skeleton);
    QVERIFY2(found, why(found));
    QCOMPARE(found->collisions.size(), found->crossings.branches.size());
    QVERIFY(!found->collisions.empty());
    double before = 1e9;
    for (const Collision& collision : found->collisions) {
        QVERIFY(collision.first < collision.second && collision.second < skeleton->size());
        QVERIFY(collision.facePairs > 0);
        QVERIFY(collision.depth >= 0.0 && collision.depth <= before);
        before = collision.depth;
    }
}

void TestCollisions::meshesFromFilesHaveNoBranches()
{
    const auto found = analyseMesh(joined(box({0, 0, 0}, {1, 1, 1}), box({0.5, 0.5, 0.5}, {2, 2, 2})));
    QVERIFY2(found, why(found));
    QVERIFY(found->crossings.total() > 0);
    QVERIFY(!found->crossings.kindsKnown);
    QVERIFY(found->collisions.empty());
    QVERIFY(found->hash != MeshHash{});
}

void TestCollisions::cancelStops()
{
    std::stop_source stop;
    stop.request_stop();
    const auto found = analyseMesh(torus(40, 20), 1, Progress{stop.get_token(), {}});
    QVERIFY(!found && found.error().code == ErrorCode::Cancelled);
}

void TestCollisions::theSameOnAnyNumberOfThreads()
{
    const auto skeleton = presetSkeleton({"SmallTree"});
    const auto one = analysisOf(*skeleton, 1), many = analysisOf(*skeleton, 7);
    QVERIFY(one && many && one->sameFindings(*many));
}

RAMURE_SUITE(TestCollisions)

} // namespace tst_collisions

#include "tst_collisions.moc"
