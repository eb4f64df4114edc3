#include "core/math/random.h"
#include "core/surface/check/self_intersections.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include "tests/support/preset_trees.h"
#include "tests/support/self_intersections.h"
#include "tests/support/solids.h"
#include "tests/support/suite.h"
#include <cmath>

namespace tst_crossing_faces {

using namespace ramure;

/// The program's own count of crossing triangles against CGAL's.
class TestCrossingFaces : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void badMeshesAreErrors();
    void cancelStops();
    void brokenTrianglesAreLeftOut();
    void cleanSolidsHaveNone();
    void twoBoxesCross();
    void soupsAgreeWithTheOracle_data();
    void soupsAgreeWithTheOracle();
    void presetsAgreeWithTheOracle_data();
    void presetsAgreeWithTheOracle();
    void theSameOnAnyNumberOfThreads();
    void listsEndWhereTheyShould();
};

namespace {

/// Triangles with corners out of a pool: they share vertices and edges, touch, and lie in one plane, often.
TriangleMesh soup(std::uint64_t seed, Index vertices, Index faces, std::uint32_t lattice)
{
    Random random(seed, RandomStream::Test);
    TriangleMesh mesh;
    for (Index i = 0; i < vertices; ++i) {
        const auto place = [&] { return lattice > 0 ? float(random.below(lattice)) : float(random.unit()); };
        mesh.positions.emplace_back(place(), place(), place());
        mesh.branch.push_back(random.below(6));
    }
    for (Index i = 0; i < faces; ++i)
        mesh.triangles.emplace_back(random.below(vertices), random.below(vertices), random.below(vertices));
    std::erase_if(mesh.triangles, [](const glm::uvec3& t) { return t.x == t.y || t.y == t.z || t.z == t.x; });
    return mesh;
}

const std::vector<Index> family{noIndex, 0, 0, 1, 1, 3};

/// Empty where both say the same.
QByteArray difference(const SelfIntersections& found, const test::SelfIntersections& expected)
{
    const std::array<Index, 4> counts{expected.same, expected.siblings, expected.parentChild, expected.far};
    for (std::size_t k = 0; k < counts.size(); ++k)
        if (found.counts[k] != counts[k])
            return "kind " + QByteArray::number(int(k)) + ": " +
                   QByteArray::number(qulonglong(found.counts[k])) + " instead of " +
                   QByteArray::number(counts[k]);
    std::vector<FacePair> pairs = found.pairs;
    std::sort(pairs.begin(), pairs.end(), [](const FacePair& a, const FacePair& b) {
        return a.first != b.first ? a.first < b.first : a.second < b.second;
    });
    if (found.total() == pairs.size())
        for (std::size_t i = 0; i < pairs.size(); ++i)
            if (pairs[i].first != expected.pairs[i].first || pairs[i].second != expected.pairs[i].second ||
                int(pairs[i].kind) != int(expected.pairs[i].kind))
                return "another pair " + QByteArray::number(pairs[i].first) + ' ' +
                       QByteArray::number(pairs[i].second);
    return {};
}

SelfIntersections need(const TriangleMesh& mesh, const std::vector<Index>& parent = {}, unsigned threads = 0)
{
    auto found = findSelfIntersections(mesh, parent, threads);
    if (!found)
        qFatal("%s", test::why(found).constData());
    return std::move(*found);
}

} // namespace

void TestCrossingFaces::badMeshesAreErrors()
{
    TriangleMesh mesh = test::box({0, 0, 0}, {1, 1, 1});
    const auto refused = [&](const std::vector<Index>& parent) {
        const auto found = findSelfIntersections(mesh, parent);
        return !found && found.error().code == ErrorCode::Invalid;
    };
    mesh.branch.assign(8, 3);
    QVERIFY(refused({noIndex, 0, 1})); // a branch that is not there
    QVERIFY(refused({noIndex, 0, 1, 4}));
    QVERIFY(refused({1, 2, 0, 0})); // a circle
    QVERIFY(!refused({3, noIndex, 0, 1}));
    mesh.branch.pop_back();
    QVERIFY(refused({noIndex, 0, 1, 2}));
    mesh.branch.clear();
    mesh.triangles.emplace_back(0, 1, 8);
    QVERIFY(refused({}));
}

void TestCrossingFaces::cancelStops()
{
    std::stop_source stop;
    stop.request_stop();
    const auto found =
        findSelfIntersections(test::torus(40, 20), {}, 1, Progress{stop.get_token(), [](double) {}});
    QVERIFY(!found);
    QCOMPARE(found.error().code, ErrorCode::Cancelled);
    double last = 0.0;
    QVERIFY(findSelfIntersections(test::torus(200, 100), {}, 2, Progress{{}, [&](double f) {
                                                                             QVERIFY(f >= last && f <= 1.0);
                                                                             last = f;
                                                                         }}));
    QVERIFY(last > 0.5);
}

void TestCrossingFaces::brokenTrianglesAreLeftOut()
{
    TriangleMesh mesh = test::box({0, 0, 0}, {1, 1, 1});
    mesh.positions.insert(mesh.positions.end(), {{0.5f, 0.5f, 0.5f},
                                                 {NAN, 0.5f, 0.5f},
                                                 {0.5f, INFINITY, 0.5f},
                                                 {2.0f, 0.5f, 0.5f},
                                                 {3.5f, 0.5f, 0.5f}});
    mesh.triangles.insert(mesh.triangles.end(), {{0, 8, 9}, {0, 8, 10}, {8, 11, 12}, {8, 8, 11}});
    QCOMPARE(need(mesh).total(), 0u);
    QCOMPARE(need({}).total(), 0u);
}

void TestCrossingFaces::cleanSolidsHaveNone()
{
    QCOMPARE(need(test::box({0, 0, 0}, {1, 1, 1})).total(), 0u);
    QCOMPARE(need(test::torus(60, 30)).total(), 0u);
    QVERIFY(!need(test::torus(6, 3)).kindsKnown);
}

void TestCrossingFaces::twoBoxesCross()
{
    TriangleMesh mesh = test::joined(test::box({0, 0, 0}, {1, 1, 1}), test::box({0.5, 0.5, 0.5}, {2, 2, 2}));
    for (Index v = 0; v < mesh.vertexCount(); ++v)
        mesh.branch.push_back(v < 8 ? 2 : 5);
    const SelfIntersections far = need(mesh, family);
    QVERIFY(far.kindsKnown);
    QVERIFY(far.count(PairKind::Far) > 0);
    QCOMPARE(far.count(PairKind::Far), far.total());
    QCOMPARE(far.branches.size(), std::size_t(1));
    QCOMPARE(far.branches[0].first, Index(2));
    QCOMPARE(far.branches[0].second, Index(5));
    QCOMPARE(far.branches[0].facePairs, far.total());
    const glm::dvec3 place = far.branches[0].place;
    QVERIFY(glm::all(glm::greaterThan(place, glm::dvec3(0.4))) &&
            glm::all(glm::lessThan(place, glm::dvec3(1.1))));
    const std::vector<Index> siblings{noIndex, 0, 0, 0, 0, 0}, child{noIndex, 0, 0, 0, 0, 2};
    QCOMPARE(need(mesh, siblings).count(PairKind::Siblings), far.total());
    QCOMPARE(need(mesh, child).count(PairKind::ParentChild), far.total());
    QCOMPARE(need(mesh).count(PairKind::Same), far.total());
    QVERIFY(need(mesh, siblings).branches.empty());
}

void TestCrossingFaces::soupsAgreeWithTheOracle_data()
{
    QTest::addColumn<int>("vertices");
    QTest::addColumn<int>("lattice");
    for (const int vertices : {6, 12, 40, 300})
        for (const int lattice : {0, 2, 3, 5, 1000})
            QTest::addRow("%d vertices, lattice %d", vertices, lattice) << vertices << lattice;
}

void TestCrossingFaces::soupsAgreeWithTheOracle()
{
    QFETCH(int, vertices);
    QFETCH(int, lattice);
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        const TriangleMesh mesh = soup(seed, Index(vertices), 60, std::uint32_t(lattice));
        const QByteArray wrong = difference(need(mesh, family), test::findSelfIntersections(mesh, family));
        QVERIFY2(wrong.isEmpty(), wrong + " in soup " + QByteArray::number(qulonglong(seed)));
    }
}

void TestCrossingFaces::presetsAgreeWithTheOracle_data()
{
    QTest::addColumn<QString>("name");
    for (const char* name : {"TinyTree", "SmallTree", "FanTree", "Fern2D"})
        QTest::newRow(name) << name;
}

void TestCrossingFaces::presetsAgreeWithTheOracle()
{
    QFETCH(QString, name);
    const std::string preset = name.toStdString();
    const auto skeleton = test::presetSkeleton({preset});
    QVERIFY2(skeleton, test::why(skeleton));
    BranchMeshOptions options;
    options.radialDivisions = 5;
    const auto built = buildBranchMesh(*skeleton, options);
    QVERIFY2(built, test::why(built));
    const std::vector<Index> parents = repairedParents(*skeleton, built->repairs);
    QVERIFY(parents == test::repairedParents(*skeleton, built->repairs));
    const SelfIntersections found = need(built->mesh, parents);
    const QByteArray wrong = difference(found, test::findSelfIntersections(built->mesh, parents));
    QVERIFY2(wrong.isEmpty(), wrong);
    std::uint64_t pairs = 0;
    for (const CrossingBranches& entry : found.branches)
        pairs += entry.facePairs;
    QCOMPARE(pairs, found.count(PairKind::Far));
}

void TestCrossingFaces::theSameOnAnyNumberOfThreads()
{
    const auto skeleton = test::presetSkeleton({"FanTree"});
    const auto built = buildBranchMesh(*skeleton, {});
    const std::vector<Index> parents = repairedParents(*skeleton, built->repairs);
    const SelfIntersections one = need(built->mesh, parents, 1);
    QVERIFY(one.total() > 0);
    for (const unsigned threads : {2u, 3u, 8u})
        QVERIFY(need(built->mesh, parents, threads) == one);
}

void TestCrossingFaces::listsEndWhereTheyShould()
{
    // 300 triangles through each other: 44,850 pairs.
    TriangleMesh mesh;
    for (Index i = 0; i < 300; ++i) {
        const float turn = float(i) * 0.01f;
        mesh.positions.emplace_back(10.0f * std::cos(turn), 10.0f * std::sin(turn), -1.0f);
        mesh.positions.emplace_back(-10.0f * std::cos(turn), -10.0f * std::sin(turn), -1.0f);
        mesh.positions.emplace_back(0.0f, 0.0f, 20.0f + turn);
        mesh.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    const SelfIntersections found = need(mesh);
    QCOMPARE(found.total(), std::uint64_t(300 * 299 / 2));
    QCOMPARE(found.pairs.size(), std::size_t(10'000));
    QVERIFY(found == need(mesh, {}, 1));
}

RAMURE_SUITE(TestCrossingFaces)

} // namespace tst_crossing_faces

#include "tst_crossing_faces.moc"
