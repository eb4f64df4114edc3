/// \file
/// Leaves of a tree: which plant's they are and how they stand on their twigs.
#pragma once

#include <cstdint>

namespace ramure {

/// Faithful: the triangles and squares of SPEC A3; all others have a row in
/// core/surface/foliage/leaf_table.h. The order is that of the interface; files know the names.
enum class LeafShape : std::uint8_t {
    Faithful,
    Beech,
    Elm,
    Cherry,
    Magnolia,
    Box,
    Birch,
    Apple,
    Aspen,
    Hazel,
    Linden,
    Redbud,
    Willow,
    Olive,
    Eucalyptus,
    Bamboo,
    Grass,
    Maple,
    JapaneseMaple,
    Plane,
    Sweetgum,
    Oak,
    RedOak,
    Hawthorn,
    Ginkgo,
    FanPalm,
    Ash,
    Rowan,
    Walnut,
    Robinia,
    Mimosa,
    HorseChestnut,
    Laburnum,
    Fern,
    Palm,
    Yew,
    Fir,
    Spruce,
    BlueSpruce,
    Cedar,
    ScotsPine,
    WhitePine,
    Larch,
    Cypress,
};
inline constexpr int leafShapeCount = 44;

/// How leaves follow each other along a twig.
enum class LeafArrangement : std::uint8_t {
    Natural,    ///< natural for the plant
    Alternate,  ///< one a node, two fifths of a turn apart
    Distichous, ///< one a node, left and right
    Spiral,     ///< one a node, 137.5 degrees apart
    Opposite,   ///< two a node, all in one plane
    Decussate,  ///< two a node, each pair across the last
    Whorled,    ///< several a node
};

struct LeafParams
{
    LeafShape shape = LeafShape::Faithful;
    double length = 0.0;       ///< m, without the petiole; 0: in proportion to the tree's trunk
    double size = 1.0;         ///< relative to that length
    double variation = 0.25;   ///< share by which leaves are larger or smaller, at most
    std::int64_t perShoot = 1; ///< leaves that stand on one short shoot and swing as one
    double width = 1.0;        ///< relative to the plant's natural width
    double fold = 0.3;         ///< rad, each half up from the plane
    double curl = 0.5;         ///< rad, from the foot of the blade to its tip, downwards
    double cup = 0.2;
    double petiole = 1.0; ///< length, relative to the plant's natural petiole
    std::int64_t detail = 2;
    LeafArrangement arrangement = LeafArrangement::Natural;
    std::int64_t whorl = 4;
    double internode = 1.0; ///< relative to the plant's natural distance
    double angle = 0.9;     ///< rad, between petiole and twig
    double droop = 0.25;
    double light = 0.6;
    double shade = 1.0;     ///< area of a leaf inside the crown, relative to one in full sun
    double damage = 0.0;    ///< share of the leaves that are smaller and have withered in part
    double season = 0.0;    ///< 0 summer .. 1 bare
    double stiffness = 1.0; ///< of the petioles, relative to the usual
    double flutter = 1.0;   ///< relative to the usual
    bool operator==(const LeafParams&) const = default;
};

} // namespace ramure
