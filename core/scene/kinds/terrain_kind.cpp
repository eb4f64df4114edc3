#include "core/scene/kinds/node_kinds.h"
#include "core/surface/primitives/terrain.h"

#include <numbers>

namespace ramure {

static void beginTerrain(NodeParams& params)
{
    params.surface.color = {0.62, 0.55, 0.43};
    // Hills behind the arm, a basin before it, lowest along the sides: seen whole, it has no ragged edge.
    params.tree.rotation.y = std::numbers::pi;
    params.terrain.seed = 15344;
    params.terrain.height = 1.2;
    params.terrain.roughness = 0.42;
    params.terrain.depth = 0.6;
}

static Expected<SharedMesh> shared(Expected<TriangleMesh> mesh)
{
    RAMURE_TRY(mesh);
    return std::make_shared<const TriangleMesh>(std::move(*mesh));
}

static Expected<SharedMesh> solidTerrain(const NodeParams& params, const SharedMesh& /*own*/)
{
    return shared(terrainSolid(params.terrain));
}

static SharedMesh terrainLook(const NodeParams& params, const SharedMesh& /*own*/)
{
    return shared(buildTerrain(params.terrain)).value_or(nullptr);
}

static bool isOpenTerrain(const NodeParams& params)
{
    return !(params.terrain.depth > 0.0);
}

extern const NodeKindRow terrainKind;
const NodeKindRow terrainKind = {
    .kind = NodeKind::Terrain,
    .name = "terrain",
    .icon = "terrain",
    .word = RAMURE_NOOP("terrain"),
    .tip = RAMURE_NOOP("Terrain: %1"),
    .label = RAMURE_NOOP("Terrain"),
    .many = RAMURE_NOOP("Terrains"),
    .addId = "edit.addTerrain",
    .addText = RAMURE_NOOP("&Terrain"),
    .addTip = RAMURE_NOOP("Add a terrain that gives an arm targets"),
    .begin = &beginTerrain,
    .look = &terrainLook,
    .solid = &solidTerrain,
    .isOpen = &isOpenTerrain,
};

} // namespace ramure
