#include "widgets/view/render/tree_ground.h"

#include "core/math/angle.h"
#include "core/math/random.h"
#include "core/math/reproducible.h"
#include "core/params/source_facts.h"
#include "core/surface/mesh/normals.h"
#include "widgets/view/render/meadow.h"
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr Index hillRings = 72, hillSides = 144;
constexpr double planeReach = 1.7;  ///< of the roots' reach: so far its ground is the tree's plane
constexpr double leastRun = 2.0;    ///< the same: from there out to the level ground
constexpr double runOfHeight = 3.0; ///< of the hill's height, at least: the same
constexpr double dip = 0.03;        ///< of the roots' reach: how far its rim is under the level ground
constexpr double litterFrom = 0.9, litterTo = 1.9; ///< of the roots' reach: where litter thins out
constexpr glm::dvec3 grassTone(86, 125, 70), litterTone(97, 78, 54); ///< sRGB, of the level ground

double smoothStep(double x)
{
    const double t = std::clamp(x, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

class Hillside
{
public:
    Hillside(const GroundPlane& ground, const glm::dvec3& foot, double reach)
        : m_ground(ground)
        , m_foot(foot)
        , m_reach(reach)
        , m_plane(planeReach * reach)
        , m_run(std::max(leastRun * reach, runOfHeight * 2.0 * m_plane * glm::length(ground.grade)))
        , m_base(hillsideBase(ground, foot, reach))
    {
    }
    /// At a distance from the foot in a direction (x, z).
    [[nodiscard]] double height(double away, const glm::dvec2& way) const
    {
        const double fade = smoothStep((away - m_plane) / m_run);
        const double onPlane = std::min(away, m_plane) + std::max(away - m_plane, 0.0) * (1.0 - fade);
        const double plane =
            -m_ground.above({m_foot.x, 0.0, m_foot.z}) + onPlane * glm::dot(m_ground.grade, way);
        return plane + fade * (m_base - dip * m_reach - plane);
    }
    TriangleMesh make() &&
    {
        m_mesh.positions.emplace_back(at(0.0, 0));
        for (Index ring = 1; ring <= hillRings; ++ring)
            for (Index side = 0; side < hillSides; ++side)
                m_mesh.positions.emplace_back(at(awayOf(ring), side));
        for (Index ring = 0; ring < hillRings; ++ring)
            for (Index side = 0; side < hillSides; ++side) {
                const Index next = (side + 1) % hillSides;
                const Index a = ring == 0 ? 0 : 1 + (ring - 1) * hillSides + side;
                const Index b = ring == 0 ? 0 : 1 + (ring - 1) * hillSides + next;
                const Index c = 1 + ring * hillSides + side, d = 1 + ring * hillSides + next;
                add({a, c, d}, awayOf(ring + 1));
                if (ring > 0)
                    add({a, d, b}, awayOf(ring));
            }
        computeNormals(m_mesh);
        return std::move(m_mesh);
    }

private:
    /// Rings are closer to each other near the foot.
    [[nodiscard]] double awayOf(Index ring) const
    {
        const double share = double(ring) / hillRings;
        return (m_plane + m_run) * share * std::sqrt(share);
    }
    [[nodiscard]] glm::dvec3 at(double away, Index side) const
    {
        const auto [sine, cosine] = maths::sincos(fullTurn * double(side) / hillSides);
        const glm::dvec2 way(cosine, -sine);
        return {m_foot.x + away * way.x, height(away, way), m_foot.z + away * way.y};
    }
    /// Litter gives way to grass by chance, more and more; far out the grass is that of the level ground.
    void add(const glm::uvec3& triangle, double away)
    {
        const double out = (away / m_reach - litterFrom) / (litterTo - litterFrom);
        const double grass = std::clamp(out + m_random.range(-0.35, 0.35), 0.0, 1.0);
        const double uneven = 0.1 * (1.0 - smoothStep((away - m_plane) / m_run));
        const double bright = 1.0 + m_random.range(-uneven, uneven);
        m_mesh.triangles.push_back(triangle);
        m_mesh.colours.emplace_back(
            glm::clamp(bright * (litterTone + grass * (grassTone - litterTone)), 0.0, 255.0));
    }

    const GroundPlane m_ground;
    const glm::dvec3 m_foot;
    const double m_reach, m_plane, m_run, m_base;
    Random m_random{1, RandomStream::Terrain};
    TriangleMesh m_mesh;
};

} // namespace

double hillsideBase(const GroundPlane& ground, const glm::dvec3& foot, double reach)
{
    return -ground.above({foot.x, 0.0, foot.z}) - planeReach * reach * glm::length(ground.grade);
}

double hillsideHeight(const GroundPlane& ground, const glm::dvec3& foot, double reach, const glm::dvec2& at)
{
    const glm::dvec2 way = at - glm::dvec2(foot.x, foot.z);
    const double away = glm::length(way);
    return Hillside(ground, foot, reach).height(away, away > 0.0 ? way / away : way);
}

TriangleMesh hillsideUnder(const GroundPlane& ground, const glm::dvec3& foot, double reach)
{
    return Hillside(ground, foot, reach).make();
}

void TreeGrounds::add(const Node& node, const NodeParams& params, const TreeResult& tree,
                      const glm::dmat4& world)
{
    ++m_trees;
    if (!(params.mesh.roots > 0) || !tree.skeleton)
        return;
    const Skeleton& skeleton = *tree.skeleton;
    const double scale = glm::length(glm::dvec3(world[0]));
    m_reach = 0.0;
    for (Index i = 0; i < skeleton.size(); ++i) {
        if (skeleton.parent[i] != noIndex)
            continue;
        const double reach = skeleton.a0[i] * (1.0 + 2.0 * params.mesh.rootLength);
        m_built.feet.push_back({glm::dvec3(world * glm::dvec4(skeleton.p0[i], 1.0)), scale * reach});
        if (reach > m_reach) {
            m_reach = reach;
            m_foot = skeleton.p0[i];
        }
    }
    if (tree.foliage && m_hasMeadow)
        m_shedding.push_back({tree.foliage,
                              tree.placed ? tree.placed : tree.foliage,
                              trunkRadius(params),
                              world,
                              {m_foot, m_reach}});
    m_node = node.id;
    m_world = world;
    m_ground = params.ground.nearby() ? std::nullopt : groundOf(params);
}

void TreeGrounds::finish(double level)
{
    m_built.ground = level;
    const bool isHill = m_trees == 1 && m_ground && m_reach > 0.0;
    if (isHill)
        addHillside();
    else
        std::erase_if(m_built.feet,
                      [this](const Foot& foot) { return foot.place.y - m_built.ground > foot.reach; });
    if (m_hasMeadow && !m_built.feet.empty())
        addMeadow(isHill);
    if (isHill)
        m_built.feet.clear(); // its own litter lies on it
}

/// On a hillside in the tree's space, else in the world.
void TreeGrounds::addMeadow(bool isHill)
{
    const double level = m_built.ground;
    const HeightOfGround height = [&](const glm::dvec2& at) {
        return isHill ? hillsideHeight(*m_ground, m_foot, m_reach, at) : level;
    };
    std::vector<Foot> feet = m_built.feet;
    if (isHill)
        feet = {{m_foot, m_reach}};
    std::vector<double> numbers{level, double(isHill)};
    for (const Foot& foot : feet)
        numbers.insert(numbers.end(), {foot.place.x, foot.place.y, foot.place.z, foot.reach});
    if (isHill)
        numbers.insert(numbers.end(), {m_ground->height, m_ground->grade.x, m_ground->grade.y});
    const std::shared_ptr<const void> anybody;
    addCopies(m_cache.get<MeshCopies>(ScenePart::Grass, anybody, anybody, numbers,
                                      [&] { return grassAround(feet, height); }),
              grassMaterial(), isHill ? m_world : glm::dmat4(1.0));
    for (const Shedding& tree : m_shedding) {
        const glm::dvec3 foot(tree.world * glm::dvec4(tree.foot.place, 1.0));
        const double below = (glm::inverse(tree.world) * glm::dvec4(foot.x, level, foot.z, 1.0)).y;
        const auto levelThere = [&](const glm::dvec2& at) { return isHill ? height(at) : below; };
        addCopies(m_cache.get<MeshCopies>(ScenePart::FallenLeaves, tree.foliage, tree.foliage, numbers,
                                          [&] {
                                              return fallenLeaves(*tree.foliage, *tree.placed, tree.alpha,
                                                                  tree.foot, levelThere);
                                          }),
                  fallenMaterial(), tree.world);
    }
}

void TreeGrounds::addCopies(std::shared_ptr<const MeshCopies> copies, Material material,
                            const glm::dmat4& world)
{
    if (copies->copies.empty())
        return;
    MeshItem item;
    item.mesh = DeferredMesh::Pointer(copies, &copies->shape);
    for (const MeshCopy& copy : copies->copies)
        item.box.add(glm::dvec3(copy.position));
    item.box = item.box.grown(copies->reach);
    item.copies = std::move(copies);
    item.material = std::move(material);
    item.world = world;
    item.closed = !item.material.twoSided;
    item.isMark = item.isGround = true;
    item.pickable = item.framed = item.castsShadow = false;
    m_built.meshes.push_back(std::move(item));
}

void TreeGrounds::addHillside()
{
    const std::shared_ptr<const void> anybody;
    MeshItem item;
    item.mesh = m_cache.get<TriangleMesh>(
        ScenePart::Hillside, anybody, anybody,
        {m_ground->height, m_ground->grade.x, m_ground->grade.y, m_foot.x, m_foot.y, m_foot.z, m_reach},
        [this] { return hillsideUnder(*m_ground, m_foot, m_reach); });
    item.box = m_cache.box(item.mesh);
    item.material.name = "hillside";
    item.world = m_world;
    item.node = m_node;
    item.isMark = item.isGround = true;
    item.pickable = item.framed = false;
    const glm::dvec4 base(m_foot.x, hillsideBase(*m_ground, m_foot, m_reach), m_foot.z, 1.0);
    m_built.ground = std::min(m_built.ground, (m_world * base).y);
    m_built.meshes.push_back(std::move(item));
}

} // namespace ramure
