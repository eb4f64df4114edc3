#include "core/generators/growth/grown_skeleton.h"
#include "core/math/angle.h"
#include "core/presets/species.h"
#include "core/skeleton/axes.h"
#include "tests/support/suite.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>
#include <vector>

namespace tst_grown_species {

using namespace ramure;

namespace {

/// What is known of a species at its mature age, standing free.
struct Fact
{
    const char* name;
    /// Height over the diameter at breast height. Of oak and birch: that of a crown 25.5 times as wide as the
    /// trunk (Coombes, Martin, Slater, "Defining the allometry of stem and crown diameter of urban trees",
    /// 2019); of the willow: 35 ft over 2 ft (Little, "Field guide to North American trees", 1980).
    double slenderness;
    double insertion;             ///< degrees, of side shoots from what carries them, their median
    double trunkLow, trunkHigh;   ///< height of the first axis over that of the tree
    double hortonLow, hortonHigh; ///< number of branches of an order over that of the next
};

// Limbs of a spruce carry whole whorls of twigs that never fork: the ratio is above 5 there.
constexpr std::array facts{
    Fact{"EnglishOak", 22, 62, 0.3, 0.9, 3, 5},     Fact{"EuropeanBeech", 33, 48, 0.5, 0.95, 3, 5},
    Fact{"SilverBirch", 53, 41, 0.9, 1, 3, 5},      Fact{"SmallLeavedLinden", 38, 50, 0.6, 1, 3, 5},
    Fact{"WeepingWillow", 18, 48, 0.3, 0.85, 3, 5}, Fact{"OrchardApple", 18, 60, 0.5, 1, 3, 5},
    Fact{"OliveTree", 16, 55, 0.2, 0.6, 3, 5},      Fact{"LombardyPoplar", 48, 32, 0.9, 1, 3, 5},
    Fact{"ScotsPine", 38, 50, 0.9, 1, 3, 5},        Fact{"NorwaySpruce", 58, 55, 0.9, 1, 3, 11},
    Fact{"LebanonCedar", 22, 72, 0.85, 1, 3, 5},
};

GrowthParams paramsOf(const GrownSpecies& species)
{
    GrowthParams params = species.growth;
    params.axil *= oneDegree;
    return params;
}

/// Of the ends of branches, from the same axis of the other tree.
double largestMove(const Skeleton& before, const Skeleton& after)
{
    const TreeAxes from = axesOf(before), to = axesOf(after);
    std::map<std::uint64_t, Index> axes;
    for (Index a = 0; a < to.axes.size(); ++a)
        axes.emplace(to.axes[a].address, a);
    double largest = 0.0;
    for (Index a = 0; a < from.axes.size(); ++a) {
        const auto same = axes.find(from.axes[a].address);
        if (same == axes.end()) // what it grows on has become too thick to show it
            continue;
        for (const Index i : from.nodesOf(a)) {
            double nearest = std::numeric_limits<double>::max();
            for (const Index j : to.nodesOf(same->second)) {
                const glm::dvec3 way = after.p1[j] - after.p0[j], p = before.p1[i] - after.p0[j];
                const double t = std::clamp(glm::dot(p, way) / glm::dot(way, way), 0.0, 1.0);
                nearest = std::min(nearest, glm::length(p - t * way));
            }
            largest = std::max(largest, nearest);
        }
    }
    return largest;
}

double median(std::vector<double> values)
{
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return values.empty() ? 0.0 : *middle;
}

glm::dvec3 directionOf(const GrowthHistory& history, Index metamer)
{
    return glm::normalize(glm::dvec3(history.direction[metamer]));
}

/// Between a side shoot's first metamer and the one that carries it: both turn with what is below.
std::vector<double> insertions(const GrowthHistory& history)
{
    std::vector<double> out;
    for (Index i = 0; i < history.size(); ++i)
        if (const Index parent = history.parent[i];
            parent != noIndex && history.axis[parent] != history.axis[i])
            out.push_back(std::acos(glm::dot(directionOf(history, i), directionOf(history, parent))) /
                          oneDegree);
    return out;
}

/// Around the axis, from the only side shoot of a metamer to that of the next of the same axis.
std::vector<double> divergences(const GrowthHistory& history)
{
    std::vector<Index> side(history.size(), noIndex), sides(history.size(), 0);
    for (Index i = 0; i < history.size(); ++i)
        if (const Index parent = history.parent[i];
            parent != noIndex && history.axis[parent] != history.axis[i]) {
            side[parent] = i;
            ++sides[parent];
        }
    std::vector<double> out;
    for (Index i = 0; i < history.size(); ++i) {
        const Index below = history.parent[i];
        if (below == noIndex || history.axis[below] != history.axis[i] || sides[i] != 1 ||
            sides[below] != 1 || history.birth[below] != history.birth[i])
            continue;
        const auto aside = [&](const glm::dvec3& direction, Index metamer) {
            const glm::dvec3 along = directionOf(history, metamer);
            return glm::normalize(direction - glm::dot(direction, along) * along);
        };
        // The axis bends from one metamer to the next: what looked aside is carried over.
        const glm::dvec3 before = aside(aside(directionOf(history, side[below]), below), i);
        const double cosine = glm::dot(before, aside(directionOf(history, side[i]), i));
        out.push_back(std::acos(std::clamp(cosine, -1.0, 1.0)) / oneDegree);
    }
    return out;
}

/// By Strahler's orders: the mean ratio, from the slope of the logarithms.
double hortonRatio(const Skeleton& tree)
{
    std::vector<int> order(tree.size()), most(tree.size(), 0), times(tree.size(), 0);
    for (Index i = tree.size(); i-- > 0;) {
        order[i] = most[i] == 0 ? 1 : most[i] + (times[i] > 1 ? 1 : 0);
        if (const Index parent = tree.parent[i]; parent != noIndex) {
            times[parent] = order[i] > most[parent] ? 1 : times[parent] + (order[i] == most[parent] ? 1 : 0);
            most[parent] = std::max(most[parent], order[i]);
        }
    }
    std::map<int, int> branches;
    for (Index i = 0; i < tree.size(); ++i)
        if (tree.parent[i] == noIndex || order[tree.parent[i]] != order[i])
            ++branches[order[i]];
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const auto& [k, count] : branches) {
        const double logarithm = std::log(double(count));
        x += k;
        y += logarithm;
        xx += double(k) * k;
        xy += k * logarithm;
    }
    const auto n = double(branches.size());
    return std::exp(-(n * xy - x * y) / (n * xx - x * x));
}

} // namespace

class TestGrownSpecies : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    /// From month to month nothing jumps, as long as nothing is shed.
    void agesFlow()
    {
        constexpr double most = 0.005; // of the height
        for (const GrownSpecies& species : grownSpecies()) {
            GrowthParams params = paramsOf(species);
            const double mature = double(species.ages[1]);
            params.age = mature + 1.0;
            const auto history = growHistory(params, 1);
            QVERIFY(history);
            Skeleton before = skeletonAtAge(*history, mature);
            for (int month = 1; month < 12; ++month) {
                const Skeleton after = skeletonAtAge(*history, mature + month / 12.0);
                QVERIFY2(largestMove(before, after) <= most * params.height, species.name);
                before = after;
            }
        }
    }

    void everySpeciesHasItsFacts()
    {
        QCOMPARE(grownSpecies().size(), facts.size());
        for (const GrownSpecies& species : grownSpecies()) {
            QCOMPARE(double(species.ages[1]), species.growth.age);
            QVERIFY(species.ages[0] < species.ages[1] && species.ages[1] < species.ages[2]);
        }
    }

    void matureTreesAreAsFloraSay_data()
    {
        QTest::addColumn<int>("row");
        for (std::size_t k = 0; k < facts.size(); ++k)
            QTest::newRow(facts[k].name) << int(k);
    }

    void matureTreesAreAsFloraSay()
    {
        QFETCH(const int, row);
        const Fact& fact = facts[std::size_t(row)];
        const auto species =
            std::ranges::find(grownSpecies(), std::string_view(fact.name), &GrownSpecies::name);
        QVERIFY(species != grownSpecies().end());
        const GrowthParams params = paramsOf(*species);
        const auto history = growHistory(params, 1);
        QVERIFY(history);
        const Skeleton tree = skeletonAtAge(*history, params.age);

        double top = 0.0, trunk = 0.0, breast = 0.0;
        for (Index i = 0; i < tree.size(); ++i) {
            top = std::max(top, tree.p1[i].y);
            if (tree.level[i] != 0)
                continue;
            trunk = std::max(trunk, tree.p1[i].y);
            if (tree.p0[i].y <= 1.3 && tree.p1[i].y > 1.3)
                breast = 2.0 * tree.a0[i];
        }
        const auto about = [&](const char* what, double value, double low, double high) {
            if (value < low || value > high)
                qWarning("%s: %s %.2f, not %.2f to %.2f", fact.name, what, value, low, high);
        };
        about("height", top / params.height, 0.85, 1.15);
        about("slenderness", top / breast / fact.slenderness, 0.75, 1.25);
        about("trunk", trunk / top, fact.trunkLow, fact.trunkHigh);
        about("living metamers", double(history->years.back().living), 5000.0, 45'000.0);
        const double insertion = median(insertions(*history));
        about("insertion", insertion, fact.insertion - 8.0, fact.insertion + 8.0);
        about("insertion", insertion, 30.0, 90.0);
        about("Horton's ratio", hortonRatio(tree), fact.hortonLow, fact.hortonHigh);
        if (params.phyllotaxis == Phyllotaxis::Spiral && params.whorl == 0)
            about("divergence", median(divergences(*history)), 130.0, 145.0);
    }
};

RAMURE_SUITE(TestGrownSpecies)

} // namespace tst_grown_species

#include "tst_grown_species.moc"
