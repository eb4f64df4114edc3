/// \file
/// The PNG files of maps that were made last: rows of a table, frames and trees with the same material share
/// them.
#pragma once

#include "core/io/material_maps.h"
#include <optional>

namespace ramure {

/// All that the bytes of some maps hang on.
class MapsKey
{
public:
    MapsKey(const BarkParams& bark, int size, std::span<const MaterialMap> kinds);
    /// \param season in hundredths, as it is in the file's name
    MapsKey(LeafShape leaf, int season, int size, std::span<const MaterialMap> kinds);
    [[nodiscard]] const std::string& text() const { return m_text; }

private:
    std::string m_text;
};

/// From any thread. Nothing, where they were not made yet or had to make room.
std::optional<std::vector<MadeMap>> findKeptMaps(const MapsKey& key);
/// Keeps up to 64 MiB; those that were not asked for longest go first. What alone is more is not kept.
void keepMaps(const MapsKey& key, const std::vector<MadeMap>& maps);

} // namespace ramure
