/// \file
/// Levels move with the bones of the tree that they were made of: a run of its branches that became one bends
/// where they do, and leaves keep their own bones though there are fewer of them.
#pragma once

#include "core/lod/tree_levels.h"
#include "core/rig/pose/skin.h"

namespace ramure {

struct LevelSkins
{
    std::shared_ptr<const Skin> bark, leaves, apples; ///< null where the level has no such mesh
};

/// \param tree the simplified skeleton. \param firstLeaf the bone of its first leaf; noIndex: leaves go with
/// their branches. Errors: those of bindBranches.
Expected<LevelSkins> bindLevel(const TreeLevel& level, const Skeleton& tree, SkinMethod method,
                               Index firstLeaf);

} // namespace ramure
