#include "core/math/random.h"
#include "core/surface/mesher/strip_patch.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace tst_strip_patch {

using namespace ramure;
using namespace ramure::test;

/// A strip is an annulus with each edge once, whatever the rows look like: that is what makes forks
/// watertight.
class TestStripPatch : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }
    void evenRowsGiveEvenTriangles();
    void threeAgainstMany();
    void oneRowInsideOneGapOfTheOther();
    void insertedVerticesAreKeptApart();
    void verticesOnEdgesAreInserted();
    void farSideIsNotTakenForTheNearOne();
    void pitsAreFilledFromBelow();
    void noEdgeThatAnotherStripCouldHave();
    void randomRows();
};

namespace {

constexpr double turn = 2.0 * std::numbers::pi;

std::vector<UnrolledVertex> evenRow(Index count, double along, Index first)
{
    std::vector<UnrolledVertex> row;
    for (Index k = 0; k < count; ++k)
        row.push_back({turn * k / count, along, first + k});
    return row;
}

/// Directed edges of the strip's triangles with their numbers.
std::map<std::pair<Index, Index>, int> edgesOf(const MeshSink& sink)
{
    std::map<std::pair<Index, Index>, int> edges;
    for (const glm::uvec3& t : sink.triangles) {
        ++edges[{t.x, t.y}];
        ++edges[{t.y, t.z}];
        ++edges[{t.z, t.x}];
    }
    return edges;
}

/// An annulus between the rows; \p inserted more vertices between them.
QByteArray faults(const StripPatch& patch, const std::vector<UnrolledVertex>& lower,
                  const std::vector<UnrolledVertex>& upper, std::size_t inserted)
{
    MeshSink sink;
    patch.write(sink);
    if (sink.triangles.size() != lower.size() + upper.size() + 2 * inserted)
        return "number of triangles";
    const auto edges = edgesOf(sink);
    std::map<std::pair<Index, Index>, int> open;
    for (const auto& [edge, count] : edges) {
        if (count != 1)
            return "an edge twice on one side";
        if (!edges.contains({edge.second, edge.first}))
            open[edge] = 1;
    }
    if (open.size() != lower.size() + upper.size())
        return "number of open edges";
    for (std::size_t i = 0; i < lower.size(); ++i)
        if (!open.contains({lower[i].vertex, lower[(i + 1) % lower.size()].vertex}))
            return "the lower row is not open";
    for (std::size_t i = 0; i < upper.size(); ++i)
        if (!open.contains({upper[(i + 1) % upper.size()].vertex, upper[i].vertex}))
            return "the upper row is not open";
    // V - E + F of an annulus is 0
    const std::size_t vertices = lower.size() + upper.size() + inserted;
    const std::size_t allEdges = (edges.size() + open.size()) / 2;
    return vertices + sink.triangles.size() == allEdges ? QByteArray() : QByteArray("Euler characteristic");
}

} // namespace

void TestStripPatch::evenRowsGiveEvenTriangles()
{
    StripPatch patch;
    const auto lower = evenRow(8, 0.0, 0), upper = evenRow(8, 1.0, 8);
    patch.zip(lower, upper, {1.0});
    QCOMPARE(faults(patch, lower, upper, 0), QByteArray());
    MeshSink sink;
    patch.write(sink);
    for (const glm::uvec3& t : sink.triangles) // nobody reaches further than its neighbour
        for (int i = 0; i < 3; ++i) {
            const int apart = std::abs(static_cast<int>(t[i] % 8) - static_cast<int>(t[(i + 1) % 3] % 8));
            QVERIFY(apart <= 1 || apart == 7);
        }
}

void TestStripPatch::threeAgainstMany()
{
    StripPatch patch;
    const auto three = evenRow(3, 0.0, 0), many = evenRow(128, 1.0, 3);
    patch.zip(three, many, {1.0});
    QCOMPARE(faults(patch, three, many, 0), QByteArray());
    auto low = many, high = three;
    patch.zip(low, high, {1.0});
    QCOMPARE(faults(patch, low, high, 0), QByteArray());
}

void TestStripPatch::oneRowInsideOneGapOfTheOther()
{
    std::vector<UnrolledVertex> lower;
    for (Index k = 0; k < 5; ++k)
        lower.push_back({1.0 + 0.01 * k, 0.1 * k, k});
    const std::vector<UnrolledVertex> upper{{3.0, 1.0, 5}, {3.01, 1.0, 6}, {3.02, 1.0, 7}};
    StripPatch patch;
    patch.zip(lower, upper, {1.0});
    QCOMPARE(faults(patch, lower, upper, 0), QByteArray());
    QVERIFY(!patch.insert({1.02, 0.5, 8})); // its triangles reach around the tube
    patch.zip(upper, lower, {1.0});
    QCOMPARE(faults(patch, upper, lower, 0), QByteArray());
}

void TestStripPatch::insertedVerticesAreKeptApart()
{
    StripPatch patch;
    const auto lower = evenRow(8, 0.0, 0), upper = evenRow(8, 1.0, 8);
    patch.zip(lower, upper, {1.0});
    QVERIFY(patch.insert({0.3, 0.5, 16}));
    QVERIFY(!patch.insert({0.3, 0.5, 17}));        // its place is taken
    QVERIFY(!patch.insert({0.0, 0.0, 17}));        // a vertex of the row
    QVERIFY(!patch.insert({0.3, 1.5, 17}));        // above the strip
    QVERIFY(!patch.insert({0.3, -0.5, 17}));       // below
    QVERIFY(patch.insert({0.3 + turn, 0.25, 17})); // azimuths of another turn are the same
    QCOMPARE(faults(patch, lower, upper, 2), QByteArray());
}

void TestStripPatch::verticesOnEdgesAreInserted()
{
    // The columns of regular rings: every point lies on the edge from the row below to the row above.
    StripPatch patch;
    const auto lower = evenRow(8, 0.0, 0), upper = evenRow(8, 3.0, 8);
    patch.zip(lower, upper, {1.0});
    for (Index k = 0; k < 16; ++k)
        QVERIFY(patch.insert({turn * (k % 8) / 8, k < 8 ? 1.0 : 2.0, 16 + k}));
    QCOMPARE(faults(patch, lower, upper, 16), QByteArray());
    QVERIFY(!patch.insert({turn / 16, 0.0, 32})); // on the lower row there is nothing beyond
    QVERIFY(!patch.insert({turn / 16, 3.0, 32}));
}

void TestStripPatch::farSideIsNotTakenForTheNearOne()
{
    StripPatch patch;
    const auto lower = evenRow(8, 0.0, 0), upper = evenRow(8, 1.0, 8);
    for (int k = 0; k < 64; ++k) {
        patch.zip(lower, upper, {1.0});
        const double azimuth = turn * (k + 0.37) / 64;
        QVERIFY(patch.insert({azimuth, 0.45, 16}));
        MeshSink sink;
        patch.write(sink);
        for (const glm::uvec3& t : sink.triangles)
            if (t.x == 16 || t.y == 16 || t.z == 16)
                for (int i = 0; i < 3; ++i)
                    if (t[i] != 16)
                        QVERIFY(std::cos(turn * (t[i] % 8) / 8 - azimuth) > 0.0);
    }
}

/// The row dips narrowly between two vertices of the other one: nobody up there sees the bottom.
void TestStripPatch::pitsAreFilledFromBelow()
{
    auto lower = evenRow(8, 0.9, 0);
    lower.push_back({turn * 0.9, 0.5, 8});
    lower.push_back({turn * 0.91, 0.0, 9});
    lower.push_back({turn * 0.92, 0.5, 10});
    const auto upper = evenRow(6, 1.0, 11);
    StripPatch patch;
    patch.zip(lower, upper, {1.0});
    QCOMPARE(faults(patch, lower, upper, 0), QByteArray());
    MeshSink sink;
    patch.write(sink);
    const auto edges = edgesOf(sink);
    QVERIFY(edges.contains({8, 10}) && edges.contains({10, 8}));
}

/// Two vertices of the lower row are never joined if another strip has both.
void TestStripPatch::noEdgeThatAnotherStripCouldHave()
{
    StripPatch patch;
    for (std::uint64_t seed = 0; seed < 500; ++seed) {
        Random random(seed, RandomStream::Test, 2);
        auto lower = evenRow(24, 0.0, 0);
        const auto upper = evenRow(8, 1.0, 24);
        for (UnrolledVertex& vertex : lower) {
            vertex.along = random.range(0.0, 0.9);
            vertex.shared = {random.below(3) == 0 ? noIndex : random.below(3),
                             random.below(2) == 0 ? noIndex : random.below(3)};
        }
        patch.zip(lower, upper, {random.range(0.1, 2.0)});
        patch.relax();
        QCOMPARE(faults(patch, lower, upper, 0), QByteArray());
        MeshSink sink;
        patch.write(sink);
        for (const auto& [edge, count] : edgesOf(sink)) {
            const auto [a, b] = edge;
            if (a >= 24 || b >= 24) {
                QVERIFY(a < 24 || b < 24 || (a - b + 8) % 8 == 1 || (b - a + 8) % 8 == 1);
                continue;
            }
            if ((a + 1) % 24 == b || (b + 1) % 24 == a)
                continue;
            for (const Index mine : lower[a].shared)
                for (const Index other : lower[b].shared)
                    QVERIFY(mine == noIndex || mine != other);
        }
    }
}

void TestStripPatch::randomRows()
{
    StripPatch patch;
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
        Random random(seed, RandomStream::Test);
        const auto row = [&](double low, double high, Index first) {
            const Index count = 3 + random.below(seed % 2 == 0 ? 3 : 30);
            std::vector<UnrolledVertex> vertices;
            for (Index k = 0; k < count; ++k)
                vertices.push_back({random.range(0.0, turn), random.range(low, high), 0});
            std::sort(vertices.begin(), vertices.end(),
                      [](const auto& a, const auto& b) { return a.azimuth < b.azimuth; });
            for (Index k = 0; k < count; ++k)
                vertices[k].vertex = first + k;
            return vertices;
        };
        const auto lower =
            row(0.0, seed % 3 == 0 ? 2.0 : 0.6, 0); // every third front is partly above the ring
        const auto upper = row(1.0, 1.0, static_cast<Index>(lower.size()));
        patch.zip(lower, upper, {random.range(0.05, 5.0), random.range(0.35, 1.0)});
        std::size_t inserted = 0;
        for (int k = 0; k < 40; ++k) {
            const auto vertex = static_cast<Index>(lower.size() + upper.size() + inserted);
            inserted +=
                patch.insert({random.range(-turn, 2.0 * turn), random.range(0.0, 1.0), vertex}) ? 1 : 0;
        }
        QByteArray wrong = faults(patch, lower, upper, inserted);
        patch.relax();
        wrong += faults(patch, lower, upper, inserted);
        QVERIFY2(wrong.isEmpty(), wrong + " with seed " + QByteArray::number(qulonglong(seed)));
    }
}

RAMURE_SUITE(TestStripPatch)

} // namespace tst_strip_patch

#include "tst_strip_patch.moc"
