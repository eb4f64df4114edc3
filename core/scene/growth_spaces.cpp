#include "core/scene/growth_spaces.h"

#include "core/generators/colonisation/growth_space.h"
#include "core/math/stage_hash.h"
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

bool heedsSolids(const Node& node)
{
    const TreeGenerator generator = node.params.generator.kind;
    return node.kind == NodeKind::Tree &&
           (generator == TreeGenerator::Colonisation || generator == TreeGenerator::Growth);
}

/// Whether it fills the solids below it.
bool fillsSolids(const NodeParams& params)
{
    return params.generator.kind == TreeGenerator::Growth
               ? params.growth.sees == GrowthLight::Space
               : params.colonisation.envelope == CrownEnvelope::Solid;
}

glm::dmat4 geometryMatrix(const Scene& scene, const Node& node)
{
    return worldMatrix(scene, node.id) * placementMatrix(node.params.local);
}

/// The hash of a solid's mesh, without making the mesh; 0 where there is none.
std::uint64_t shapeOf(const Node& solid)
{
    if (solid.kind == NodeKind::Mesh)
        return solid.mesh && !solid.mesh->empty() ? solid.mesh.hash() : 0;
    StageHash hash(0);
    for (const double number : ownNumbers(solid.kind, solid.params))
        hash.add(number);
    return hash.value();
}

std::vector<Placed> solidsOf(const Scene& scene)
{
    std::vector<Placed> solids;
    for (const Node& node : scene.nodes())
        if (isSolid(node))
            if (const std::uint64_t shape = shapeOf(node); shape != 0)
                solids.push_back({&node, shape, geometryMatrix(scene, node)});
    return solids;
}

void add(StageHash& hash, const Placed& solid, const glm::dmat4& place)
{
    hash.add(std::string_view(solid.node->name)).add(static_cast<int>(solid.node->params.growthRole));
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
            hash.add(place[column][row]);
    hash.add(solid.shape);
}

bool hasCrown(const Node& node)
{
    return node.kind == NodeKind::Tree && node.params.generator.kind == TreeGenerator::Growth &&
           node.params.growth.habit == GrowthHabit::Branching;
}

/// The trees that reach a tree's light, nearest first. Equally near ones are ordered by their places, so that
/// the order of the scene changes nothing.
std::vector<NeighbourCrown> neighboursOf(const Scene& scene, const Node& tree, const glm::dmat4& intoTree)
{
    constexpr std::size_t most = 12;
    std::vector<NeighbourCrown> all;
    if (!hasCrown(tree) || !tree.params.growth.neighbours)
        return all;
    for (const Node& node : scene.nodes()) {
        if (node.id == tree.id || !hasCrown(node))
            continue;
        const GrowthParams& growth = node.params.growth;
        const glm::dmat4 place = intoTree * geometryMatrix(scene, node);
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

/// The mesh of a solid in the space of the tree.
std::shared_ptr<const TriangleMesh> moved(const Node& solid, const glm::dmat4& place)
{
    TriangleMesh out;
    const auto mesh = objectSolid(solid, solid.params);
    if (!mesh || !*mesh)
        return std::make_shared<const TriangleMesh>(std::move(out));
    out.positions.reserve((*mesh)->positions.size());
    for (const glm::vec3& p : (*mesh)->positions)
        out.positions.emplace_back(place * glm::dvec4(p, 1.0));
    out.triangles = (*mesh)->triangles;
    return std::make_shared<const TriangleMesh>(std::move(out));
}

/// Nothing where the tree has the same already.
std::optional<GrowthSpaceLink> linkOf(const Scene& scene, const Node& tree, const std::vector<Placed>& solids)
{
    const bool fills = fillsSolids(tree.params);
    const glm::dmat4 intoTree = glm::inverse(geometryMatrix(scene, tree));
    StageHash hash(fills ? 1 : 0);
    std::vector<const Placed*> mine;
    for (const Placed& solid : solids) {
        const bool isEnvelope = solid.node->params.growthRole == GrowthRole::Envelope;
        if (isEnvelope && !(fills && scene.isAncestor(tree.id, solid.node->id)))
            continue;
        mine.push_back(&solid);
        add(hash, solid, intoTree * solid.world);
    }
    GrowthSpaceLink link;
    link.neighbours = neighboursOf(scene, tree, intoTree);
    for (const NeighbourCrown& crown : link.neighbours)
        add(hash, crown);
    const bool hasSolids =
        !mine.empty() || (fills && tree.params.generator.kind == TreeGenerator::Colonisation);
    if (hasSolids || !link.neighbours.empty())
        link.hash = hash.value();
    if (link == tree.params.colonisation.space)
        return std::nullopt;
    std::vector<GrowthSpace::Solid> moving;
    for (const Placed* solid : mine)
        moving.push_back({solid->node->name, moved(*solid->node, intoTree * solid->world),
                          solid->node->params.growthRole});
    if (hasSolids) {
        link.space = std::make_shared<const GrowthSpace>(std::move(moving));
        link.top = link.space->top();
    }
    return link;
}

} // namespace

std::map<NodeId, GrowthSpaceLink> staleGrowthSpaces(const Scene& scene)
{
    std::map<NodeId, GrowthSpaceLink> stale;
    std::optional<std::vector<Placed>> solids;
    for (const Node& node : scene.nodes()) {
        if (!heedsSolids(node)) {
            if (node.params.colonisation.space.hash != 0)
                stale.emplace(node.id, GrowthSpaceLink());
            continue;
        }
        if (!solids)
            solids = solidsOf(scene);
        if (auto link = linkOf(scene, node, *solids))
            stale.emplace(node.id, std::move(*link));
    }
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
    for (const auto& [id, ground] : staleGrounds(scene))
        scene.find(id)->params.ground = ground;
}

} // namespace ramure
