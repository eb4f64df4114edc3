/// \file
/// Parameters of the bark's picture. The member initialisers are the defaults.
#pragma once

#include <cstdint>

namespace ramure {

/// The values are positions in the table's list of items; files have the names.
enum class BarkFamily : std::uint8_t {
    Plain,     ///< one colour
    Smooth,    ///< beech: fine wrinkles across, lichen
    Plated,    ///< pine: large plates of thin flakes
    Furrowed,  ///< oak: long ridges that part and meet
    Scaly,     ///< spruce: small scales that lift
    Peeling,   ///< eucalyptus: long strips over pale wood
    Ringed,    ///< birch: white, with lenticels
    Fibrous,   ///< cedar: fibres along the trunk
    Mosaic,    ///< plane: patches of three ages
    PalmScars, ///< palm: rings where fronds were
    Thorny,    ///< kapok: cones on smooth bark
    Corky,     ///< cork oak: deep, soft ridges
    Bamboo,    ///< smooth, with a node each tile
    Ribbed,    ///< cactus: green ribs with spines along their crests
    Banded,    ///< cherry: red brown, glossy, with pale lenticels across
    PalmBoots, ///< date palm: stubs of its fronds, in crossing spirals
};

/// Used where a surface is drawn or its maps are written; no geometry depends on them.
struct BarkParams
{
    BarkFamily family = BarkFamily::Plain;
    double depth = 1.0; ///< multiplies the relief of the family
    double light = 0.0; ///< -1 black, 1 twice as light
    double moss = 0.0;  ///< share of the surface
    std::int64_t seed = 1;
    bool operator==(const BarkParams&) const = default;
};

} // namespace ramure
