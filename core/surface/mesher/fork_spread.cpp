#include "core/surface/mesher/fork_spread.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace ramure {

namespace {

constexpr double leastSpread = 1e-3; ///< of the radius: less is not seen

} // namespace

void spreadAboveForks(NormalSkeleton& skeleton, double length)
{
    if (!(length > 0.0))
        return;
    for (Index parent = 0; parent < skeleton.branches.size(); ++parent) { // parents come first
        if (skeleton.branches[parent].isPlate)
            continue;
        double thickest = 0.0;
        for (const Index child : skeleton.childrenOf(parent))
            thickest = std::max(thickest, skeleton.branches[child].a0);
        if (!(thickest > 0.0))
            continue;
        const double spread = std::min(skeleton.branches[parent].radiusAt(1.0) / thickest - 1.0, mostSpread);
        if (spread < leastSpread)
            continue;
        for (const Index child : skeleton.childrenOf(parent)) {
            MeshBranch& branch = skeleton.branches[child];
            if (branch.isLimb)
                continue;
            branch.spread = spread;
            branch.spreadDecay = glm::length(branch.p1 - branch.p0) / (length * branch.a0 * (2.0 + spread));
        }
    }
}

} // namespace ramure
