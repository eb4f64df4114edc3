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

/// Of the arms on show that follow a target; nothing where there are none. Cheap: it takes what the player or
/// \p reach (may be null) has computed; of an arm at rest only where its tip is.
std::optional<ArmResiduals> armResiduals(const Scene& scene, const Player& player, const ArmReach* reach);

} // namespace ramure
