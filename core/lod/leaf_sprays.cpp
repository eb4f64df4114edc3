#include "core/lod/leaf_sprays.h"

#include "core/math/box.h"
#include "core/params/param_def.h"
#include "core/surface/foliage/leaf_table.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numeric>
#include <string>

namespace ramure {
namespace {

/// Of a twig's half sides: what is left free around it, so that pictures do not run into each other.
constexpr double freeRim = 0.03;
/// By so much at most all sprays grow or shrink together, so that they show as much leaf as the tree has.
constexpr double mostGrowth = 1.35;

double traceOf(const glm::dmat3& m)
{
    return m[0][0] + m[1][1] + m[2][2];
}

glm::vec3 toneOf(const FoliageItem& leaf)
{
    return leaf.tone * leaf.tint;
}

/// By the area of the leaves.
glm::vec3 meanTone(std::span<const FoliageItem> leaves, const LeafCluster& cluster)
{
    glm::dvec3 sum(0.0);
    double area = 0.0;
    for (const Index m : cluster.members) {
        const double own = double(leaves[m].size) * double(leaves[m].size);
        sum += own * glm::dvec3(toneOf(leaves[m]));
        area += own;
    }
    return area > 0.0 ? glm::vec3(sum / area) : glm::vec3(1.0F);
}

/// The frames of sprays: turned as leafOfCluster() turns them, as large as their clusters are spread. Where
/// few leaves are spread far, or many not, they are nearer to the usual size for so much leaf.
std::vector<FoliageItem> framesOf(std::span<const FoliageItem> leaves, std::span<const LeafCluster> clusters,
                                  const LeafShapeOfLevel& whole)
{
    constexpr double smallest = 0.75, largest = 1.4; // of the usual
    std::vector<FoliageItem> out;
    std::vector<double> wide, ratios;
    std::vector<LeafSpread> spreads;
    for (const LeafCluster& cluster : clusters) {
        out.push_back(leafOfCluster(leaves, cluster, whole, whole, glm::dvec3(0.0)));
        spreads.push_back(spreadOf(leaves, cluster, whole));
        wide.push_back(std::sqrt(traceOf(spreads.back().spread) / std::max(traceOf(whole.spread), 1e-300)));
        ratios.push_back(wide.back() / std::sqrt(std::max(spreads.back().squares, 1e-300)));
    }
    std::vector<double> order = ratios;
    const auto middle = order.begin() + std::ptrdiff_t(order.size() / 2);
    std::ranges::nth_element(order, middle);
    for (std::size_t c = 0; c < clusters.size(); ++c) {
        const double usual = *middle * std::sqrt(spreads[c].squares);
        const double size = std::clamp(wide[c], smallest * usual, largest * usual);
        out[c].size = static_cast<float>(size);
        out[c].position = spreads[c].middle - glm::mat3_cast(out[c].orientation) * (size * whole.middle);
    }
    return out;
}

/// The leaves of a cluster in the space of its spray. \param brightest their tones are relative to it.
std::vector<FoliageItem> leavesOf(std::span<const FoliageItem> leaves, const LeafCluster& cluster,
                                  const FoliageItem& spray, const glm::vec3& brightest)
{
    std::vector<FoliageItem> out;
    const glm::dquat back = glm::conjugate(spray.orientation);
    const double scale = 1.0 / double(spray.size);
    for (const Index m : cluster.members) {
        FoliageItem item = leaves[m];
        item.position = scale * (back * (item.position - spray.position));
        item.orientation = back * item.orientation;
        item.size *= static_cast<float>(scale);
        item.tint = glm::min(toneOf(item) / brightest, 1.0F);
        item.tone = 1.0F;
        out.push_back(item);
    }
    return out;
}

Box boxOf(const ShownSurface& twig)
{
    Box box;
    for (const FoliageItem& item : twig.copies)
        for (const glm::vec3& at : twig.mesh->positions)
            box.add(item.position + item.orientation * (double(item.size) * glm::dvec3(at)));
    return box;
}

/// The first lies across Z and has the left half of the twig's cell, the second lies across X.
void addCards(CardAtlas& atlas, std::size_t twig, std::size_t count)
{
    std::size_t across = 1;
    while (across * across < count)
        ++across;
    const Box box = boxOf(atlas.surfaces[twig]);
    const glm::dvec3 half = glm::max(0.5 * (1.0 + freeRim) * box.size(), glm::dvec3(1e-9));
    const double cell = 1.0 / double(across), gutter = 0.5 * cardGutter / 1024.0;
    const std::size_t row = twig / across;
    for (const bool isSide : {false, true}) {
        ShownCard card{twig, twig + 1, {}, box.centre(), {isSide ? half.z : half.x, half.y}};
        if (isSide)
            card.frame = {{0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}, {-1.0, 0.0, 0.0}};
        const glm::dvec2 corner(cell * (double(twig % across) + (isSide ? 0.5 : 0.0)), cell * double(row));
        card.low = corner + gutter;
        card.high = corner + glm::dvec2(0.5 * cell, cell) - gutter;
        atlas.cards.push_back(card);
    }
}

/// Clusters whose leaves are spread as those of most are: the middle ones, by their extent for their area.
std::vector<std::size_t> typicalOf(std::span<const FoliageItem> leaves, std::span<const LeafCluster> clusters,
                                   std::span<const FoliageItem> sprays)
{
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t c = 0; c < clusters.size(); ++c) {
        double squares = 0.0;
        for (const Index m : clusters[c].members)
            squares += double(leaves[m].size) * double(leaves[m].size);
        order.emplace_back(squares / std::max(double(sprays[c].size) * double(sprays[c].size), 1e-300), c);
    }
    std::ranges::sort(order);
    std::vector<std::size_t> out;
    for (std::size_t k = 0; k < sharedTwigs; ++k)
        out.push_back(
            order[static_cast<std::size_t>((0.42 + 0.06 * double(k)) * double(order.size()))].second);
    return out;
}

} // namespace

LeafSprays leafSprays(const Foliage& foliage, std::span<const LeafCluster> clusters,
                      const LeafShapeOfLevel& whole)
{
    LeafSprays out;
    const std::span<const FoliageItem> leaves = foliage.leaves;
    out.items = framesOf(leaves, clusters, whole);
    const bool isOwn = clusters.size() <= mostOwnTwigs;
    std::vector<std::size_t> shownOf(clusters.size());
    std::iota(shownOf.begin(), shownOf.end(), std::size_t(0));
    if (!isOwn)
        shownOf = typicalOf(leaves, clusters, out.items);
    auto atlas = std::make_shared<CardAtlas>();
    const LeafForm& form = foliage.form;
    atlas->name = std::string("sprays_") + findParam("foliage.leaf")->items[std::size_t(form.shape)].name;
    // On a day of the year tints are whole colours.
    const glm::u8vec3 colour = form.onDay ? glm::u8vec3(255) : leafColour(form.shape, form.turns);
    const auto leaf = std::make_shared<const TriangleMesh>(whole.mesh);
    std::vector<double> shown; // m² of leaf on a card of size 1
    std::vector<glm::vec3> brightest;
    for (const std::size_t c : shownOf) {
        const FoliageItem& spray = out.items[c];
        glm::vec3 most(isOwn ? 1.0F : 1e-3F);
        double squares = 0.0;
        for (const Index m : clusters[c].members) {
            most = glm::max(most, toneOf(leaves[m]));
            squares += double(leaves[m].size) * double(leaves[m].size);
        }
        brightest.push_back(most / glm::max(meanTone(leaves, clusters[c]), glm::vec3(1e-3F)));
        shown.push_back(whole.area * squares / (double(spray.size) * double(spray.size)));
        atlas->surfaces.push_back({leaf, leavesOf(leaves, clusters[c], spray, most), form, {}, colour});
        addCards(*atlas, atlas->surfaces.size() - 1, shownOf.size());
    }
    atlas->hash = hashOf(*atlas);
    double all = 0.0, showing = 0.0;
    for (std::size_t c = 0; c < clusters.size(); ++c) {
        const auto twig = static_cast<std::uint16_t>(isOwn ? c : (clusters[c].leaf * 2654435761U) >> 30U);
        out.twig.push_back(twig);
        showing += shown[twig] * double(out.items[c].size) * double(out.items[c].size);
        for (const Index m : clusters[c].members)
            all += whole.area * double(leaves[m].size) * double(leaves[m].size);
    }
    const double growth =
        isOwn ? 1.0 : std::clamp(std::sqrt(all / std::max(showing, 1e-300)), 1.0 / mostGrowth, mostGrowth);
    out.area = showing * growth * growth;
    for (std::size_t c = 0; c < clusters.size(); ++c) {
        FoliageItem& own = out.items[c];
        const glm::dvec3 middle = own.position + own.orientation * (double(own.size) * whole.middle);
        own.size *= static_cast<float>(growth);
        own.position = middle - own.orientation * (double(own.size) * whole.middle);
        own.tone = 1.0F;
        own.tint =
            isOwn ? glm::vec3(1.0F) : glm::min(brightest[out.twig[c]] * meanTone(leaves, clusters[c]), 1.0F);
    }
    out.atlas = std::move(atlas);
    return out;
}

TriangleMesh buildSprays(const Skeleton& skeleton, const LeafSprays& sprays)
{
    TriangleMesh out;
    for (std::size_t i = 0; i < sprays.items.size(); ++i) {
        const FoliageItem& item = sprays.items[i];
        const glm::mat3 turn(glm::mat3_cast(item.orientation));
        const glm::vec3 place(item.position);
        for (const std::size_t side : {std::size_t(0), std::size_t(1)}) {
            const TriangleMesh card = meshOf(sprays.atlas->cards[2 * std::size_t(sprays.twig[i]) + side]);
            const auto first = out.vertexCount();
            for (std::size_t v = 0; v < card.positions.size(); ++v) {
                out.positions.push_back(place + turn * (item.size * card.positions[v]));
                out.normals.push_back(turn * card.normals[v]);
                out.uv.push_back(card.uv[v]);
                out.branch.push_back(item.branch);
                out.level.push_back(skeleton.level[item.branch]);
            }
            for (const glm::uvec3& face : card.triangles) {
                out.triangles.push_back(face + first);
                out.colours.emplace_back(item.tint * 255.0F + 0.5F);
            }
        }
    }
    return out;
}

} // namespace ramure
