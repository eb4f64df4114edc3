#include "core/surface/foliage/organ_placement.h"

#include "core/math/frame.h"
#include "core/surface/foliage/leaf_placement.h"
#include "core/surface/foliage/leaf_table.h"
#include <algorithm>
#include <glm/common.hpp>
#include <glm/gtc/quaternion.hpp>

namespace ramure {
namespace {

/// An organ where its branch is now, and whatever else it may carry.
struct Stand
{
    glm::dvec3 foot, heading, up;
};

/// \p v taken along as one frame turns into the other.
glm::dvec3 turned(const glm::dvec3& v, const Frame& from, const Frame& to)
{
    return glm::dot(v, from.tangent) * to.tangent + glm::dot(v, from.normal) * to.normal +
           glm::dot(v, from.binormal) * to.binormal;
}

Stand standOf(const Skeleton& skeleton, const Organ& organ)
{
    const Index b = organ.branch;
    const glm::dvec3 way = skeleton.p1[b] - skeleton.p0[b];
    const double length = glm::length(way);
    const Frame drawn = frameFromTangent(organ.axis);
    const Frame now = length > 0.0 ? transported(drawn, way / length) : drawn;
    Stand stand{glm::mix(skeleton.p0[b], skeleton.p1[b], organ.share) + turned(organ.offset, drawn, now),
                turned(organ.heading, drawn, now), turned(organ.up, drawn, now)};
    // Out of the wood, on the side to which it points.
    const glm::dvec3 aside = stand.heading - glm::dot(stand.heading, now.tangent) * now.tangent;
    if (glm::length(aside) > 1e-3)
        stand.foot += glm::mix(skeleton.a0[b], skeleton.a1[b], organ.share) * glm::normalize(aside);
    return stand;
}

FoliageItem leafAt(const Stand& stand, double size)
{
    FoliageItem item;
    item.position = stand.foot;
    item.orientation = glm::normalize(
        glm::quat_cast(glm::dmat3(glm::cross(stand.heading, stand.up), stand.heading, stand.up)));
    item.size = static_cast<float>(size);
    return item;
}

/// \param reach from the middle of the fruit to the foot of its stalk, for a size of 1.
FoliageItem fruitAt(const Stand& stand, double size, double reach)
{
    FoliageItem item;
    item.position = stand.foot + size * reach * stand.heading;
    item.orientation = glm::normalize(
        glm::quat_cast(glm::dmat3(glm::cross(stand.up, stand.heading), -stand.heading, stand.up)));
    item.size = static_cast<float>(size);
    return item;
}

} // namespace

Expected<void> placeOrgans(const Skeleton& skeleton, const LeafParams& leaf, double alpha, Foliage& foliage)
{
    const bool faithful = foliage.form.shape == LeafShape::Faithful;
    const double leafLength = alpha * (faithful ? 1.0 : leafRow(foliage.form.shape).length);
    const double radius = alpha * fruitRadius(foliage.fruit), reach = radius * fruitReach(foliage.fruit);
    std::uint32_t number = 1u << 20; // after all that grow by themselves
    for (const Organ& organ : skeleton.organs) {
        const bool isLeaf = organ.kind == OrganKind::Leaf;
        const double usual = isLeaf ? leafLength : 2.0 * radius;
        const double size = organ.size < 0.0 ? (isLeaf && !faithful ? leaf.size : 1.0)
                                             : (usual > 0.0 ? organ.size / usual : 0.0);
        if (!(size > 0.0))
            continue;
        const Stand stand = standOf(skeleton, organ);
        FoliageItem item = isLeaf ? leafAt(stand, size) : fruitAt(stand, size, reach);
        item.branch = organ.branch;
        item.number = number++;
        (isLeaf ? foliage.leaves : foliage.apples).push_back(item);
    }
    if (foliage.leaves.size() > maxLeaves)
        return tooMuchFoliage(RAMURE_NOOP("the tree would carry more than %1 leaves"), maxLeaves,
                              "grammar.iterations");
    if (foliage.apples.size() > maxApples)
        return tooMuchFoliage(RAMURE_NOOP("the tree would carry more than %1 apples"), maxApples,
                              "grammar.iterations");
    return {};
}

} // namespace ramure
