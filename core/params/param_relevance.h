/// \file
/// Which parameters have an effect beside the others: a box has no radius, the transpose solver alone a step
/// size. The interface hides what has none; files and the command line take every value all the same.
#pragma once

#include "core/params/param_def.h"
#include <span>

namespace ramure {

/// Whether \p def has an effect on a node of these values.
bool isRelevant(const NodeParams& params, const ParamDef& def);

/// The choice that decides about \p def and the items with which it has an effect; null where nothing does.
struct Relevance
{
    const char* key;     ///< "primitive.radius"; "turtle.": all of these
    const char* chooser; ///< "primitive.shape"
    std::span<const char* const> items;
};
const Relevance* relevanceOf(const ParamDef& def);

} // namespace ramure
