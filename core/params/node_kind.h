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
    /// Of a file that a newer version has written. The node is a place for its children; everything else of
    /// it stays in Node::extras and is written back.
    Unknown = 15,
};
inline constexpr int nodeKindCount = 7; ///< without Unknown

using KindBits = std::uint16_t;

constexpr KindBits kindBit(NodeKind kind)
{
    return static_cast<KindBits>(1u << static_cast<unsigned>(kind));
}

} // namespace ramure
