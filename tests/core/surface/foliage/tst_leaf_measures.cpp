#include "core/surface/foliage/leaf_measures.h"
#include "core/surface/foliage/leaf_shoot.h"
#include "core/surface/foliage/leaf_table.h"
#include "core/surface/foliage/place_foliage.h"
#include "tests/support/suite.h"

#include <cmath>
#include <numbers>

namespace tst_leaf_measures {

using namespace ramure;

namespace {

/// A crown of a few leaves of chosen sizes.
Foliage crown(LeafShape shape, std::initializer_list<float> sizes, double length = 0.0)
{
    LeafParams params;
    params.shape = shape;
    params.length = length;
    Foliage foliage;
    foliage.form = leafForm(params);
    for (const float size : sizes) {
        FoliageItem item;
        item.branch = 0;
        item.size = size;
        foliage.leaves.push_back(item);
    }
    return foliage;
}

} // namespace

class TestLeafMeasures : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void aBareTreeHasNone()
    {
        const LeafMeasures none = leafMeasures(crown(LeafShape::Beech, {}), 0.3, 10.0);
        QCOMPARE(none.leaves, std::size_t(0));
        QCOMPARE(none.area + none.areaIndex + none.length + none.reach, 0.0);
    }

    void withoutACrownThereIsNoIndex()
    {
        const LeafMeasures one = leafMeasures(crown(LeafShape::Beech, {1.0F}, 0.1), 0.3, 0.0);
        QVERIFY(one.area > 0.0);
        QCOMPARE(one.areaIndex, 0.0);
    }

    void sizesAreMetres()
    {
        const Foliage foliage = crown(LeafShape::Oak, {0.5F, 1.0F, 2.0F}, 0.11);
        const LeafMeasures sizes = leafMeasures(foliage, 17.0, 2.0); // whatever the trunk
        QCOMPARE(sizes.leaves, std::size_t(3));
        QVERIFY(std::abs(sizes.length - 0.11) < 1e-12);
        QVERIFY(std::abs(sizes.reach - 0.11 * (1.0 + leafRow(LeafShape::Oak).petiole)) < 1e-12);
        const double each = bladeArea(foliage.form) * 0.11 * 0.11;
        QVERIFY(std::abs(sizes.area - 5.25 * each) < 1e-9);
        QVERIFY(std::abs(sizes.areaIndex - sizes.area / std::numbers::pi) < 1e-12);
    }

    void withoutALengthLeavesGrowWithTheTrunk()
    {
        const Foliage foliage = crown(LeafShape::Oak, {1.0F});
        const LeafMeasures thin = leafMeasures(foliage, 0.1, 1.0), thick = leafMeasures(foliage, 0.4, 1.0);
        QVERIFY(std::abs(thin.length - 0.1 * leafRow(LeafShape::Oak).length) < 1e-12);
        QVERIFY(std::abs(thick.area / thin.area - 16.0) < 1e-9);
    }

    void shootsCountWithAllTheirLeaves()
    {
        Foliage foliage = crown(LeafShape::Beech, {1.0F, 1.0F}, 0.08);
        const LeafMeasures alone = leafMeasures(foliage, 0.3, 4.0);
        LeafParams params;
        params.shape = LeafShape::Beech;
        params.length = 0.08;
        params.perShoot = 6;
        foliage.form = leafForm(params);
        const LeafMeasures shoots = leafMeasures(foliage, 0.3, 4.0);
        QCOMPARE(shoots.leaves, std::size_t(12));
        QVERIFY(shoots.area > 3.0 * alone.area && shoots.area < 6.0 * alone.area);
    }
};

RAMURE_SUITE(TestLeafMeasures)

} // namespace tst_leaf_measures

#include "tst_leaf_measures.moc"
