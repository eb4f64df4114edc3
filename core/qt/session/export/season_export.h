/// \file
/// The four seasons of a tree's leaves and fruit, on their way to files.
#pragma once

#include "core/io/export_scene.h"
#include "core/params/node_params.h"
#include "core/surface/foliage/foliage.h"

namespace ramure {

/// Leaves and fruit in spring, summer, autumn and winter: one mesh each, whose materials change. What is bare
/// in a season is hidden then.
struct TreeSeasons
{
    std::shared_ptr<const ExportSeasons> leaves, fruit;
};
/// Adds the materials. \param placed as it stands in no season: its tints are tones. \pre leaves of a plant.
TreeSeasons seasonsOf(ExportScene& out, const Foliage& placed, const Skeleton& skeleton,
                      const NodeParams& params);
/// Gives the leaves and fruit of one tree their seasons; without a choice it is summer. \param suffix of the
/// names of their parts.
void tellSeasons(ExportScene& out, const std::string& suffix, const TreeSeasons& seasons);

} // namespace ramure
