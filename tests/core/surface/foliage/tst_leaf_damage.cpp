#include "core/surface/foliage/leaf_damage.h"

#include "core/params/param_def.h"
#include "core/surface/foliage/place_foliage.h"
#include "tests/support/preset_trees.h"
#include "tests/support/suite.h"
#include <cmath>

namespace tst_leaf_damage {

using namespace ramure;

namespace {

Foliage leavesOf(double share)
{
    const auto skeleton = test::presetSkeleton({"TinyTree"});
    LeafParams leaf;
    leaf.shape = LeafShape::Oak;
    leaf.damage = share;
    auto foliage = placeFoliage(*skeleton, {0.1, 10, 0.0, 1}, leaf, {}, 0.2);
    if (!foliage)
        qFatal("%s", foliage.error().message().c_str());
    return std::move(*foliage);
}

} // namespace

class TestLeafDamage : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void sharesOutsideAreRefused()
    {
        NodeParams params;
        for (const double share : {-0.01, 1.01, std::nan("")})
            QVERIFY(!setParam(params, *findParam("foliage.leafDamage"), share));
    }

    /// As many leaves as said are smaller and of another colour; more damage marks those of less, too.
    void asManyAreMarkedAsItSays()
    {
        const Foliage whole = leavesOf(0.0);
        std::vector<bool> before(whole.leaves.size(), false);
        for (const double share : {0.05, 0.3, 1.0}) {
            const Foliage marked = leavesOf(share);
            QCOMPARE(marked.leaves.size(), whole.leaves.size());
            std::size_t count = 0;
            for (std::size_t i = 0; i < whole.leaves.size(); ++i) {
                const bool isMarked = marked.leaves[i].tint != whole.leaves[i].tint;
                QCOMPARE(isMarked, marked.leaves[i].size < whole.leaves[i].size);
                QVERIFY(isMarked || !before[i]);
                QVERIFY(glm::all(glm::lessThanEqual(marked.leaves[i].tint, glm::vec3(1.0f))));
                before[i] = isMarked;
                count += isMarked ? 1 : 0;
            }
            const double expected = share * double(whole.leaves.size());
            QVERIFY(std::abs(double(count) - expected) <= 4.0 * std::sqrt(expected));
        }
    }
};

RAMURE_SUITE(TestLeafDamage)

} // namespace tst_leaf_damage

#include "tst_leaf_damage.moc"
