#include "core/params/param_def.h"
#include "core/surface/foliage/leaf_shoot.h"
#include "core/surface/foliage/leaf_table.h"
#include "core/surface/foliage/place_foliage.h"
#include "tests/support/suite.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace tst_leaf_shoot {

using namespace ramure;

namespace {

LeafForm shoot(LeafShape shape, std::int64_t leaves, std::int64_t detail = 2,
               LeafArrangement arrangement = LeafArrangement::Natural)
{
    LeafParams params;
    params.shape = shape;
    params.perShoot = leaves;
    params.detail = detail;
    params.arrangement = arrangement;
    return leafForm(params);
}

std::size_t woodOf(const TriangleMesh& mesh, const TriangleMesh& leaf, std::size_t leaves)
{
    return mesh.triangles.size() - leaves * leaf.triangles.size();
}

TriangleMesh leafOf(LeafForm form)
{
    // Inside a shoot a leaf has fewer triangles than alone: one of a shoot of one leaf tells nothing.
    const TriangleMesh two = leafMesh((form.perShoot = 2, form)), three = leafMesh((form.perShoot = 3, form));
    TriangleMesh one;
    one.triangles.resize(three.triangles.size() - two.triangles.size());
    return one;
}

} // namespace

class TestLeafShoot : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void badNumbersAreRefused()
    {
        const ParamDef& perShoot = *findParam("foliage.leavesPerShoot");
        for (const std::int64_t bad : {std::int64_t(0), std::int64_t(-3), std::int64_t(1'000'000)})
            QVERIFY(!checkValue(perShoot, bad));
        const ParamDef& length = *findParam("foliage.leafLength");
        for (const double bad : {-0.1, 21.0, std::nan(""), HUGE_VAL})
            QVERIFY(!checkValue(length, bad));
        QVERIFY(checkValue(length, 10.0)); // a frond of a palm is not far from it
    }

    void oneLeafIsTheLeaf()
    {
        for (int i = 1; i < leafShapeCount; ++i) {
            const LeafForm form = shoot(static_cast<LeafShape>(i), 1);
            QVERIFY(form == leafForm({.shape = form.shape}));
            const TriangleMesh leaf = leafMesh(form);
            QVERIFY(shootOf(leaf, form).positions == leaf.positions);
        }
        QCOMPARE(shoot(LeafShape::Faithful, 7).perShoot, 1);
    }

    void everyPlantHasSoundShoots()
    {
        for (int i = 1; i < leafShapeCount; ++i)
            for (const std::int64_t leaves : {2, 3, 5, 8, 40})
                for (const std::int64_t detail : {1, 2, 3}) {
                    const TriangleMesh mesh = leafMesh(shoot(static_cast<LeafShape>(i), leaves, detail));
                    QCOMPARE(mesh.colours.size(), mesh.triangles.size());
                    QCOMPARE(mesh.uv.size(), mesh.positions.size());
                    QCOMPARE(mesh.normals.size(), mesh.positions.size());
                    for (const glm::uvec3& t : mesh.triangles)
                        QVERIFY(std::max({t.x, t.y, t.z}) < mesh.positions.size());
                    for (const glm::vec3& p : mesh.positions)
                        QVERIFY(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
                }
    }

    void everyLeafIsThere()
    {
        for (const LeafShape shape : {LeafShape::Beech, LeafShape::Oak, LeafShape::Maple, LeafShape::Spruce})
            for (const auto arrangement :
                 {LeafArrangement::Natural, LeafArrangement::Distichous, LeafArrangement::Spiral,
                  LeafArrangement::Opposite, LeafArrangement::Decussate, LeafArrangement::Whorled})
                for (std::int64_t leaves = 2; leaves < 12; ++leaves) {
                    const LeafForm form = shoot(shape, leaves, 2, arrangement);
                    const std::size_t wood =
                        woodOf(leafMesh(form), leafOf(form), static_cast<std::size_t>(leaves));
                    QVERIFY2(wood >= 3 && wood <= 9, qPrintable(QString::number(wood)));
                }
    }

    /// A shoot begins in the bark and grows away from it: the more leaves, the longer.
    void shootsGrowWithTheirLeaves()
    {
        float before = 0.0F;
        for (const std::int64_t leaves : {3, 6, 12, 24}) {
            const TriangleMesh mesh = leafMesh(shoot(LeafShape::Elm, leaves));
            const float low = std::ranges::min(mesh.positions, {}, &glm::vec3::y).y;
            const float high = std::ranges::max(mesh.positions, {}, &glm::vec3::y).y;
            QVERIFY(low < 0.0F && low > -0.6F);
            QVERIFY(high > before);
            before = high;
        }
    }

    void cardsStandWhereTheLeavesDo()
    {
        const LeafForm form = shoot(LeafShape::Beech, 5);
        const TriangleMesh fine = leafMesh(form), square = leafCard(form),
                           rhomb = leafCard(form, CardOutline::Rhomb);
        QCOMPARE(square.triangles.size(), rhomb.triangles.size());
        QVERIFY(rhomb.triangles.size() < fine.triangles.size());
        const auto middle = [](const TriangleMesh& mesh) {
            glm::dvec3 sum(0.0);
            for (const glm::vec3& p : mesh.positions)
                sum += glm::dvec3(p);
            return sum / double(mesh.positions.size());
        };
        QVERIFY(glm::length(middle(fine) - middle(square)) < 0.35);
        QVERIFY(glm::length(middle(rhomb) - middle(square)) < 0.05);
    }

    void greenIsMeasuredWithoutItsWood()
    {
        const LeafForm one = shoot(LeafShape::Willow, 1), many = shoot(LeafShape::Willow, 10);
        QVERIFY(bladeArea(many) > 5.0 * bladeArea(one) && bladeArea(many) < 10.0 * bladeArea(one));
        LeafForm wide = many;
        wide.width = 2.0;
        QVERIFY(bladeArea(wide) > 1.5 * bladeArea(many));
    }
};

RAMURE_SUITE(TestLeafShoot)

} // namespace tst_leaf_shoot

#include "tst_leaf_shoot.moc"
