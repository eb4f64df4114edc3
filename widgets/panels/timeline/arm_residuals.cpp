#include "widgets/panels/timeline/arm_residuals.h"

#include "core/qt/session/arm/arm_reach.h"
#include "core/qt/session/motion/player.h"
#include "core/rig/arm/arm_chain.h"
#include <algorithm>
#include <glm/geometric.hpp>
#include <span>

namespace ramure {
namespace {

/// Of ways of different lengths the ends belong together.
void add(ArmResiduals& all, double now, std::span<const float> way)
{
    all.now = std::max(all.now, now);
    if (all.way.size() < way.size())
        all.way.insert(all.way.begin(), way.size() - all.way.size(), 0.0);
    const std::size_t first = all.way.size() - way.size();
    for (std::size_t i = 0; i < way.size(); ++i)
        all.way[first + i] = std::max(all.way[first + i], double(way[i]));
}

} // namespace

std::optional<ArmResiduals> armResiduals(const Scene& scene, const Player& player, const ArmReach* reach)
{
    const std::shared_ptr<const MotionFrame> motion = player.motion();
    std::optional<ArmResiduals> all;
    for (const Node& node : scene.nodes()) {
        if (node.kind != NodeKind::Arm || !node.params.arm.follows || !scene.isShown(node.id))
            continue;
        if (!all)
            all.emplace();
        const NodeMotion* moving = motion->of(node.id);
        const ArmProgress* shown = reach ? reach->shown(node.id) : nullptr;
        if (!shown && moving)
            shown = moving->arm.get();
        if (shown)
            add(*all, shown->residual, shown->residuals);
        else
            add(*all, glm::distance(ArmChain(node.params.joints).tip(), node.params.arm.target), {});
    }
    return all;
}

} // namespace ramure
