/// \file
/// A scene of which only some nodes are seen.
#pragma once

#include "core/scene/scene.h"
#include <span>

namespace ramure {

/// Hides all nodes but these and their descendants, which are shown even if they were hidden. Their ancestors
/// stay as places without shapes. Unknown ids are ignored.
void showOnly(Scene& scene, std::span<const NodeId> chosen);
/// Whether anything is shown that has a shape: a tree, an arm, a terrain, a mesh.
bool showsAnything(const Scene& scene);

} // namespace ramure
