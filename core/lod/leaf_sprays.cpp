#include "core/lod/leaf_sprays.h"

#include "core/math/box.h"
#include "core/math/stage_hash.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/quaternion.hpp>

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

/// The leaves of a cluster in the space of its spray. Their tones are relative to their brightest.
TriangleMesh twigOf(std::span<const FoliageItem> leaves, const LeafCluster& cluster, const FoliageItem& spray,
                    const TriangleMesh& leaf, const glm::vec3& brightest)
{
    TriangleMesh out;
    const glm::dquat back = glm::conjugate(spray.orientation);
    const double scale = 1.0 / double(spray.size);
    const auto take = [&](const FoliageItem& item) {
        const glm::dvec3 at = scale * (back * (item.position - spray.position));
        const glm::dquat turn = back * item.orientation;
        const auto first = out.vertexCount();
        for (std::size_t v = 0; v < leaf.positions.size(); ++v) {
            out.positions.emplace_back(at +
                                       turn * (scale * double(item.size) * glm::dvec3(leaf.positions[v])));
            out.normals.emplace_back(turn * glm::dvec3(leaf.normals[v]));
            out.uv.push_back(leaf.uv[v]);
        }
        const glm::vec3 tone = glm::min(toneOf(item) / brightest, 1.0F);
        for (std::size_t f = 0; f < leaf.triangles.size(); ++f) {
            out.triangles.push_back(leaf.triangles[f] + first);
            const glm::vec3 own = leaf.colours.empty() ? glm::vec3(255.0F) : glm::vec3(leaf.colours[f]);
            out.colours.emplace_back(tone * own + 0.5F);
        }
    };
    for (const Index m : cluster.members)
        take(leaves[m]);
    return out;
}

std::uint64_t hashOf(const SprayAtlas& atlas)
{
    StageHash hash(1);
    hash.add(std::uint64_t(atlas.form.shape)).add(std::uint64_t(atlas.form.turns));
    const auto addAll = [&hash](const auto& values) {
        hash.add(std::string_view(reinterpret_cast<const char*>(values.data()),
                                  values.size() * sizeof(values[0])));
    };
    for (const TriangleMesh& twig : atlas.twigs) {
        addAll(twig.positions);
        addAll(twig.colours);
    }
    return hash.value();
}

/// Clusters whose leaves are spread as those of most are: the middle ones, by their extent for their area.
std::array<std::size_t, SprayAtlas::count> typicalOf(std::span<const FoliageItem> leaves,
                                                     std::span<const LeafCluster> clusters,
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
    std::array<std::size_t, SprayAtlas::count> out{};
    constexpr std::array quantiles{0.42, 0.48, 0.54, 0.60};
    for (std::size_t k = 0; k < out.size(); ++k)
        out[k] = order[static_cast<std::size_t>(quantiles[k] * double(order.size()))].second;
    return out;
}

} // namespace

SprayFrame sprayFrame(const TriangleMesh& twig)
{
    Box box;
    for (const glm::vec3& at : twig.positions)
        box.add(glm::dvec3(at));
    if (box.empty())
        return {};
    return {box.centre(), glm::max(0.5 * (1.0 + freeRim) * box.size(), glm::dvec3(1e-9))};
}

TriangleMesh sprayCards(const SprayFrame& frame, int twig)
{
    constexpr float cell = 1.0F / SprayAtlas::across;
    TriangleMesh out;
    for (const int across : {2, 0}) { // Z, then X
        const int column = twig % SprayAtlas::across, row = twig / SprayAtlas::across;
        const glm::vec2 corner(cell * (float(column) + (across == 0 ? 0.5F : 0.0F)), cell * float(row));
        const int right = 2 - across;
        const auto first = out.vertexCount();
        for (const glm::vec2& at : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)}) {
            glm::dvec3 place = frame.middle;
            place[right] += frame.half[right] * (2.0 * double(at.x) - 1.0);
            place.y += frame.half.y * (2.0 * double(at.y) - 1.0);
            glm::vec3 normal(0.0F);
            normal[across] = across == 2 ? 1.0F : -1.0F; // right × up
            out.positions.emplace_back(place);
            out.normals.push_back(normal);
            out.uv.push_back(corner + cell * at * glm::vec2(0.5F, 1.0F));
        }
        out.triangles.emplace_back(first, first + 1, first + 2);
        out.triangles.emplace_back(first, first + 2, first + 3);
    }
    out.colours.assign(out.triangles.size(), glm::u8vec3(255));
    return out;
}

LeafSprays leafSprays(const Foliage& foliage, std::span<const LeafCluster> clusters,
                      const LeafShapeOfLevel& whole)
{
    LeafSprays out;
    const std::span<const FoliageItem> leaves = foliage.leaves;
    out.items = framesOf(leaves, clusters, whole);
    const auto typical = typicalOf(leaves, clusters, out.items);
    auto atlas = std::make_shared<SprayAtlas>();
    atlas->form = foliage.form;
    std::array<double, SprayAtlas::count> shown{}; // m² of leaf on a card of size 1
    std::array<glm::vec3, SprayAtlas::count> brightest{};
    for (std::size_t k = 0; k < typical.size(); ++k) {
        const LeafCluster& cluster = clusters[typical[k]];
        const FoliageItem& spray = out.items[typical[k]];
        glm::vec3 most(1e-3F);
        double squares = 0.0;
        for (const Index m : cluster.members) {
            most = glm::max(most, toneOf(leaves[m]));
            squares += double(leaves[m].size) * double(leaves[m].size);
        }
        brightest[k] = most / glm::max(meanTone(leaves, cluster), glm::vec3(1e-3F));
        shown[k] = whole.area * squares / (double(spray.size) * double(spray.size));
        atlas->twigs[k] = twigOf(leaves, cluster, spray, whole.mesh, most);
    }
    atlas->hash = hashOf(*atlas);
    double all = 0.0, showing = 0.0;
    for (std::size_t c = 0; c < clusters.size(); ++c) {
        const FoliageItem& own = out.items[c];
        const auto twig = static_cast<std::uint8_t>((clusters[c].leaf * 2654435761U) >> 30U);
        out.twig.push_back(twig);
        showing += shown[twig] * double(own.size) * double(own.size);
        for (const Index m : clusters[c].members)
            all += whole.area * double(leaves[m].size) * double(leaves[m].size);
    }
    const double growth =
        std::clamp(std::sqrt(all / std::max(showing, 1e-300)), 1.0 / mostGrowth, mostGrowth);
    out.area = showing * growth * growth;
    for (std::size_t c = 0; c < clusters.size(); ++c) {
        FoliageItem& own = out.items[c];
        const glm::dvec3 middle = own.position + own.orientation * (double(own.size) * whole.middle);
        own.size *= static_cast<float>(growth);
        own.position = middle - own.orientation * (double(own.size) * whole.middle);
        own.tone = 1.0F;
        own.tint = glm::min(brightest[out.twig[c]] * meanTone(leaves, clusters[c]), 1.0F);
    }
    out.atlas = std::move(atlas);
    return out;
}

TriangleMesh buildSprays(const Skeleton& skeleton, const LeafSprays& sprays)
{
    std::array<TriangleMesh, SprayAtlas::count> cards;
    for (int k = 0; k < SprayAtlas::count; ++k)
        cards[std::size_t(k)] = sprayCards(sprayFrame(sprays.atlas->twigs[std::size_t(k)]), k);
    TriangleMesh out;
    for (std::size_t i = 0; i < sprays.items.size(); ++i) {
        const FoliageItem& item = sprays.items[i];
        const TriangleMesh& card = cards[sprays.twig[i]];
        const glm::mat3 turn(glm::mat3_cast(item.orientation));
        const glm::vec3 place(item.position);
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
    return out;
}

} // namespace ramure
