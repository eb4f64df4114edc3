/// \file
/// Which drags of the mouse turn, move and zoom the view.
#pragma once

#include <cstdint>

namespace ramure {

enum class NavigationStyle : std::uint8_t {
    Blender, ///< middle drag orbits, Shift+middle pans, Ctrl+middle zooms
    Maya,    ///< Alt+left orbits, Alt+middle pans, Alt+right zooms
};

} // namespace ramure
