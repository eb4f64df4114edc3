/// \file
/// What the large view of a leaf shows: one leaf, and beside it a twig with its leaves.
#pragma once

#include "core/params/node_params.h"
#include "widgets/view/render/render_scene.h"

namespace ramure {

/// In steps of the tree, so that all trees with the same leaves look the same. Never fails: what cannot be
/// placed is left out.
RenderScene leafScene(const NodeParams& params);

} // namespace ramure
