/// \file
/// Tests that run over the whole parameter table need a node that has the parameter.
#pragma once

#include "core/params/param_relevance.h"
#include <cstdint>

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

/// Chooses what gives \p def an effect, and turns the switch or number that it needs.
inline void makeRelevant(NodeParams& params, const ParamDef& def)
{
    const Relevance* relevance = relevanceOf(def);
    if (relevance && !isRelevant(params, def)) {
        const ParamDef& chooser = *findParam(relevance->chooser);
        makeRelevant(params, chooser);
        chooser.assign(params, EnumValue{relevance->items[0]});
    }
    for (const ParamDef& other : paramTable()) {
        if (acts(params, def))
            return;
        NodeParams turned = params;
        if (other.type == ParamType::Bool)
            other.assign(turned, true);
        else if (other.type == ParamType::Int)
            other.assign(turned, static_cast<std::int64_t>(other.hardMax));
        else if (other.type == ParamType::Real)
            other.assign(turned, other.hardMax);
        if (&other != &def && acts(turned, def))
            params = turned;
    }
}

} // namespace ramure::test
