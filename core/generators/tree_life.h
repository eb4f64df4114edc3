/// \file
/// The life of a tree that grows year by year, and the edits that it lives with.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/generators/growth/growth_history.h"
#include "core/params/node_params.h"

namespace ramure {

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

} // namespace ramure
