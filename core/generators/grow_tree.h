/// \file
/// Whatever generator a tree has: from its parameters to a skeleton. A new generator has its place here.
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

/// Errors of both functions: those of the generators, path = the parameter's key; Cancelled. \pre
/// checkParams.
Expected<GrownSymbols> growSymbols(const NodeParams& params, const Progress& progress = {});
Expected<Skeleton> growSkeleton(const GrownSymbols& grown, const NodeParams& params,
                                const Progress& progress = {});

/// The life of a tree that grows by years, before its first one. Errors: those of growHistory().
Expected<GrowthRun> beginLife(const NodeParams& params, const Progress& progress = {});

/// Years that the history of a tree is grown for: as many for all ages of ten years.
double historyYears(const NodeParams& params);

/// Edits that say at what age of a growing tree they are made. Behind a frozen step they are not of its life.
GrowthCuts growthCuts(const NodeParams& params);
/// Whether an edit can be one of those.
bool canLiveOn(const TreeEdit& edit);
/// TreeEdit::year of an edit that is made now; 0: the tree does not grow by years, or is frozen.
double growthYears(const NodeParams& params);

/// The parameter that most likely makes a tree too large.
const char* sizeKey(const NodeParams& params);

} // namespace ramure
