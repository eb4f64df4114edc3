/// \file
/// Decides which parameters have an effect beside the others: a box has no radius, and only the transpose
/// solver has a step size. The interface offers no other parameter; files and the command line take them all.
#pragma once

#include "core/params/param_def.h"
#include <span>

namespace ramure {

/// Whether the choices in \p params (generator, dialect, shape, leaf …) use \p def at all.
bool isRelevant(const NodeParams& params, const ParamDef& def);
/// Whether an edit of \p def changes anything: the choices use it, and no number or switch turns it off
/// (ParamDef::matters).
bool acts(const NodeParams& params, const ParamDef& def);

/// The choice that decides about \p def and the items with which it has an effect; null where nothing does.
struct Relevance
{
    const char* key;     ///< "primitive.radius"; "turtle.": all of these
    const char* chooser; ///< "primitive.shape"
    std::span<const char* const> items;
};
const Relevance* relevanceOf(const ParamDef& def);

} // namespace ramure
