/// \file
/// The selection that a link to one branch makes.
#pragma once

#include "core/qt/document/selection.h"

namespace ramure {

/// Selects the branch alone, with its tree as the active node, like a second click on it in the viewport.
inline Selection onlyBranch(NodeId node, Index branch)
{
    return {{node}, node, {branch}, branch};
}

} // namespace ramure
