#include "core/generators/grammar/grammar.h"
#include "core/generators/grammar/rewrite.h"
#include "core/generators/grammar/turtle.h"
#include "core/skeleton/simplify.h"
#include "core/surface/mesh/mesh_cleanup.h"
#include "core/surface/mesh/near_positions.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include "tests/support/fork_judge.h"
#include "tests/support/mesh_checker.h"
#include "tests/support/preset_trees.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace tst_build_branch_mesh {

using namespace ramure;
using namespace ramure::test;

/// What the mesher says and does besides being watertight (tst_forks_topology): errors, repairs, where
/// vertices lie, progress.
class TestBuildBranchMesh : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }
    void badOptionsAreErrors();
    void badSkeletonsAreErrors();
    void rootWithoutLengthBecomesAStub();
    void zeroLengthBranchHandsItsChildrenOn();
    void thinBranchesAreThickened();
    void insideOutTreesAreSlimmed();
    void twinRatioDecidesAboutNearTwins();
    void oneBranchIsATubeWithCaps();
    void ringsLieOnTheirCircles();
    void singleChildSharesItsParentsRing();
    void rollTurnsTheRings();
    void manyChildren_data();
    void manyChildren();
    void childrenInOnePlane();
    void deepChain();
    void farFromTheOrigin();
    void scales_data();
    void scales();
    void progressRisesAndCancelStops();
    void cleanupPartsTwinsAndOpensFlatTriangles();
    void placesDrawnTwiceHaveVerticesApart();
    void nothingIsFinerThanTheLeastRadius();
};

namespace {

Skeleton stem(double radius = 0.1)
{
    Skeleton s;
    s.add(noIndex, {0, 0, 0}, {0, 1, 0}, radius, radius);
    return s;
}

bool has(const BranchMesh& built, SkeletonRepair kind, Index branch)
{
    return std::any_of(built.repairs.begin(), built.repairs.end(),
                       [&](const RepairNote& note) { return note.kind == kind && note.branch == branch; });
}

/// Children of branch 0 of a stem, evenly on a cone of this opening, and one in the middle.
Skeleton cone(int children, double angle, double length)
{
    Skeleton s = stem();
    for (int k = 0; k < children; ++k) {
        const double azimuth = 2.0 * std::numbers::pi * k / std::max(1, children - 1);
        const double open = k == children - 1 ? 0.0 : angle;
        const glm::dvec3 way(std::sin(open) * std::cos(azimuth), std::cos(open),
                             std::sin(open) * std::sin(azimuth));
        s.add(0, {0, 1, 0}, glm::dvec3(0, 1, 0) + length * way, 0.1, 0.05, 1);
    }
    return s;
}

} // namespace

void TestBuildBranchMesh::badOptionsAreErrors()
{
    const Skeleton good = stem();
    const auto refused = [&](auto change) {
        BranchMeshOptions options;
        change(options);
        const Expected<BranchMesh> built = buildBranchMesh(good, options);
        return !built && built.error().code == ErrorCode::Invalid && !built.error().message().empty();
    };
    for (const int bad : {-1, 0, 1, 65, 1000000})
        QVERIFY(refused([&](BranchMeshOptions& o) { o.lengthDivisions = bad; }));
    for (const int bad : {-8, 0, 2, 129, std::numeric_limits<int>::max()})
        QVERIFY(refused([&](BranchMeshOptions& o) { o.radialDivisions = bad; }));
    for (const double bad : {double(NAN), double(INFINITY), -0.1})
        QVERIFY(refused([&](BranchMeshOptions& o) { o.nearTwinRatio = bad; }));
    for (const double bad : {double(NAN), double(INFINITY), -0.1, 4.1})
        QVERIFY(refused([&](BranchMeshOptions& o) { o.forkReach = bad; }));
    for (const double bad : {double(NAN), double(INFINITY), -0.1, 10.1})
        QVERIFY(refused([&](BranchMeshOptions& o) { o.forkLength = bad; }));
    for (const double bad : {double(NAN), double(INFINITY), -0.1, 1.1}) {
        QVERIFY(refused([&](BranchMeshOptions& o) { o.forkSoftness = bad; }));
        QVERIFY(refused([&](BranchMeshOptions& o) { o.leastRadius = bad; }));
    }
    const std::vector<double> two{0.0, 0.0}, notANumber{double(NAN)};
    QVERIFY(refused([&](BranchMeshOptions& o) { o.rollRad = two; }));
    QVERIFY(refused([&](BranchMeshOptions& o) { o.rollRad = notANumber; }));
}

void TestBuildBranchMesh::badSkeletonsAreErrors()
{
    const auto message = [](const Skeleton& s) {
        const Expected<BranchMesh> built = buildBranchMesh(s, {});
        return built ? QByteArray() : why(built);
    };
    Skeleton s;
    QVERIFY(!message(s).isEmpty());
    s = stem();
    s.a1[0] = -0.1;
    QVERIFY(message(s).contains("negative"));
    s = stem();
    s.p1[0].y = 1e30;
    QVERIFY(message(s).contains("large"));
    s = stem(1e-20);
    s.p1[0] = {0, 1e-20, 0};
    QVERIFY(message(s).contains("small"));
    s = stem(0.0);
    s.p1[0] = s.p0[0];
    QVERIFY(message(s).contains("length"));
    s = stem();
    s.add(0, {0, 1, 0}, {0, 2, double(NAN)}, 0.1, 0.1);
    QVERIFY(message(s).contains("Branch 1"));
}

void TestBuildBranchMesh::rootWithoutLengthBecomesAStub()
{
    Skeleton s = stem();
    s.p1[0] = s.p0[0];
    s.add(0, {0, 0, 0}, {1, 0, 0}, 0.1, 0.05, 1);
    const Expected<BranchMesh> built = buildBranchMesh(s, {});
    QVERIFY2(built, why(built));
    QVERIFY(has(*built, SkeletonRepair::RootStub, 0));
    const std::string faults = branchMeshFaults(s, *built);
    QVERIFY2(faults.empty(), faults.c_str());
    // half its radius behind its child, which stays where it is
    float low = 1.0f;
    for (const glm::vec3& p : built->mesh.positions)
        low = std::min(low, p.x);
    QVERIFY(std::abs(low + 0.05f) < 1e-6f);
}

void TestBuildBranchMesh::zeroLengthBranchHandsItsChildrenOn()
{
    Skeleton s = stem();
    s.add(0, {0, 1, 0}, {0, 1, 0}, 0.1, 0.1);
    s.add(1, {0, 1, 0}, {0.5, 2, 0}, 0.1, 0.05);
    s.add(1, {0, 1, 0}, {-0.5, 2, 0}, 0.1, 0.05);
    const Expected<BranchMesh> built = buildBranchMesh(s, {});
    QVERIFY2(built, why(built));
    QVERIFY(has(*built, SkeletonRepair::ZeroLengthContracted, 1));
    QCOMPARE(built->repairs[0].other, Index(0));
    QCOMPARE(std::count(built->mesh.branch.begin(), built->mesh.branch.end(), 1u), 0);
    const std::string faults = branchMeshFaults(s, *built);
    QVERIFY2(faults.empty(), faults.c_str());
}

void TestBuildBranchMesh::thinBranchesAreThickened()
{
    const Skeleton s = stem(0.0);
    const Expected<BranchMesh> built = buildBranchMesh(s, {});
    QVERIFY2(built, why(built));
    QVERIFY(has(*built, SkeletonRepair::RadiusClamped, 0));
    const std::string faults = branchMeshFaults(s, *built);
    QVERIFY2(faults.empty(), faults.c_str());
}

void TestBuildBranchMesh::insideOutTreesAreSlimmed()
{
    // Half-turns of branches a tenth as long as thick
    Skeleton s;
    s.add(noIndex, {0, 0, 0}, {0, 0.1, 0}, 1.0, 1.0);
    for (Index i = 0; i < 40; ++i) {
        const glm::dvec3 from = s.p1[i];
        s.add(i, from, from + glm::dvec3(0.1 * std::sin(0.5 * i), 0.1 * std::cos(0.5 * i), 0.001), 1.0, 1.0);
    }
    const std::string faults = branchMeshFaults(s, BranchMeshOptions{});
    QVERIFY2(faults.empty(), faults.c_str());
}

void TestBuildBranchMesh::twinRatioDecidesAboutNearTwins()
{
    Skeleton s = stem();
    s.add(0, {0, 1, 0}, {0.02, 2, 0}, 0.1, 0.1, 1);
    s.add(0, {0, 1, 0}, {-0.02, 2, 0}, 0.1, 0.1, 1);
    BranchMeshOptions options;
    const Expected<BranchMesh> joined = buildBranchMesh(s, options);
    QVERIFY2(joined, why(joined));
    QVERIFY(has(*joined, SkeletonRepair::SiblingsMerged, 2));
    options.nearTwinRatio = 0.0;
    const Expected<BranchMesh> apart = buildBranchMesh(s, options);
    QVERIFY2(apart, why(apart));
    QVERIFY(apart->repairs.empty());
    QVERIFY(std::count(apart->mesh.branch.begin(), apart->mesh.branch.end(), 2u) > 0);
}

void TestBuildBranchMesh::oneBranchIsATubeWithCaps()
{
    for (const int n : {3, 8, 128})
        for (const int rows : {2, 4, 64}) {
            BranchMeshOptions options;
            options.radialDivisions = n;
            options.lengthDivisions = rows;
            const Expected<BranchMesh> built = buildBranchMesh(stem(), options);
            QVERIFY2(built, why(built));
            const CheckedMesh checked = checkMesh(built->mesh);
            QVERIFY2(checked.perfect(1), checked.summary().c_str());
            if (rows < 64) { // of 64 the last ones are nearer to the end than a ring may be
                QCOMPARE(built->mesh.vertexCount(), static_cast<Index>(n * rows + 2));
                QCOMPARE(built->mesh.faceCount(), static_cast<Index>(2 * n * rows));
            }
            const double area = 0.5 * n * 0.01 * std::sin(2.0 * std::numbers::pi / n);
            QVERIFY(std::abs(checked.volume() - area * (1.0 + 0.035 / 3.0)) < 1e-6);
        }
}

void TestBuildBranchMesh::ringsLieOnTheirCircles()
{
    const Expected<BranchMesh> built = buildBranchMesh(stem(), {});
    QVERIFY2(built, why(built));
    for (const glm::vec3& p : built->mesh.positions) {
        const double out = std::hypot(p.x, p.z);
        QVERIFY(out < 1e-7 || std::abs(out - 0.1) < 1e-7);
    }
}

void TestBuildBranchMesh::singleChildSharesItsParentsRing()
{
    Skeleton s = stem();
    s.add(0, {0, 1, 0}, {0.5, 1.8, 0}, 0.1, 0.05);
    const Expected<BranchMesh> built = buildBranchMesh(s, {});
    QVERIFY2(built, why(built));
    QCOMPARE(built->mesh.vertexCount(), Index(8 * 7 + 2)); // 4 rings and 3 more
    const std::string faults = branchMeshFaults(s, *built);
    QVERIFY2(faults.empty(), faults.c_str());
}

void TestBuildBranchMesh::rollTurnsTheRings()
{
    Skeleton s = cone(3, 0.6, 1.0);
    s.add(1, s.p1[1], s.p1[1] + glm::dvec3(0.3, 0.6, 0.0), 0.05, 0.03, 1);
    const Expected<BranchMesh> plain = buildBranchMesh(s, {});
    QVERIFY2(plain, why(plain));
    const std::vector<double> rolls{0.3, -1.0, 7.0, 0.0, 2.5};
    BranchMeshOptions options;
    options.rollRad = rolls;
    const Expected<BranchMesh> turned = buildBranchMesh(s, options);
    QVERIFY2(turned, why(turned));
    const std::string faults = branchMeshFaults(s, *turned);
    QVERIFY2(faults.empty(), faults.c_str());
    QVERIFY(plain->mesh.positions != turned->mesh.positions);
    // the root's own ring is turned too: by 0.3 of its first point
    const glm::vec3 a = plain->mesh.positions[1], b = turned->mesh.positions[1];
    const double angle =
        std::acos(std::clamp(double(glm::dot(glm::normalize(a), glm::normalize(b))), -1.0, 1.0));
    QVERIFY(std::abs(angle - 0.3) < 1e-3);
    // a whole turn changes nothing but rounding
    const std::vector<double> whole(s.size(), 0.0);
    options.rollRad = whole;
    const Expected<BranchMesh> same = buildBranchMesh(s, options);
    QVERIFY2(same, why(same));
    QVERIFY(same->mesh == plain->mesh);
}

void TestBuildBranchMesh::manyChildren_data()
{
    QTest::addColumn<int>("children");
    for (const int children : {1, 2, 3, 4, 5, 7, 14, 20, 33, 64, 200})
        QTest::addRow("%d", children) << children;
}

void TestBuildBranchMesh::manyChildren()
{
    QFETCH(int, children);
    for (const double angle : {0.2, 0.8, 1.5, 2.4, 3.1})
        for (const double length : {0.05, 0.5, 3.0}) {
            BranchMeshOptions options;
            options.nearTwinRatio = 0.0; // all of them
            const std::string faults = branchMeshFaults(cone(children, angle, length), options);
            QVERIFY2(faults.empty(), faults.c_str());
        }
}

void TestBuildBranchMesh::childrenInOnePlane()
{
    for (int children = 2; children <= 13; ++children)
        for (const double tilt : {0.0, 0.4}) {
            Skeleton s = stem();
            for (int k = 0; k < children; ++k) {
                const double angle = std::numbers::pi * (k + 0.5) / children - 0.5 * std::numbers::pi;
                const glm::dvec3 way(std::sin(angle), std::cos(angle) * std::cos(tilt), std::sin(tilt));
                s.add(0, {0, 1, 0}, glm::dvec3(0, 1, 0) + way, 0.1, 0.05, 1);
            }
            for (const int n : {3, 8, 17}) {
                BranchMeshOptions options;
                options.radialDivisions = n;
                options.nearTwinRatio = 0.0;
                const std::string faults = branchMeshFaults(s, options);
                QVERIFY2(faults.empty(), faults.c_str());
            }
        }
}

void TestBuildBranchMesh::deepChain()
{
    Skeleton s = stem(0.02);
    for (Index i = 1; i < 100000; ++i)
        s.add(i - 1, s.p1[i - 1], s.p1[i - 1] + glm::dvec3(std::sin(0.1 * i), 1.0, std::cos(0.1 * i)), 0.02,
              0.02);
    BranchMeshOptions options;
    options.radialDivisions = 3;
    options.lengthDivisions = 2;
    const Expected<BranchMesh> built = buildBranchMesh(s, options);
    QVERIFY2(built, why(built));
    const CheckedMesh checked = checkMesh(built->mesh);
    QVERIFY2(checked.perfect(1), checked.summary().c_str());
}

void TestBuildBranchMesh::farFromTheOrigin()
{
    const Expected<Skeleton> tiny = presetSkeleton({"TinyTree"});
    QVERIFY2(tiny, why(tiny));
    for (const double distance : {10.0, 1e3, 1e5, 1e7, 1e10}) {
        Skeleton s = *tiny;
        for (Index i = 0; i < s.size(); ++i) {
            s.p0[i] += glm::dvec3(distance, -distance, 0.3 * distance);
            s.p1[i] += glm::dvec3(distance, -distance, 0.3 * distance);
        }
        const std::string faults = branchMeshFaults(s, BranchMeshOptions{});
        QVERIFY2(faults.empty(), (std::to_string(distance) + ": " + faults).c_str());
    }
}

void TestBuildBranchMesh::scales_data()
{
    QTest::addColumn<double>("scale");
    for (const double scale : {1e-9, 1e-5, 1e-2, 1e3, 1e6, 1e9})
        QTest::addRow("%g", scale) << scale;
}

void TestBuildBranchMesh::scales()
{
    QFETCH(double, scale);
    Expected<Skeleton> s = presetSkeleton({"TinyTree"});
    QVERIFY2(s, why(s));
    for (Index i = 0; i < s->size(); ++i) {
        s->p0[i] *= scale;
        s->p1[i] *= scale;
        s->a0[i] *= scale;
        s->a1[i] *= scale;
    }
    BranchMeshOptions options;
    for (const double leastRadius : {options.leastRadius, 0.0}) {
        options.leastRadius = leastRadius;
        const std::string faults = branchMeshFaults(*s, options);
        QVERIFY2(faults.empty(), faults.c_str());
    }
}

void TestBuildBranchMesh::progressRisesAndCancelStops()
{
    const Expected<Skeleton> s = presetSkeleton({"SmallTree"});
    QVERIFY2(s, why(s));
    std::vector<double> told;
    Progress progress;
    progress.onFraction = [&](double fraction) { told.push_back(fraction); };
    QVERIFY(buildBranchMesh(*s, {}, progress));
    QVERIFY(told.size() > 3);
    QVERIFY(std::is_sorted(told.begin(), told.end()));
    QVERIFY(told.front() >= 0.0);
    QCOMPARE(told.back(), 1.0);

    std::stop_source source;
    progress.stop = source.get_token();
    progress.onFraction = [&](double fraction) {
        if (fraction > 0.3)
            source.request_stop();
    };
    const Expected<BranchMesh> stopped = buildBranchMesh(*s, {}, progress);
    QVERIFY(!stopped);
    QCOMPARE(stopped.error().code, ErrorCode::Cancelled);
}

void TestBuildBranchMesh::cleanupPartsTwinsAndOpensFlatTriangles()
{
    const std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 1, 5}, {3, 4, 5}, {0, 4, 2}};
    for (const double leastGap : {0.0, 0.01}) {
        std::vector<glm::vec3> positions{{0, 0, 0},     {1, 0, 0},     {0, 1, 0},
                                         {1, 0, 1e-7f}, {-0.0f, 0, 0}, {0.5f, 0, 0}};
        const CleanupInput input{triangles, nullptr, leastGap};
        QVERIFY(!areSeparate(positions, input));
        QVERIFY(separateVertices(positions, input, {}) > 0);
        QVERIFY(findNearPositions(positions, std::max(leastGap, 4e-7)).empty());
        for (const glm::uvec3& t : triangles)
            QVERIFY(glm::length(glm::cross(positions[t.y] - positions[t.x],
                                           positions[t.z] - positions[t.x])) > 1e-7f);
        QVERIFY(areSeparate(positions, input));
        QCOMPARE(separateVertices(positions, input, {}), Index(0)); // nothing more to do
    }
}

/// Branches of a grammar that end in one place, but for the last bit of their coordinates.
void TestBuildBranchMesh::placesDrawnTwiceHaveVerticesApart()
{
    const auto grammar = parseGrammar("AXF", "X -> \\\\\\[[AFF\\XB]/B[BB__--^]BB][CBA__]XAC\n"
                                             "B -> F[__BF][CB]\\\\F[FXC[FB\\\\BC]]\n");
    QVERIFY2(grammar, why(grammar));
    const auto symbols = rewrite(*grammar, RewriteOptions{.iterations = 4});
    QVERIFY2(symbols, why(symbols));
    const auto drawn = runTurtle(*symbols, TurtleParams{.theta = 1.3784, .decay = 0.469});
    QVERIFY2(drawn, why(drawn));
    const Skeleton skeleton = simplify(*drawn, 1e-4).skeleton;
    BranchMeshOptions options;
    options.radialDivisions = 3;
    options.lengthDivisions = 2;
    for (const double leastRadius : {0.0, options.leastRadius}) {
        options.leastRadius = leastRadius;
        const auto built = buildBranchMesh(skeleton, options);
        QVERIFY2(built, why(built));
        QCOMPARE(branchMeshFaults(skeleton, *built), std::string());
        const double size = 12.0; // m
        QVERIFY(findNearPositions(built->mesh.positions, std::max(4e-7 * size, built->leastGap)).empty());
    }
}

/// Twigs that end at nothing, pieces shorter than anything, and a least radius beyond what a tree can have.
void TestBuildBranchMesh::nothingIsFinerThanTheLeastRadius()
{
    Skeleton s = stem();
    s.a1[0] = 0.0;
    for (int k = 0; k < 40; ++k) {
        const auto last = static_cast<Index>(s.size() - 1);
        const glm::dvec3 way = 1e-5 * double(k) * glm::dvec3(std::sin(0.7 * k), 1.0, std::cos(0.7 * k));
        s.add(last, s.p1[last], s.p1[last] + way, 1e-4, 0.0, 1);
    }
    struct Divisions
    {
        int sides, sections, budget;
        double gap; ///< of the least radius
    };
    for (const auto& [sides, sections, budget, gap] : {Divisions{8, 4, 0, 0.48},
                                                       {3, 2, 0, 0.48},
                                                       {12, 64, 0, 0.48},
                                                       {60, 4, 0, 0.1},
                                                       {60, 64, 5000, 0.48}})
        for (const double leastRadius : {1e-4, 5e-4, 1e-2, 1.0}) {
            BranchMeshOptions options;
            options.radialDivisions = sides;
            options.lengthDivisions = sections;
            options.targetTriangles = budget;
            options.leastRadius = leastRadius;
            const auto built = buildBranchMesh(s, options);
            QVERIFY2(built, why(built));
            QCOMPARE(branchMeshFaults(s, *built), std::string());
            const double least = std::min(leastRadius, 5e-4); // the tree is a metre high
            QVERIFY(built->leastGap >= gap * least * (1.0 - 1e-12));
            QVERIFY(findNearPositions(built->mesh.positions, built->leastGap).empty());
            for (const TubeAxis& axis : built->axes)
                QVERIFY(std::min(axis.a0, axis.a1) >= least);
        }
}

RAMURE_SUITE(TestBuildBranchMesh)

} // namespace tst_build_branch_mesh

#include "tst_build_branch_mesh.moc"
