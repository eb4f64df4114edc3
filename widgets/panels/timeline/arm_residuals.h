/// \file
/// How far the tips of arms are from their targets, now and on the way there.
#pragma once

#include "core/scene/scene.h"
#include <optional>
#include <vector>

namespace ramure {

class ArmReach;
class Player;

struct ArmResiduals
{
    double now = 0.0; ///< m, the largest of all arms
    std::vector<double>
        way; ///< m, the same by ticks of the solver up to now; empty where nothing has moved yet
};

/// Returns the residuals of the visible arms that follow a target; nothing if there are none. It is cheap: it
/// takes what the player or \p reach (may be null) has computed, and for an arm at rest only its tip.
std::optional<ArmResiduals> armResiduals(const Scene& scene, const Player& player, const ArmReach* reach);

} // namespace ramure
