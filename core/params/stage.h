/// \file
/// The stages of a tree's computation, in their order. A parameter names the first stage it affects.
#pragma once

#include <cstddef>
#include <cstdint>

namespace ramure {

enum class Stage : std::uint8_t {
    Symbols,    ///< the rewritten string
    Skeleton,   ///< branches as the turtle draws them
    Simplified, ///< after merging nearly straight runs
    Sections,   ///< cross-sections with their frames
    Mesh,       ///< the continuous branch mesh and its report
    Foliage,    ///< leaves and apples, where they stand
    Season,     ///< how these look on a day, and which hang then
    Placement,  ///< the node's place: no geometry changes
    Motion,     ///< how it moves: nothing at rest changes
    Texture,    ///< how its surface is mapped: made when asked for, no geometry changes
};
inline constexpr std::size_t stageCount = 10;

} // namespace ramure
