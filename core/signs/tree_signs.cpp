#include "core/signs/tree_signs.h"

#include "core/pipeline/tree_pipeline.h"
#include "core/presets/tree_measures.h"
#include "core/signs/sign_rows.h"
#include "core/skeleton/measures.h"
#include <algorithm>

namespace ramure {

const char* nameOf(SignState state)
{
    switch (state) {
    case SignState::Inside:
        return "inside";
    case SignState::Outside:
        return "outside";
    case SignState::NoBand:
        return "no band";
    case SignState::Absent:
        return "absent";
    case SignState::NotModelled:
        return "not modelled";
    }
    return "";
}

namespace signs {

TreeSign measured(TreeSign sign, double value)
{
    sign.value = value;
    sign.state = value >= sign.low && value <= sign.high ? SignState::Inside : SignState::Outside;
    return sign;
}

TreeSign absent(TreeSign sign, std::string note)
{
    sign.state = SignState::Absent;
    sign.note = std::move(note);
    return sign;
}

namespace {

void addHorton(Rows& rows, const Skeleton& tree)
{
    TreeSign sign{"hortonRatio",
                  "Horton ratio",
                  "",
                  {},
                  0.0,
                  3.0,
                  5.0,
                  "branches of an order over those of the next, by Strahler"};
    const double ratio = hortonRatio(tree);
    rows.push_back(ratio > 0.0 ? measured(std::move(sign), ratio)
                               : absent(std::move(sign), "fewer than three orders"));
}

/// Published are the trees with the thickest stems, which are old ones.
Expected<void> addSlenderness(Rows& rows, NodeParams params, const Preset* species, TreePipeline& pipeline)
{
    TreeSign sign{"slenderness", "slenderness", "",   {},
                  0.0,           0.75,          1.25, "height over stem diameter, over the published"};
    const PublishedMeasures* known = species ? publishedMeasures(species->latin) : nullptr;
    if (!known || !(known->mean.stemDiameter > 0.0)) {
        rows.push_back(absent(std::move(sign), "no published measures of the species"));
        return {};
    }
    if (params.generator.kind == EditOperation::Growth && species->ages.back() > 0) {
        params.growth.age = species->ages.back();
        sign.note += ", at " + std::to_string(species->ages.back()) + " years";
    }
    const auto tree = pipeline.evaluate(params, Stage::Skeleton);
    RAMURE_TRY(tree);
    const TreeMeasures own = measuresOf(*tree->skeleton);
    const double usual = known->mean.height / known->mean.stemDiameter;
    rows.push_back(own.stemDiameter > 0.0 ? measured(std::move(sign), own.height / own.stemDiameter / usual)
                                          : absent(std::move(sign), "lower than breast height"));
    return {};
}

/// Of all ends of branches those without leaves. They die in the shade where a step or the growth lets them.
void addDeadTwigs(Rows& rows, const Skeleton& tree)
{
    TreeSign sign{"deadTwigs", "dead twigs", "", {}, 0.0, 0.03, 0.12, "share of the ends of branches"};
    if (tree.bare.empty()) {
        rows.push_back(std::move(sign));
        return;
    }
    std::vector<bool> goesOn(tree.size(), false);
    for (const Index parent : tree.parent)
        if (parent != noIndex)
            goesOn[parent] = true;
    double ends = 0.0, dead = 0.0;
    for (Index i = 0; i < tree.size(); ++i)
        if (!goesOn[i]) {
            ends += 1.0;
            dead += std::ranges::binary_search(tree.bare, i) ? 1.0 : 0.0;
        }
    rows.push_back(measured(std::move(sign), ends > 0.0 ? dead / ends : 0.0));
}

} // namespace
} // namespace signs

Expected<std::vector<TreeSign>> treeSigns(const NodeParams& params, const Preset* species,
                                          const Progress& progress)
{
    TreePipeline pipeline;
    const auto tree = pipeline.evaluate(params, Stage::Mesh, progress.part(0.0, 0.3));
    RAMURE_TRY(tree);
    signs::Rows rows;
    signs::addWood(rows, *tree->branches, params);
    signs::addHorton(rows, *tree->skeleton);
    RAMURE_TRY(signs::addSlenderness(rows, params, species, pipeline));
    RAMURE_TRY(signs::addSag(rows, *tree->skeleton, params, progress.part(0.3, 0.5)));
    RAMURE_TRY(signs::addGrowth(rows, params, species ? species->latin : "", progress.part(0.5, 0.9)));
    RAMURE_TRY(signs::addFoliage(rows, params, pipeline, progress.part(0.9, 1.0)));
    signs::addDeadTwigs(rows, *tree->skeleton);
    rows.push_back({"scars", "scars of shed limbs", "", {}, 0.0, 0.9, 1.1, "scars over limbs shed"});
    rows.push_back(
        {"buttresses", "buttresses", "", {}, 0.0, 3.0, 12.0, "fins of the foot, where a species has them"});
    return rows;
}

} // namespace ramure
