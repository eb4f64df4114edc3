#include "core/generators/colonisation/growth_space.h"
#include "core/generators/growth/grown_skeleton.h"
#include "core/skeleton/axes.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include "tests/support/suite.h"
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace tst_growth_history {

using namespace ramure;

namespace {

GrowthParams aged(double age)
{
    GrowthParams params;
    params.age = age;
    return params;
}

double topOf(const Skeleton& skeleton, Index mostLevel)
{
    double top = 0.0;
    for (Index i = 0; i < skeleton.size(); ++i)
        if (skeleton.level[i] <= mostLevel)
            top = std::max(top, skeleton.p1[i].y);
    return top;
}

/// How far the middle of the tips stands beside the trunk in X, over the crown's radius.
double asideOf(const GrowthParams& params, std::uint64_t seed)
{
    const Skeleton tree = skeletonAtAge(*growHistory(params, seed), params.age);
    double sum = 0.0, radius = 0.0;
    for (Index i = 0; i < tree.size(); ++i) {
        sum += tree.p1[i].x;
        radius = std::max(radius, std::hypot(tree.p1[i].x, tree.p1[i].z));
    }
    return sum / (double(tree.size()) * radius);
}

/// Species as unlike as can be.
std::vector<GrowthParams> species(double age)
{
    std::vector<GrowthParams> all(5, aged(age));
    all[1].leaderUntil = 1000.0; // a spruce
    all[1].whorl = 5;
    all[1].axil = 1.45;
    all[1].crownTop = 1.0;
    all[1].crownWidest = 0.05;
    all[2].weeping = 1.1; // a willow
    all[2].branching = 0.5;
    all[2].sympodial = 0.2;
    all[3].phyllotaxis = Phyllotaxis::Opposite;
    all[3].vigour = VigourModel::Priority;
    all[3].stems = 3;
    all[4].sees = GrowthLight::Space;
    all[4].phyllotaxis = Phyllotaxis::Alternate; // a beech
    all[4].plagiotropy = 0.3;
    all[4].reiteration = 0.05;
    all[4].droop = 1.0;
    return all;
}

} // namespace

class TestGrowthHistory : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void errorsNameTheKey()
    {
        const auto refused = [](auto&& change, ErrorCode code, const char* path) {
            GrowthParams params;
            change(params);
            const auto history = growHistory(params, 1);
            QVERIFY(!history);
            QCOMPARE(history.error().code, code);
            QCOMPARE(history.error().path, std::string(path));
        };
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        refused([](GrowthParams& p) { p.age = -1.0; }, ErrorCode::Invalid, "growth.age");
        refused([](GrowthParams& p) { p.age = nan; }, ErrorCode::Invalid, "growth.age");
        refused([](GrowthParams& p) { p.age = 10'000.0; }, ErrorCode::Invalid, "growth.age");
        refused([](GrowthParams& p) { p.height = 0.0; }, ErrorCode::Invalid, "growth.height");
        refused([](GrowthParams& p) { p.internode = nan; }, ErrorCode::Invalid, "growth.internode");
        refused([](GrowthParams& p) { p.orders = 0; }, ErrorCode::Invalid, "growth.orders");
        refused([](GrowthParams& p) { p.stems = 100; }, ErrorCode::Invalid, "growth.stems");
        // 80 x 12,000 x 12,000 voxels.
        refused(
            [](GrowthParams& p) {
                p.height = 1.0;
                p.crownWidth = 150.0;
                p.internode = 0.001;
            },
            ErrorCode::Limit, "growth.crownWidth");
    }

    void canBeCancelled()
    {
        std::stop_source source;
        source.request_stop();
        const auto history = growHistory({}, 1, Progress{source.get_token(), {}});
        QVERIFY(!history);
        QCOMPARE(history.error().code, ErrorCode::Cancelled);
    }

    void diesWithoutLight()
    {
        GrowthParams params = aged(40.0);
        params.sunlight = 0.0;
        const auto history = growHistory(params, 1);
        QVERIFY(history);
        QVERIFY(history->diedAt > 0 && history->diedAt < 10);
        QVERIFY(!skeletonAtAge(*history, history->diedAt - 1).empty());
        QVERIFY(skeletonAtAge(*history, history->diedAt).empty());
        QVERIFY(skeletonAtAge(*history, 40.0).empty());
    }

    void isASeedAtFirst()
    {
        const auto history = growHistory(aged(0.0), 1);
        QVERIFY(history);
        QVERIFY(skeletonAtAge(*history, 0.0).empty());
    }

    void vigourIsKept()
    {
        for (const GrowthParams& params : species(35.0)) {
            const auto history = growHistory(params, 3);
            QVERIFY(history);
            for (const GrowthYear& year : history->years)
                QVERIFY(std::abs(year.vigour - year.vigourSpent) <= 1e-12 * std::max(1.0, year.vigour));
        }
    }

    void anAgeIsATreeGrownSoLong()
    {
        for (const GrowthParams& params : species(30.0)) {
            const auto whole = growHistory(params, 5);
            QVERIFY(whole);
            for (const double age : {0.4, 1.0, 7.0, 12.25, 29.9}) {
                GrowthParams shorter = params;
                shorter.age = age;
                const auto part = growHistory(shorter, 5);
                QVERIFY(part);
                QVERIFY(skeletonAtAge(*whole, age) == skeletonAtAge(*part, age));
            }
        }
    }

    void theSeedDecides()
    {
        const auto one = growHistory(aged(15.0), 1), same = growHistory(aged(15.0), 1),
                   other = growHistory(aged(15.0), 2);
        QVERIFY(one && same && other);
        QVERIFY(skeletonAtAge(*one, 15.0) == skeletonAtAge(*same, 15.0));
        QVERIFY(skeletonAtAge(*one, 15.0) != skeletonAtAge(*other, 15.0));
    }

    /// lambda is a switch; what an artist has is not.
    void theTrunkIsAsLongAsItLeads()
    {
        double before = 0.0;
        for (const double until : {2.0, 4.0, 6.0, 8.0, 12.0, 16.0, 28.0}) {
            double share = 0.0;
            for (std::uint64_t seed = 1; seed <= 5; ++seed) {
                GrowthParams params = aged(28.0);
                params.leaderUntil = until;
                const Skeleton tree = skeletonAtAge(*growHistory(params, seed), 28.0);
                share += topOf(tree, 0) / topOf(tree, noIndex) / 5.0;
            }
            QVERIFY2(share > before, qPrintable(QString::number(share)));
            QVERIFY(before == 0.0 || share < before + 0.25);
            before = share;
        }
        QVERIFY(before > 0.98);
    }

    void skeletonsAreWhole()
    {
        for (const GrowthParams& params : species(45.0)) {
            const auto history = growHistory(params, 7);
            QVERIFY(history);
            for (int k = 1; k <= 40; ++k)
                check(skeletonAtAge(*history, 45.0 * k / 40.0));
        }
    }

    void everyAgeIsOneClosedMesh()
    {
        for (const GrowthParams& params : species(24.0)) {
            const auto history = growHistory(params, 9);
            QVERIFY(history);
            for (const double age : {0.3, 1.0, 3.5, 9.0, 24.0}) {
                const auto mesh = buildCheckedBranchMesh(skeletonAtAge(*history, age), {});
                QVERIFY(mesh);
                QVERIFY(mesh->report.valid);
                QCOMPARE(mesh->report.components, Index(1));
            }
        }
    }

    void nothingJumpsFromMonthToMonth()
    {
        const GrowthParams params = aged(32.0);
        const auto history = growHistory(params, 1);
        QVERIFY(history);
        std::map<std::uint64_t, glm::dvec3> before;
        for (int month = 0; month <= 24; ++month) {
            const Skeleton tree = skeletonAtAge(*history, 30.0 + month / 12.0);
            std::map<std::uint64_t, glm::dvec3> now;
            for (Index i = 0; i < tree.size(); ++i) {
                now[tree.key[i]] = tree.p1[i];
                if (const auto at = before.find(tree.key[i]); at != before.end())
                    QVERIFY(glm::length(at->second - tree.p1[i]) <= 0.005 * params.height);
            }
            before.swap(now);
        }
    }

    void axesKeepTheirAddresses()
    {
        const auto history = growHistory(aged(30.0), 1);
        QVERIFY(history);
        const auto addresses = [&](double age) {
            std::set<std::uint64_t> all;
            for (const Axis& axis : axesOf(skeletonAtAge(*history, age)).axes)
                all.insert(axis.address);
            return all;
        };
        const auto young = addresses(10.0), old = addresses(10.0 + 1.0 / 12.0);
        QVERIFY(young.size() > 20);
        for (const std::uint64_t address : young)
            QVERIFY(old.contains(address));
    }

    void wallsDriveTheCrownAway()
    {
        auto wall = std::make_shared<TriangleMesh>();
        wall->positions = {
            {1.5f, 0.0f, -40.0f}, {1.5f, 0.0f, 40.0f}, {1.5f, 40.0f, 40.0f}, {1.5f, 40.0f, -40.0f}};
        wall->triangles = {{0, 1, 2}, {0, 2, 3}};
        GrowthParams open = aged(25.0), walled = open;
        walled.space.solids = std::make_shared<const Lazy<GrowthSolids>>([wall] {
            return GrowthSolids{std::make_shared<const GrowthSpace>(
                std::vector<GrowthSpace::Solid>{{"wall", wall, GrowthRole::Obstacle}})};
        });
        walled.space.hash = 1;
        double free = 0.0;
        for (std::uint64_t seed = 1; seed <= 8; ++seed)
            free += asideOf(open, seed) / 8.0;
        QVERIFY2(std::abs(free) <= 0.03, qPrintable(QString::number(free)));
        const double aside = asideOf(walled, 1);
        QVERIFY2(aside <= -0.15, qPrintable(QString::number(aside)));
        const Skeleton tree = skeletonAtAge(*growHistory(walled, 1), 25.0);
        for (Index i = 0; i < tree.size(); ++i)
            QVERIFY(tree.p1[i].x < 1.5);
    }

    void anySliderGrowsATree()
    {
        const auto grows = [](auto&& change) {
            GrowthParams params = aged(25.0);
            change(params);
            const auto history = growHistory(params, 1);
            QVERIFY(history);
            QCOMPARE(history->diedAt, 0);
            QVERIFY(history->years.back().living > 20);
            QVERIFY(history->years.back().living < 200'000);
        };
        grows([](GrowthParams& p) { p.apicalControl = 0.0; });
        grows([](GrowthParams& p) { p.apicalControl = 1.0; });
        grows([](GrowthParams& p) { p.shadeTolerance = 0.0; });
        grows([](GrowthParams& p) { p.shadeTolerance = 1.0; });
        grows([](GrowthParams& p) { p.shedding = 0.0; });
        grows([](GrowthParams& p) { p.shedding = 1.0; });
        grows([](GrowthParams& p) { p.density = 4.0; });
        grows([](GrowthParams& p) { p.density = 0.1; });
        grows([](GrowthParams& p) { p.autonomy = 0.0; });
        grows([](GrowthParams& p) { p.autonomy = 1.0; });
        grows([](GrowthParams& p) { p.branching = 0.2; });
        grows([](GrowthParams& p) { p.sympodial = 0.9; });
        grows([](GrowthParams& p) { p.sees = GrowthLight::Space; });
        grows([](GrowthParams& p) { p.light = 2.0; });
        grows([](GrowthParams& p) { p.droop = 2.0; });
        grows([](GrowthParams& p) { p.wander = 2.0; });
        grows([](GrowthParams& p) { p.maturity = 5.0; });
    }

    void bytesAMetamerAreFew()
    {
        const auto history = growHistory(aged(60.0), 1);
        QVERIFY(history);
        QVERIFY(history->bytes() <= 400 * std::size_t(history->size()));
    }

    void pipesArePackedDownwards()
    {
        for (float pipes = 1.0f; pipes < 1e6f; pipes *= 1.37f) {
            const float again = pipesOf(packedPipes(pipes));
            QVERIFY(again <= pipes && again >= pipes * (1.0f - 1.0f / 2048.0f));
        }
    }

private:
    static void check(const Skeleton& tree)
    {
        std::set<std::uint64_t> keys;
        for (Index i = 0; i < tree.size(); ++i) {
            const Index parent = tree.parent[i];
            QVERIFY(parent == noIndex || parent < i);
            QVERIFY(parent == noIndex || (tree.p0[i] == tree.p1[parent] && tree.a0[i] <= tree.a1[parent]));
            QVERIFY(std::isfinite(tree.p1[i].x) && std::isfinite(tree.p1[i].y) &&
                    std::isfinite(tree.p1[i].z));
            QVERIFY(tree.a1[i] > 0.0 && tree.a1[i] <= tree.a0[i]);
            QVERIFY(tree.length(i) > 0.0 && tree.p1[i].y > -0.5);
            QVERIFY(keys.insert(tree.key[i]).second);
        }
    }
};

RAMURE_SUITE(TestGrowthHistory)

} // namespace tst_growth_history

#include "tst_growth_history.moc"
