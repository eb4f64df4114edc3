/// \file
/// Keys of branches that a turtle draws: a hash of the way from the root, by the branch's number among its
/// siblings. Part of the file format: values of branches are saved by key.
#pragma once

#include "core/base/index.h"
#include "core/math/random.h"
#include <cstdint>

namespace ramure {

/// In place of the parent's key, of roots.
inline constexpr std::uint64_t rootBranchKey = 0x52616D757265ull;

constexpr std::uint64_t branchKeyBelow(std::uint64_t parentKey, Index number)
{
    return mixBits(parentKey + 0x9E3779B97F4A7C15ull * (std::uint64_t(number) + 1));
}

} // namespace ramure
