/// \file
/// Solids of the scene as shapes that trees are pruned to.
#pragma once

#include "core/params/tree_edit.h"
#include "core/scene/scene.h"

namespace ramure {

/// A primitive or an imported mesh as it stands at rest, in the space of a tree. A copy: whatever becomes of
/// the solid, the edit stays. Errors: Unknown (node), Invalid (no solid).
Expected<EditShape> meshShape(const Scene& scene, NodeId tree, NodeId solid);

} // namespace ramure
