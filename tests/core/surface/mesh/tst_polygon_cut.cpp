#include "core/surface/mesh/polygon_cut.h"
#include "tests/support/suite.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>
#include <random>

namespace tst_polygon_cut {

using namespace ramure;

namespace {

using Corners = std::vector<glm::vec3>;

glm::dvec3 areaVector(const Corners& corners)
{
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < corners.size(); ++i)
        sum += glm::cross(glm::dvec3(corners[i]), glm::dvec3(corners[(i + 1) % corners.size()]));
    return 0.5 * sum;
}

/// Triangles that all turn like the polygon and have its area together lie side by side within it.
QString faultOf(const Corners& corners, const std::vector<glm::uvec3>& triangles)
{
    if (triangles.size() != corners.size() - 2)
        return "another number of triangles";
    const glm::dvec3 whole = areaVector(corners), up = glm::normalize(whole);
    double sum = 0.0, least = 1.0;
    for (const glm::uvec3& t : triangles) {
        const double area = glm::dot(up, areaVector({corners[t.x], corners[t.y], corners[t.z]}));
        sum += std::abs(area);
        least = std::min(least, area);
    }
    if (least <= 0.0)
        return QString("a triangle with the area %1").arg(least);
    return std::abs(sum - glm::length(whole)) < 1e-6 * sum ? QString() : QString("another area");
}

/// Seen along an axis that is none of the three, either way round.
Corners tilted(const std::vector<glm::dvec2>& points, unsigned seed)
{
    std::mt19937 random(seed);
    const auto number = [&random] { return double(random()) / 4294967296.0 - 0.5; };
    const glm::dvec3 x = glm::normalize(glm::dvec3(number(), number(), number()));
    const glm::dvec3 y = glm::normalize(glm::cross(x, glm::dvec3(number(), number(), number())));
    Corners out;
    for (const glm::dvec2& p : points)
        out.emplace_back(p.x * x + p.y * y);
    if (seed % 2 == 0)
        std::ranges::reverse(out);
    return out;
}

const std::vector<glm::dvec2> letterU{{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};

} // namespace

class TestPolygonCut : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void withoutAnArea()
    {
        const Corners point(6, glm::vec3(1.0F)), line{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
        for (const Corners& corners : {point, line}) {
            QVERIFY(isFan(corners));
            std::vector<glm::uvec3> triangles;
            (void)cutPolygon(corners, triangles);
            QCOMPARE(triangles.size(), corners.size() - 2);
        }
    }
    void crossingItself()
    {
        std::vector<glm::dvec2> star;
        for (int i = 0; i < 7; ++i)
            star.emplace_back(std::cos(3 * i * std::numbers::pi * 2 / 7),
                              std::sin(3 * i * std::numbers::pi * 2 / 7));
        std::vector<glm::uvec3> triangles;
        (void)cutPolygon(tilted(star, 3), triangles);
        QCOMPARE(triangles.size(), std::size_t(5));
    }
    void convexIsAFan()
    {
        std::vector<glm::dvec2> circle;
        for (int i = 0; i < 1000; ++i)
            circle.emplace_back(std::cos(i * std::numbers::pi / 500), std::sin(i * std::numbers::pi / 500));
        for (const unsigned seed : {1U, 2U}) {
            QVERIFY(isFan(tilted(circle, seed)));
            QVERIFY(isFan(tilted({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, seed)));
        }
        // Seen from its first corner, a dart is one too.
        QVERIFY(isFan(Corners{{0, 0, 0}, {2, 1, 0}, {0.5F, 0.5F, 0}, {1, 2, 0}}));
        QVERIFY(!isFan(Corners{{2, 1, 0}, {0.5F, 0.5F, 0}, {1, 2, 0}, {0, 0, 0}}));
    }
    /// Wherever the list begins, and however it lies in space.
    void theLetterU()
    {
        for (unsigned seed = 0; seed < 40; ++seed) {
            std::vector<glm::dvec2> points = letterU;
            std::rotate(points.begin(), points.begin() + seed % 8, points.end());
            const Corners corners = tilted(points, seed);
            QVERIFY(!isFan(corners));
            std::vector<glm::uvec3> triangles;
            QVERIFY(cutPolygon(corners, triangles));
            QCOMPARE(faultOf(corners, triangles), QString());
        }
    }
    /// Corners on a straight side: no triangle is a line.
    void cornersOnSides()
    {
        std::vector<glm::dvec2> points;
        for (std::size_t i = 0; i < letterU.size(); ++i)
            for (int k = 0; k < 5; ++k)
                points.push_back(letterU[i] + (letterU[(i + 1) % letterU.size()] - letterU[i]) * (k / 5.0));
        Corners corners;
        for (const glm::dvec2& p : points)
            corners.emplace_back(0.0F, p);
        std::vector<glm::uvec3> triangles;
        QVERIFY(cutPolygon(corners, triangles));
        QCOMPARE(faultOf(corners, triangles), QString());
    }
    /// A hole as some programs write it: the way in and the way out are one line.
    void aHoleOnABridge()
    {
        const Corners corners =
            tilted({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}}, 3);
        std::vector<glm::uvec3> triangles;
        QVERIFY(cutPolygon(corners, triangles));
        QCOMPARE(faultOf(corners, triangles), QString());
    }
    void randomOutlines()
    {
        std::mt19937 random(7);
        for (unsigned round = 0; round < 300; ++round) {
            std::vector<glm::dvec2> points;
            const int count = 4 + int(random() % 60);
            for (int i = 0; i < count; ++i) {
                const double radius = 0.1 + double(random() % 1000) / 1000.0,
                             turn = i * 2 * std::numbers::pi / count;
                points.emplace_back(radius * std::cos(turn), radius * std::sin(turn));
            }
            const Corners corners = tilted(points, round);
            std::vector<glm::uvec3> triangles;
            QVERIFY(cutPolygon(corners, triangles));
            QCOMPARE(faultOf(corners, triangles), QString());
        }
    }
    /// Two arms that wind about each other: nearly every corner is in the way of others.
    void longSpiral()
    {
        std::vector<glm::dvec2> points;
        constexpr int count = 3'000;
        for (int i = 0; i < count; ++i) {
            const double turn = i * 0.01;
            points.emplace_back((1 + turn) * std::cos(turn), (1 + turn) * std::sin(turn));
        }
        for (int i = count - 1; i >= 0; --i) {
            const double turn = i * 0.01;
            points.emplace_back((3 + turn) * std::cos(turn), (3 + turn) * std::sin(turn));
        }
        const Corners corners = tilted(points, 1);
        std::vector<glm::uvec3> triangles;
        QVERIFY(cutPolygon(corners, triangles));
        QCOMPARE(faultOf(corners, triangles), QString());
    }
};

RAMURE_SUITE(TestPolygonCut)

} // namespace tst_polygon_cut

#include "tst_polygon_cut.moc"
