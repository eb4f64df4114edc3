#include "core/surface/foliage/organ_placement.h"

#include "core/math/frame.h"
#include "core/surface/foliage/leaf_placement.h"
#include "core/surface/foliage/leaf_table.h"
#include "core/surface/foliage/twig_line.h"
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

/// On the bark as those that grow by themselves: leaves look to the light, fruit hang, flowers look outwards.
Stand naturalStand(const Skeleton& skeleton, const Organ& organ, bool hung)
{
    const TwigLine line(skeleton, organ.branch);
    const TwigLine::Place place = line.at(organ.share * line.length());
    const glm::dvec3& tangent = place.frame.tangent;
    const glm::dvec3 drawn =
        turned(organ.up, frameFromTangent(organ.axis), transported(frameFromTangent(organ.axis), tangent));
    const glm::dvec3 side = across(drawn, tangent, place.frame.normal);
    Stand stand{place.centre + 0.95 * place.radius * side, {}, {}};
    if (organ.kind == OrganKind::Leaf) {
        stand.heading = glm::normalize(side + 0.7 * tangent);
        stand.up = across(0.5 * sky + 0.5 * tangent, stand.heading, glm::cross(side, tangent));
        return stand;
    }
    stand.heading = glm::normalize(hung ? 0.35 * side - sky : side + 0.5 * sky + 0.4 * tangent);
    stand.up = across(tangent, stand.heading, across(side, stand.heading, sky));
    return stand;
}

Stand standOf(const Skeleton& skeleton, const Organ& organ, bool hung)
{
    if (organ.heading == glm::dvec3(0.0))
        return naturalStand(skeleton, organ, hung);
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
    const double length = leafLength(foliage.form, alpha);
    const double radius = fruitRadius(foliage.fruit, alpha), reach = radius * fruitReach(foliage.fruit);
    std::uint32_t number = 1u << 20; // after all that grow by themselves
    for (const Organ& organ : skeleton.organs) {
        if (isMark(organ.kind))
            continue;
        const bool isLeaf = organ.kind == OrganKind::Leaf;
        const double usual = isLeaf ? length : 2.0 * radius;
        const double size = organ.size < 0.0 ? -organ.size * (isLeaf && !faithful ? leaf.size : 1.0)
                                             : (usual > 0.0 ? organ.size / usual : 0.0);
        if (!(size > 0.0))
            continue;
        const Stand stand =
            standOf(skeleton, organ, foliage.fruit.kind == FruitKind::Faithful || hangs(foliage.fruit.kind));
        // A sphere without a stalk lies on the bark that a hand has put it on.
        const bool lies = organ.heading == glm::dvec3(0.0) && reach == 0.0;
        FoliageItem item = isLeaf ? leafAt(stand, size) : fruitAt(stand, size, lies ? radius : reach);
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
