#include "core/scatter/stand_places.h"

#include "core/params/source_facts.h"
#include "core/scatter/stand.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace ramure {
namespace {

/// How a prototype grows in a stand, and how high it is itself.
struct StandPrototype
{
    bool isTree = false;
    StandSpecies species;
    double height = 0.0; ///< m
};

/// A species without a table grows as the beech does, to its own height.
StandSpecies speciesOf(const Node& tree)
{
    if (const StandSpecies* known = findStandSpecies(tree.preset))
        return *known;
    const bool hasAge = tree.params.generator.kind == EditOperation::Growth;
    StandSpecies out = *findStandSpecies("EuropeanBeech");
    out.name = tree.preset.c_str();
    out.topHeight = hasAge ? 1.15 * tree.params.growth.height : sourceFacts(tree.params).reach(tree.params);
    return out;
}

StandPrototype standing(const Node& node)
{
    StandPrototype out;
    out.isTree = node.kind == NodeKind::Tree;
    if (!out.isTree)
        return out;
    out.species = speciesOf(node);
    const bool hasAge = node.params.generator.kind == EditOperation::Growth;
    out.height = hasAge ? topHeightAt(out.species, node.params.growth.age) : out.species.topHeight;
    return out;
}

/// Of the prototypes of one species, the one whose height is nearest by ratio.
std::size_t nearest(const std::vector<StandPrototype>& all, std::size_t sown, double height)
{
    std::size_t best = sown;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double ratio = height > all[i].height ? height / all[i].height : all[i].height / height;
        if (all[i].isTree && std::string_view(all[i].species.name) == all[sown].species.name &&
            ratio < least) {
            least = ratio;
            best = i;
        }
    }
    return best;
}

} // namespace

Expected<ScatterPlaces> grownPlaces(const ScatterParams& params, const std::vector<const Node*>& prototypes,
                                    ScatterPlaces sown, const Progress& progress)
{
    std::vector<StandPrototype> all;
    for (const Node* node : prototypes)
        all.push_back(standing(*node));
    std::vector<Seedling> seedlings;
    std::vector<std::size_t> placeOf; // per seedling
    for (std::size_t i = 0; i < sown.size(); ++i)
        if (const StandPrototype& prototype = all[sown[i].prototype]; prototype.isTree) {
            seedlings.push_back({{sown[i].position.x, sown[i].position.z}, &prototype.species});
            placeOf.push_back(i);
        }
    if (seedlings.empty())
        return sown;
    auto grown = grownStand(seedlings, int(std::lround(params.age)), std::uint64_t(params.seed), progress);
    if (!grown) {
        grown.error().path = "scatter.stand";
        return fail(grown.error());
    }
    ScatterPlaces out;
    for (const ScatterPlace& place : sown)
        if (!all[place.prototype].isTree)
            out.push_back(place);
    for (const StandTree& tree : *grown) {
        ScatterPlace& place = out.emplace_back(sown[placeOf[tree.number]]);
        place.prototype = static_cast<std::uint32_t>(nearest(all, place.prototype, tree.height));
        place.size = tree.height / all[place.prototype].height;
    }
    return out;
}

} // namespace ramure
