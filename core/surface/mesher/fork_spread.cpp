#include "core/surface/mesher/fork_spread.h"

#include "core/surface/mesher/stem_limbs.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ramure {

namespace {

constexpr double leastSpread = 1e-3;      ///< of the radius: less is not seen
constexpr double latestCollar = 0.7;      ///< of the limb: where it leaves the stem
constexpr double collarRoom = 0.8;        ///< of the stem's radius: no collar is wider
constexpr double collarRoomBeside = 0.65; ///< of what limbs need around a stem: nearer ones have no collar
constexpr double mostSwelling = 0.17; ///< of the stem's section: what collars beside each other add together

/// Limbs that leave a stem in one place share the wood of their collars: so much of each is left.
double collarShare(const NormalSkeleton& skeleton, std::span<const Index> children, double stem)
{
    double linear = 0.0, square = 0.0; // of what they add to their own sections
    for (const Index child : children) {
        const MeshBranch& limb = skeleton.branches[child];
        if (!(limb.spreadStart > 0.0))
            continue;
        linear += limb.spread * limb.a0 * limb.a0;
        square += limb.spread * limb.spread * limb.a0 * limb.a0;
    }
    const double most = mostSwelling * stem * stem;
    return square + 2.0 * linear > most ? (std::sqrt(linear * linear + square * most) - linear) / square
                                        : 1.0;
}

/// Have limbs room for collars beside each other?
bool standAround(const NormalSkeleton& skeleton, std::span<const Index> children, Index stem)
{
    std::vector<StemLimb> all;
    for (const Index child : children) {
        const MeshBranch& own = skeleton.branches[child];
        const glm::dvec3 way = own.p1 - own.p0;
        const double length = glm::length(way);
        if (own.isLimb || child == stem)
            all.push_back({way / std::max(length, 1e-12), length, own.a0, own.childCount > 0});
    }
    return standAroundStem(all, collarRoomBeside);
}

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
        const Index thickest =
            *std::ranges::max_element(children, {}, [&](Index child) { return skeleton.branches[child].a0; });
        const MeshBranch& stem = skeleton.branches[thickest];
        const glm::dvec3 up = glm::normalize(stem.p1 - stem.p0);
        if (!standAround(skeleton, children, thickest))
            continue;
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
        const double share = collarShare(skeleton, children, stem.a0);
        for (const Index child : children)
            if (skeleton.branches[child].spreadStart > 0.0)
                skeleton.branches[child].spread *= share;
    }
}

} // namespace ramure
