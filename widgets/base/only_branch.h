/// \file
/// The selection that a link to one branch makes.
#pragma once

#include "core/qt/document/selection.h"

namespace ramure {

/// The branch alone, and its tree as the active node: what a second click on it in the viewport selects.
inline Selection onlyBranch(NodeId node, Index branch)
{
    return {{node}, node, {branch}, branch};
}

} // namespace ramure
