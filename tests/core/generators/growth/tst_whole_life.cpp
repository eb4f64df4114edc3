#include "core/generators/growth/whole_life.h"

#include "core/generators/growth/grown_skeleton.h"
#include "core/skeleton/skeleton_check.h"
#include "tests/support/suite.h"
#include <algorithm>

namespace tst_whole_life {

using namespace ramure;

namespace {

GrowthHistory grown(double age, std::uint64_t seed = 1)
{
    GrowthParams params;
    params.age = age;
    params.height = 10.0;
    params.crownWidth = 8.0;
    auto history = growHistory(params, seed);
    if (!history)
        qFatal("%s", test::why(history).constData());
    return std::move(*history);
}

} // namespace

/// All wood of a tree's life.
class TestWholeLife : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void withoutAxesThereIsNothing()
    {
        const GrowthHistory history = grown(8.0);
        const WholeLife life = wholeLife(history, std::vector<bool>(history.axisAddress.size(), false));
        QVERIFY(life.skeleton.empty() && life.metamer.empty());
        // Nor without the trunk.
        std::vector<bool> limbs(history.axisAddress.size(), true);
        limbs[history.axis[0]] = false;
        QVERIFY(wholeLife(history, limbs).skeleton.empty());
    }

    void woodOfAnAgeIsThatOfItsSkeleton()
    {
        const GrowthHistory history = grown(30.0);
        for (const double age : {1.0, 7.5, 30.0}) {
            const WoodAtAge wood = woodAtAge(history, age);
            const Skeleton tree = skeletonAtAge(history, age);
            for (const glm::dvec3& end : tree.p1)
                QVERIFY(std::ranges::find(wood.at, end) != wood.at.end());
            for (Index i = 0; i < history.size(); ++i)
                if (double(history.birth[i]) <= age - 1.0)
                    QCOMPARE(wood.radius[i] > 0.0, double(history.death[i]) > std::floor(age));
                else if (double(history.birth[i]) >= age)
                    QCOMPARE(wood.radius[i], 0.0);
        }
    }

    void sharesAreThoseOfTheYoungToo()
    {
        const GrowthHistory history = grown(40.0);
        const std::vector<double> share = greatestShares(history, {2.0, 20.0, 40.0});
        const std::vector<double> late = greatestShares(history, {40.0});
        QCOMPARE(share.size(), history.axisAddress.size());
        Index more = 0;
        for (Index i = 0; i < history.size(); ++i) {
            const Index axis = history.axis[i],
                        below = history.parent[i] == noIndex ? noIndex : history.axis[history.parent[i]];
            QVERIFY(share[axis] >= late[axis] && share[axis] <= 1.0 + 1e-12);
            if (below != noIndex)
                QVERIFY(share[below] >= share[axis]);
            more += share[axis] > late[axis] ? 1 : 0;
        }
        QVERIFY(std::abs(share[history.axis[0]] - 1.0) < 1e-9);
        QVERIFY(more > 0);
    }

    void allEverGrownIsOneSkeleton()
    {
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const GrowthHistory history = grown(35.0, seed);
            const WholeLife life = wholeLife(history, std::vector<bool>(history.axisAddress.size(), true));
            QVERIFY(checkForMesh(life.skeleton));
            QCOMPARE(std::size_t(life.skeleton.size()), life.metamer.size());
            QVERIFY(life.skeleton.size() > skeletonAtAge(history, 35.0).size());
            bool hasGone = false;
            for (Index b = 0; b < life.skeleton.size(); ++b) {
                const Index end = life.metamer[b], parent = life.skeleton.parent[b];
                hasGone = hasGone || int(history.death[end]) <= 35;
                QVERIFY(life.radius[end] > 0.0);
                // What a branch hangs on came before its end.
                if (parent != noIndex)
                    QVERIFY(life.metamer[parent] < end);
            }
            QVERIFY(hasGone);
        }
    }
};

RAMURE_SUITE(TestWholeLife)

} // namespace tst_whole_life

#include "tst_whole_life.moc"
