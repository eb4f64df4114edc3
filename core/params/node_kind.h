/// \file
/// The kinds of scene nodes.
#pragma once

#include <cstdint>

namespace ramure {

enum class NodeKind : std::uint8_t {
    Group,     ///< only a place for its children
    Tree,      ///< a skeleton grown from a grammar, with its skin
    Primitive, ///< a simple solid, by its parameters
    Mesh,      ///< an imported mesh, kept in the node
    Arm,       ///< an articulated arm with its skin
    Terrain,   ///< a terrain
    Camera,    ///< what a picture is seen from
};
inline constexpr int nodeKindCount = 7;

constexpr std::uint8_t kindBit(NodeKind kind)
{
    return static_cast<std::uint8_t>(1u << static_cast<unsigned>(kind));
}

} // namespace ramure
