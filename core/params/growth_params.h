/// \file
/// The parameters of trees that grow year by year: Palubicki, Horel, Longay, Runions, Lane, Mech,
/// Prusinkiewicz, "Self-organizing tree models for image synthesis" (SIGGRAPH 2009). Lengths in metres,
/// angles in radians, tree space.
#pragma once

#include "core/params/growth_space.h"
#include <cstdint>

namespace ramure {

/// How buds follow each other along a shoot. The order is that of the interface; files know the names.
enum class Phyllotaxis : std::uint8_t {
    Spiral,    ///< one bud a node, turned by GrowthParams::divergence
    Opposite,  ///< two, turned by 90 degrees
    Alternate, ///< one, turned by 180 degrees
};

/// How light reaches the buds. The order is that of the interface; files know the names.
enum class GrowthLight : std::uint8_t {
    Shadows, ///< the sky, as far as leaves above do not hide it
    Space,   ///< free room in the crown, or in the solid that the tree fills
};

/// How vigour is shared out. The order is that of the interface; files know the names.
enum class VigourModel : std::uint8_t {
    BorchertHonda, ///< at each fork by the light above it
    Priority,      ///< along each axis by the rank of its buds and limbs in the light
};

/// The kind of plant. The order is that of the interface; files know the names.
enum class GrowthHabit : std::uint8_t {
    Branching, ///< shoots that compete for light
    Palm,      ///< one stem under a crown of fronds (palm.h)
};

/// The parameters that artists set. Technical factors of the model (lambda, alpha and the weights of the
/// shadows) follow from these, so every combination within the limits grows a tree.
struct GrowthParams
{
    double age = 40.0; ///< years
    GrowthHabit habit = GrowthHabit::Branching;

    double height = 20.0;     ///< at maturity
    double crownWidth = 16.0; ///< at maturity
    double crownBase = 0.1;   ///< share of the height below which limbs get no light
    double crownWidest = 0.4; ///< height of its widest place, as a share of the crown's height
    double crownTop = 0.5;    ///< exponent above: 0.2 an umbrella, 0.5 round, 1 a cone
    double maturity = 60.0;   ///< years until the height is nearly reached
    double density = 1.0;     ///< density of the leaves on shoots, 1 is usual

    double leaderUntil = 20.0;  ///< years; from then on the trunk is a limb among limbs
    double apicalControl = 0.5; ///< 0: limbs fork evenly; 1: they keep one axis each
    VigourModel vigour = VigourModel::BorchertHonda;
    double sideLength = 0.8; ///< longest shoot of an order of axes over that of the order before
    double internode = 0.2;
    Phyllotaxis phyllotaxis = Phyllotaxis::Spiral;
    double divergence = 2.39996322972865; ///< angle of a leaf spiral, rad: 137.5 degrees
    double axil = 0.9;                    ///< between an axis and its side shoots
    double acrotony = 0.6;                ///< 1: only buds near the end of a year's shoot grow, 0: all alike
    double branching = 1.0;   ///< share of the vigour that side buds take; 0.4: long, whippy twigs
    std::int64_t whorl = 0;   ///< limbs around the end of each year's shoot of the trunk; 0: none
    std::int64_t endBuds = 2; ///< side buds around the end of each year's shoot, where there is no whorl
    std::int64_t orders = 9;  ///< highest order of an axis
    /// Share of a shoot's growth that comes from its own leaves, for a shoot in the light, relative to the
    /// strongest one. 0: everything is shared out from the roots. 1: each limb is a tree of its own.
    double autonomy = 0.35;
    double shortShoots = 0.4; ///< how weak a bud still makes a short shoot: 0 none, 1 all
    double sympodial = 0.0;   ///< chance a year that an apex dies and side buds go on
    std::int64_t stems = 1;

    GrowthLight sees = GrowthLight::Shadows;
    double shadeTolerance = 0.5; ///< 0: a light crown of few layers; 1: a deep and dense one
    double shedding = 0.5;       ///< 0: shaded branches stay; 1: they go at once
    double deadWood = 0.0;       ///< how long what died in the shade stands: 1 as wood rots; 0: it is gone
    double light = 0.35;         ///< how much shoots turn to the light
    double upright = 0.1;        ///< how much they turn upwards; below 0: downwards
    double weeping = 0.0;        ///< how much the shoots of higher orders hang
    double plagiotropy = 0.0;    ///< how flat side shoots stay
    double wander = 0.25;        ///< how much chance turns each internode
    double droop = 0.2;          ///< share of a year's bend under the weight that stays
    double reaction = 0.3;       ///< how soon wood turns up again
    double reiteration = 0.0;    ///< chance a year that a dormant bud in the light begins a tree anew

    double pipeExponent = 2.2; ///< e of d^e = sum of the children's d^e
    double tipRadius = 0.0035;
    double girth = 0.35; ///< share of shed branches' wood that the stem keeps as girth

    double scars = 0.0;   ///< share of shed limbs over 2 cm that leave a scar
    double hollows = 0.0; ///< share of the scars over 8 cm that rot
    double burrs = 0.0;   ///< on ten metres of stems and limbs

    // Of palms alone.
    std::int64_t fronds = 13; ///< fronds that open in a year
    double frondLength = 4.5; ///< m
    double frondYears = 2.4;  ///< years from the day it opens until it falls
    double stemRadius = 0.16; ///< m, above the swollen foot
    std::int64_t fruit = 8;   ///< fruits in a bunch

    double sunlight = 1.0; ///< share of the open sky; 0: the tree dies

    // The site. Directions are turns about the vertical axis: 0 along X, a quarter turn against Z.
    double wind = 0.0;           ///< mean wind, m/s
    double windDirection = 0.0;  ///< rad, where the wind blows to
    double sideLight = 0.0;      ///< 0: light from all around; 1: from one side only
    double lightDirection = 0.0; ///< rad, the side that the light comes from
    double slope = 0.0;          ///< rad, of the ground through the foot
    double slopeDirection = 0.0; ///< rad, downhill
    double lean = 0.0;           ///< rad, of the seedling, downhill
    bool neighbours = false;     ///< whether other growing trees of the scene shade it
    GrowthSpaceLink space{};     ///< no parameter: filled in from the scene; obstacles shade and stop shoots
    bool operator==(const GrowthParams&) const = default;
};

} // namespace ramure
