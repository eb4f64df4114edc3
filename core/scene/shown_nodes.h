/// \file
/// A scene of which only some nodes are seen.
#pragma once

#include "core/scene/scene.h"
#include <span>

namespace ramure {

/// Hides all but these nodes and what is below them; they are shown even where they were hidden. What is
/// above them stays as a place without a shape of its own. Ids that are unknown count for nothing.
void showOnly(Scene& scene, std::span<const NodeId> chosen);
/// Whether anything is shown that has a shape: a tree, an arm, a terrain, a mesh.
bool showsAnything(const Scene& scene);

} // namespace ramure
