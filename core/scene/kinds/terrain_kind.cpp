#include "core/scene/kinds/node_kinds.h"
#include "core/surface/primitives/terrain.h"

#include <numbers>

namespace ramure {

static void begin(NodeParams& params)
{
    params.surface.color = {0.62, 0.55, 0.43};
    // Hills behind the arm, a basin before it, lowest along the sides: seen whole, it has no ragged edge.
    params.tree.rotation.y = std::numbers::pi;
    params.terrain.seed = 15344;
    params.terrain.height = 1.2;
    params.terrain.roughness = 0.42;
}

static Expected<SharedMesh> solid(const NodeParams& params, const SharedMesh& /*own*/)
{
    auto terrain = buildTerrain(params.terrain);
    if (!terrain)
        return fail(std::move(terrain.error()));
    return std::make_shared<const TriangleMesh>(std::move(*terrain));
}

static SharedMesh look(const NodeParams& params, const SharedMesh& own)
{
    return solid(params, own).value_or(nullptr);
}

static bool isOpen(const NodeParams& /*params*/)
{
    return true;
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
    .begin = &begin,
    .look = &look,
    .solid = &solid,
    .isOpen = &isOpen,
};

} // namespace ramure
