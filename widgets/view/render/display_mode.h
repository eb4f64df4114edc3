/// \file
/// What a picture shows of a tree, and how.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace ramure {

/// The views of SPEC A10. The names (displayModeName) are those of `ramure-cli render --mode`.
enum class DisplayMode : std::uint8_t {
    Skeleton,   ///< branches as the turtle drew them, as lines
    Simplified, ///< lines after simplification; the nodes it removed marked in red
    Rough,      ///< cones, squares and cubes
    Sections,   ///< curves and cross-sections, with frames on demand
    Mesh,       ///< the one continuous mesh with leaves and apples
    Checker,    ///< the branches' texture coordinates as a pattern of squares
    Stretch,    ///< how far those are from squares, as colours
};
enum class ShadingMode : std::uint8_t { Solid, SolidWire, Wire };
/// Which sections show their frame as three arrows: tangent blue, normal red, binormal green.
enum class FrameDisplay : std::uint8_t { None, Selection, All };

/// "skeleton", "simplified", "rough", "sections", "mesh", "checker", "stretch", in the order of the enum.
std::span<const char* const> displayModeNames();
const char* displayModeName(DisplayMode mode);
std::optional<DisplayMode> displayModeFromName(std::string_view name);

} // namespace ramure
