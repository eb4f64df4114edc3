/// \file
/// Tests that run over the whole parameter table need a node that has the parameter.
#pragma once

#include "core/params/param_relevance.h"

namespace ramure::test {

/// Trees where they have it, else the first kind that does.
inline NodeKind kindWith(const ParamDef& def)
{
    if (hasParam(NodeKind::Tree, def))
        return NodeKind::Tree;
    for (int i = 0; i < nodeKindCount; ++i)
        if (hasParam(static_cast<NodeKind>(i), def))
            return static_cast<NodeKind>(i);
    return NodeKind::Group;
}

/// Chooses what gives \p def an effect.
inline void makeRelevant(NodeParams& params, const ParamDef& def)
{
    const Relevance* relevance = relevanceOf(def);
    if (!relevance || isRelevant(params, def))
        return;
    const ParamDef& chooser = *findParam(relevance->chooser);
    makeRelevant(params, chooser);
    chooser.assign(params, EnumValue{relevance->items[0]});
}

} // namespace ramure::test
