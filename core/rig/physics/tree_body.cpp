#include "core/rig/physics/tree_body.h"

#include "core/math/stage_hash.h"
#include "core/rig/physics/limb_fall.h"
#include <algorithm>
#include <numeric>

namespace ramure {
namespace {

/// Branches by depth, stable: parents stand before children, neighbours stay neighbours.
void sortByDepth(const Skeleton& skeleton, TreeBody& body)
{
    const Index count = skeleton.size();
    std::vector<Index> depth(count, 0);
    Index deepest = 0;
    for (Index i = 0; i < count; ++i) {
        if (skeleton.parent[i] != noIndex)
            depth[i] = depth[skeleton.parent[i]] + 1;
        deepest = std::max(deepest, depth[i]);
    }
    body.depthEnd.assign(count == 0 ? 0 : deepest + 1, 0);
    for (const Index d : depth)
        ++body.depthEnd[d];
    std::partial_sum(body.depthEnd.begin(), body.depthEnd.end(), body.depthEnd.begin());
    std::vector<Index> next(body.depthEnd.size(), 0);
    for (std::size_t d = 1; d < next.size(); ++d)
        next[d] = body.depthEnd[d - 1];
    body.branchOf.resize(count);
    body.slotOf.resize(count);
    for (Index i = 0; i < count; ++i) {
        body.slotOf[i] = next[depth[i]]++;
        body.branchOf[body.slotOf[i]] = i;
    }
}

void takeBranches(const Skeleton& skeleton, TreeBody& body)
{
    for (const Index branch : body.branchOf) {
        const Index above = skeleton.parent[branch];
        body.parent.push_back(above == noIndex ? noIndex : body.slotOf[above]);
        body.p0.push_back(skeleton.p0[branch]);
        body.p1.push_back(skeleton.p1[branch]);
        const double length = skeleton.length(branch);
        const glm::dvec3 way = skeleton.p1[branch] - skeleton.p0[branch];
        const glm::dvec3 direction = length > 0.0 ? way / length : glm::dvec3(0.0, 1.0, 0.0);
        body.dirX.push_back(direction.x);
        body.dirY.push_back(direction.y);
        body.dirZ.push_back(direction.z);
        body.length.push_back(length);
        body.a0.push_back(skeleton.a0[branch]);
        body.a1.push_back(skeleton.a1[branch]);
    }
    body.reach = body.length;
    std::vector<double> above(body.size(), 0.0); // the farthest of the children
    for (Index slot = body.size(); slot-- > 0;) {
        body.reach[slot] += above[slot];
        if (const Index parent = body.parent[slot]; parent != noIndex)
            above[parent] = std::max(above[parent], body.reach[slot]);
    }
}

void takeApples(const Foliage& foliage, TreeBody& body)
{
    for (const FoliageItem& apple : foliage.apples) {
        body.appleSlot.push_back(body.slotOf[apple.branch]);
        body.applePosition.push_back(apple.position);
        body.appleOrientation.push_back(apple.orientation);
    }
}

Index firstTerminal(const Skeleton& skeleton)
{
    std::vector<char> carries(skeleton.size(), 0);
    for (const Index parent : skeleton.parent)
        if (parent != noIndex)
            carries[parent] = 1;
    return static_cast<Index>(std::ranges::find(carries, 0) - carries.begin());
}

std::uint64_t keyOf(const TreeBody& body)
{
    StageHash hash(0x7452656542F64791ull);
    const auto addPoint = [&](const glm::dvec3& p) { hash.add(p.x).add(p.y).add(p.z); };
    hash.add(body.size());
    for (Index slot = 0; slot < body.size(); ++slot) {
        hash.add(body.branchOf[slot]).add(body.parent[slot]).add(body.a0[slot]).add(body.a1[slot]);
        addPoint(body.p0[slot]);
        addPoint(body.p1[slot]);
    }
    for (const LooseBody& limb : body.limbs)
        hash.add(limb.root).add(limb.stump).add(limb.seconds);
    hash.add(body.appleSlot.size()).add(body.appleRadius);
    for (std::size_t i = 0; i < body.appleSlot.size(); ++i) {
        hash.add(body.appleSlot[i]);
        addPoint(body.applePosition[i]);
    }
    return hash.value();
}

} // namespace

std::shared_ptr<const TreeBody> makeTreeBody(const Skeleton& skeleton, const Foliage* foliage, double alpha)
{
    auto body = std::make_shared<TreeBody>();
    sortByDepth(skeleton, *body);
    takeBranches(skeleton, *body);
    takeLimbs(skeleton.loose, *body);
    if (foliage)
        takeApples(*foliage, *body);
    body->appleRadius = fruitRadius(foliage ? foliage->fruit : FruitForm(), alpha);
    if (!skeleton.empty())
        body->firstTerminal = body->slotOf[firstTerminal(skeleton)];
    body->key = keyOf(*body);
    return body;
}

} // namespace ramure
