#include "core/game_wind/wind_elements.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ramure {
namespace {

/// As the engine has it.
glm::vec3 turned(const glm::dvec3& v)
{
    return {v.x, v.z, v.y};
}

void setReach(WindElement& element, const glm::dvec3& tip)
{
    const glm::dvec3 way = tip - element.pivot;
    const double length = glm::length(way);
    if (length > 0.0)
        element.axis = way / length;
    element.extent = std::max(leastExtent, length);
}

std::size_t stemsUpTo(const WindTree& tree, Index order)
{
    return static_cast<std::size_t>(
        std::ranges::count_if(tree.stems, [=](const WindStem& stem) { return stem.order <= order; }));
}

} // namespace

std::vector<WindLeaf> windLeaves(const TriangleMesh& mesh, std::span<const FoliageItem> items)
{
    std::vector<WindLeaf> out(items.size());
    const std::size_t each = items.empty() ? 0 : mesh.positions.size() / items.size();
    for (std::size_t i = 0; i < items.size(); ++i) {
        out[i] = {items[i].branch, items[i].position, items[i].position};
        double farthest = 0.0;
        for (std::size_t v = i * each; v < (i + 1) * each; ++v) {
            const glm::dvec3 place(mesh.positions[v]);
            if (const double reach = glm::distance(place, out[i].foot); reach > farthest) {
                farthest = reach;
                out[i].tip = place;
            }
        }
    }
    return out;
}

Expected<WindElements> windElements(const WindTree& tree, std::span<const WindLeaf> leaves)
{
    WindElements out;
    Index deepest = mostElementDepth - (leaves.empty() ? 1 : 2);
    if (stemsUpTo(tree, deepest) + leaves.size() > mostElements) {
        out.leavesGoAlong = !leaves.empty();
        deepest = mostElementDepth - 1;
        while (deepest > 0 && stemsUpTo(tree, deepest) > mostElements)
            --deepest;
        if (stemsUpTo(tree, deepest) > mostElements)
            return fail(ErrorCode::Limit, RAMURE_NOOP("Pivot Painter has room for %1 trunks"),
                        {std::to_string(mostElements)});
    }
    for (const WindStem& stem : tree.stems) {
        if (stem.order > deepest) {
            out.ofStem.push_back(out.ofStem[stem.parent]);
            continue;
        }
        const auto number = static_cast<Index>(out.elements.size());
        WindElement element{stem.parent == noIndex ? number : out.ofStem[stem.parent], stem.order, stem.foot};
        // A trunk turns as if it were upright: the level ring of its foot stays where it is.
        const bool isTrunk = stem.parent == noIndex && stem.tip.y > stem.foot.y;
        setReach(element, isTrunk ? glm::dvec3(stem.foot.x, stem.tip.y, stem.foot.z) : stem.tip);
        out.ofStem.push_back(number);
        out.elements.push_back(element);
    }
    for (const WindLeaf& leaf : leaves) {
        const Index stem = out.ofStem[tree.stemOf[leaf.branch]];
        out.ofLeaf.push_back(out.leavesGoAlong ? stem : static_cast<Index>(out.elements.size()));
        if (out.leavesGoAlong)
            continue;
        WindElement element{stem, out.elements[stem].depth + 1, leaf.foot};
        setReach(element, leaf.tip);
        out.elements.push_back(element);
    }
    return out;
}

float packedIndex(Index index)
{
    const Index bits = index + 1024, exponent = bits >> 10U, mantissa = bits & 1023U;
    return std::ldexp(static_cast<float>(1024U + mantissa), static_cast<int>(exponent) - 25);
}

PivotTextures pivotTextures(const WindElements& from)
{
    PivotTextures out;
    while (std::size_t(out.width) * out.height < from.elements.size())
        (out.width <= out.height ? out.width : out.height) *= 2;
    out.pivots.resize(std::size_t(out.width) * out.height, glm::vec4(0.0F));
    out.axes = out.pivots;
    constexpr float centimetres = 100.0F, rangeOfExtent = 2048.0F;
    for (std::size_t i = 0; i < from.elements.size(); ++i) {
        const WindElement& element = from.elements[i];
        out.pivots[i] = glm::vec4(centimetres * turned(element.pivot), packedIndex(element.parent));
        out.axes[i] = glm::vec4(0.5F + 0.5F * turned(element.axis),
                                centimetres * static_cast<float>(element.extent) / rangeOfExtent);
    }
    return out;
}

} // namespace ramure
