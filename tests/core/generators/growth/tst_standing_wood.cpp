#include "core/generators/growth/standing_wood.h"
#include "core/params/param_def.h"
#include "tests/support/suite.h"
#include <cmath>
#include <set>

namespace tst_standing_wood {

using namespace ramure;

namespace {

GrowthParams usual()
{
    GrowthParams params;
    params.height = 6.0;
    params.crownWidth = 5.0;
    params.maturity = 20.0;
    return params;
}

/// A bare trunk that leans, of so many pieces.
Skeleton trunk(int pieces, double height, const glm::dvec3& foot = glm::dvec3(0.0))
{
    Skeleton tree;
    glm::dvec3 from = foot;
    for (int k = 0; k < pieces; ++k) {
        const glm::dvec3 to =
            foot + height * double(k + 1) / pieces * glm::dvec3(0.3 * double(k) / pieces, 1.0, 0.0);
        tree.add(k == 0 ? noIndex : Index(k - 1), from, to, 0.12 - 0.08 * k / pieces,
                 0.12 - 0.08 * (k + 1) / pieces);
        from = to;
    }
    return tree;
}

std::set<std::uint64_t> addressesOf(const TreeAxes& axes)
{
    std::set<std::uint64_t> all;
    for (const Axis& axis : axes.axes)
        all.insert(axis.address);
    return all;
}

/// How far a point is from a tree's pieces.
double distance(const Skeleton& tree, const glm::dvec3& at)
{
    double nearest = 1e9;
    for (Index i = 0; i < tree.size(); ++i) {
        const glm::dvec3 way = tree.p1[i] - tree.p0[i];
        const double t = std::clamp(glm::dot(at - tree.p0[i], way) / glm::dot(way, way), 0.0, 1.0);
        nearest = std::min(nearest, glm::length(at - tree.p0[i] - t * way));
    }
    return nearest;
}

} // namespace

class TestStandingWood : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void whatCannotGrowOnSaysWhy()
    {
        const auto nothing = growOn({}, {}, usual(), 5.0, 1);
        QVERIFY(!nothing);
        QCOMPARE(nothing.error().code, ErrorCode::Invalid);
        const Skeleton tree = trunk(6, 2.0);
        GrowthParams params = usual();
        params.internode = -1.0;
        const auto wrong = growOn(tree, axesOf(tree), params, 5.0, 1);
        QVERIFY(!wrong);
        QCOMPARE(wrong.error().path, std::string("growth.internode"));
        params = usual();
        params.sunlight = 0.0;
        QVERIFY(!growOn(tree, axesOf(tree), params, 40.0, 1));
        std::stop_source stop;
        stop.request_stop();
        const auto cancelled = growOn(tree, axesOf(tree), usual(), 5.0, 1, {stop.get_token(), {}});
        QVERIFY(!cancelled);
        QCOMPARE(cancelled.error().code, ErrorCode::Cancelled);
    }

    /// A trunk that was drawn gets limbs, and stays where it is.
    void aBareTrunkLivesOn()
    {
        const glm::dvec3 foot(3.0, 0.0, -1.0);
        const Skeleton tree = trunk(6, 2.0, foot);
        const TreeAxes axes = axesOf(tree);
        const auto later = growOn(tree, axes, usual(), 12.0, 1);
        QVERIFY(later);
        const TreeAxes now = axesOf(*later);
        QVERIFY(now.axes.size() > 20);
        QCOMPARE(now.axes.front().address, axes.axes.front().address);
        QVERIFY(later->p0.front() == foot);
        for (const glm::dvec3& node : tree.p1)
            QVERIFY(distance(*later, node) < 0.03);
        QVERIFY(later->a0.front() >= 0.999 * tree.a0.front());
        QVERIFY(skeletonStats(*later).max.y > 2.3);
        std::set<std::uint64_t> keys(later->key.begin(), later->key.end());
        QCOMPARE(keys.size(), std::size_t(later->size()));
    }

    void moreYearsAreMoreTree()
    {
        const Skeleton tree = trunk(8, 1.5);
        double before = 0.0;
        for (const double years : {1.0, 4.0, 8.0, 16.0}) {
            const auto later = growOn(tree, axesOf(tree), usual(), years, 2);
            QVERIFY(later);
            const double length = skeletonStats(*later).totalLength;
            QVERIFY(length > before);
            before = length;
        }
    }

    void theSameSeedGivesTheSameTree()
    {
        const Skeleton tree = trunk(6, 2.0);
        const auto one = growOn(tree, axesOf(tree), usual(), 8.0, 5),
                   again = growOn(tree, axesOf(tree), usual(), 8.0, 5),
                   other = growOn(tree, axesOf(tree), usual(), 8.0, 6);
        QVERIFY(one && again && other);
        QVERIFY(*one == *again);
        QVERIFY(one->p1 != other->p1);
    }

    /// Twice: axes of before keep their addresses, and no two share one.
    void itCanGoOnAgain()
    {
        const Skeleton tree = trunk(6, 2.0);
        GrowthParams params = usual();
        params.shadeTolerance = 0.8;
        params.shedding = 0.2;
        const auto once = growOn(tree, axesOf(tree), params, 6.0, 1);
        QVERIFY(once);
        const TreeAxes before = axesOf(*once);
        const auto twice = growOn(*once, before, params, 6.0, 2);
        QVERIFY(twice);
        const TreeAxes after = axesOf(*twice);
        const auto then = addressesOf(before), now = addressesOf(after);
        QCOMPARE(now.size(), after.axes.size());
        std::size_t kept = 0;
        for (const std::uint64_t address : then)
            kept += now.contains(address) ? 1 : 0;
        QVERIFY2(2 * kept > then.size(), qPrintable(QString("%1 of %2").arg(kept).arg(then.size())));
        QVERIFY(now.size() > then.size());
    }

    /// Trunks beside each other, axes of a high order, pieces without a length, very long ones.
    void strangeTreesGrowOn()
    {
        Skeleton tree = trunk(3, 1.0);
        const Index second = tree.add(noIndex, {2.0, 0.0, 0.0}, {2.0, 1.0, 0.0}, 0.05, 0.03);
        tree.add(second, {2.0, 1.0, 0.0}, {2.0, 1.0, 0.0}, 0.03, 0.03);
        Index below = 2;
        for (Index order = 1; order < 20; ++order) {
            const glm::dvec3 from = tree.p1[below];
            tree.add(below, from, from + glm::dvec3(order % 2 ? 0.3 : -0.1, 0.1, 0.0), 0.01, 0.008, order);
            below = tree.size() - 1;
            tree.add(below, tree.p1[below], tree.p1[below] + glm::dvec3(0.0, 0.2, 0.05), 0.008, 0.007, order);
        }
        tree.add(second, {2.0, 1.0, 0.0}, {60.0, 30.0, 0.0}, 0.03, 0.02, 1);
        const auto later = growOn(tree, axesOf(tree), usual(), 5.0, 1);
        QVERIFY(later);
        for (Index i = 0; i < later->size(); ++i) {
            QVERIFY(std::isfinite(later->p1[i].x + later->p1[i].y + later->p1[i].z));
            QVERIFY(later->a1[i] > 0.0 && later->a1[i] <= later->a0[i]);
            QVERIFY(later->parent[i] == noIndex || later->p0[i] == later->p1[later->parent[i]]);
        }
        QCOMPARE(skeletonStats(*later).roots, Index(2));
    }
};

RAMURE_SUITE(TestStandingWood)

} // namespace tst_standing_wood

#include "tst_standing_wood.moc"
