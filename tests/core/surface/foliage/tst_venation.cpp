#include "core/surface/foliage/venation.h"

#include "core/surface/foliage/leaf_maps.h"
#include "core/surface/foliage/leaf_table.h"
#include "tests/support/suite.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace tst_venation {

using namespace ramure;

namespace {

bool isIn(const FlatBlade& blade, const glm::dvec2& p, double slack)
{
    return std::ranges::any_of(blade.triangles, [&](const glm::uvec3& t) {
        const glm::dvec2 corner[] = {blade.points[t.x], blade.points[t.y], blade.points[t.z]};
        for (int i = 0; i < 3; ++i) {
            const glm::dvec2 a = corner[i], b = corner[(i + 1) % 3], way = b - a;
            if ((way.x * (p.y - a.y) - way.y * (p.x - a.x)) / std::hypot(way.x, way.y) < -slack)
                return false;
        }
        return true;
    });
}

} // namespace

class TestVenation : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void nothingGrowsWithoutABlade()
    {
        QVERIFY(venation({}, {{0.0, 1.0}}, 0.1, 1).empty());
        QVERIFY(!leafMaps(LeafShape::Faithful, 64));
        for (const int size : {-1, 0, 15, 8193, 1 << 30})
            QCOMPARE(leafMaps(LeafShape::Oak, size).error().code, ErrorCode::Invalid);
    }
    /// Each piece begins where another ends, inside the blade; bundles hold what their branches hold.
    void veinsAreATreeInsideTheBlade()
    {
        for (int i = 1; i < leafShapeCount; ++i) {
            const VeinedBlade veined = veinedBlade(static_cast<LeafShape>(i));
            QVERIFY(!veined.veins.empty());
            QVERIFY(veined.veins.size() < 5000);
            std::map<std::pair<double, double>, double> arrives;
            std::map<std::pair<double, double>, double> leaves;
            for (const Vein& vein : veined.veins) {
                const std::pair from(vein.from.x, vein.from.y);
                QVERIFY(from == std::pair(0.0, 0.0) || arrives.contains(from)); // parents first
                QVERIFY2(isIn(veined.blade, vein.to, 1e-6), qPrintable(QString::number(i)));
                arrives[{vein.to.x, vein.to.y}] += std::pow(vein.radius, 3.0);
                leaves[from] += std::pow(vein.radius, 3.0);
                QVERIFY(vein.radius > 0.99);
            }
            for (const auto& [place, cubes] : leaves)
                if (arrives.contains(place))
                    QVERIFY(std::abs(arrives[place] - cubes) < 1e-6 * cubes);
        }
    }
    void theSameSeedGivesTheSameVeins()
    {
        const FlatBlade blade = bladeOf(leafRow(LeafShape::Beech), 1.0, 5, true);
        const auto points = [&](std::uint64_t seed) {
            std::vector<double> all;
            for (const Vein& vein : venation(blade, {{0.0, 0.9}}, 0.08, seed))
                all.insert(all.end(), {vein.to.x, vein.to.y, vein.radius});
            return all;
        };
        QCOMPARE(points(3), points(3));
        QVERIFY(points(3) != points(4));
    }
    void picturesShowThem()
    {
        for (const LeafShape shape :
             {LeafShape::Oak, LeafShape::Maple, LeafShape::Ginkgo, LeafShape::Willow}) {
            const auto maps = leafMaps(shape, 128);
            QVERIFY2(maps, test::why(maps));
            const std::size_t pixels = 128 * 128;
            QCOMPARE(maps->colour.size(), pixels);
            QCOMPARE(maps->normal.size(), pixels);
            QCOMPARE(maps->height.size(), pixels);
            std::size_t inside = 0, veined = 0;
            for (std::size_t i = 0; i < pixels; ++i) {
                inside += maps->coverage[i] == 255 ? 1 : 0;
                veined += maps->through[i] < 200 ? 1 : 0;
                QVERIFY(maps->normal[i].z > 127); // upwards
            }
            QVERIFY(inside > pixels / 5 && inside < pixels);
            QVERIFY2(veined > pixels / 100 && veined < pixels / 2,
                     qPrintable(QString::number(int(shape)) + ": " + QString::number(veined)));
        }
    }
};

RAMURE_SUITE(TestVenation)

} // namespace tst_venation

#include "tst_venation.moc"
