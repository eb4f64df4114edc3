#include "core/surface/foliage/leaf_season.h"

#include "core/params/param_def.h"
#include "core/scene/material.h"
#include "core/surface/foliage/fruit_shapes.h"
#include "core/surface/foliage/leaf_table.h"
#include "core/surface/foliage/place_foliage.h"
#include "tests/support/preset_trees.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <set>

namespace tst_leaf_season {

using namespace ramure;

namespace {

Foliage leavesAt(double season, LeafShape shape = LeafShape::Maple)
{
    const auto skeleton = test::presetSkeleton({"TinyTree"});
    LeafParams leaf;
    leaf.shape = shape;
    leaf.season = season;
    auto foliage = placeFoliage(*skeleton, {0.1, 10, 0.0, 1}, leaf, {}, 0.2);
    if (!foliage)
        qFatal("%s", foliage.error().message().c_str());
    return std::move(*foliage);
}

std::set<std::pair<Index, std::uint32_t>> addresses(const Foliage& foliage)
{
    std::set<std::pair<Index, std::uint32_t>> out;
    for (const FoliageItem& leaf : foliage.leaves)
        out.emplace(leaf.branch, leaf.number);
    return out;
}

glm::vec3 meanTint(const Foliage& foliage)
{
    glm::vec3 sum(0.0F);
    for (const FoliageItem& leaf : foliage.leaves)
        sum += leaf.tint;
    return sum / float(foliage.leaves.size());
}

} // namespace

class TestLeafSeason : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void seasonsOutsideTheYearAreRefused()
    {
        NodeParams params;
        for (const double season : {-0.01, 1.01})
            QVERIFY(!setParam(params, *findParam("foliage.season"), season));
    }

    void bareTreesAndFaithfulLeavesStay()
    {
        Foliage none;
        none.form.shape = LeafShape::Maple;
        turnLeaves(Skeleton(), 1.0, none);
        QVERIFY(none.leaves.empty() && none.shed == 0);
        QCOMPARE(leavesAt(1.0, LeafShape::Faithful).leaves.size(),
                 leavesAt(0.0, LeafShape::Faithful).leaves.size());
    }

    /// In summer leaves differ by what they are: some are yellower, some bluer, none is brighter than their
    /// plant's.
    void summerHasAllItsGreens()
    {
        const Foliage summer = leavesAt(0.0);
        QCOMPARE(summer.shed, std::size_t(0));
        std::size_t yellow = 0, blue = 0;
        for (const FoliageItem& leaf : summer.leaves) {
            QVERIFY(glm::all(glm::lessThanEqual(leaf.tint, glm::vec3(1.0F))));
            QVERIFY(glm::all(glm::greaterThan(leaf.tint, glm::vec3(0.75F))));
            yellow += leaf.tint.b < 0.95F ? 1 : 0;
            blue += leaf.tint.r < 0.95F ? 1 : 0;
        }
        QVERIFY(4 * yellow > summer.leaves.size() && 5 * blue > summer.leaves.size());
        QCOMPARE(leavesMaterial(LeafShape::Maple).colour, leafRow(LeafShape::Maple).colour);
        // The first day after it looks the same.
        const Foliage next = leavesAt(1e-9);
        const glm::vec3 green = meanTint(summer) * glm::vec3(leafRow(LeafShape::Maple).colour);
        const glm::vec3 seen = meanTint(next) * glm::vec3(leavesMaterial(LeafShape::Maple, true).colour);
        QVERIFY(glm::length(seen - green) < 1.0F);
    }

    void laterSeasonsShedMoreOfTheSame()
    {
        auto before = addresses(leavesAt(0.0));
        const std::size_t all = before.size();
        for (const double season : {0.3, 0.6, 0.7, 0.8, 0.9, 1.0}) {
            const Foliage foliage = leavesAt(season);
            const auto now = addresses(foliage);
            QVERIFY(std::ranges::includes(before, now));
            QCOMPARE(now.size() + foliage.shed, all);
            before = now;
        }
        QVERIFY(before.empty());
        QVERIFY(leavesAt(0.5).shed == 0 && leavesAt(0.8).shed > all / 4 && leavesAt(0.8).shed < all);
    }

    void leavesTurnRed()
    {
        const glm::vec3 summer = meanTint(leavesAt(0.05)), autumn = meanTint(leavesAt(0.6));
        QVERIFY(autumn.r > 1.3F * summer.r && autumn.g < 0.8F * summer.g);
        const Foliage half = leavesAt(0.4); // not all at once
        const auto [least, most] =
            std::ranges::minmax_element(half.leaves, {}, [](const FoliageItem& leaf) { return leaf.tint.r; });
        QVERIFY(most->tint.r - least->tint.r > 0.1F);
    }

    void fruitFallBeforeTheLeavesAreDown()
    {
        const auto skeleton = test::presetSkeleton({"TinyTree"});
        const auto hanging = [&](FruitKind kind, LeafShape shape, double season) {
            LeafParams leaf;
            leaf.shape = shape;
            leaf.season = season;
            FruitParams fruit;
            fruit.kind = kind;
            const auto foliage = placeFoliage(*skeleton, {0.1, 10, 1.0, 1}, leaf, fruit, 0.2);
            return foliage ? foliage->apples.size() : std::size_t(0);
        };
        const std::size_t all = hanging(FruitKind::Acorn, LeafShape::Oak, 0.0);
        QVERIFY(all > 20);
        std::size_t before = all;
        for (const double season : {0.4, 0.5, 0.6, 0.7, 0.8}) {
            const std::size_t now = hanging(FruitKind::Acorn, LeafShape::Oak, season);
            QVERIFY(now <= before);
            before = now;
        }
        QCOMPARE(before, std::size_t(0));
        QCOMPARE(hanging(FruitKind::Acorn, LeafShape::Oak, 1.0), std::size_t(0));
        QCOMPARE(hanging(FruitKind::Acorn, LeafShape::Oak, 0.3), all);
        QVERIFY(hanging(FruitKind::Blossom, LeafShape::Cherry, 0.0) > 0);
        QCOMPARE(hanging(FruitKind::Blossom, LeafShape::Cherry, 0.5), std::size_t(0));
        QVERIFY(hanging(FruitKind::Cone, LeafShape::Oak, 1.0) > 0);
        QVERIFY(hanging(FruitKind::Olive, LeafShape::Olive, 1.0) > 0);
    }

    /// A tree has hundreds of them.
    void smallFruitHaveFewTriangles()
    {
        for (const FruitKind kind :
             {FruitKind::Acorn, FruitKind::Cherry, FruitKind::Olive, FruitKind::Berries})
            QVERIFY(fruitMesh({kind, 1.0, 1.0}).faceCount() <= 80);
    }

    void evergreensStay()
    {
        for (const LeafShape shape : {LeafShape::Fir, LeafShape::Olive, LeafShape::Palm}) {
            const Foliage foliage = leavesAt(1.0, shape);
            QCOMPARE(foliage.shed, std::size_t(0));
            QCOMPARE(meanTint(foliage), meanTint(leavesAt(0.0, shape)));
            QCOMPARE(leafColour(shape, true), leafColour(shape, false));
        }
    }
};

RAMURE_SUITE(TestLeafSeason)

} // namespace tst_leaf_season

#include "tst_leaf_season.moc"
