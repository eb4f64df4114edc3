#include "core/math/random.h"
#include "core/surface/mesher/fork_triangulation.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <set>

namespace tst_fork_triangulation {

using namespace ramure;
using namespace ramure::test;

/// Whatever the directions of the children: a triangulation of their convex hull, each child in it, Delaunay.
class TestForkTriangulation : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }
    void twoSitesHaveNoTriangle();
    void sitesOnOneLine();
    void equalSitesAreMovedApart();
    void farSitesStayInsideTheGrid();
    void squareAndRing();
    void flatSidesAreOpened();
    void aStarGoesOutAndBackToEachSite();
    void randomSites_data();
    void randomSites();
};

namespace {

double orient(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// What any valid result must satisfy; returns what is wrong.
QByteArray faults(const ForkTriangulation& result, std::size_t count)
{
    std::map<std::pair<Index, Index>, Index> directed;
    std::set<Index> seen;
    for (Index t = 0; t < result.triangles().size(); ++t) {
        const auto& triangle = result.triangles()[t];
        if (orient(result.place(triangle.site[0]), result.place(triangle.site[1]),
                   result.place(triangle.site[2])) <= 0.0)
            return "a triangle is not counter-clockwise";
        for (std::size_t i = 0; i < 3; ++i) {
            seen.insert(triangle.site[i]);
            if (!directed.insert({{triangle.site[i], triangle.site[(i + 1) % 3]}, t}).second)
                return "an edge is in two triangles on the same side";
        }
    }
    if (seen.size() != count)
        return "a site is in no triangle";
    std::size_t open = 0;
    for (const auto& [edge, t] : directed) {
        const auto back = directed.find({edge.second, edge.first});
        open += back == directed.end() ? 1 : 0;
        const auto& triangle = result.triangles()[t];
        for (std::size_t i = 0; i < 3; ++i)
            if (triangle.site[i] == edge.first &&
                triangle.neighbour[i] != (back == directed.end() ? noIndex : back->second))
                return "a neighbour is wrong";
    }
    if (open != result.hull().size())
        return "the hull is not the outline";
    // Euler's formula of a disc without holes
    if (result.triangles().size() != 2 * count - 2 - result.hull().size())
        return "the number of triangles is wrong";
    for (std::size_t e = 0; e < result.hull().size(); ++e) {
        const auto& edge = result.hull()[e];
        const auto found = directed.find({edge.from, edge.to});
        if (found == directed.end() || found->second != edge.triangle)
            return "a hull edge does not know its triangle";
        if (edge.to != result.hull()[(e + 1) % result.hull().size()].from)
            return "the hull is not one cycle";
        for (Index site = 0; site < count; ++site)
            if (orient(result.place(edge.from), result.place(edge.to), result.place(site)) < 0.0)
                return "a site lies outside the hull";
    }
    return {};
}

/// The circle through a, b, c (counter-clockwise) holds d, by more than rounding.
bool inCircle(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d)
{
    using Real = long double;
    const Real ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y, cx = c.x - d.x, cy = c.y - d.y;
    const Real aa = ax * ax + ay * ay, bb = bx * bx + by * by, cc = cx * cx + cy * cy;
    const Real value = aa * (bx * cy - by * cx) - bb * (ax * cy - ay * cx) + cc * (ax * by - ay * bx);
    return value > 1e-12L * (aa + bb + cc) * (aa + bb + cc);
}

} // namespace

void TestForkTriangulation::twoSitesHaveNoTriangle()
{
    ForkTriangulation result;
    result.build(std::vector<glm::dvec2>{{0.1, 0.2}, {-0.3, 0.2}});
    QVERIFY(result.triangles().empty());
    QCOMPARE(result.hull().size(), std::size_t(2));
    QCOMPARE(result.hull()[0].from, Index(1)); // from the left
    QCOMPARE(result.hull()[0].to, Index(0));
    QCOMPARE(result.hull()[1].from, Index(0));
    QCOMPARE(result.hull()[1].triangle, noIndex);
}

void TestForkTriangulation::sitesOnOneLine()
{
    ForkTriangulation result;
    result.build(std::vector<glm::dvec2>{{0.0, 0.25}, {0.0, -0.5}, {0.0, 1.0}, {0.0, 0.5}});
    QVERIFY(result.triangles().empty());
    const std::vector<Index> order{1, 0, 3, 2, 3, 0};
    QCOMPARE(result.hull().size(), order.size());
    for (std::size_t e = 0; e < order.size(); ++e) {
        QCOMPARE(result.hull()[e].from, order[e]);
        QCOMPARE(result.hull()[e].to, order[(e + 1) % order.size()]);
    }
}

void TestForkTriangulation::equalSitesAreMovedApart()
{
    ForkTriangulation result;
    std::vector<glm::dvec2> sites(7, glm::dvec2(0.5, -0.25));
    result.build(sites);
    QVERIFY(result.triangles().empty()); // all in one column of the grid
    QCOMPARE(result.hull().size(), std::size_t(12));
    std::set<std::pair<double, double>> places;
    for (Index i = 0; i < sites.size(); ++i)
        places.insert({result.place(i).x, result.place(i).y});
    QCOMPARE(places.size(), sites.size());

    sites.push_back({0.7, 0.1});
    result.build(sites);
    QCOMPARE(faults(result, sites.size()), QByteArray());
}

void TestForkTriangulation::farSitesStayInsideTheGrid()
{
    ForkTriangulation result;
    const std::vector<glm::dvec2> sites{{12.7, 0.0}, {-12.7, 0.0}, {0.0, 12.7}, {0.0, -12.7}, {1e-4, 1e-4}};
    result.build(sites);
    QCOMPARE(faults(result, sites.size()), QByteArray());
    for (Index i = 0; i < sites.size(); ++i)
        QVERIFY(glm::length(result.place(i) - sites[i]) < 2e-5);
}

void TestForkTriangulation::squareAndRing()
{
    ForkTriangulation result;
    std::vector<glm::dvec2> sites;
    for (int x = -3; x <= 3; ++x) // a grid is all cocircular and collinear
        for (int y = -3; y <= 3; ++y)
            sites.push_back({0.25 * x, 0.25 * y});
    result.build(sites);
    // inner points of the square's sides lie on the hull too
    QCOMPARE(result.hull().size(), std::size_t(24));
    QCOMPARE(faults(result, sites.size()), QByteArray());

    sites.assign(1, {0.0, 0.0});
    for (int k = 0; k < 12; ++k)
        sites.push_back({0.5 * std::cos(k * std::numbers::pi / 6), 0.5 * std::sin(k * std::numbers::pi / 6)});
    result.build(sites);
    QCOMPARE(faults(result, sites.size()), QByteArray());
}

/// A site a little inside the line between two others gets a place on the hull; one further inside does not.
void TestForkTriangulation::flatSidesAreOpened()
{
    ForkTriangulation result;
    const std::vector<glm::dvec2> sites{{-1.0, 0.0}, {0.0, 0.01}, {1.0, 0.0}, {0.0, 1.0}, {0.0, 0.4}};
    result.build(sites);
    QCOMPARE(result.hull().size(), std::size_t(3));
    QCOMPARE(result.triangles().size(), std::size_t(5));
    result.openFlatSides(-0.9);
    QCOMPARE(result.hull().size(), std::size_t(4));
    QCOMPARE(result.triangles().size(), std::size_t(4));
    QVERIFY(std::any_of(result.hull().begin(), result.hull().end(),
                        [](const auto& edge) { return edge.from == 1; }));

    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        Random random(seed, RandomStream::Test, 9);
        std::vector<glm::dvec2> random2(3 + random.below(30));
        for (glm::dvec2& site : random2)
            site = {random.range(-1.0, 1.0), random.range(-1.0, 1.0) * (seed % 3 == 0 ? 0.01 : 1.0)};
        result.build(random2);
        const std::size_t all = result.triangles().size(), before = result.hull().size();
        result.openFlatSides(random.range(-1.0, -0.5));
        // Each triangle that goes gives one more site to the hull, which stays one cycle without a
        // repetition.
        QCOMPARE(all - result.triangles().size(), result.hull().size() - before);
        std::set<Index> seen;
        for (std::size_t e = 0; e < result.hull().size(); ++e) {
            const auto& edge = result.hull()[e];
            QVERIFY(seen.insert(edge.from).second);
            QCOMPARE(edge.to, result.hull()[(e + 1) % result.hull().size()].from);
            const auto& sitesOf = result.triangles()[edge.triangle].site;
            const auto at = std::find(sitesOf.begin(), sitesOf.end(), edge.from) - sitesOf.begin();
            QCOMPARE(sitesOf[(at + 1) % 3], edge.to);
            QCOMPARE(result.triangles()[edge.triangle].neighbour[at], noIndex);
        }
        std::map<std::pair<Index, Index>, Index> directed;
        for (Index t = 0; t < result.triangles().size(); ++t)
            for (std::size_t i = 0; i < 3; ++i)
                directed[{result.triangles()[t].site[i], result.triangles()[t].site[(i + 1) % 3]}] = t;
        for (const auto& [edge, t] : directed) {
            const auto back = directed.find({edge.second, edge.first});
            const auto& triangle = result.triangles()[t];
            for (std::size_t i = 0; i < 3; ++i)
                if (triangle.site[i] == edge.first)
                    QCOMPARE(triangle.neighbour[i], back == directed.end() ? noIndex : back->second);
        }
    }
}

/// Whatever the sites, on one line, in one place, or on the centre itself.
void TestForkTriangulation::aStarGoesOutAndBackToEachSite()
{
    const std::vector<glm::dvec2> sites{{1, 0}, {0, 0}, {-1, 0}, {-1, 0}, {0, 0}, {0, -1}, {0.5, 0.5}};
    ForkTriangulation result;
    result.buildStar(sites, 1);
    QVERIFY(result.triangles().empty());
    QCOMPARE(result.hull().size(), std::size_t(12));
    std::vector<int> visits(sites.size());
    for (Index e = 0; e < result.hull().size(); ++e) {
        const auto& edge = result.hull()[e];
        QCOMPARE(edge.triangle, noIndex);
        QVERIFY(edge.from == 1 || edge.to == 1);
        QCOMPARE(result.hull()[edge.partner].from, edge.to);
        QCOMPARE(result.hull()[(e + 1) % result.hull().size()].from, edge.to);
        ++visits[edge.from];
    }
    QCOMPARE(visits, (std::vector<int>{1, 6, 1, 1, 1, 1, 1}));
}

void TestForkTriangulation::randomSites_data()
{
    QTest::addColumn<int>("shape");
    QTest::newRow("anywhere") << 0;
    QTest::newRow("close together") << 1;
    QTest::newRow("on few lines") << 2;
    QTest::newRow("on a circle") << 3;
}

void TestForkTriangulation::randomSites()
{
    QFETCH(int, shape);
    ForkTriangulation result;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        Random random(seed, RandomStream::Test, static_cast<std::uint64_t>(shape));
        std::vector<glm::dvec2> sites(3 + random.below(40));
        for (glm::dvec2& site : sites) {
            site = {random.range(-1.0, 1.0), random.range(-1.0, 1.0)};
            if (shape == 1)
                site *= 1e-4;
            else if (shape == 2)
                site.x = 0.5 * random.below(3);
            else if (shape == 3)
                site = glm::normalize(site) * 0.5;
        }
        result.build(sites);
        if (result.triangles().empty())
            continue; // a few sites of "on few lines" can share their line
        const QByteArray wrong = faults(result, sites.size());
        QVERIFY2(wrong.isEmpty(), wrong + " with seed " + QByteArray::number(qulonglong(seed)));
        for (const auto& triangle : result.triangles())
            for (Index site = 0; site < sites.size(); ++site)
                QVERIFY2(!inCircle(result.place(triangle.site[0]), result.place(triangle.site[1]),
                                   result.place(triangle.site[2]), result.place(site)),
                         "not Delaunay with seed " + QByteArray::number(qulonglong(seed)));
    }
}

RAMURE_SUITE(TestForkTriangulation)

} // namespace tst_fork_triangulation

#include "tst_fork_triangulation.moc"
