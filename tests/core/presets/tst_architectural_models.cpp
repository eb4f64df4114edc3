#include "core/generators/growth/grown_skeleton.h"
#include "core/generators/growth/whole_life.h"
#include "core/math/angle.h"
#include "core/presets/species.h"
#include "tests/support/suite.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <set>
#include <string_view>
#include <vector>

namespace tst_architectural_models {

using namespace ramure;

namespace {

/// Models of growth, after Hallé, Oldeman, Tomlinson: "Tropical trees and forests. An architectural analysis"
/// (1978), which knows 23.
enum class Model : std::uint8_t { Rauh, Massart, Attims, Troll, Scarrone, Corner };

struct Assigned
{
    const char* name;
    Model model;
};

// Of conifers after Edelin, "Images de l'architecture des conifères" (1977); of others after the book.
constexpr std::array assigned{
    Assigned{"EnglishOak", Model::Rauh},
    Assigned{"RedOak", Model::Rauh},
    Assigned{"LiveOak", Model::Rauh},
    Assigned{"ScotsPine", Model::Rauh},
    Assigned{"EasternWhitePine", Model::Rauh},
    Assigned{"StonePine", Model::Rauh},
    Assigned{"CommonWalnut", Model::Rauh},
    Assigned{"TulipTree", Model::Rauh},
    Assigned{"Sweetgum", Model::Rauh},
    Assigned{"DouglasFir", Model::Massart},
    Assigned{"CoastRedwood", Model::Massart},
    Assigned{"LebanonCedar", Model::Massart},
    Assigned{"ItalianCypress", Model::Attims},
    Assigned{"EuropeanBeech", Model::Troll},
    Assigned{"SmallLeavedLinden", Model::Troll},
    Assigned{"AmericanElm", Model::Troll},
    Assigned{"FieldElm", Model::Troll},
    Assigned{"Hornbeam", Model::Troll},
    Assigned{"HoneyLocust", Model::Troll},
    Assigned{"HorseChestnut", Model::Scarrone},
    Assigned{"CoconutPalm", Model::Corner},
};

/// How a tree is built, of all that it bore up to an age.
struct Habit
{
    double trunk = 0.0;  ///< height of the first axis over that of the tree
    double rhythm = 0.0; ///< limbs at the end of a year's shoot of the trunk, over those at its other nodes
    double rise = 0.0;   ///< mean sine of the angle between limbs' outer halves and the ground
    double aside = 0.0;  ///< mean sine of the angle between what limbs bear and their flat side
    double pairs = 0.0;  ///< of the nodes that bear side shoots, those that bear two opposite ones
    double rows = 0.0; ///< of single side shoots, those that stand opposite the one before, within 30 degrees
    double replaced = 0.0; ///< of the living limbs, those that have ended and go on in side shoots
};

GrowthParams paramsOf(const GrownSpecies& species)
{
    GrowthParams params = species.growth;
    params.axil *= oneDegree;
    return params;
}

struct Measure
{
    double sum = 0.0, count = 0.0;
    void add(double value)
    {
        sum += value;
        count += 1.0;
    }
    [[nodiscard]] double mean() const { return count > 0.0 ? sum / count : 0.0; }
};

Habit habitOf(const GrowthHistory& h, int age)
{
    const WoodAtAge wood = woodAtAge(h, age);
    Habit out;
    std::vector<std::vector<Index>> sides(h.size());
    std::vector<Index> next(h.size(), noIndex);
    std::vector<std::vector<Index>> axes(h.axisAddress.size());
    for (Index i = 0; i < h.size() && int(h.birth[i]) < age; ++i) {
        axes[h.axis[i]].push_back(i);
        if (const Index below = h.parent[i]; below != noIndex)
            h.axis[below] == h.axis[i] ? (void)(next[below] = i) : sides[below].push_back(i);
    }
    double top = 0.0, trunkTop = 0.0;
    for (Index i = 0; i < h.size(); ++i)
        if (wood.radius[i] > 0.0) {
            top = std::max(top, wood.at[i].y);
            if (h.axisOrder[h.axis[i]] == 0)
                trunkTop = std::max(trunkTop, wood.at[i].y);
        }
    out.trunk = top > 0.0 ? trunkTop / top : 0.0;
    Measure ends, others, rise, flat, pairs, rows, replaced;
    const auto wayOf = [&](Index i) {
        const glm::dvec3 below = h.parent[i] == noIndex ? h.footOf(i) : wood.at[h.parent[i]];
        return glm::normalize(wood.at[i] - below);
    };
    for (std::size_t a = 0; a < axes.size(); ++a) {
        const std::vector<Index>& own = axes[a];
        const unsigned order = h.axisOrder[a];
        for (std::size_t from = 0, to = 0; order == 0 && from < own.size(); from = to) {
            while (to < own.size() && h.birth[own[to]] == h.birth[own[from]])
                ++to;
            for (std::size_t k = from; k < to && to - from >= 2; ++k)
                (k + 1 == to ? ends : others).add(double(sides[own[k]].size()));
        }
        std::size_t living = 0;
        while (living < own.size() && wood.radius[own[living]] > 0.0)
            ++living;
        if (living >= 6)
            for (std::size_t k = living / 2; order == 1 && k < living; ++k)
                rise.add(wayOf(own[k]).y);
        if (order == 2 && living >= 1) { // out of the plane of its limb and the horizontal
            const glm::dvec3 limb = wayOf(h.parent[own[0]]);
            const glm::dvec3 across = glm::cross(glm::dvec3(0, 1, 0), limb);
            if (glm::length(across) > 0.2)
                flat.add(std::abs(glm::dot(wayOf(own[0]), glm::normalize(glm::cross(limb, across)))));
        }
        if (living >= 4 && order >= 1)
            replaced.add(living == own.size() && !sides[own.back()].empty() &&
                                 int(h.birth[own.back()]) + 2 < age
                             ? 1.0
                             : 0.0);
        Index before = noIndex;
        for (const Index i : own) {
            if (next[i] == noIndex || sides[i].empty())
                continue;
            const glm::dvec3 along(h.direction[i]);
            const auto aside = [&](Index side) {
                const glm::dvec3 d(h.direction[side]);
                return glm::normalize(d - glm::dot(d, along) * along);
            };
            pairs.add(sides[i].size() == 2 && glm::dot(aside(sides[i][0]), aside(sides[i][1])) < -0.8 ? 1.0
                                                                                                      : 0.0);
            if (sides[i].size() == 1 && before != noIndex && h.parent[i] == before && order > 0 &&
                h.birth[i] == h.birth[before])
                rows.add(glm::dot(aside(sides[i][0]), aside(sides[before][0])) < -std::cos(30.0 * oneDegree)
                             ? 1.0
                             : 0.0);
            before = sides[i].size() == 1 ? i : noIndex;
        }
    }
    out.rhythm = ends.mean() / std::max(others.mean(), 0.01);
    out.rise = rise.mean();
    out.aside = flat.mean();
    out.pairs = pairs.mean();
    out.rows = rows.mean();
    out.replaced = replaced.mean();
    return out;
}

} // namespace

class TestArchitecturalModels : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void everySpeciesShowsItsModel_data()
    {
        QTest::addColumn<int>("row");
        for (int k = 0; k < int(assigned.size()); ++k)
            QTest::newRow(assigned[std::size_t(k)].name) << k;
    }
    /// By where it branches, where its limbs look, and what ends its axes.
    void everySpeciesShowsItsModel()
    {
        QFETCH(const int, row);
        const auto [name, model] = assigned[std::size_t(row)];
        const auto species = std::ranges::find(grownSpecies(), std::string_view(name), &GrownSpecies::name);
        QVERIFY(species != grownSpecies().end());
        if (model == Model::Corner)
            return isOfCorner(species->growth);
        GrowthParams params = paramsOf(*species);
        params.age = double(species->ages[0]); // before its leader is lost
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const auto history = growHistory(params, seed);
            QVERIFY(history);
            const Habit h = habitOf(*history, int(params.age));
            const QByteArray found =
                QStringLiteral(
                    "seed %1: trunk %2, rhythm %3, rise %4, aside %5, pairs %6, rows %7, replaced %8")
                    .arg(seed)
                    .arg(h.trunk)
                    .arg(h.rhythm)
                    .arg(h.rise)
                    .arg(h.aside)
                    .arg(h.pairs)
                    .arg(h.rows)
                    .arg(h.replaced)
                    .toLatin1();
            QVERIFY2(h.trunk > 0.9, found.constData()); // all of these are monopodial
            QVERIFY2(shows(model, h), found.constData());
        }
    }

    /// Each of them is shown by a tree, and no tree shows one that it has not.
    void modelsDiffer()
    {
        std::set<Model> shown;
        for (const Assigned& one : assigned)
            shown.insert(one.model);
        QCOMPARE(shown.size(), std::size_t{6});
        for (const auto& [name, model] :
             {Assigned{"EuropeanBeech", Model::Rauh}, Assigned{"EnglishOak", Model::Troll},
              Assigned{"DouglasFir", Model::Attims}, Assigned{"RedOak", Model::Massart},
              Assigned{"ItalianCypress", Model::Massart}, Assigned{"CommonAsh", Model::Scarrone}}) {
            const auto species =
                std::ranges::find(grownSpecies(), std::string_view(name), &GrownSpecies::name);
            GrowthParams params = paramsOf(*species);
            params.age = double(species->ages[0]);
            const auto history = growHistory(params, 1);
            QVERIFY(history);
            QVERIFY2(!shows(model, habitOf(*history, int(params.age))), name);
        }
    }

private:
    static bool shows(Model model, const Habit& h)
    {
        constexpr double tiers = 1.6, even = 1.3; // see Habit::rhythm
        constexpr double level = 0.25, allAround = 0.4, flat = 0.3, goesOn = 0.05;
        const bool hasTiers = h.rhythm >= tiers, rises = h.rise > 0.15;
        switch (model) {
        case Model::Rauh: // limbs are like the trunk, and flowers stand aside
            return hasTiers && rises && h.aside > allAround && h.replaced < goesOn;
        case Model::Massart: // level limbs in tiers
            return hasTiers && h.rise < level && h.rhythm > 2.5;
        case Model::Attims: // no tiers, limbs like the trunk
            return h.rhythm < even && h.rise > level && h.rows < 0.5;
        case Model::Troll: // all axes lie flat, leaves in two rows
            return h.rows > 0.75 && h.aside < flat;
        case Model::Scarrone: // limbs end in flowers and fork
            return rises && h.pairs > 0.9 && h.replaced > goesOn;
        case Model::Corner:
            break;
        }
        return false;
    }

    /// One axis that never ends and never branches; bunches stand in the axils of its leaves.
    static void isOfCorner(GrowthParams params)
    {
        const auto history = growHistory(params, 1);
        QVERIFY(history);
        const Skeleton tree = skeletonAtAge(*history, params.age);
        double top = 0.0, highest = 0.0, lowest = 1e9;
        for (Index i = 0; i < tree.size(); ++i) {
            if (tree.level[i] == 0)
                top = std::max(top, tree.p1[i].y);
            else if (tree.parent[i] != noIndex && tree.level[tree.parent[i]] == 0)
                lowest = std::min(lowest, tree.p0[i].y);
        }
        int fruit = 0;
        for (const Organ& organ : tree.organs)
            if (organ.kind == OrganKind::Fruit) {
                ++fruit;
                highest =
                    std::max(highest, glm::mix(tree.p0[organ.branch], tree.p1[organ.branch], organ.share).y);
            }
        QVERIFY(lowest > 0.5 * top); // nothing but the crown of leaves
        QVERIFY(fruit > 0 && highest < top + 0.5);
    }
};

RAMURE_SUITE(TestArchitecturalModels)

} // namespace tst_architectural_models

#include "tst_architectural_models.moc"
