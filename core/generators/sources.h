/// \file
/// The sources of recipes: from a source's parameters to a skeleton. A new source has its row in sources.cpp.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/generators/growth/growth_history.h"
#include "core/generators/parametric/derive.h"
#include "core/params/node_params.h"
#include "core/skeleton/skeleton.h"
#include <memory>
#include <string>

namespace ramure {

/// The word that the rules made of the axiom, or the history of a tree grown by years. Parts that the
/// generator does not have are empty.
struct GrownSymbols
{
    std::string letters;
    ModuleWord word; ///< parametric dialect: one module per letter
    /// Only for a tree that grows year by year: its life, from which its age is cut.
    std::shared_ptr<const GrowthHistory> history{};
};

struct Source
{
    EditOperation operation;
    Expected<Skeleton> (*skeleton)(const GrownSymbols& grown, const NodeParams& params,
                                   const Progress& progress);
    bool (*varies)(const NodeParams& params); ///< whether two seeds can give two trees
    /// Null: it has no symbols.
    Expected<GrownSymbols> (*symbols)(const NodeParams& params, const Progress& progress) = nullptr;
};
/// The source that a tree begins with.
const Source& sourceOf(const NodeParams& params);

/// Errors of both functions: those of the generators, path = the parameter's key; Cancelled. \pre
/// checkParams.
Expected<GrownSymbols> growSymbols(const NodeParams& params, const Progress& progress = {});
Expected<Skeleton> growSkeleton(const GrownSymbols& grown, const NodeParams& params,
                                const Progress& progress = {});

} // namespace ramure
