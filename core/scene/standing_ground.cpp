#include "core/scene/standing_ground.h"

#include "core/math/intersect.h"
#include "core/math/stage_hash.h"
#include "core/params/source_facts.h"
#include "core/params/steep_ground.h"
#include "core/scene/object_mesh.h"
#include "core/surface/primitives/terrain.h"
#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <vector>

namespace ramure {
namespace {

constexpr double mostAway = 4.0; ///< radii of the trunk: how far above or below the foot the ground may be
constexpr double measuredAround = 2.0; ///< the same: how far around the foot its slope is measured

struct Surface
{
    std::optional<TerrainHeights> terrain;
    std::shared_ptr<const TriangleMesh> solid;
};

struct GroundSurface
{
    glm::dmat4 world{1.0};
    std::uint64_t shape; ///< equal for equal surfaces
    std::shared_ptr<const Lazy<Surface>> surface;
};

bool isGround(const Node& node)
{
    const bool isSolid = node.kind == NodeKind::Primitive || node.kind == NodeKind::Mesh;
    return node.kind == NodeKind::Terrain || (isSolid && node.params.growthRole == GrowthRole::Obstacle);
}

Surface surfaceOf(const Node& node)
{
    Surface surface;
    if (node.kind != NodeKind::Terrain)
        surface.solid = objectSolid(node, node.params).value_or(nullptr);
    else if (auto heights = TerrainHeights::of(node.params.terrain))
        surface.terrain.emplace(std::move(*heights));
    return surface;
}

std::vector<GroundSurface> surfacesOf(const Scene& scene)
{
    std::vector<GroundSurface> out;
    for (const Node& node : scene.nodes())
        if (isGround(node) && !isPrototype(scene, node.id))
            out.push_back({geometryMatrix(scene, node), shapeHash(node),
                           std::make_shared<const Lazy<Surface>>([node] { return surfaceOf(node); })});
    return out;
}

/// Where the line meets the terrain: the height over it falls steadily along the line unless hills are
/// steeper.
std::optional<double> meet(const TerrainHeights& terrain, const Ray& line)
{
    if (!(std::abs(line.direction.y) > 1e-6))
        return std::nullopt;
    double t = 0.0;
    for (int round = 0; round < 24; ++round) {
        const glm::dvec3 at = line.at(t);
        if (!terrain.isOn(at.x, at.z))
            return std::nullopt;
        t += (terrain.at(at.x, at.z) - at.y) / line.direction.y;
    }
    return std::isfinite(t) ? std::optional(t) : std::nullopt;
}

/// The nearest place where the line comes out of the solid.
std::optional<double> meet(const TriangleMesh& solid, const Ray& line, double most)
{
    std::optional<double> nearest;
    for (const Ray& ray : {line, Ray{line.origin, -line.direction}})
        for (const glm::uvec3& t : solid.triangles) {
            const glm::dvec3 a(solid.positions[t.x]), b(solid.positions[t.y]), c(solid.positions[t.z]);
            if (!(glm::dot(glm::cross(b - a, c - a), line.direction) > 0.0))
                continue;
            const auto hit = intersect(ray, a, b, c);
            if (hit && hit->t <= most && (!nearest || hit->t < std::abs(*nearest)))
                nearest = std::copysign(hit->t, glm::dot(ray.direction, line.direction));
        }
    return nearest;
}

/// m over the tree's origin, of the surface nearest to it along the tree's vertical through (x, 0, z).
std::optional<double> heightAt(const Surface& surface, const glm::dmat4& intoSurface, double x, double z,
                               double most)
{
    const Ray line{glm::dvec3(intoSurface * glm::dvec4(x, 0.0, z, 1.0)), glm::dvec3(intoSurface[1])};
    const auto height = surface.terrain ? meet(*surface.terrain, line)
                        : surface.solid ? meet(*surface.solid, line, most)
                                        : std::nullopt;
    return height && std::abs(*height) <= most ? height : std::nullopt;
}

/// m a metre, from the heights on both sides, or on the one that has ground.
double gradeBetween(double here, const std::optional<double>& before, const std::optional<double>& after,
                    double apart)
{
    if (before && after)
        return 0.5 * (*after - *before) / apart;
    return after ? (*after - here) / apart : before ? (here - *before) / apart : 0.0;
}

/// \param radius m, of the trunk
std::optional<GroundPlane> groundUnder(const glm::dmat4& world, double radius,
                                       const std::vector<GroundSurface>& surfaces)
{
    const double apart = measuredAround * radius, most = mostAway * radius;
    std::optional<GroundPlane> best;
    for (const GroundSurface& surface : surfaces) {
        const glm::dmat4 into = glm::inverse(surface.world) * world;
        const auto here = heightAt(**surface.surface, into, 0.0, 0.0, most);
        if (!here || (best && std::abs(best->height) <= std::abs(*here)))
            continue;
        // Steep ground is further away at a distance.
        const auto at = [&](double x, double z) {
            return heightAt(**surface.surface, into, x * apart, z * apart, most + 4.0 * apart);
        };
        best = GroundPlane{*here,
                           {gradeBetween(*here, at(-1.0, 0.0), at(1.0, 0.0), apart),
                            gradeBetween(*here, at(0.0, -1.0), at(0.0, 1.0), apart)}};
    }
    const bool isPlane =
        best && std::isfinite(best->height) && std::isfinite(best->grade.x) && std::isfinite(best->grade.y);
    return isPlane ? std::optional(eased(*best)) : std::nullopt;
}

void add(StageHash& hash, const glm::dmat4& place)
{
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
            hash.add(place[column][row]);
}

/// What the ground under a tree follows from.
std::uint64_t groundHash(const glm::dmat4& world, const NodeParams& params,
                         const std::vector<GroundSurface>& surfaces)
{
    StageHash hash(params.colonisation.space.hash); // the trunk's radius may follow from it
    const SourceFacts& facts = sourceFacts(params);
    if (facts.solids(params) != SolidUse::Needs)
        hash.add(facts.trunkRadius(params));
    add(hash, world);
    for (const GroundSurface& surface : surfaces)
        add(hash.add(surface.shape), surface.world);
    return hash.value();
}

} // namespace

std::map<NodeId, StandingGround> staleGrounds(const Scene& scene, std::span<const NodeId> only)
{
    std::map<NodeId, StandingGround> stale;
    std::shared_ptr<const std::vector<GroundSurface>> surfaces;
    forEachOf(scene, only, [&](const Node& node) {
        const bool hasRoots =
            node.kind == NodeKind::Tree && node.params.mesh.roots > 0 && !isPrototype(scene, node.id);
        if (hasRoots && !surfaces)
            surfaces = std::make_shared<const std::vector<GroundSurface>>(surfacesOf(scene));
        if (!hasRoots || surfaces->empty()) {
            if (node.params.ground.hash != 0)
                stale.emplace(node.id, StandingGround());
            return;
        }
        const glm::dmat4 world = geometryMatrix(scene, node);
        const std::uint64_t hash = groundHash(world, node.params, *surfaces);
        if (hash == node.params.ground.hash)
            return;
        NodeParams tree = node.params;
        tree.ground = {}; // else each ground would keep the one before
        const auto plane = [world, surfaces, tree = std::move(tree)] {
            return groundUnder(world, trunkRadius(tree), *surfaces);
        };
        stale.emplace(node.id, StandingGround{hash, std::make_shared<const LazyGround>(plane)});
    });
    return stale;
}

} // namespace ramure
