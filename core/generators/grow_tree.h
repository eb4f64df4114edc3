/// \file
/// Whatever generator a tree has: from its parameters to a skeleton. A new generator has its place here.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/generators/parametric/derive.h"
#include "core/params/node_params.h"
#include "core/skeleton/skeleton.h"
#include <string>

namespace ramure {

/// What the rules made of the axiom; empty where no grammar grows.
struct GrownSymbols
{
    std::string letters;
    ModuleWord word; ///< of the parametric dialect, one module a letter
};

/// Errors of both: those of the generators, path = the parameter's key; Cancelled. \pre checkParams.
Expected<GrownSymbols> growSymbols(const NodeParams& params, const Progress& progress = {});
Expected<Skeleton> growSkeleton(const GrownSymbols& grown, const NodeParams& params,
                                const Progress& progress = {});

/// The parameter that most likely makes a tree too large.
const char* sizeKey(const NodeParams& params);

} // namespace ramure
