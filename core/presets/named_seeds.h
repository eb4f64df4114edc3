/// \file
/// Seeds of each species that are worth a look, named after the special features of their trees.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace ramure {

inline constexpr std::size_t namedSeedCount = 6;

/// English, context "core": of forty trees of a species, the one nearest to the mean in its three measures,
/// the highest, the lowest, the widest and the narrowest for their height, the one of the thickest stem.
extern const std::array<const char*, namedSeedCount> seedNames;

/// In the order of seedNames; nullptr of a preset that is no species.
const std::array<std::int64_t, namedSeedCount>* namedSeeds(std::string_view preset);

} // namespace ramure
