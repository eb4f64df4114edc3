#include "core/surface/foliage/leaf_light.h"

#include "core/params/param_def.h"
#include "core/surface/foliage/place_foliage.h"
#include "tests/support/preset_trees.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>

namespace tst_leaf_light {

using namespace ramure;

namespace {

Foliage leavesOf(double ratio)
{
    const auto skeleton = test::presetSkeleton({"TinyTree"});
    LeafParams leaf;
    leaf.shape = LeafShape::Beech;
    leaf.shade = ratio;
    auto foliage = placeFoliage(*skeleton, {0.1, 10, 0.0, 1}, leaf, {}, 0.2);
    if (!foliage)
        qFatal("%s", foliage.error().message().c_str());
    return std::move(*foliage);
}

} // namespace

class TestLeafLight : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void ratiosOutsideAreRefused()
    {
        NodeParams params;
        for (const double ratio : {0.24, 4.01, std::nan("")})
            QVERIFY(!setParam(params, *findParam("foliage.shadeLeaves"), ratio));
    }

    void fewLeavesHaveLight()
    {
        QVERIFY(leafLight({}).empty());
        const std::vector<FoliageItem> one(1), same(5);
        for (const auto& leaves : {one, same})
            for (const float light : leafLight(leaves))
                QVERIFY(light >= 0.0f && light <= 1.0f);
        Foliage none;
        growByLight(1.6, none);
        QVERIFY(none.leaves.empty());
    }

    /// Outside there is more light than inside, on top more than below.
    void lightComesFromOutsideAndAbove()
    {
        std::vector<FoliageItem> ball;
        for (int x = -6; x <= 6; ++x)
            for (int y = -6; y <= 6; ++y)
                for (int z = -6; z <= 6; ++z)
                    if (x * x + y * y + z * z <= 36)
                        ball.emplace_back().position = {x, 10 + y, z};
        const std::vector<float> light = leafLight(ball);
        const auto at = [&](const glm::dvec3& place) {
            const auto found = std::ranges::find(ball, place, &FoliageItem::position);
            return light[std::size_t(found - ball.begin())];
        };
        QVERIFY(at({0, 16, 0}) > 0.9f);
        QVERIFY(at({0, 10, 0}) < 0.05f);
        QVERIFY(at({0, 16, 0}) > at({6, 10, 0}) && at({6, 10, 0}) > at({0, 4, 0}));
        QVERIFY(at({6, 10, 0}) > at({3, 10, 0}));
        QCOMPARE(at({6, 10, 0}), at({0, 10, 6}));
    }

    /// The mean size stays, and the areas of shade and sun stand as the ratio says.
    void shadeLeavesAreLarger()
    {
        const Foliage even = leavesOf(1.0);
        for (const double ratio : {1.3, 1.8, 4.0}) {
            const Foliage made = leavesOf(ratio);
            QCOMPARE(made.leaves.size(), even.leaves.size());
            double sum = 0.0, least = 1e9, most = 0.0;
            const std::vector<float> light = leafLight(even.leaves);
            for (std::size_t i = 0; i < made.leaves.size(); ++i) {
                const double grown = double(made.leaves[i].size) / double(even.leaves[i].size);
                sum += std::log(grown);
                least = std::min(least, grown);
                most = std::max(most, grown);
                QCOMPARE(made.leaves[i].position, even.leaves[i].position);
                QVERIFY(glm::all(glm::lessThanEqual(made.leaves[i].tint, even.leaves[i].tint)));
            }
            QVERIFY(std::abs(sum / double(made.leaves.size())) < 1e-4);
            const auto [dark, bright] = std::ranges::minmax(light);
            QVERIFY(std::abs(most * most / (least * least) - std::pow(ratio, double(bright - dark))) < 1e-3);
        }
    }
};

RAMURE_SUITE(TestLeafLight)

} // namespace tst_leaf_light

#include "tst_leaf_light.moc"
