#include "core/generators/colonisation/growth_space.h"
#include "core/generators/growth/grown_skeleton.h"
#include "core/generators/growth/palm.h"
#include "core/presets/presets.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace tst_palm {

using namespace ramure;

namespace {

GrowthParams palm()
{
    return presetParams("CoconutPalm")->growth;
}

std::size_t axesOfOrder(const Skeleton& tree, Index order)
{
    return std::size_t(std::ranges::count_if(
        tree.axisStarts, [&](const auto& start) { return tree.level[start.first] == order; }));
}

} // namespace

class TestPalm : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void errorsNameTheKey()
    {
        const auto refused = [](auto&& change, const char* path) {
            GrowthParams params = palm();
            change(params);
            const auto history = growHistory(params, 1);
            QVERIFY(!history);
            QCOMPARE(history.error().code, ErrorCode::Invalid);
            QCOMPARE(history.error().path, std::string(path));
        };
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        refused([](GrowthParams& p) { p.age = -1.0; }, "growth.age");
        refused([](GrowthParams& p) { p.fronds = 0; }, "growth.fronds");
        refused([](GrowthParams& p) { p.fronds = 1000; }, "growth.fronds");
        refused([](GrowthParams& p) { p.frondLength = nan; }, "growth.frondLength");
        refused([](GrowthParams& p) { p.frondYears = 0.0; }, "growth.frondYears");
        refused([](GrowthParams& p) { p.stemRadius = -0.1; }, "growth.stemRadius");
        refused([](GrowthParams& p) { p.fruit = -1; }, "growth.fruit");
    }

    void diesWithoutLight()
    {
        GrowthParams params = palm();
        params.sunlight = 0.0;
        const auto history = growHistory(params, 1);
        QVERIFY(history);
        QVERIFY(history->diedAt > 0 && history->diedAt < 10);
        QVERIFY(!skeletonAtAge(*history, history->diedAt - 1).empty());
        QVERIFY(skeletonAtAge(*history, history->diedAt).empty());
    }

    /// Whatever the sliders say, at any age.
    void isSound()
    {
        for (int choice = 0; choice < 64; ++choice) {
            GrowthParams params = palm();
            params.fronds = choice & 1 ? 60 : 1 + choice % 7;
            params.frondLength = choice & 2 ? 0.05 : 9.0;
            params.frondYears = choice & 4 ? 0.2 : 6.0;
            params.stemRadius = choice & 8 ? 0.005 : 1.0;
            params.height = choice & 16 ? 0.1 : 40.0;
            params.fruit = choice & 32 ? 60 : 0;
            for (const double age : {0.01, 0.25, 1.0, 3.7, 17.3, 60.0, 2000.0}) {
                const Skeleton tree = palmAtAge(params, std::uint64_t(choice), age);
                std::set<std::uint64_t> keys;
                QVERIFY(!tree.empty());
                for (Index i = 0; i < tree.size(); ++i) {
                    const Index parent = tree.parent[i];
                    QVERIFY(parent == noIndex ? i == 0 : parent < i && tree.p0[i] == tree.p1[parent]);
                    QVERIFY(std::isfinite(glm::length(tree.p1[i])) && tree.length(i) > 0.0);
                    QVERIFY(tree.a1[i] > 0.0 && tree.a1[i] <= tree.a0[i]);
                    QVERIFY(keys.insert(tree.key[i]).second);
                }
                for (const Organ& organ : tree.organs) {
                    QVERIFY(organ.branch < tree.size() && organ.size > 0.0);
                    QVERIFY(std::abs(glm::dot(organ.heading, organ.up)) < 1e-9);
                    QVERIFY(std::abs(glm::length(organ.heading) - 1.0) +
                                std::abs(glm::length(organ.up) - 1.0) <
                            1e-9);
                }
                QVERIFY(std::ranges::is_sorted(tree.axisStarts));
            }
        }
    }

    /// Wood that has left the crown stays where it is and as thick as it is.
    void theStemStands()
    {
        const GrowthParams params = palm();
        for (const double age : {12.0, 25.5, 40.0}) {
            const Skeleton young = palmAtAge(params, 3, age), old = palmAtAge(params, 3, age + 21.3);
            std::map<std::uint64_t, Index> later;
            for (Index i = 0; i < old.size(); ++i)
                later.emplace(old.key[i], i);
            double left = 0.0; // m, how high the end of the stem was when the oldest fronds opened
            const Skeleton before = palmAtAge(params, 3, age - 1.3 * params.frondYears);
            for (Index i = 0; i < before.size(); ++i)
                left = std::max(left, before.level[i] == 0 ? before.p1[i].y : 0.0);
            std::size_t compared = 0;
            for (Index i = 0; i < young.size(); ++i) {
                if (young.level[i] != 0)
                    continue;
                if (young.p1[i].y > left)
                    break;
                const auto same = later.find(young.key[i]);
                QVERIFY(same != later.end());
                QCOMPARE(old.p1[same->second], young.p1[i]);
                QCOMPARE(old.a1[same->second], young.a1[i]);
                ++compared;
            }
            QVERIFY(compared > 10);
        }
    }

    void theCrownIsOfItsFronds()
    {
        GrowthParams params = palm();
        const Skeleton tree = palmAtAge(params, 1, 40.0);
        const double fronds = double(params.fronds) * params.frondYears;
        params.fruit = 0;
        const Skeleton bare = palmAtAge(params, 1, 40.0);
        QVERIFY(std::abs(double(axesOfOrder(bare, 1)) - fronds) < 0.2 * fronds);
        QVERIFY(axesOfOrder(tree, 1) > axesOfOrder(bare, 1));
        const auto isFruit = [](const Organ& organ) { return organ.kind == OrganKind::Fruit; };
        QVERIFY(std::ranges::any_of(tree.organs, isFruit));
        QVERIFY(std::ranges::none_of(bare.organs, isFruit));
        QVERIFY(std::ranges::none_of(palmAtAge(palm(), 1, 5.0).organs, isFruit)); // too young
    }

    /// A frond stands at first and hangs at last; it has one address as long as it lives.
    void frondsComeDown()
    {
        const GrowthParams params = palm();
        std::map<std::uint64_t, double> before;
        int seen = 0;
        for (double age = 30.0; age < 34.0; age += 0.125) {
            const Skeleton tree = palmAtAge(params, 2, age);
            std::map<std::uint64_t, double> now;
            for (const auto& [branch, address] : tree.axisStarts)
                if (tree.level[branch] == 1)
                    now[address] = glm::normalize(tree.p1[branch] - tree.p0[branch]).y;
            for (const auto& [address, up] : now)
                if (const auto was = before.find(address); was != before.end()) {
                    QVERIFY(up <= was->second);
                    ++seen;
                }
            before = std::move(now);
        }
        QVERIFY(seen > 500);
    }

    /// The bud stands at the end of the stem: without it nothing goes on, and what stood stands.
    void aCutStemDies()
    {
        GrowthParams params = palm();
        params.age = 60.0;
        const auto whole = growHistory(params, 1);
        const auto cut = growHistory(params, 1, {{palmStemAddress, 0.6, 20, 7}, {12345, 0.5, 20, 8}});
        QVERIFY(whole && cut);
        using State = LivedEdit::State;
        const auto livedAt = [&](double age) { return skeletonAtAge(*cut, age).lived; };
        QVERIFY((livedAt(19.9) == std::vector<LivedEdit>{{7, State::Waits}, {8, State::Waits}}));
        QVERIFY((livedAt(20.0) == std::vector<LivedEdit>{{7, State::Made}, {8, State::Missed}}));
        Skeleton young = skeletonAtAge(*cut, 19.9);
        young.lived.clear();
        QVERIFY(young == skeletonAtAge(*whole, 19.9));
        const Skeleton stump = skeletonAtAge(*cut, 20.0), before = skeletonAtAge(*whole, 20.0);
        QVERIFY(stump == skeletonAtAge(*cut, 60.0));
        QCOMPARE(axesOfOrder(stump, 1), std::size_t(0));
        QVERIFY(stump.organs.empty());
        QCOMPARE(stump.sawn, std::vector<Index>{Index(stump.size() - 1)});
        double top = 0.0;
        for (Index i = 0; i < before.size(); ++i)
            top = before.level[i] == 0 ? before.p1[i].y : top;
        QVERIFY(std::abs(stump.p1.back().y - 0.6 * top) < 0.02 * top);
        const auto felled = growHistory(params, 1, {{palmStemAddress, 0.0, 20, 7}});
        QVERIFY(!skeletonAtAge(*felled, 40.0).empty());
    }

    void aCutFrondIsGoneAndTheOthersStay()
    {
        GrowthParams params = palm();
        const Skeleton whole = palmAtAge(params, 1, 30.0);
        const auto frond = std::ranges::find_if(
            whole.axisStarts, [&](const auto& start) { return whole.level[start.first] == 1; });
        const auto fronds = [&](double share) {
            const GrowthCuts cuts{{frond->second, share, 30, 7}};
            return palmAtAge(params, 1, 30.0, cuts);
        };
        QCOMPARE(axesOfOrder(fronds(0.0), 1), axesOfOrder(whole, 1) - 1);
        const Skeleton half = fronds(0.5);
        QCOMPARE(axesOfOrder(half, 1), axesOfOrder(whole, 1));
        QVERIFY(half.size() < whole.size() && half.sawn.size() == 1);
        QVERIFY(palmAtAge(params, 1, 29.9, {{frond->second, 0.0, 30, 7}}) == palmAtAge(params, 1, 29.9));
    }

    /// Away from a wall, to the light, and no higher than a roof.
    void lightAndSolidsSteerTheStem()
    {
        const auto under = [](std::vector<glm::vec3> corners) {
            const auto mesh = std::make_shared<TriangleMesh>();
            mesh->positions = std::move(corners);
            mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
            GrowthParams params = palm();
            params.space.solids = std::make_shared<const Lazy<GrowthSolids>>([mesh] {
                return GrowthSolids{std::make_shared<const GrowthSpace>(
                    std::vector<GrowthSpace::Solid>{{"solid", mesh, GrowthRole::Obstacle}})};
            });
            params.space.hash = 1;
            return params;
        };
        const GrowthParams walled = under({{1.5f, 0, -40}, {1.5f, 0, 40}, {1.5f, 40, 40}, {1.5f, 40, -40}});
        const GrowthParams roofed = under({{-9, 5, -9}, {-9, 5, 9}, {9, 5, 9}, {9, 5, -9}});
        const auto topOf = [](const Skeleton& tree) {
            glm::dvec3 top(0.0);
            for (Index i = 0; i < tree.size(); ++i)
                top = tree.level[i] == 0 ? tree.p1[i] : top;
            return top;
        };
        for (const std::uint64_t seed : {1u, 2u, 3u}) {
            const double free = topOf(palmAtAge(palm(), seed, 40.0)).x;
            const Skeleton tree = palmAtAge(walled, seed, 40.0);
            QVERIFY2(topOf(tree).x < free - 1.0, qPrintable(QString::number(topOf(tree).x - free)));
            for (const glm::dvec3& at : tree.p1)
                QVERIFY(at.x < 1.5);
            const Skeleton low = palmAtAge(roofed, seed, 40.0);
            for (const glm::dvec3& at : low.p1)
                QVERIFY(at.y < 5.0);
            QVERIFY(topOf(low).y > 3.0 && axesOfOrder(low, 1) > 10);
        }
        GrowthParams lit = palm();
        lit.sideLight = 0.8;
        lit.lightDirection = 0.0; // along X
        const glm::dvec3 lean = topOf(palmAtAge(lit, 1, 40.0)) - topOf(palmAtAge(palm(), 1, 40.0));
        QVERIFY2(lean.x > 0.5 && std::abs(lean.z) < 0.1 * lean.x, qPrintable(QString::number(lean.x)));
        GrowthParams blind = walled;
        blind.light = 0.0;
        QVERIFY(topOf(palmAtAge(blind, 1, 40.0)).x > topOf(palmAtAge(walled, 1, 40.0)).x);
    }

    void seedsLeanOtherwise()
    {
        const Skeleton one = palmAtAge(palm(), 1, 40.0), two = palmAtAge(palm(), 2, 40.0);
        QVERIFY(one != two);
        QVERIFY(one == palmAtAge(palm(), 1, 40.0));
    }
};

RAMURE_SUITE(TestPalm)

} // namespace tst_palm

#include "tst_palm.moc"
