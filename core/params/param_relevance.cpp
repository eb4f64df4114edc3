#include "core/params/param_relevance.h"

#include "core/params/param_items.h"
#include "core/params/tree_edit_table.h"
#include <algorithm>
#include <string_view>
#include <vector>

namespace ramure {
namespace {

constexpr std::array round{"cylinder", "sphere", "cone", "frameCross"};
constexpr std::array tall{"cylinder", "cone", "frameCross"};
constexpr std::array angular{"box", "plane"};
constexpr std::array standing{"cylinder", "sphere", "box", "cone", "plane"};
constexpr std::array pictured{"smooth", "plated",    "furrowed", "scaly", "peeling", "ringed", "fibrous",
                              "mosaic", "palmScars", "thorny",   "corky", "bamboo",  "banded", "palmBoots"};
constexpr std::array classic{"classic"};
constexpr std::array parametricOnly{"parametric"};
constexpr std::array robust{"robust"};
constexpr std::array growth{"growth"};
constexpr std::array spiral{"spiral"};
constexpr std::array branching{"branching"};
constexpr std::array palm{"palm"};
constexpr std::array profile{"profile"};
constexpr std::array revolved{"sphere", "hemisphere", "cone", "cylinder", "profile"};
constexpr std::array transpose{"transpose"};
constexpr std::array faithful{"faithful"};
constexpr std::array whorled{"whorled"};
/// All but the first, which is the faithful one.
constexpr auto realLeaves = [] {
    std::array<const char*, leafShapeCount - 1> names{};
    for (std::size_t i = 0; i < names.size(); ++i)
        names[i] = itemsOf<LeafShape>[i + 1].name;
    return names;
}();

/// Of plants that have a year: palms have none.
constexpr auto yearlyLeaves = [] {
    std::array<const char*, leafShapeCount - 3> names{};
    std::size_t count = 0;
    for (std::size_t i = 1; i < itemsOf<LeafShape>.size(); ++i)
        if (const auto shape = static_cast<LeafShape>(i);
            shape != LeafShape::Palm && shape != LeafShape::FanPalm)
            names[count++] = itemsOf<LeafShape>[i].name;
    return names;
}();

constexpr auto realFruit = [] {
    std::array<const char*, fruitKindCount - 1> names{};
    for (std::size_t i = 0; i < names.size(); ++i)
        names[i] = itemsOf<FruitKind>[i + 1].name;
    return names;
}();

constexpr std::array relevances{
    Relevance{"grammar.constants", "grammar.dialect", parametricOnly},
    Relevance{"turtle.tropism", "grammar.dialect", parametricOnly},
    Relevance{"turtle.elasticity", "grammar.dialect", parametricOnly},
    Relevance{"variation.radius", "grammar.dialect", classic},
    Relevance{"growth.divergence", "growth.phyllotaxis", spiral},
    Relevance{"growth.age", "generator.kind", growth},
    Relevance{"growth.habit", "generator.kind", growth},
    Relevance{"growth.maturity", "generator.kind", growth},
    Relevance{"growth.height", "generator.kind", growth},
    Relevance{"growth.sunlight", "generator.kind", growth},
    Relevance{"growth.wander", "generator.kind", growth},
    Relevance{"growth.fronds", "growth.habit", palm},
    Relevance{"growth.frondLength", "growth.habit", palm},
    Relevance{"growth.frondYears", "growth.habit", palm},
    Relevance{"growth.stemRadius", "growth.habit", palm},
    Relevance{"growth.fruit", "growth.habit", palm},
    Relevance{"colonisation.profile", "colonisation.envelope", profile},
    Relevance{"colonisation.crownBase", "colonisation.envelope", revolved},
    Relevance{"colonisation.crownHeight", "colonisation.envelope", revolved},
    Relevance{"colonisation.crownRadius", "colonisation.envelope", revolved},
    Relevance{"primitive.radius", "primitive.shape", round},
    Relevance{"primitive.height", "primitive.shape", tall},
    Relevance{"primitive.size", "primitive.shape", angular},
    Relevance{"primitive.sides", "primitive.shape", round},
    Relevance{"primitive.axis", "primitive.shape", standing},
    Relevance{"bark.depth", "bark.family", pictured},
    Relevance{"bark.light", "bark.family", pictured},
    Relevance{"bark.moss", "bark.family", pictured},
    Relevance{"bark.seed", "bark.family", pictured},
    Relevance{"physics.substeps", "physics.mode", robust},
    Relevance{"physics.settled", "physics.mode", robust},
    Relevance{"foliage.leavesDensity", "foliage.leaf", faithful},
    Relevance{"foliage.whorl", "foliage.arrangement", whorled},
    Relevance{"foliage.internode", "foliage.leaf", realLeaves},
    Relevance{"foliage.arrangement", "foliage.leaf", realLeaves},
    Relevance{"foliage.leafAngle", "foliage.leaf", realLeaves},
    Relevance{"foliage.leafDroop", "foliage.leaf", realLeaves},
    Relevance{"foliage.leafLight", "foliage.leaf", realLeaves},
    Relevance{"season.day", "foliage.leaf", yearlyLeaves},
    Relevance{"season.climate", "foliage.leaf", yearlyLeaves},
    Relevance{"season.purple", "foliage.leaf", yearlyLeaves},
    Relevance{"season.redness", "foliage.leaf", yearlyLeaves},
    Relevance{"foliage.season", "foliage.leaf", realLeaves},
    Relevance{"foliage.leafStiffness", "foliage.leaf", realLeaves},
    Relevance{"foliage.leafFlutter", "foliage.leaf", realLeaves},
    Relevance{"foliage.leafLength", "foliage.leaf", realLeaves},
    Relevance{"foliage.leavesPerShoot", "foliage.leaf", realLeaves},
    Relevance{"foliage.leafSize", "foliage.leaf", realLeaves},
    Relevance{"foliage.leafVariation", "foliage.leaf", realLeaves},
    Relevance{"foliage.leafWidth", "foliage.leaf", realLeaves},
    Relevance{"foliage.petiole", "foliage.leaf", realLeaves},
    Relevance{"foliage.leafFold", "foliage.leaf", realLeaves},
    Relevance{"foliage.leafCurl", "foliage.leaf", realLeaves},
    Relevance{"foliage.leafCup", "foliage.leaf", realLeaves},
    Relevance{"foliage.leafDetail", "foliage.leaf", realLeaves},
    Relevance{"foliage.shadeLeaves", "foliage.leaf", realLeaves},
    Relevance{"foliage.leafDamage", "foliage.leaf", realLeaves},
    Relevance{"foliage.fruitDiameter", "foliage.fruit", realFruit},
    Relevance{"foliage.fruitCluster", "foliage.fruit", realFruit},
    Relevance{"foliage.fruitRipeness", "foliage.fruit", realFruit},
    Relevance{"foliage.fruitSize", "foliage.fruit", realFruit},
    Relevance{"foliage.fruitStalk", "foliage.fruit", realFruit},
    Relevance{"ik.gain", "ik.solver", transpose},
    // All whose key begins so and that have no row above.
    Relevance{"growth.", "growth.habit", branching},
};

/// Parameters of a source matter to a tree that begins with it.
std::vector<Relevance> ofSources()
{
    std::vector<Relevance> all;
    for (const EditOperation source : firstSources) {
        const EditOperationInfo& kind = infoOf(source);
        for (const ParamDef* def : stepParams(source))
            if (hasParam(NodeKind::Tree, *def))
                all.push_back({def->key, "generator.kind", {&kind.first.name, 1}});
    }
    return all;
}

} // namespace

const Relevance* relevanceOf(const ParamDef& def)
{
    const std::string_view key = def.key;
    if (key == "grammar.seed") // one seed, whatever grows
        return nullptr;
    const auto isOf = [key](const Relevance& each) {
        const std::string_view own = each.key;
        return own.ends_with('.') ? key.starts_with(own) : key == own;
    };
    if (const auto* found = std::ranges::find_if(relevances, isOf); found != relevances.end())
        return found;
    static const std::vector<Relevance> sources = ofSources();
    const auto found = std::ranges::find_if(sources, isOf);
    return found == sources.end() ? nullptr : &*found;
}

bool isRelevant(const NodeParams& params, const ParamDef& def)
{
    const Relevance* relevance = relevanceOf(def);
    if (!relevance)
        return true;
    // No leaves at all: whoever misses them finds the reason.
    if (def.key == std::string_view("foliage.leavesDensity") && params.foliage.leavesDensity == 0)
        return true;
    const ParamDef& chooser = *findParam(relevance->chooser);
    if (!isRelevant(params, chooser))
        return false;
    const ParamValue chosen = chooser.get(params);
    const auto* item = std::get_if<EnumValue>(&chosen);
    return !item ||
           std::ranges::any_of(relevance->items, [&](const char* name) { return item->name == name; });
}

bool acts(const NodeParams& params, const ParamDef& def)
{
    return isRelevant(params, def) && (!def.matters || def.matters(params));
}

} // namespace ramure
