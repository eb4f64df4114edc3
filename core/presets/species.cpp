#include "core/presets/species.h"

#include "core/math/angle.h"
#include <algorithm>
#include <array>
#include <string_view>

namespace ramure {
namespace {

using S = CrownShape;
using L = LeafShape;
using B = BarkFamily;
using F = FruitKind;

/// The first four are those of the paper, in its numbers (doi 10.1145/218380.218427, appendix); what it says
/// of leaves stands here as their size and distance. Two differ: the willow has 60 twigs on a shoot, not 300,
/// with leaves on the shoots themselves, and the oak varies by 3 m in height, not by 10.
// clang-format off
const std::array mixedSpecies{
    Species{"QuakingAspen", "Populus tremuloides", RAMURE_NOOP("Slender, with a light crown that never rests"), false,
        {.shape = S::TendFlame, .baseSize = 0.4, .scale = 13, .scaleV = 3, .levels = 3, .ratio = 0.015, .ratioPower = 1.2,
         .lobes = 5, .lobeDepth = 0.07, .flare = 0.6, .attractionUp = 0.5,
         .level = {{{.curveRes = 5, .curveV = 20},
                    {.length = 0.3, .curveRes = 5, .curve = -40, .curveV = 50, .downAngle = 60, .downAngleV = -50, .rotate = 140, .branches = 50},
                    {.length = 0.6, .curveRes = 3, .curve = -40, .curveV = 75, .downAngle = 45, .downAngleV = 10, .rotate = 140, .branches = 30},
                    {.length = 0, .curveRes = 1, .downAngle = 45, .downAngleV = 10, .rotate = 77, .branches = 10}}}},
        {L::Aspen, 1.6, 1.5, 0.13, B::Ringed, 0.15}},
    Species{"BlackTupelo", "Nyssa sylvatica", RAMURE_NOOP("A straight trunk through a narrow cone of level limbs"), false,
        {.shape = S::TaperedCylindrical, .baseSize = 0.2, .scale = 23, .scaleV = 5, .levels = 4, .ratio = 0.015, .ratioPower = 1.3,
         .lobes = 3, .lobeDepth = 0.1, .flare = 1, .attractionUp = 0.5,
         .level = {{{.taper = 1.1, .curveRes = 10, .curveV = 40},
                    {.length = 0.3, .lengthV = 0.05, .curveRes = 10, .curveV = 90, .downAngle = 60, .downAngleV = -40, .rotate = 140, .branches = 50},
                    {.length = 0.6, .lengthV = 0.1, .curveRes = 10, .curve = -10, .curveV = 150, .downAngle = 30, .downAngleV = 10, .rotate = 140, .branches = 25},
                    {.length = 0.4, .curveRes = 1, .downAngle = 45, .downAngleV = 10, .rotate = 140, .branches = 12}}}},
        {L::Cherry, 1.3, 2.5, 0.035, B::Furrowed, -0.1}},
    Species{"WeepingWillow1995", "Salix babylonica", RAMURE_NOOP("A short trunk below curtains of hanging shoots"), false,
        {.shape = S::Cylindrical, .baseSize = 0.05, .scale = 15, .scaleV = 5, .levels = 4, .ratio = 0.03, .ratioPower = 2,
         .lobes = 9, .lobeDepth = 0.03, .flare = 0.75, .attractionUp = -3,
         .pruneRatio = 1, .pruneWidth = 0.48, .pruneWidthPeak = 0.6, .prunePowerLow = 0.001, .prunePowerHigh = 0.25,
         .level = {{{.length = 0.8, .baseSplits = 2, .segSplits = 0.1, .splitAngle = 3, .curveRes = 8, .curveBack = 20, .curveV = 120},
                    {.length = 0.5, .lengthV = 0.1, .segSplits = 0.2, .splitAngle = 30, .splitAngleV = 10, .curveRes = 16, .curve = 40, .curveBack = 80, .curveV = 90, .downAngle = 20, .downAngleV = 10, .rotate = -120, .rotateV = 30, .branches = 25},
                    {.length = 1.5, .segSplits = 0.2, .splitAngle = 45, .splitAngleV = 20, .curveRes = 12, .downAngle = 30, .downAngleV = 10, .rotate = -120, .rotateV = 30, .branches = 10},
                    {.length = 0.1, .curveRes = 1, .downAngle = 20, .downAngleV = 10, .rotate = 140, .branches = 60}}}},
        {L::Willow, 0.5, 0.6, 0.08, B::Furrowed, 0.0}},
    Species{"CaliforniaBlackOak", "Quercus kelloggii", RAMURE_NOOP("Low and wide, with crooked limbs from the ground on"), false,
        {.shape = S::Hemispherical, .baseSize = 0.05, .scale = 10, .scaleV = 3, .levels = 3, .ratio = 0.018, .ratioPower = 1.3,
         .lobes = 5, .lobeDepth = 0.1, .flare = 1.2, .attractionUp = 0.8,
         .level = {{{.taper = 0.95, .baseSplits = 2, .segSplits = 0.4, .splitAngle = 10, .curveRes = 8, .curveV = 90},
                    {.length = 0.8, .lengthV = 0.1, .segSplits = 0.2, .splitAngle = 10, .splitAngleV = 10, .curveRes = 10, .curve = 40, .curveBack = -70, .curveV = 150, .downAngle = 30, .downAngleV = -30, .rotate = 80, .branches = 40},
                    {.length = 0.2, .lengthV = 0.05, .segSplits = 0.1, .splitAngle = 10, .splitAngleV = 10, .curveRes = 3, .curve = -40, .curveV = -30, .downAngle = 45, .downAngleV = 10, .rotate = 140, .branches = 120},
                    {.length = 0.4, .curveRes = 1, .downAngle = 45, .downAngleV = 10, .rotate = 140, .branches = 0}}}},
        {L::RedOak, 1.1, 0.8, 0.12, B::Furrowed, -0.2, F::Acorn, 0.02, 0.018}},
    Species{"SilverBirch1995", "Betula pendula", RAMURE_NOOP("A white trunk, and fine twigs that hang from rising limbs"), false,
        {.shape = S::TendFlame, .baseSize = 0.2, .scale = 16.4, .scaleV = 2, .levels = 3, .ratio = 0.0149, .ratioPower = 1.5, .lobes = 0, .flare = 0.4, .attractionUp = -1.6,
         .level = {{{.curveRes = 8, .curveV = 30},
                    {.length = 0.417, .lengthV = 0.05, .curveRes = 8, .curve = -25, .curveBack = 50, .curveV = 60, .downAngle = 45, .downAngleV = -20, .rotate = 137, .rotateV = 20, .branches = 42},
                    {.length = 0.5, .lengthV = 0.1, .curveRes = 6, .curve = 30, .curveV = 50, .downAngle = 45, .downAngleV = 15, .rotate = 137, .rotateV = 20, .branches = 22},
                    {.length = 0.3, .curveRes = 1}}}},
        {L::Birch, 1.5, 1.5, 0.12, B::Ringed, 0.1}},
    Species{"LombardyPoplar1995", "Populus nigra 'Italica'", RAMURE_NOOP("A narrow column: all limbs rise close to the trunk"), false,
        {.shape = S::Cylindrical, .baseSize = 0.06, .scale = 22, .scaleV = 2, .levels = 3, .ratio = 0.014, .ratioPower = 1.3, .lobes = 7, .lobeDepth = 0.08, .flare = 0.8, .attractionUp = 2,
         .level = {{{.curveRes = 10, .curveV = 15},
                    {.length = 0.17, .lengthV = 0.03, .curveRes = 6, .curve = -25, .curveV = 20, .downAngle = 38, .downAngleV = -15, .rotate = 137, .rotateV = 15, .branches = 70},
                    {.length = 0.45, .lengthV = 0.1, .curveRes = 4, .curve = -20, .curveV = 30, .downAngle = 35, .downAngleV = 10, .rotate = 137, .branches = 18},
                    {.length = 0.3, .curveRes = 1}}}},
        {L::Aspen, 1.1, 1.1, 0.12, B::Furrowed, 0.1}},
    Species{"EnglishOak1995", "Quercus robur", RAMURE_NOOP("A stout trunk that parts into a broad round crown"), false,
        {.shape = S::Spherical, .baseSize = 0.22, .scale = 14.2, .scaleV = 1.8, .levels = 3, .ratio = 0.0369, .ratioPower = 1.35, .lobes = 5, .lobeDepth = 0.08, .flare = 1, .attractionUp = 0.6,
         .level = {{{.taper = 0.95, .segSplits = 0.1, .splitAngle = 20, .curveRes = 8, .curveV = 60},
                    {.length = 0.566, .lengthV = 0.08, .segSplits = 0.1, .splitAngle = 30, .splitAngleV = 10, .curveRes = 8, .curve = -10, .curveV = 130, .downAngle = 70, .downAngleV = -20, .rotate = 137, .rotateV = 20, .branches = 36},
                    {.length = 0.36, .lengthV = 0.08, .curveRes = 4, .curve = -10, .curveV = 120, .downAngle = 50, .downAngleV = 12, .rotate = 137, .rotateV = 20, .branches = 75},
                    {.length = 0.3, .curveRes = 1}}}},
        {L::Oak, 1.15, 0.6, 0.13, B::Furrowed, 0.0, F::Acorn, 0.02, 0.016}},
    Species{"NorwaySpruce1995", "Picea abies", RAMURE_NOOP("A dark spire of limbs that droop and rise again"), true,
        {.shape = S::Envelope, .baseSize = 0.04, .scale = 17.9, .scaleV = 1.6, .levels = 3, .ratio = 0.015, .ratioPower = 1.4, .lobes = 0, .flare = 0.5, .attractionUp = -0.2,
         .pruneWidthPeak = 0.05, .prunePowerLow = 0.05, .prunePowerHigh = 0.85,
         .level = {{{.curveRes = 8, .curveV = 5},
                    {.length = 0.274, .lengthV = 0.02, .curveRes = 6, .curve = 25, .curveBack = -45, .curveV = 20, .downAngle = 80, .downAngleV = -32, .rotate = 137, .rotateV = 10, .branches = 95},
                    {.length = 0.36, .lengthV = 0.05, .curveRes = 2, .curve = 25, .curveV = 20, .downAngle = 55, .downAngleV = 8, .rotate = -95, .rotateV = 12, .branches = 40},
                    {.length = 0.3, .curveRes = 1}}}},
        {L::Spruce, 3.6, 1.4, 0.2, B::Scaly, -0.1, F::Cone, 0.005, 0.035}},
    Species{"ScotsPine1995", "Pinus sylvestris", RAMURE_NOOP("A tall bare trunk below an open crown of tufts"), true,
        {.shape = S::Hemispherical, .baseSize = 0.5, .scale = 12.9, .scaleV = 1.4, .levels = 3, .ratio = 0.0258, .ratioPower = 1.4, .lobes = 0, .flare = 0.5, .attractionUp = 1,
         .level = {{{.curveRes = 8, .curveV = 45},
                    {.length = 0.339, .lengthV = 0.06, .curveRes = 8, .curve = -30, .curveV = 110, .downAngle = 75, .downAngleV = -25, .rotate = 137, .rotateV = 25, .branches = 34},
                    {.length = 0.45, .lengthV = 0.1, .curveRes = 4, .curve = -40, .curveV = 70, .downAngle = 50, .downAngleV = 12, .rotate = 137, .rotateV = 20, .branches = 36},
                    {.length = 0.3, .curveRes = 1}}}},
        {L::ScotsPine, 1.25, 0.62, 0.1, B::Plated, 0.15, F::Cone, 0.01, 0.03}},
};
// clang-format on

/// m: shoots and leaves hang below the twigs.
constexpr double usualClearance = 0.5;

/// Leaves of species that have no tree which grows by years, in the sizes of a flora. Their few twigs carry
/// long shoots.
struct DressedLeaves
{
    std::string_view name;
    GrownLeaves leaves;
};
constexpr std::array dressedLeaves{
    DressedLeaves{"BlackTupelo", {0.10, 2.74, 6}},
    DressedLeaves{"BlueGum1995", {0.20, 1.09, 6}},
    DressedLeaves{"EasternCottonwood1995", {0.10, 1.63, 8}},
    DressedLeaves{"FieldElm1995", {0.085, 1.6, 10}},
    DressedLeaves{"Jacaranda1995", {0.36, 0.43, 3}},
    DressedLeaves{"QuakingAspen", {0.05, 3.07, 6}},
    DressedLeaves{"Sassafras", {0.12, 1.22, 4}},
    DressedLeaves{"SouthernMagnolia1995", {0.17, 1.8, 6}},
};

} // namespace

std::span<const Species> species()
{
    return mixedSpecies;
}

double grownBarkTile(BarkFamily family)
{
    switch (family) {
    case BarkFamily::Smooth:
        return 2.0;
    case BarkFamily::Mosaic:
        return 1.0;
    case BarkFamily::Ringed:
    case BarkFamily::Banded:
    case BarkFamily::Peeling:
    case BarkFamily::Fibrous:
        return 0.6;
    case BarkFamily::Scaly:
    case BarkFamily::Corky:
    case BarkFamily::Ribbed:
        return 0.4;
    default:
        return 0.5;
    }
}

void setLeaves(NodeParams& params, const GrownLeaves& leaves)
{
    params.leaf.length = leaves.length;
    params.leaf.size = 1.0;
    params.leaf.internode = leaves.internode;
    params.leaf.perShoot = leaves.perShoot;
    params.leaf.width = leaves.width;
}

NodeParams speciesParams(const Species& species)
{
    NodeParams params;
    params.generator.kind = EditOperation::WeberPenn;
    params.weberPenn = species.growth;
    if (double& clearance = params.weberPenn.clearance; clearance == 0.0)
        clearance = usualClearance;
    for (WeberPennLevel& level : params.weberPenn.level)
        for (double WeberPennLevel::*angle :
             {&WeberPennLevel::splitAngle, &WeberPennLevel::splitAngleV, &WeberPennLevel::curve,
              &WeberPennLevel::curveBack, &WeberPennLevel::curveV, &WeberPennLevel::downAngle,
              &WeberPennLevel::downAngleV, &WeberPennLevel::rotate, &WeberPennLevel::rotateV})
            level.*angle *= oneDegree;
    const SpeciesDress& dress = species.dress;
    params.leaf.shape = dress.leaf;
    params.leaf.size = dress.size;
    params.leaf.internode = dress.internode;
    if (const auto own = std::ranges::find(dressedLeaves, species.name, &DressedLeaves::name);
        own != dressedLeaves.end())
        setLeaves(params, own->leaves);
    params.foliage.leavesCutoff = dress.twig;
    params.bark.family = dress.bark;
    params.bark.light = dress.light;
    params.texture.tileSize = dress.tile;
    params.fruit.kind = dress.fruit;
    params.fruit.diameter = dress.fruitDiameter;
    params.fruit.cluster = dress.fruit == FruitKind::Berries ? 20 : 0; // a corymb
    params.leaf.shade = species.conifer ? 1.2 : 1.5;
    params.foliage.applesProbability = dress.fruitful;
    params.sections = {3, 6};
    params.mesh.targetTriangles = 300'000; // which makes trunks round; twigs do with less than the sections
    params.mesh.clampOvershoot = true;
    params.mesh.collar = 0.5;
    params.mesh.fairing = 1.0;
    params.mesh.ridge = 0.04;
    params.mesh.rootLength = 0.55;
    params.mesh.roots = species.growth.lobes > 0 ? std::max<std::int64_t>(species.growth.lobes, 4) : 5;
    return params;
}

} // namespace ramure
