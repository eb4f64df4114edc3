#include "core/scene/growth_spaces.h"

#include "core/generators/colonisation/growth_space.h"
#include "core/math/stage_hash.h"
#include "core/params/source_facts.h"
#include "core/scene/object_mesh.h"
#include "core/scene/standing_ground.h"
#include <algorithm>
#include <glm/matrix.hpp>
#include <optional>
#include <tuple>

namespace ramure {
namespace {

struct Placed
{
    const Node* node;
    std::uint64_t shape; ///< equal for equal meshes
    glm::dmat4 world{1.0};
};

bool isSolid(const Node& node)
{
    return (node.kind == NodeKind::Primitive || node.kind == NodeKind::Mesh) &&
           node.params.growthRole != GrowthRole::None;
}

SolidUse solidUse(const Node& node)
{
    return node.kind == NodeKind::Tree ? sourceFacts(node.params).solids(node.params) : SolidUse::None;
}

bool hasCrown(const Node& node)
{
    return node.kind == NodeKind::Tree && node.params.generator.kind == EditOperation::Growth &&
           node.params.growth.habit == GrowthHabit::Branching;
}

/// What a tree may find around it.
struct Surroundings
{
    std::vector<Placed> solids, crowns;

    explicit Surroundings(const Scene& scene)
    {
        for (const Node& node : scene.nodes())
            if (isSolid(node)) {
                if (const std::uint64_t shape = shapeHash(node); shape != 0)
                    solids.push_back({&node, shape, geometryMatrix(scene, node)});
            } else if (hasCrown(node) && !isPrototype(scene, node.id))
                crowns.push_back({&node, 0, geometryMatrix(scene, node)});
    }
};

void add(StageHash& hash, const Placed& solid, const glm::dmat4& place)
{
    hash.add(std::string_view(solid.node->name)).add(static_cast<int>(solid.node->params.growthRole));
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
            hash.add(place[column][row]);
    hash.add(solid.shape);
}

/// The trees that reach a tree's light, nearest first. Equally near ones are ordered by their places, so that
/// the order of the scene changes nothing.
std::vector<NeighbourCrown> neighboursOf(const std::vector<Placed>& crowns, const Node& tree,
                                         const glm::dmat4& intoTree)
{
    constexpr std::size_t most = 12;
    std::vector<NeighbourCrown> all;
    if (!hasCrown(tree) || !tree.params.growth.neighbours)
        return all;
    for (const Placed& each : crowns) {
        if (each.node->id == tree.id)
            continue;
        const GrowthParams& growth = each.node->params.growth;
        const glm::dmat4 place = intoTree * each.world;
        const double scale = glm::length(glm::dvec3(place[1]));
        const NeighbourCrown crown{glm::dvec3(place[3]), scale * growth.height, scale * growth.crownWidth,
                                   growth.crownBase, growth.maturity};
        const double reach = crown.height + 0.5 * (crown.width + tree.params.growth.crownWidth);
        if (glm::length(glm::dvec2(crown.foot.x, crown.foot.z)) < reach)
            all.push_back(crown);
    }
    const auto order = [](const NeighbourCrown& crown) {
        const glm::dvec3& at = crown.foot;
        return std::tuple(at.x * at.x + at.z * at.z, at.x, at.z, crown.height, crown.width, crown.base);
    };
    std::ranges::sort(all, std::less(), order);
    all.resize(std::min(all.size(), most));
    return all;
}

void add(StageHash& hash, const NeighbourCrown& crown)
{
    for (const double number :
         {crown.foot.x, crown.foot.y, crown.foot.z, crown.height, crown.width, crown.base, crown.maturity})
        hash.add(number);
}

/// A solid and its place in the space of the tree.
using SolidInTree = std::pair<Node, glm::dmat4>;

GrowthSolids builtOf(const std::vector<SolidInTree>& moved)
{
    std::vector<GrowthSpace::Solid> solids;
    for (const auto& [solid, place] : moved) {
        TriangleMesh out;
        const auto mesh = objectSolid(solid, solid.params);
        if (mesh && *mesh) {
            out.positions.reserve((*mesh)->positions.size());
            for (const glm::vec3& p : (*mesh)->positions)
                out.positions.emplace_back(place * glm::dvec4(p, 1.0));
            out.triangles = (*mesh)->triangles;
        }
        solids.push_back(
            {solid.name, std::make_shared<const TriangleMesh>(std::move(out)), solid.params.growthRole});
    }
    GrowthSolids built{std::make_shared<const GrowthSpace>(std::move(solids))};
    built.top = built.space->top();
    return built;
}

/// Nothing where the tree has the same already.
std::optional<GrowthSpaceLink> linkOf(const Scene& scene, const Node& tree, const Surroundings& around)
{
    const SolidUse use = solidUse(tree);
    const bool fills = use != SolidUse::Around;
    const bool isAlone = isPrototype(scene, tree.id); // its copies stand somewhere else
    const glm::dmat4 intoTree = glm::inverse(geometryMatrix(scene, tree));
    StageHash hash(fills ? 1 : 0);
    std::vector<const Placed*> mine;
    for (const Placed& solid : around.solids) {
        const bool isEnvelope = solid.node->params.growthRole == GrowthRole::Envelope;
        if (isEnvelope ? !(fills && scene.isAncestor(tree.id, solid.node->id)) : isAlone)
            continue;
        mine.push_back(&solid);
        add(hash, solid, intoTree * solid.world);
    }
    GrowthSpaceLink link;
    if (!isAlone)
        link.neighbours = neighboursOf(around.crowns, tree, intoTree);
    for (const NeighbourCrown& crown : link.neighbours)
        add(hash, crown);
    const bool hasSolids = !mine.empty() || use == SolidUse::Needs;
    if (hasSolids || !link.neighbours.empty())
        link.hash = hash.value();
    if (link == tree.params.colonisation.space)
        return std::nullopt;
    if (!hasSolids)
        return link;
    std::vector<SolidInTree> moving;
    for (const Placed* solid : mine)
        moving.emplace_back(*solid->node, intoTree * solid->world);
    link.solids =
        std::make_shared<const Lazy<GrowthSolids>>([moved = std::move(moving)] { return builtOf(moved); });
    return link;
}

} // namespace

std::map<NodeId, GrowthSpaceLink> staleGrowthSpaces(const Scene& scene, std::span<const NodeId> only)
{
    std::map<NodeId, GrowthSpaceLink> stale;
    std::optional<Surroundings> around;
    forEachOf(scene, only, [&](const Node& node) {
        if (solidUse(node) == SolidUse::None) {
            if (node.params.colonisation.space.hash != 0)
                stale.emplace(node.id, GrowthSpaceLink());
            return;
        }
        if (!around)
            around.emplace(scene);
        if (auto link = linkOf(scene, node, *around))
            stale.emplace(node.id, std::move(*link));
    });
    return stale;
}

void setGrowthSpace(NodeParams& params, const GrowthSpaceLink& link)
{
    params.colonisation.space = link;
    params.growth.space = link;
}

void linkGrowthSpaces(Scene& scene)
{
    for (auto& [id, link] : staleGrowthSpaces(scene))
        setGrowthSpace(scene.find(id)->params, link);
    for (auto& [id, ground] : staleGrounds(scene))
        scene.find(id)->params.ground = std::move(ground);
}

} // namespace ramure
