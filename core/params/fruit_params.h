/// \file
/// Fruit and flowers of a tree: which they are and how large.
#pragma once

#include <cstdint>

namespace ramure {

/// Faithful: the spheres and cubes of SPEC A6; all others have a row in
/// core/surface/foliage/fruit_shapes.cpp. The order is that of the interface; files know the names.
enum class FruitKind : std::uint8_t {
    Faithful,
    Apple,
    Pear,
    Cherry,
    Plum,
    Orange,
    Lemon,
    Olive,
    Acorn,
    Cone,
    Coconut,
    Dates,
    Berries,
    Blossom,
};
inline constexpr int fruitKindCount = 14;

struct FruitParams
{
    FruitKind kind = FruitKind::Faithful;
    double size = 1.0;        ///< relative to the diameter
    double stalk = 1.0;       ///< length, relative to the plant's natural stalk
    double diameter = 0.0;    ///< m, at the widest; 0: in proportion to the tree's trunk
    std::int64_t cluster = 0; ///< how many hang from one place; 0: as the plant has it
    double ripeness = 1.0;    ///< share of the fruit that are ripe; flowers know none
    bool operator==(const FruitParams&) const = default;
};

} // namespace ramure
