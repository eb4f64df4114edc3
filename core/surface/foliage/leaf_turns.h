/// \file
/// How leaves go around what carries them, node by node. Internal to the placement of leaves.
#pragma once

#include "core/math/angle.h"
#include "core/params/leaf_params.h"

namespace ramure {

struct LeafTurns
{
    int perNode;
    double fromNodeToNode; ///< rad
    bool level;            ///< they lie left and right of a level twig
};

/// \param whorl leaves of a node of LeafArrangement::Whorled. \pre the arrangement is not Natural.
inline LeafTurns leafTurns(LeafArrangement arrangement, int whorl)
{
    switch (arrangement) {
    case LeafArrangement::Distichous:
        return {1, pi, true};
    case LeafArrangement::Spiral:
        return {1, goldenAngle, false};
    case LeafArrangement::Opposite:
        return {2, 0.0, true};
    case LeafArrangement::Decussate:
        return {2, 0.5 * pi, false};
    case LeafArrangement::Whorled:
        return {whorl, pi / whorl, false};
    default:
        return {1, 0.8 * pi, false};
    }
}

} // namespace ramure
