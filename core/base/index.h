/// \file
/// Indices of branches, vertices and faces are 32 bits wide everywhere.
#pragma once

#include <cstdint>

namespace ramure {

using Index = std::uint32_t;
inline constexpr Index noIndex = 0xFFFFFFFFu;

} // namespace ramure
