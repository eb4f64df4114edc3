#include "core/math/random.h"
#include "core/surface/mesh/near_positions.h"
#include "tests/support/suite.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <set>

namespace tst_near_positions {

using namespace ramure;

namespace {

bool areNear(const glm::vec3& a, const glm::vec3& b, double distance)
{
    const glm::dvec3 way = glm::dvec3(a) - glm::dvec3(b);
    return glm::dot(way, way) <= distance * distance;
}

/// By the definition.
std::vector<NearPair> allPairs(const std::vector<glm::vec3>& positions, double distance)
{
    std::vector<NearPair> pairs;
    for (Index v = 0; v < positions.size(); ++v)
        for (Index earlier = 0; earlier < v; ++earlier)
            if (areNear(positions[v], positions[earlier], distance))
                pairs.push_back({v, earlier});
    return pairs;
}

} // namespace

class TestNearPositions : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void nothingIsNearNothing()
    {
        QVERIFY(findNearPositions({}, 1.0).empty());
        const std::vector<glm::vec3> one{{1, 2, 3}};
        QVERIFY(findNearPositions(one, 1.0).empty());
    }
    void whatIsNotFiniteIsNearNothing()
    {
        constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                        infinite = std::numeric_limits<float>::infinity(),
                        most = std::numeric_limits<float>::max();
        const std::vector<glm::vec3> positions{{0, nan, 0},   {0, nan, 0}, {infinite, 0, 0}, {infinite, 0, 0},
                                               {most, 0, -1}, {0, 0, 0},   {most, 0, -1},    {-most, 0, 0}};
        QCOMPARE(findNearPositions(positions, 1e-4), (std::vector<NearPair>{{6, 4}}));
    }
    /// Clouds, sheets and lines, some far from the origin, with vertices in one place and at the distance.
    void findsThePairsOfTheDefinition()
    {
        for (std::uint64_t seed = 0; seed < 100; ++seed) {
            Random random(seed, RandomStream::Test);
            const double distance = std::pow(10.0, random.range(-6.0, 1.0));
            const double width = distance * std::pow(10.0, random.range(-0.5, 3.0));
            const glm::dvec3 flat(1.0, random.below(2), random.below(2));
            const glm::dvec3 centre(seed % 3 == 0 ? 1000.0 * width : 0.0);
            std::vector<glm::vec3> positions;
            for (int i = 0; i < 200; ++i) {
                const glm::dvec3 at(random.unit(), random.unit(), random.unit());
                positions.emplace_back(centre + width * flat * at);
                if (random.below(4) == 0)
                    positions.push_back(
                        positions[random.below(static_cast<std::uint32_t>(positions.size()))]);
                if (random.below(4) == 0)
                    positions.push_back(positions.back() + glm::vec3(float(distance), 0, 0));
            }
            const std::vector<NearPair> pairs = allPairs(positions, distance);
            QCOMPARE(findNearPositions(positions, distance), pairs);
            std::set<Index> vertices, found;
            for (const NearPair& pair : pairs)
                vertices.insert(pair.vertex);
            for (const NearPair& pair : findNearVertices(positions, distance)) {
                found.insert(pair.vertex);
                QVERIFY(std::ranges::find(pairs, pair) != pairs.end());
            }
            QVERIFY(found == vertices);
        }
    }
    void heapsAreQuick()
    {
        const std::vector<glm::vec3> heap(20'000, glm::vec3(0.5F));
        const auto pairs = findNearPositions(heap, 1e-4, 1000);
        QCOMPARE(pairs.size(), std::size_t(1000));
        for (const NearPair& pair : pairs)
            QVERIFY(pair.earlier < pair.vertex);
        QVERIFY(findNearVertices(heap, 1e-4).size() < 8 * heap.size());
    }
};

RAMURE_SUITE(TestNearPositions)

} // namespace tst_near_positions

#include "tst_near_positions.moc"
