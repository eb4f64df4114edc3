/// \file
/// The ways to display a tree: one row of a table for each mode. The menu, the palette, the list of keys and
/// `ramure-cli render --mode` are made from the rows. A new mode is a value of the enum, its row in
/// display_modes.cpp, and its drawing in scene_builder.cpp.
#pragma once

#include "core/params/stage.h"
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace ramure {

/// The views of SPEC A10.
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
/// How much is done for a picture.
enum class Quality : std::uint8_t {
    Draft, ///< sun, shadow and sky light, nothing besides
    Good,  ///< with the dark inside of crowns, leaves lit as parts of them, and the response of film
    Best,  ///< with several samples a pixel and finer shadows: for pictures
};
/// Which sections show their frame as three arrows: tangent blue, normal red, binormal green.
enum class FrameDisplay : std::uint8_t { None, Selection, All };

/// How a mode shows the branches.
enum class Shown : std::uint8_t { Lines, Tubes, Surface, Texture };

/// A row: the action's id is "view." and the name.
template <class Mode> struct ModeRow
{
    Mode mode;
    const char* action; ///< "view.skeleton"
    const char* icon;   ///< name in resources/icons
    const char* text;   ///< English, with a mnemonic, context "Actions"
    const char* tip;    ///< tooltip like the text; null: the text serves
    [[nodiscard]] const char* name() const { return action + std::string_view("view.").size(); }
};
struct DisplayModeRow : ModeRow<DisplayMode>
{
    Shown shown;
    Stage stage; ///< the last one whose result is needed
};

/// In the order of the menu; the first nine have the keys Alt+1, Alt+2 ...
std::span<const DisplayModeRow> displayModes();
std::span<const ModeRow<ShadingMode>> shadingModes();
std::span<const ModeRow<Quality>> qualities();

const DisplayModeRow& rowOf(DisplayMode mode);
/// Returns the mode with this name on the command line: "mesh".
std::optional<DisplayMode> displayModeFromName(std::string_view name);

} // namespace ramure
