/// \file
/// The forms in which one tree of a crowd is drawn: levels of detail whose leaves are cards, and the
/// billboard.
#pragma once

#include "core/base/progress.h"
#include "core/pipeline/tree_pipeline.h"
#include "widgets/view/render/render_scene.h"

namespace ramure {

using CrowdForms = std::vector<CrowdForm>;

/// Returns the forms of a tree, in its own space. The same tree and parameters give the same forms. \param
/// tree with its simplified skeleton. Errors: those of treeLevels(); Cancelled.
Expected<CrowdForms> crowdForms(const TreeResult& tree, const NodeParams& params,
                                const Progress& progress = {});

/// Returns the form that is shown until those of a tree are made: an egg of the colour of its leaves.
/// \param box of the tree, not empty
CrowdForms standInForms(const Box& box, const TreeResult& tree, const NodeParams& params);

/// Returns the one form of meshes that have no levels, such as rocks: all of them. Mesh items that are copies
/// are left out.
CrowdForms plainForms(const std::vector<MeshItem>& items);

} // namespace ramure
