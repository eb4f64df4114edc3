#include "core/surface/mesher/fork_spread.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace ramure {

namespace {

constexpr double leastSpread = 1e-3; ///< of the radius: less is not seen
constexpr double latestCollar = 0.7; ///< of the limb: where it leaves the stem
constexpr double collarRoom = 0.8;   ///< of the stem's radius: no collar is wider

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

void makeCollars(NormalSkeleton& skeleton, double collar)
{
    if (!(collar > 0.0))
        return;
    for (Index parent = 0; parent < skeleton.branches.size(); ++parent) {
        const std::span<const Index> children = skeleton.childrenOf(parent);
        if (children.size() < 2)
            continue;
        const MeshBranch& stem = skeleton.branches[*std::ranges::max_element(
            children, {}, [&](Index child) { return skeleton.branches[child].a0; })];
        const glm::dvec3 up = glm::normalize(stem.p1 - stem.p0);
        for (const Index child : children) {
            MeshBranch& limb = skeleton.branches[child];
            if (!limb.isLimb)
                continue;
            const glm::dvec3 way = limb.p1 - limb.p0;
            const double length = glm::length(way), aside = glm::length(way - glm::dot(way, up) * up);
            const double start = stem.a0 / std::max(aside, 1e-12);
            const double spread = std::min(collar, collarRoom * stem.a0 / limb.a0 - 1.0);
            if (start > latestCollar || spread < leastSpread)
                continue;
            limb.spread = spread;
            limb.spreadStart = start;
            limb.spreadDecay = length / (collarLength * 2.0 * limb.a0);
        }
    }
}

} // namespace ramure
