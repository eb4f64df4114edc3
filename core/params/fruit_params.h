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
    double size = 1.0;  ///< relative to the plant's natural size
    double stalk = 1.0; ///< length, relative to the plant's natural stalk
    bool operator==(const FruitParams&) const = default;
};

} // namespace ramure
