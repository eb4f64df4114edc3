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

    /// A bare limb gets no shoots and no leaves: it breaks off from its end, a twig sooner than thick wood. A
    /// bare piece below what lives stays bare.
    void deadWoodStaysDeadAndFalls()
    {
        Skeleton tree = trunk(6, 2.0);
        const Index thick = tree.add(3, tree.p1[3], tree.p1[3] + glm::dvec3(0.5, 0.2, 0.0), 0.05, 0.04, 1);
        tree.add(thick, tree.p1[thick], tree.p1[thick] + glm::dvec3(0.6, 0.2, 0.0), 0.04, 0.004, 1);
        const Index twig = tree.add(4, tree.p1[4], tree.p1[4] + glm::dvec3(0.0, 0.1, 0.4), 0.004, 0.002, 1);
        tree.bare = {1, thick, Index(thick + 1), twig};
        for (Index i = 0; i < tree.size(); ++i)
            tree.key[i] = i + 1;
        const TreeAxes axes = axesOf(tree);
        struct Stands
        {
            double limb = 0.0, twig = 0.0; // m
        };
        const auto after = [&](double years) {
            Stands stands;
            const auto later = growOn(tree, axes, usual(), years, 3);
            if (!later)
                return stands;
            const TreeAxes now = axesOf(*later);
            for (const Axis& axis : now.axes) {
                const bool isLimb = axis.address == axes.axes[axes.axisOf[thick]].address;
                if (!isLimb && axis.address != axes.axes[axes.axisOf[twig]].address)
                    continue;
                for (const Index i : now.nodesOf(Index(&axis - now.axes.data()))) {
                    (isLimb ? stands.limb : stands.twig) += later->length(i);
                    if (!std::ranges::binary_search(later->bare, i) ||
                        std::ranges::any_of(later->parent, [&](Index below) {
                            return below == i && now.axisOf[below] != now.axisOf[i];
                        }))
                        stands.limb = -1e9;
                }
            }
            const auto bareOfTrunk =
                std::ranges::count(later->bare, Index(0), [&](Index i) { return now.axisOf[i]; });
            if (bareOfTrunk == 0 || bareOfTrunk >= std::ptrdiff_t(now.nodesOf(0).size() / 2))
                stands.limb = -1e9; // the trunk was bare in one of six places
            return stands;
        };
        const double whole = tree.length(thick) + tree.length(thick + 1);
        const Stands soon = after(2.0), later = after(6.0), last = after(25.0);
        QVERIFY2(std::abs(soon.limb - whole) < 0.05 && soon.twig > 0.3,
                 qPrintable(QString::number(soon.limb)));
        QVERIFY2(later.limb > 0.4 && later.limb < whole - 0.1, qPrintable(QString::number(later.limb)));
        QCOMPARE(later.twig, 0.0);
        QCOMPARE(last.limb, 0.0);
        for (Index i = 0; i < tree.size(); ++i)
            tree.bare.push_back(i);
        tree.bare.erase(tree.bare.begin(), tree.bare.begin() + 4);
        const auto dead = growOn(tree, axes, usual(), 5.0, 3);
        QVERIFY(!dead);
        QCOMPARE(dead.error().code, ErrorCode::Invalid);
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
