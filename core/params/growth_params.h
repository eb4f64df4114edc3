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

/// What buds see. The order is that of the interface; files know the names.
enum class GrowthLight : std::uint8_t {
    Shadows, ///< the sky, as far as leaves above do not hide it
    Space,   ///< free room in the crown, or in the solid that the tree fills
};

/// How vigour is shared out. The order is that of the interface; files know the names.
enum class VigourModel : std::uint8_t {
    BorchertHonda, ///< at each fork by the light above it
    Priority,      ///< along each axis by the rank of its buds and limbs in the light
};

/// What an artist says. The factors of the model that are switches rather than knobs (lambda, alpha and the
/// weights of the shadows) follow from these: every combination within the limits grows a tree.
struct GrowthParams
{
    double age = 40.0; ///< years

    double height = 20.0;     ///< at maturity
    double crownWidth = 16.0; ///< at maturity
    double crownBase = 0.1;   ///< share of the height below which limbs get no light
    double crownWidest = 0.4; ///< share of the crown's height where it is widest
    double crownTop = 0.5;    ///< exponent above: 0.2 an umbrella, 0.5 round, 1 a cone
    double maturity = 60.0;   ///< years until the height is nearly reached
    double density = 1.0;     ///< of the shoots, 1 a usual one

    double leaderUntil = 20.0;  ///< years; from then on the trunk is a limb among limbs
    double apicalControl = 0.5; ///< 0: limbs fork evenly; 1: they keep one axis each
    VigourModel vigour = VigourModel::BorchertHonda;
    double sideLength = 0.8; ///< longest shoot of an order of axes over that of the order before
    double internode = 0.2;
    Phyllotaxis phyllotaxis = Phyllotaxis::Spiral;
    double divergence = 2.39996322972865; ///< of a spiral: 137.5 degrees
    double axil = 0.9;                    ///< between an axis and its side shoots
    double acrotony = 0.6;                ///< 1: only buds near the end of a year's shoot grow, 0: all alike
    double branching = 1.0;   ///< share of the vigour that side buds take; 0.4: long, whippy twigs
    std::int64_t whorl = 0;   ///< limbs around the end of each year's shoot of the trunk; 0: none
    std::int64_t endBuds = 2; ///< side buds around the end of each year's shoot, where there is no whorl
    std::int64_t orders = 9;  ///< of axes
    /// What a shoot in the light grows out of its own leaves, of what the strongest one grows: 0, all is
    /// shared out from the roots; 1, each limb is a tree of its own.
    double autonomy = 0.35;
    double shortShoots = 0.4; ///< how weak a bud still makes a short shoot: 0 none, 1 all
    double sympodial = 0.0;   ///< chance a year that an apex dies and side buds go on
    std::int64_t stems = 1;

    GrowthLight sees = GrowthLight::Shadows;
    double shadeTolerance = 0.5; ///< 0: a light crown of few layers; 1: a deep and dense one
    double shedding = 0.5;       ///< 0: shaded branches stay; 1: they go at once
    double light = 0.35;         ///< how much shoots turn to the light
    double upright = 0.1;        ///< how much they turn upwards; below 0: downwards
    double weeping = 0.0;        ///< how much the shoots of higher orders hang
    double plagiotropy = 0.0;    ///< how flat side shoots stay
    double wander = 0.25;        ///< how much chance turns each internode
    double droop = 0.2;          ///< share of what the weight of a year bends that stays
    double reaction = 0.3;       ///< how soon wood turns up again
    double reiteration = 0.0;    ///< chance a year that a dormant bud in the light begins a tree anew

    double pipeExponent = 2.2; ///< e of d^e = sum of the children's d^e
    double tipRadius = 0.0035;
    double girth = 0.35;     ///< share of shed branches' wood that the stem keeps as girth
    double sunlight = 1.0;   ///< of the open sky; 0: the tree dies
    GrowthSpaceLink space{}; ///< no parameter: what the scene says; obstacles shade and stop shoots
    bool operator==(const GrowthParams&) const = default;
};

} // namespace ramure
