/// \file
/// The foliage of a tree as lists of instances, for files.
#pragma once

#include "core/evaluate/node_motion.h"
#include "core/io/export_scene.h"
#include "core/params/node_params.h"
#include "core/surface/foliage/foliage.h"

namespace ramure {

/// Leaves and fruit of one tree, and what moves them.
struct FoliageInstances
{
    const Foliage& foliage;
    const Skeleton& skeleton;
    const NodeParams& params;
    const NodeMotion& motion; ///< without bones they are as they rest
    FoliageModel model;
    bool texture;       ///< the shapes have texture coordinates, where the model is fine
    bool rides = false; ///< they stay at rest and say with which bones they go, if there are some
};

/// Each copy where its piece of the merged mesh is. Name, node and material are the caller's.
ExportCopies leafInstances(const FoliageInstances& all);
ExportCopies appleInstances(const FoliageInstances& all);

} // namespace ramure
