#include "core/generators/growth/grown_skeleton.h"
#include "core/generators/growth/whole_life.h"
#include "core/math/angle.h"
#include "core/params/source_facts.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/presets/species.h"
#include "core/presets/tree_measures.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/measures.h"
#include "core/surface/foliage/leaf_measures.h"
#include "core/surface/foliage/place_foliage.h"
#include "tests/support/suite.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <vector>

namespace tst_grown_species {

using namespace ramure;

namespace {

/// What is known of a species, standing free: at its mature age unless it says otherwise.
struct Fact
{
    const char* name;
    /// Height over the diameter at breast height; 0: that of tree_measures.h.
    double slenderness;
    std::size_t at;             ///< which of its ages the published trees had
    double insertion;           ///< degrees, of side shoots from what carries them, their median
    double trunkLow, trunkHigh; ///< height of the first axis over that of the tree
};

constexpr std::size_t mature = 1, old = 2;
constexpr std::size_t everyNth = test::isSanitized ? 4 : 1;

// The trees of tree_measures.h are those with the thickest stems: old ones, but for olives, which get far
// older than streets. The willow: 35 ft over 2 ft (Little, "Field guide to North American trees", 1980). The
// poplar: 29 m high and 2.8 m around (Fairwater Park, Cardiff, measured in 2017). The cedar: 26 m high
// and 4.5 m around at 120 years (Museo del Prado, Madrid). The sequoia: 54.8 m high and 9.12 m around at 150
// years (Castle Leod, measured in 2003). The cypress: 32 m and 4.05 m at 200 years (Real Jardín Botánico,
// Madrid). The fir: 12 to 18 m and 30 to 46 cm (Burns, Honkala, "Silvics of North America", 1990). The elm:
// the mean of 30 m over 0.95 m (East Coker) and 25 m over 1.45 m (Hatfield Peverel). The stone pine: 40 to 80
// ft over 36 to 48 in. (W. Warriner, consulting arborist, Los Angeles).
constexpr std::array facts{
    Fact{"EnglishOak", 0, old, 62, 0.3, 0.9},
    Fact{"EuropeanBeech", 0, old, 48, 0.5, 0.95},
    Fact{"SilverBirch", 0, old, 41, 0.9, 1},
    Fact{"SmallLeavedLinden", 0, old, 50, 0.6, 1},
    Fact{"WeepingWillow", 17.5, mature, 48, 0.3, 0.85},
    Fact{"OrchardApple", 0, mature, 60, 0.5, 1},
    Fact{"OliveTree", 0, mature, 55, 0.2, 0.6},
    Fact{"LombardyPoplar", 32.5, old, 32, 0.9, 1},
    Fact{"ScotsPine", 0, old, 50, 0.9, 1},
    Fact{"NorwaySpruce", 0, old, 55, 0.9, 1},
    Fact{"LebanonCedar", 18.2, old, 72, 0.85, 1},
    Fact{"SugarMaple", 0, old, 48, 0.58, 1},
    Fact{"NorwayMaple", 0, old, 52, 0.62, 1},
    Fact{"JapaneseMaple", 0, old, 52, 0.9, 1},
    Fact{"CommonAsh", 0, old, 46, 0.52, 1},
    Fact{"HorseChestnut", 0, old, 54, 0.55, 1},
    Fact{"WildCherry", 0, old, 56, 0.9, 1},
    Fact{"LondonPlane", 0, old, 56, 0.63, 1},
    Fact{"AmericanElm", 0, old, 40, 0.2, 0.85},
    Fact{"Hawthorn", 0, old, 64, 0.65, 1},
    Fact{"RedOak", 0, old, 60, 0.9, 1},
    Fact{"LiveOak", 0, old, 64, 0.57, 1},
    Fact{"SweetChestnut", 0, old, 56, 0.6, 1},
    Fact{"TulipTree", 0, old, 52, 0.9, 1},
    Fact{"Sweetgum", 0, old, 56, 0.9, 1},
    Fact{"BlackLocust", 0, old, 42, 0.56, 1},
    Fact{"Rowan", 0, old, 44, 0.9, 1},
    Fact{"Hornbeam", 0, old, 42, 0.6, 1},
    Fact{"CommonAlder", 0, old, 56, 0.9, 1},
    Fact{"CommonWalnut", 0, old, 56, 0.35, 0.85},
    Fact{"Ginkgo", 0, old, 51, 0.9, 1},
    Fact{"EuropeanLarch", 0, old, 49, 0.9, 1},
    Fact{"EasternWhitePine", 0, old, 49, 0.9, 1},
    Fact{"BlueSpruce", 0, old, 51, 0.9, 1},
    Fact{"DeodarCedar", 0, old, 74, 0.9, 1},
    Fact{"WhiteWillow", 0, old, 42, 0.4, 1},
    Fact{"HoneyLocust", 0, old, 54, 0.4, 1},
    Fact{"RainTree", 0, old, 58, 0.3, 1},
    Fact{"DouglasFir", 0, old, 50, 0.9, 1},
    Fact{"StonePine", 17.2, old, 50, 0.6, 1},
    Fact{"ItalianCypress", 24.8, old, 36, 0.9, 1},
    Fact{"GiantSequoia", 18.9, old, 55, 0.9, 1},
    Fact{"CommonYew", 0, old, 60, 0.6, 1},
    Fact{"BalsamFir", 39.5, old, 52, 0.9, 1},
    Fact{"CoastRedwood", 0, old, 55, 0.9, 1},
    Fact{"EasternCottonwood", 0, old, 48, 0.5, 1},
    Fact{"FieldElm", 24.4, old, 46, 0.5, 1},
    Fact{"Jacaranda", 0, old, 48, 0.4, 1},
    Fact{"BlueGum", 0, old, 44, 0.6, 1},
    Fact{"SouthernMagnolia", 0, old, 58, 0.85, 1},
    Fact{"CoconutPalm", 0, old, 0, 0.7, 1},
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

/// m
struct Size
{
    double top = 0.0, trunk = 0.0,
           breast = 0.0; ///< heights of the tree and its first axis, diameter at 1.3 m
};

/// Limbs that live and are not drawn, though they are long against the tree, stand well out of their stem's
/// wood and are no twigs beside it.
std::size_t missingLimbs(const GrowthHistory& history, double age)
{
    constexpr double longest = 0.25, clear = 2.5, thick = 0.35; // of the tree; radii of the stem
    const WoodAtAge wood = woodAtAge(history, age);
    std::vector<double> reach(history.size(), 0.0);
    std::set<std::uint64_t> drawn;
    for (const auto& [first, address] : skeletonAtAge(history, age).axisStarts)
        drawn.insert(address);
    for (Index i = history.size(); i-- > 0;)
        if (const Index below = history.parent[i]; wood.radius[i] > 0.0) {
            reach[i] += double(history.length[i]);
            if (below != noIndex)
                reach[below] = std::max(reach[below], reach[i]);
        }
    const double most = reach.empty() ? 0.0 : *std::ranges::max_element(reach);
    std::size_t missing = 0;
    std::vector<bool> isOut(history.axisAddress.size(), false); // with what carries it
    for (Index i = 0; i < history.size(); ++i) {
        const Index below = history.parent[i];
        if (!(wood.radius[i] > 0.0) || below == noIndex || history.axis[below] == history.axis[i])
            continue;
        const Index axis = history.axis[i];
        const bool isLimb = reach[i] >= std::max(longest * most, clear * wood.radius[below]) &&
                            wood.radius[i] >= thick * wood.radius[below];
        const bool isDrawn = drawn.contains(history.axisAddress[axis]);
        missing += isLimb && !isDrawn && !isOut[history.axis[below]] ? 1 : 0;
        isOut[axis] = isOut[history.axis[below]] || !isDrawn;
    }
    return missing;
}

Size sizeOf(const Skeleton& tree)
{
    Size size;
    for (Index i = 0; i < tree.size(); ++i) {
        size.top = std::max(size.top, tree.p1[i].y);
        if (tree.level[i] != 0)
            continue;
        size.trunk = std::max(size.trunk, tree.p1[i].y);
        if (tree.p0[i].y <= 1.3 && tree.p1[i].y > 1.3)
            size.breast = 2.0 * tree.a0[i];
    }
    return size;
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
        for (std::size_t k = 0; k < grownSpecies().size(); k += everyNth) {
            const GrownSpecies& species = grownSpecies()[k];
            GrowthParams params = paramsOf(species);
            if (species.growth.habit == GrowthHabit::Palm) // its fronds are leaves that open and hang
                continue;
            const auto age = double(species.ages[mature]);
            params.age = age + 1.0;
            const auto history = growHistory(params, 1);
            QVERIFY(history);
            Skeleton before = skeletonAtAge(*history, age);
            for (int month = 1; month < 12; ++month) {
                const Skeleton after = skeletonAtAge(*history, age + month / 12.0);
                QVERIFY2(largestMove(before, after) <= most * params.height, species.name);
                before = after;
            }
        }
    }

    /// What has come to lie in thick wood, as near a trunk's foot, is a limb still.
    void noLimbIsLost_data()
    {
        QTest::addColumn<int>("row");
        for (std::size_t k = 0; k < grownSpecies().size(); k += everyNth)
            if (grownSpecies()[k].growth.habit != GrowthHabit::Palm)
                QTest::newRow(grownSpecies()[k].name) << int(k);
    }
    void noLimbIsLost()
    {
        QFETCH(const int, row);
        const GrownSpecies& species = grownSpecies()[std::size_t(row)];
        GrowthParams params = paramsOf(species);
        params.age = double(species.ages[old]);
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const auto history = growHistory(params, seed);
            QVERIFY(history);
            for (const double share : {0.1, 0.25, 0.5, 0.75, 1.0}) {
                const double age = std::floor(share * params.age);
                const std::size_t missing = missingLimbs(*history, age);
                QVERIFY2(missing == 0,
                         qPrintable(QStringLiteral("seed %1, %2 years: %3").arg(seed).arg(age).arg(missing)));
            }
        }
    }

    /// A limb that leaves an oak a foot above the ground is there at all ages, as long as it lives.
    void limbsOfTheFootStay()
    {
        GrowthParams params = presetParams("EnglishOak").value().growth;
        params.age = 80.0;
        const auto history = growHistory(params, 1);
        QVERIFY(history);
        constexpr double low = 0.7, far = 5.0; // m
        int limbs = 0;
        for (int age = 8; age <= 80; age += 3) {
            const WoodAtAge wood = woodAtAge(*history, age);
            std::set<std::uint64_t> living, drawn;
            for (Index i = 0; i < history->size(); ++i)
                if (wood.radius[i] > 0.0 && history->axisOrder[history->axis[i]] == 1 &&
                    glm::length(wood.at[i]) > far)
                    living.insert(history->axisAddress[history->axis[i]]);
            for (const auto& [first, address] : skeletonAtAge(*history, age).axisStarts)
                drawn.insert(address);
            for (Index i = 0; i < history->size(); ++i)
                if (const Index below = history->parent[i];
                    below != noIndex && wood.at[below].y < low && history->axis[below] != history->axis[i] &&
                    living.contains(history->axisAddress[history->axis[i]])) {
                    ++limbs;
                    QVERIFY2(drawn.contains(history->axisAddress[history->axis[i]]),
                             qPrintable(QString::number(age)));
                }
        }
        QVERIFY(limbs > 10);
    }

    void everySpeciesHasItsFacts()
    {
        QCOMPARE(grownSpecies().size(), facts.size());
        for (const GrownSpecies& species : grownSpecies()) {
            QCOMPARE(double(species.ages[1]), species.growth.age);
            QVERIFY(species.ages[0] < species.ages[1] && species.ages[1] < species.ages[2]);
        }
    }

    /// The middle of a flora's range by a quarter, and an index inside its band.
    void leavesAreAsFloraSay_data()
    {
        QTest::addColumn<QString>("name");
        for (std::size_t k = 0; k < presets().size(); k += everyNth) {
            const NodeParams& params = presets()[k].params;
            if (params.leaf.length > 0.0 && presets()[k].latin[0] != '\0')
                QTest::newRow(presets()[k].name) << QString::fromLatin1(presets()[k].name);
        }
    }
    void leavesAreAsFloraSay()
    {
        QFETCH(const QString, name);
        const std::string wanted = name.toStdString();
        const auto preset = std::ranges::find(presets(), std::string_view(wanted), &Preset::name);
        QVERIFY(preset != presets().end());
        if (preset->params.growth.habit == GrowthHabit::Palm) // its fronds are twigs with leaflets
            return;
        const PublishedLeaves* published = publishedLeaves(preset->latin);
        QVERIFY2(published, preset->name);
        TreePipeline pipeline;
        const auto tree = pipeline.evaluate(preset->params, Stage::Simplified);
        QVERIFY(tree);
        const double alpha = trunkRadius(preset->params);
        const auto foliage = placeFoliage(tree->simplified->skeleton, preset->params.foliage,
                                          preset->params.leaf, preset->params.fruit, alpha);
        QVERIFY(foliage);
        const LeafMeasures leaves = leafMeasures(*foliage, alpha, measuresOf(*tree->skeleton).crownWidth);
        const double middle = 0.5 * (published->length.from + published->length.to);
        QVERIFY2(std::abs(leaves.length - middle) <= 0.25 * middle,
                 qPrintable(QStringLiteral("%1: %2 m").arg(preset->name).arg(leaves.length)));
        if (published->areaIndex.to > 0.0)
            QVERIFY2(leaves.areaIndex >= published->areaIndex.from &&
                         leaves.areaIndex <= published->areaIndex.to,
                     qPrintable(QStringLiteral("%1: %2").arg(preset->name).arg(leaves.areaIndex)));
    }

    void matureTreesAreAsFloraSay_data()
    {
        QTest::addColumn<int>("row");
        for (std::size_t k = 0; k < facts.size(); k += everyNth)
            QTest::newRow(facts[k].name) << int(k);
    }

    void matureTreesAreAsFloraSay()
    {
        QFETCH(const int, row);
        const Fact& fact = facts[std::size_t(row)];
        const auto species =
            std::ranges::find(grownSpecies(), std::string_view(fact.name), &GrownSpecies::name);
        QVERIFY(species != grownSpecies().end());
        GrowthParams params = paramsOf(*species);
        params.age = double(species->ages[old]);
        const auto history = growHistory(params, 1);
        QVERIFY(history);
        const auto about = [&](const char* what, double value, double low, double high) {
            if (value < low || value > high)
                qWarning("%s: %s %.2f, not %.2f to %.2f", fact.name, what, value, low, high);
        };
        const Size measured = sizeOf(skeletonAtAge(*history, double(species->ages[fact.at])));
        const PublishedMeasures* published = publishedMeasures(species->latin);
        const double slenderness =
            fact.slenderness > 0.0 ? fact.slenderness : published->mean.height / published->mean.stemDiameter;
        about("slenderness", measured.top / measured.breast / slenderness, 0.75, 1.25);

        const Skeleton tree = skeletonAtAge(*history, double(species->ages[mature]));
        const Size size = sizeOf(tree);
        about("height", size.top / params.height, 0.85, 1.15);
        about("trunk", size.trunk / size.top, fact.trunkLow, fact.trunkHigh);
        if (params.habit == GrowthHabit::Palm)
            return;
        about("living metamers", double(history->years[std::size_t(species->ages[mature]) - 1].living),
              5000.0, 45'000.0);
        const double insertion = median(insertions(*history));
        about("insertion", insertion, fact.insertion - 8.0, fact.insertion + 8.0);
        about("insertion", insertion, 30.0, 90.0);
        about("Horton's ratio", hortonRatio(tree), 3.0, 5.0);
        if (params.phyllotaxis == Phyllotaxis::Spiral && params.whorl == 0)
            about("divergence", median(divergences(*history)), 130.0, 145.0);
    }
};

RAMURE_SUITE(TestGrownSpecies)

} // namespace tst_grown_species

#include "tst_grown_species.moc"
