#include "core/generators/growth/grown_skeleton.h"
#include "core/generators/growth/shadow_grid.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <set>

namespace tst_growth_cuts {

using namespace ramure;

namespace {

constexpr int cutAt = 15, later = 50;

/// Trees with many limbs that live long.
std::vector<GrowthParams> trees()
{
    std::vector<GrowthParams> all(3);
    for (GrowthParams& params : all) {
        params.age = cutAt + later;
        params.height = 12.0;
        params.crownWidth = 9.0;
    }
    all[1].leaderUntil = 1000.0;
    all[1].whorl = 5;
    all[1].axil = 1.45;
    all[1].crownTop = 1.0;
    all[1].crownWidest = 0.05;
    all[2].sees = GrowthLight::Space;
    return all;
}

bool stands(const GrowthHistory& history, Index metamer, int age)
{
    return int(history.birth[metamer])<age&& int(history.death[metamer])> age;
}

/// Of axes that stand at \p age.
std::set<std::uint64_t> addresses(const GrowthHistory& history, int age)
{
    std::set<std::uint64_t> all;
    for (Index i = 0; i < history.size(); ++i)
        if (stands(history, i, age))
            all.insert(history.axisAddress[history.axis[i]]);
    return all;
}

/// The thickest limb of the trunk at \p age: its first metamer.
Index thickestLimb(const GrowthHistory& history, int age)
{
    Index thickest = noIndex;
    std::uint16_t most = 0;
    std::size_t row = 0;
    for (Index i = 0; i < history.size(); ++i) {
        if (!stands(history, i, age))
            continue;
        const std::uint16_t pipes = history.pipesAt(age)[row++];
        const Index parent = history.parent[i];
        if (parent != noIndex && history.axisOrder[history.axis[i]] == 1 &&
            history.axis[parent] != history.axis[i] && pipes > most) {
            most = pipes;
            thickest = i;
        }
    }
    return thickest;
}

/// Of the limb and of all that it ever carries.
std::set<std::uint64_t> carried(const GrowthHistory& history, Index limb)
{
    std::vector<bool> above(history.size(), false);
    std::set<std::uint64_t> all;
    for (Index i = limb; i < history.size(); ++i) {
        const Index parent = history.parent[i];
        above[i] = i == limb || (parent != noIndex && above[parent]);
        if (above[i])
            all.insert(history.axisAddress[history.axis[i]]);
    }
    return all;
}

bool same(const GrowthHistory& a, const GrowthHistory& b)
{
    return a.params == b.params && a.parent == b.parent && a.axis == b.axis && a.birth == b.birth &&
           a.death == b.death && a.direction == b.direction && a.length == b.length &&
           a.axisAddress == b.axisAddress && a.axisOrder == b.axisOrder && a.rowStart == b.rowStart &&
           a.pipes == b.pipes && a.bends == b.bends && a.years == b.years && a.diedAt == b.diedAt;
}

} // namespace

class TestGrowthCuts : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void aLimbThatIsCutIsNotThereLater()
    {
        for (const GrowthParams& params : trees()) {
            const auto uncut = growHistory(params, 1);
            QVERIFY(uncut);
            const Index limb = thickestLimb(*uncut, cutAt);
            const std::set<std::uint64_t> gone = carried(*uncut, limb);
            const auto cut = growHistory(params, 1, {{uncut->axisAddress[uncut->axis[limb]], 0.0, cutAt}});
            QVERIFY(cut);
            QVERIFY(skeletonAtAge(*cut, cutAt - 1.0) == skeletonAtAge(*uncut, cutAt - 1.0));
            for (int age = cutAt; age <= cutAt + later; ++age)
                for (const std::uint64_t address : addresses(*cut, age))
                    QVERIFY(!gone.contains(address));

            // What stands elsewhere goes on as it was.
            std::size_t kept = 0, all = 0;
            const auto then = addresses(*uncut, cutAt + later), now = addresses(*cut, cutAt + later);
            for (const std::uint64_t address : then)
                if (!gone.contains(address)) {
                    ++all;
                    kept += now.contains(address) ? 1u : 0u;
                }
            QVERIFY(all > 500);
            QVERIFY2(double(kept) >= 0.95 * double(all),
                     qPrintable(QString::number(double(kept) / double(all))));
        }
    }

    void budsBelowTheWoundShoot()
    {
        for (const GrowthParams& params : trees()) {
            const auto uncut = growHistory(params, 1);
            const Index limb = thickestLimb(*uncut, cutAt);
            const auto cut = growHistory(params, 1, {{uncut->axisAddress[uncut->axis[limb]], 0.0, cutAt}});
            const Index carrier = uncut->parent[limb];
            int shoots = 0;
            for (Index i = limb; i < cut->size(); ++i)
                shoots +=
                    cut->birth[i] == cutAt && cut->parent[i] == carrier && cut->axis[i] != cut->axis[carrier]
                        ? 1
                        : 0;
            QVERIFY(shoots > 0);
        }
    }

    void aStumpKeepsItsShare()
    {
        const GrowthParams params = trees().front();
        const auto uncut = growHistory(params, 1);
        const Index axis = uncut->axis[thickestLimb(*uncut, cutAt)];
        const auto nodes = [&](const GrowthHistory& history) {
            int count = 0;
            for (Index i = 0; i < history.size(); ++i)
                count += history.axis[i] == axis && stands(history, i, cutAt) ? 1 : 0;
            return count;
        };
        const auto half = growHistory(params, 1, {{uncut->axisAddress[axis], 0.5, cutAt}});
        QVERIFY(nodes(*half) > nodes(*uncut) / 4 && nodes(*half) < nodes(*uncut) * 3 / 4);
        const auto whole = growHistory(params, 1, {{uncut->axisAddress[axis], 1.0, cutAt}});
        QVERIFY(same(*whole, *uncut));
    }

    void aFelledTrunkShootsFromTheStump()
    {
        const GrowthParams params = trees().front();
        const auto uncut = growHistory(params, 1);
        const auto felled = growHistory(params, 1, {{uncut->axisAddress[0], 0.0, cutAt}});
        QVERIFY(felled);
        int trunk = 0;
        for (Index i = 0; i < felled->size(); ++i)
            trunk += felled->axis[i] == 0 && stands(*felled, i, cutAt) ? 1 : 0;
        QCOMPARE(trunk, 1);
        QVERIFY(felled->years.back().living > 100);
        QCOMPARE(felled->diedAt, 0);
    }

    void cutsOfWhatIsNotThereDoNothing()
    {
        GrowthParams params = trees().front();
        params.age = 25.0;
        const auto uncut = growHistory(params, 1);
        const auto cut = growHistory(params, 1, {{12345, 0.0, 10}, {uncut->axisAddress.back(), 0.0, 5}});
        QVERIFY(cut && same(*cut, *uncut));
    }

    void theirOrderChangesNothing()
    {
        GrowthParams params = trees().front();
        params.age = 40.0;
        const auto uncut = growHistory(params, 1);
        const std::uint64_t one = uncut->axisAddress[uncut->axis[thickestLimb(*uncut, 10)]],
                            other = uncut->axisAddress[uncut->axis[thickestLimb(*uncut, 20)]];
        const auto cut = growHistory(params, 1, {{one, 0.0, 10}, {other, 0.3, 20}});
        const auto turned = growHistory(params, 1, {{other, 0.3, 20}, {one, 0.0, 10}});
        QVERIFY(cut && turned && same(*cut, *turned));
        QVERIFY(!same(*cut, *uncut));
    }

    void whatWasShadedGetsLight()
    {
        const GrowthParams params = trees().front();
        const auto uncut = growHistory(params, 1);
        const Index limb = thickestLimb(*uncut, cutAt);
        const auto cut = growHistory(params, 1, {{uncut->axisAddress[uncut->axis[limb]], 0.0, cutAt}});
        const Skeleton before = skeletonAtAge(*uncut, cutAt - 0.01);
        const Skeleton with = skeletonAtAge(*uncut, cutAt + 5.0), without = skeletonAtAge(*cut, cutAt + 5.0);
        const std::set<std::uint64_t> left = addresses(*cut, cutAt);
        const auto shadowBelow = [&](const Skeleton& tree) {
            ShadowGrid grid;
            grid.reset(glm::dvec3(-15.0, -2.0, -15.0), glm::dvec3(15.0, 20.0, 15.0), 0.25);
            for (const glm::dvec3& at : tree.p1)
                grid.add(at, 16);
            grid.sum();
            double sum = 0.0;
            for (const auto& [branch, address] : before.axisStarts)
                if (!left.contains(address))
                    sum += grid.shadowAt(before.p1[branch] - glm::dvec3(0.0, 0.5, 0.0), 0.1);
            return sum;
        };
        QVERIFY(shadowBelow(without) < 0.8 * shadowBelow(with));
    }

    void aTreeGoesOnFromWhereItStopped()
    {
        for (GrowthParams params : trees()) {
            params.age = 30.0;
            const auto at20 = growHistory(params, 3);
            const GrowthCuts cuts = {{at20->axisAddress[at20->axis[thickestLimb(*at20, 12)]], 0.0, 12}};
            for (const GrowthCuts& some : {GrowthCuts{}, cuts}) {
                const auto once = growHistory(params, 3, some);
                GrowthParams young = params;
                young.age = 7.5;
                auto run = GrowthRun::begin(young, 3, some);
                QVERIFY(run);
                for (const double age : {7.5, 11.0, 12.0, 13.0, 30.0})
                    QVERIFY(run->growTo(age));
                QVERIFY(same(run->history(), *once));
            }
        }
    }

    void aRunGoesOnAfterACancel()
    {
        GrowthParams params = trees().front();
        params.age = 20.0;
        auto run = GrowthRun::begin(params, 3);
        std::stop_source source;
        const Progress progress{source.get_token(), [&](double done) {
                                    if (done > 0.5)
                                        source.request_stop();
                                }};
        const auto stopped = run->growTo(20.0, progress);
        QVERIFY(!stopped);
        QCOMPARE(stopped.error().code, ErrorCode::Cancelled);
        QVERIFY(run->history().grownYears() < 20);
        QVERIFY(run->growTo(20.0));
        QVERIFY(same(run->history(), *growHistory(params, 3)));
    }
};

RAMURE_SUITE(TestGrowthCuts)

} // namespace tst_growth_cuts

#include "tst_growth_cuts.moc"
