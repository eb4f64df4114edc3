/// \file
/// A person of 1.8 m beside the first tree, who shows how large everything is.
#pragma once

#include "widgets/view/render/render_scene.h"

namespace ramure {

inline constexpr double figureHeight = 1.8; ///< m

/// Returns the figure as a mesh with normals: its soles at y = 0, in the middle of the origin, looking along
/// +Z.
TriangleMesh figureMesh();

/// Adds the figure to \p scene, a step beside the foot of its first tree; without a tree, beside the middle
/// of what there is. It throws a shadow, and is neither picked nor framed. \param trunks where trees stand
/// (world) and how thick they are there (m)
void addFigure(RenderScene& scene, const std::vector<Foot>& trunks);

} // namespace ramure
