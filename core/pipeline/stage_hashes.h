/// \file
/// One hash per stage of a tree, made from all inputs of the stage: equal hashes mean equal results. The
/// parameter table says which stage a parameter affects first.
#pragma once

#include "core/params/node_params.h"
#include "core/params/stage.h"
#include <array>

namespace ramure {

class StageHashes
{
public:
    explicit StageHashes(const NodeParams& params);

    /// Returns the hash of all inputs of a stage, including the stages before it. Placement and Motion have
    /// none here, because the pipeline does not make them.
    [[nodiscard]] std::uint64_t operator[](Stage stage) const
    {
        return m_hashes[static_cast<std::size_t>(stage)];
    }

    /// Hash of the inputs of the generator, before any edit.
    [[nodiscard]] std::uint64_t grown() const { return m_grown; }

    /// Of what a growing tree lives by, whatever its age: trees of one life are one tree at several ages. 0:
    /// it does not grow by years.
    [[nodiscard]] std::uint64_t life() const { return m_life; }

private:
    std::uint64_t m_grown = 0, m_life = 0;
    std::array<std::uint64_t, stageCount> m_hashes{};
};

/// Equal where bark looks the same: of all values that the table has of bark, but for its image files.
std::uint64_t barkHash(const BarkParams& bark, std::uint64_t version = 0);

} // namespace ramure
