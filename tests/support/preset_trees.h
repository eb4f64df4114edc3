/// \file
/// Skeletons of the presets, for suites that need real trees.
#pragma once

#include "core/base/error.h"
#include "core/skeleton/skeleton.h"
#include <cstdint>
#include <optional>
#include <string_view>

namespace ramure::test {

struct PresetTree
{
    std::string_view name;                     ///< as in presets()
    std::optional<std::uint64_t> stochastic{}; ///< rewrite with the probabilities and this seed
    std::optional<int> iterations{};           ///< instead of the preset's own
    bool simplified = true;                    ///< merge the straight runs as the preset says
};

/// Grammar, turtle and simplification, without the pipeline.
Expected<Skeleton> presetSkeleton(const PresetTree& tree);

} // namespace ramure::test
