#include "core/game_wind/wind_tree.h"

#include "core/math/random.h"
#include "core/skeleton/axes.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace ramure {
namespace {

/// From the address, whatever grows elsewhere.
double phaseOf(std::uint64_t address)
{
    return double(Random(address, RandomStream::Wind).below(phaseSteps)) / phaseSteps;
}

/// 0 to 1, of the nearest place on a branch.
double shareAlong(const glm::dvec3& p0, const glm::dvec3& p1, const glm::dvec3& place)
{
    const glm::dvec3 way = p1 - p0;
    const double squared = glm::dot(way, way);
    return squared > 0.0 ? std::clamp(glm::dot(place - p0, way) / squared, 0.0, 1.0) : 0.0;
}

double swayOn(const WindStem& stem, double along)
{
    return stem.footSway +
           (stem.order > 0 && stem.length > 0.0 ? branchSway * along * along / stem.length : 0.0);
}

/// The stems themselves; a branch goes on with its parent's where both are of one axis.
void findStems(const Skeleton& grown, const SimplifiedSkeleton& simplified, WindTree& out)
{
    const TreeAxes axes = axesOf(grown);
    const Skeleton& tree = simplified.skeleton;
    std::vector<Index> axisOf(tree.size(), noIndex);
    for (Index i = 0; i < grown.size(); ++i)
        if (Index& axis = axisOf[simplified.mergedInto[i]]; axis == noIndex)
            axis = axes.axisOf[i];
    for (Index b = 0; b < tree.size(); ++b) {
        const Index parent = tree.parent[b];
        const bool goesOn = parent != noIndex && axisOf[parent] == axisOf[b];
        out.start[b] = goesOn ? out.start[parent] + tree.length(parent) : 0.0;
        out.stemOf[b] = goesOn ? out.stemOf[parent] : static_cast<Index>(out.stems.size());
        if (!goesOn) {
            WindStem stem;
            stem.parent = parent == noIndex ? noIndex : out.stemOf[parent];
            stem.order = parent == noIndex ? 0 : out.stems[stem.parent].order + 1;
            stem.address = axes.axes[axisOf[b]].address;
            stem.foot = tree.p0[b];
            out.stems.push_back(stem);
        }
        WindStem& stem = out.stems[out.stemOf[b]];
        const double end = out.start[b] + tree.length(b);
        if (end >= stem.length) {
            stem.length = end;
            stem.tip = tree.p1[b];
        }
    }
}

} // namespace

double WindTree::sway(Index branch, const glm::dvec3& place) const
{
    const double share = shareAlong(p0[branch], p1[branch], place);
    return swayOn(stems[stemOf[branch]], start[branch] + share * glm::distance(p0[branch], p1[branch]));
}

double WindTree::lean(double y) const
{
    const double up = std::max(0.0, y - base);
    return height > 0.0 ? trunkSway * up * up / height : 0.0;
}

WindTree windTree(const Skeleton& grown, const SimplifiedSkeleton& simplified)
{
    const Skeleton& tree = simplified.skeleton;
    WindTree out;
    out.stemOf.resize(tree.size());
    out.start.resize(tree.size());
    out.p0 = tree.p0;
    out.p1 = tree.p1;
    findStems(grown, simplified, out);
    // The length of a stem is known by now, and with it how far its children's feet sway.
    std::vector<bool> isDone(out.stems.size(), false);
    for (Index b = 0; b < tree.size(); ++b) {
        const Index at = out.stemOf[b], parent = tree.parent[b];
        if (isDone[at])
            continue;
        isDone[at] = true;
        WindStem& stem = out.stems[at];
        if (parent == noIndex)
            continue;
        stem.footSway = out.sway(parent, tree.p1[parent]);
        stem.phase = stem.order == 1 ? phaseOf(stem.address) : out.stems[stem.parent].phase;
    }
    bool isFirst = true;
    double top = 0.0;
    for (Index b = 0; b < tree.size(); ++b) {
        if (tree.parent[b] == noIndex)
            out.base = isFirst ? tree.p0[b].y : std::min(out.base, tree.p0[b].y);
        top = isFirst ? tree.p1[b].y : std::max(top, tree.p1[b].y);
        isFirst = false;
    }
    out.height = std::max(0.0, top - out.base);
    return out;
}

std::vector<WindVertex> windOfBark(const WindTree& tree, const TriangleMesh& mesh)
{
    std::vector<WindVertex> out(mesh.positions.size());
    for (std::size_t v = 0; v < out.size(); ++v) {
        const glm::dvec3 place(mesh.positions[v]);
        const Index branch = mesh.branch[v];
        out[v].phase = static_cast<float>(tree.stems[tree.stemOf[branch]].phase);
        out[v].lean = static_cast<float>(tree.lean(place.y));
        out[v].sway = static_cast<float>(tree.sway(branch, place));
    }
    return out;
}

std::vector<WindVertex> windOfItems(const WindTree& tree, const TriangleMesh& mesh,
                                    std::span<const FoliageItem> items, bool flutters)
{
    std::vector<WindVertex> out(mesh.positions.size());
    const std::size_t each = out.size() / items.size();
    for (std::size_t i = 0; i < items.size(); ++i) {
        const FoliageItem& item = items[i];
        WindVertex whole;
        whole.phase = static_cast<float>(tree.stems[tree.stemOf[item.branch]].phase);
        whole.sway = static_cast<float>(tree.sway(item.branch, item.position));
        double size = 0.0;
        const auto reach = [&](std::size_t v) {
            return glm::distance(glm::dvec3(mesh.positions[v]), item.position);
        };
        for (std::size_t v = i * each; v < (i + 1) * each; ++v)
            size = std::max(size, reach(v));
        for (std::size_t v = i * each; v < (i + 1) * each; ++v) {
            out[v] = whole;
            out[v].lean = static_cast<float>(tree.lean(mesh.positions[v].y));
            // Towards the tip and the edges, and not where the petiole holds.
            out[v].flutter = flutters ? static_cast<float>(leafFlutter * reach(v)) : 0.0F;
        }
    }
    return out;
}

} // namespace ramure
