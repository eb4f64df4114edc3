/// \file
/// What the stages of a tree are made from, each as one number: equal numbers, equal results. Made from the
/// parameter table, whose rows say the first stage that they affect.
#pragma once

#include "core/params/node_params.h"
#include "core/params/stage.h"
#include <array>

namespace ramure {

class StageHashes
{
public:
    explicit StageHashes(const NodeParams& params);

    /// Of all inputs of a stage, those of the stages before it included. Placement and Motion have none here:
    /// the pipeline does not make them.
    [[nodiscard]] std::uint64_t operator[](Stage stage) const
    {
        return m_hashes[static_cast<std::size_t>(stage)];
    }

    /// Of what the generator makes, before any edit.
    [[nodiscard]] std::uint64_t grown() const { return m_grown; }

private:
    std::uint64_t m_grown = 0;
    std::array<std::uint64_t, stageCount> m_hashes{};
};

/// Equal where bark looks the same: of all values that the table has of bark, but for its image files.
std::uint64_t barkHash(const BarkParams& bark, std::uint64_t version = 0);

} // namespace ramure
