/// \file
/// Constants and functions that progress bars share.
#pragma once

namespace ramure {

inline constexpr int progressSteps = 1000; ///< full range of a bar
inline constexpr int patienceMs = 300;     ///< before one is shown in a line of the window

} // namespace ramure
