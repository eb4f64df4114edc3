#include "core/surface/foliage/leaf_table.h"

#include <array>
#include <glm/common.hpp>

namespace ramure {
namespace {

using enum LeafFamily;
using enum LeafArrangement;
using S = LeafShape;

// clang-format off
constexpr std::array<LeafRow, leafShapeCount - 1> rows{{
    // Elliptic
    {.shape = S::Beech, .length = 0.45, .internode = 0.17, .arrangement = Distichous, .petiole = 0.12, .width = 0.62, .base = 0.50, .tip = 0.62, .teeth = 0.06, .autumn = {0xC0, 0x75, 0x2E}},
    {.shape = S::Elm, .length = 0.48, .internode = 0.17, .arrangement = Distichous, .petiole = 0.08, .width = 0.56, .base = 0.42, .tip = 0.70, .teeth = 0.16, .autumn = {0xD9, 0xB3, 0x38}},
    {.shape = S::Cherry, .length = 0.52, .internode = 0.18, .arrangement = Alternate, .petiole = 0.28, .width = 0.48, .base = 0.55, .tip = 0.75, .teeth = 0.10, .autumn = {0xC8, 0x50, 0x2A}},
    {.shape = S::Magnolia, .length = 0.80, .internode = 0.24, .arrangement = Spiral, .petiole = 0.15, .width = 0.45, .base = 0.60, .tip = 0.62, .colour = {0x4E, 0x7B, 0x33}, .evergreen = true},
    {.shape = S::Box, .length = 0.20, .internode = 0.11, .arrangement = Decussate, .petiole = 0.08, .width = 0.58, .base = 0.45, .tip = 0.45, .colour = {0x4F, 0x77, 0x30}, .evergreen = true},
    // Ovate
    {.shape = S::Birch, .length = 0.42, .internode = 0.15, .arrangement = Alternate, .petiole = 0.40, .width = 0.72, .base = 0.32, .tip = 0.95, .teeth = 0.16, .autumn = {0xE2, 0xB6, 0x2F}},
    {.shape = S::Apple, .length = 0.48, .internode = 0.18, .arrangement = Alternate, .petiole = 0.30, .width = 0.60, .base = 0.45, .tip = 0.62, .teeth = 0.10, .autumn = {0xCF, 0xA6, 0x3A}},
    {.shape = S::Aspen, .length = 0.40, .internode = 0.16, .arrangement = Alternate, .petiole = 0.85, .width = 0.95, .base = 0.38, .tip = 0.60, .teeth = 0.10, .colour = {0x7C, 0xA0, 0x46}, .autumn = {0xE8, 0xB9, 0x23}},
    // Heart-shaped
    {.shape = S::Hazel, .length = 0.55, .internode = 0.20, .arrangement = Distichous, .petiole = 0.15, .width = 0.85, .base = 0.42, .tip = 0.62, .notch = 0.08, .teeth = 0.14, .autumn = {0xCF, 0xA6, 0x3A}},
    {.shape = S::Linden, .length = 0.52, .internode = 0.19, .arrangement = Distichous, .petiole = 0.50, .width = 0.88, .base = 0.38, .tip = 0.72, .notch = 0.12, .teeth = 0.10, .autumn = {0xDD, 0xB8, 0x3A}},
    {.shape = S::Redbud, .length = 0.55, .internode = 0.21, .arrangement = Distichous, .petiole = 0.55, .width = 1.05, .base = 0.36, .tip = 0.66, .notch = 0.15, .autumn = {0xDD, 0xB4, 0x40}},
    // Lanceolate and linear
    {.shape = S::Willow, .length = 0.60, .internode = 0.13, .arrangement = Alternate, .petiole = 0.08, .width = 0.18, .base = 0.45, .tip = 0.80, .colour = {0x86, 0xA0, 0x55}, .autumn = {0xCD, 0xBB, 0x45}},
    {.shape = S::Olive, .length = 0.36, .internode = 0.13, .arrangement = Decussate, .petiole = 0.08, .width = 0.24, .base = 0.55, .tip = 0.58, .colour = {0x7F, 0x8F, 0x62}, .evergreen = true},
    {.shape = S::Eucalyptus, .length = 0.70, .internode = 0.20, .arrangement = Alternate, .petiole = 0.18, .width = 0.19, .base = 0.40, .tip = 0.80, .colour = {0x78, 0x93, 0x66}, .evergreen = true},
    {.shape = S::Bamboo, .length = 0.70, .internode = 0.16, .arrangement = Distichous, .petiole = 0.05, .width = 0.14, .base = 0.30, .tip = 0.70, .evergreen = true},
    {.shape = S::Grass, .length = 1.10, .internode = 0.20, .arrangement = Distichous, .petiole = 0.0, .width = 0.045, .base = 0.20, .tip = 0.60, .autumn = {0xCD, 0xB6, 0x76}},
    // Lobes from one place
    {.shape = S::Maple, .family = Star, .length = 0.58, .internode = 0.26, .arrangement = Decussate, .petiole = 0.80, .width = 1.00, .lobes = 5, .depth = 0.52, .spread = 4.0, .dwindle = 0.5, .autumn = {0xD2, 0x50, 0x2A}},
    {.shape = S::JapaneseMaple, .family = Star, .length = 0.40, .internode = 0.22, .arrangement = Decussate, .petiole = 0.60, .width = 0.95, .lobes = 7, .depth = 0.70, .spread = 4.1, .dwindle = 0.5, .colour = {0x8F, 0x9C, 0x3E}, .autumn = {0xB5, 0x20, 0x2A}},
    {.shape = S::Plane, .family = Star, .length = 0.65, .internode = 0.28, .arrangement = Alternate, .petiole = 0.40, .width = 1.05, .lobes = 5, .depth = 0.38, .spread = 3.5, .dwindle = 0.4, .autumn = {0xB9, 0x8A, 0x3E}},
    {.shape = S::Sweetgum, .family = Star, .length = 0.55, .internode = 0.24, .arrangement = Spiral, .petiole = 0.75, .width = 1.00, .lobes = 5, .depth = 0.55, .spread = 4.0, .autumn = {0xA8, 0x2F, 0x33}},
    // Lobes left and right
    {.shape = S::Oak, .length = 0.58, .internode = 0.18, .arrangement = Spiral, .petiole = 0.06, .width = 0.58, .base = 0.85, .tip = 0.42, .lobes = 4, .depth = 0.42, .pointed = false, .autumn = {0xA8, 0x74, 0x3A}},
    {.shape = S::RedOak, .length = 0.68, .internode = 0.21, .arrangement = Spiral, .petiole = 0.25, .width = 0.68, .base = 0.60, .tip = 0.50, .lobes = 4, .depth = 0.55, .autumn = {0xB0, 0x3A, 0x22}},
    {.shape = S::Hawthorn, .length = 0.32, .internode = 0.15, .arrangement = Alternate, .petiole = 0.25, .width = 0.85, .base = 0.70, .tip = 0.45, .lobes = 3, .depth = 0.45, .autumn = {0xB5, 0x50, 0x2E}},
    // Fans
    {.shape = S::Ginkgo, .family = Star, .length = 0.42, .internode = 0.17, .arrangement = Spiral, .petiole = 0.70, .width = 1.00, .depth = 0.22, .spread = 1.9, .colour = {0x86, 0xA8, 0x4A}, .autumn = {0xEB, 0xC5, 0x2E}},
    {.shape = S::FanPalm, .family = Star, .length = 2.60, .internode = 0.30, .arrangement = Spiral, .petiole = 0.90, .width = 1.00, .lobes = 17, .depth = 0.35, .spread = 4.4, .dwindle = 0.15, .colour = {0x5C, 0x7E, 0x4A}, .evergreen = true},
    // Pinnate
    {.shape = S::Ash, .family = Pinnate, .length = 1.10, .internode = 0.42, .arrangement = Decussate, .petiole = 0.18, .width = 0.38, .base = 0.55, .tip = 0.80, .spread = 1.1, .leaflets = 4, .leaflet = 0.34, .dwindle = 0.1, .autumn = {0xD8, 0xBC, 0x3F}},
    {.shape = S::Rowan, .family = Pinnate, .length = 0.95, .internode = 0.36, .arrangement = Alternate, .petiole = 0.15, .width = 0.32, .base = 0.35, .tip = 0.60, .teeth = 0.15, .spread = 1.15, .leaflets = 6, .leaflet = 0.30, .dwindle = 0.2, .autumn = {0xC2, 0x4A, 0x25}},
    {.shape = S::Walnut, .family = Pinnate, .length = 1.40, .internode = 0.45, .arrangement = Spiral, .petiole = 0.15, .width = 0.48, .base = 0.50, .tip = 0.62, .spread = 1.1, .leaflets = 3, .leaflet = 0.38, .dwindle = -0.3, .autumn = {0xD2, 0xB0, 0x42}},
    {.shape = S::Robinia, .family = Pinnate, .length = 1.05, .internode = 0.38, .arrangement = Alternate, .petiole = 0.12, .width = 0.50, .base = 0.45, .tip = 0.45, .spread = 1.35, .leaflets = 7, .leaflet = 0.19, .dwindle = 0.2, .colour = {0x80, 0xA6, 0x50}, .autumn = {0xDC, 0xC2, 0x4A}},
    {.shape = S::Mimosa, .family = Pinnate, .length = 1.15, .internode = 0.40, .arrangement = Alternate, .petiole = 0.15, .width = 0.30, .base = 0.45, .tip = 0.45, .lobes = 5, .depth = 0.85, .spread = 1.1, .leaflets = 4, .leaflet = 0.42, .dwindle = 0.3, .colour = {0x79, 0x9C, 0x52}, .evergreen = true},
    // Fingers
    {.shape = S::HorseChestnut, .family = Fingers, .length = 0.95, .internode = 0.40, .arrangement = Decussate, .petiole = 0.85, .width = 0.38, .base = 0.95, .tip = 0.42, .teeth = 0.06, .spread = 3.9, .leaflets = 7, .dwindle = 0.45, .autumn = {0xB8, 0x74, 0x2E}},
    {.shape = S::Laburnum, .family = Fingers, .length = 0.40, .internode = 0.16, .arrangement = Alternate, .petiole = 0.80, .width = 0.48, .base = 0.50, .tip = 0.55, .spread = 3.0, .leaflets = 3, .dwindle = 0.05, .autumn = {0xD6, 0xBE, 0x4E}},
    // Fronds
    {.shape = S::Fern, .family = Pinnate, .length = 1.60, .internode = 0.40, .arrangement = Spiral, .petiole = 0.20, .width = 0.17, .base = 0.25, .tip = 0.75, .teeth = 0.25, .spread = 1.25, .leaflets = 19, .leaflet = 0.32, .dwindle = 0.85, .autumn = {0xB0, 0x7A, 0x35}},
    {.shape = S::Palm, .family = Pinnate, .length = 5.50, .internode = 0.60, .arrangement = Spiral, .petiole = 0.25, .width = 0.11, .base = 0.25, .tip = 0.60, .spread = 1.0, .leaflets = 16, .leaflet = 0.30, .dwindle = 0.45, .colour = {0x6A, 0x93, 0x3E}, .evergreen = true},
    // Needles, on shoots of the year, and scales
    {.shape = S::Yew, .family = Shoot, .length = 0.20, .internode = 0.060, .arrangement = Distichous, .petiole = 0.0, .width = 0.36, .base = 0.20, .tip = 0.35, .spread = 1.15, .leaflets = 32, .leaflet = 0.11, .dwindle = 0.4, .flat = true, .colour = {0x3F, 0x66, 0x31}, .evergreen = true},
    {.shape = S::Fir, .family = Shoot, .length = 0.22, .internode = 0.070, .arrangement = Distichous, .petiole = 0.0, .width = 0.40, .base = 0.12, .tip = 0.20, .spread = 1.2, .leaflets = 30, .leaflet = 0.13, .dwindle = 0.3, .flat = true, .colour = {0x46, 0x70, 0x45}, .evergreen = true},
    {.shape = S::Spruce, .family = Shoot, .length = 0.22, .internode = 0.070, .arrangement = Alternate, .petiole = 0.0, .width = 0.42, .base = 0.12, .tip = 0.30, .spread = 0.95, .leaflets = 30, .leaflet = 0.12, .dwindle = 0.2, .colour = {0x41, 0x68, 0x3C}, .evergreen = true},
    {.shape = S::BlueSpruce, .family = Shoot, .length = 0.22, .internode = 0.070, .arrangement = Alternate, .petiole = 0.0, .width = 0.36, .base = 0.12, .tip = 0.30, .spread = 1.05, .leaflets = 30, .leaflet = 0.14, .dwindle = 0.2, .colour = {0x76, 0x95, 0x93}, .evergreen = true},
    {.shape = S::Cedar, .family = Shoot, .length = 0.22, .internode = 0.075, .arrangement = Distichous, .petiole = 0.0, .width = 0.28, .base = 0.12, .tip = 0.30, .spread = 1.2, .leaflets = 28, .leaflet = 0.13, .dwindle = 0.1, .rosettes = 7, .colour = {0x4C, 0x74, 0x58}, .evergreen = true},
    {.shape = S::ScotsPine, .family = Shoot, .length = 0.42, .internode = 0.11, .arrangement = Spiral, .petiole = 0.0, .width = 0.18, .base = 0.12, .tip = 0.40, .spread = 0.8, .leaflets = 32, .leaflet = 0.40, .dwindle = 0.1, .bareFoot = 0.25, .colour = {0x5D, 0x80, 0x55}, .evergreen = true},
    {.shape = S::WhitePine, .family = Shoot, .length = 0.60, .internode = 0.13, .arrangement = Spiral, .petiole = 0.0, .width = 0.14, .base = 0.12, .tip = 0.40, .spread = 0.7, .leaflets = 30, .leaflet = 0.50, .dwindle = 0.1, .bareFoot = 0.2, .colour = {0x62, 0x88, 0x60}, .evergreen = true},
    {.shape = S::Larch, .family = Shoot, .length = 0.24, .internode = 0.10, .arrangement = Alternate, .petiole = 0.0, .width = 0.24, .base = 0.15, .tip = 0.40, .spread = 1.25, .leaflets = 28, .leaflet = 0.14, .dwindle = 0.1, .rosettes = 7, .colour = {0x7D, 0xA2, 0x4C}, .autumn = {0xDD, 0xA5, 0x2F}},
    {.shape = S::Cypress, .family = Pinnate, .length = 0.48, .internode = 0.09, .arrangement = Alternate, .petiole = 0.03, .width = 0.52, .base = 0.40, .tip = 0.60, .spread = 0.55, .leaflets = 6, .leaflet = 0.26, .dwindle = 0.5, .colour = {0x4A, 0x72, 0x3C}, .evergreen = true},
}};
// clang-format on

constexpr bool leavesStandInOrder()
{
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (static_cast<std::size_t>(rows[i].shape) != i + 1)
            return false;
    return true;
}

} // namespace

const LeafRow& leafRow(LeafShape shape)
{
    static_assert(leavesStandInOrder(), "the rows stand in the order of the shapes");
    return rows[static_cast<std::size_t>(shape) - 1];
}

glm::u8vec3 leafColour(LeafShape shape, bool turn)
{
    const LeafRow& row = leafRow(shape);
    return turn && !row.evergreen ? glm::max(row.colour, row.autumn) : row.colour;
}

} // namespace ramure
