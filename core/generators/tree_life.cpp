#include "core/generators/tree_life.h"

#include "core/generators/shape_test.h"
#include "core/params/tree_edit_table.h"
#include <algorithm>
#include <cmath>

namespace ramure {

double historyYears(const NodeParams& params)
{
    constexpr double step = 10.0;
    return std::min(step * std::max(std::ceil(params.growth.age / step), 1.0), maxGrowthAge);
}

bool canLiveOn(const TreeEdit& edit)
{
    // What falls hangs on its stump until then; what a graft has made never grew.
    return (infoOf(edit.operation).fields & editYear) && !edit.falls && edit.target.maker == 0;
}

double growthYears(const NodeParams& params)
{
    const bool grows = params.generator.kind == EditOperation::Growth && stepsFrozen(params.edits) == 0;
    return grows ? std::max(std::floor(params.growth.age), 1.0) : 0.0;
}

/// Null: it has no inside.
static std::shared_ptr<const GrowthShape> shapeOf(const EditShape& shape)
{
    const auto kept = std::make_shared<const EditShape>(shape);
    const auto test = std::make_shared<const ShapeTest>(*kept);
    if (!test->check())
        return nullptr;
    return std::make_shared<const GrowthShape>(
        [kept, test](const glm::dvec3& at) { return test->contains(at); });
}

GrowthCuts growthCuts(const NodeParams& params)
{
    GrowthCuts cuts;
    if (growthYears(params) <= 0.0)
        return cuts;
    for (const TreeEdit& edit : params.edits)
        if (edit.enabled && edit.year > 0.0 && canLiveOn(edit) &&
            (edit.operation != EditOperation::Prune || params.growth.habit == GrowthHabit::Branching)) {
            GrowthCut cut{edit.target.address, 0.0, std::max(int(edit.year), 1), edit.id, {}};
            if (edit.operation == EditOperation::Cut)
                cut.share = edit.at;
            if (edit.operation == EditOperation::Prune && !(cut.within = shapeOf(edit.shape)))
                continue; // the recipe says why it cannot
            cuts.push_back(std::move(cut));
        }
    return cuts;
}

Expected<GrowthRun> beginLife(const NodeParams& params, const Progress& progress)
{
    const auto seed = static_cast<std::uint64_t>(params.grammar.seed);
    return GrowthRun::begin(params.growth, seed, growthCuts(params), progress);
}

} // namespace ramure
