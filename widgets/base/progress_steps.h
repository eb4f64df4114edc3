/// \file
/// What progress bars have in common.
#pragma once

namespace ramure {

inline constexpr int progressSteps = 1000; ///< of a bar, from nothing to all
inline constexpr int patienceMs = 300;     ///< before one is shown in a line of the window

} // namespace ramure
