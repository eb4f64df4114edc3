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
    Camera,    ///< a viewpoint for pictures
    Scatter,   ///< many copies of its children, which are prototypes
    /// A kind from the file of a newer version. The node holds a place for its children. All its other data
    /// stay in Node::extras and are written back.
    Unknown = 15,
};
inline constexpr int nodeKindCount = 8; ///< without Unknown

using KindBits = std::uint16_t;

constexpr KindBits kindBit(NodeKind kind)
{
    return static_cast<KindBits>(1u << static_cast<unsigned>(kind));
}

} // namespace ramure
