/// \file
/// A person of 1.8 m beside the first tree, who shows how large everything is.
#pragma once

#include "core/params/ground_plane.h"
#include "widgets/view/render/render_scene.h"

namespace ramure {

inline constexpr double figureHeight = 1.8; ///< m

/// Returns the figure as a mesh with normals: its soles at y = 0, in the middle of the origin, looking along
/// +Z.
TriangleMesh figureMesh();

/// The foot of a tree.
struct FigureTree
{
    glm::dvec3 foot{0.0};                ///< m, in the tree's space
    double radius = 0.0;                 ///< m, there
    glm::dmat4 world{1.0};               ///< of the tree
    std::optional<GroundPlane> ground{}; ///< that it stands on, in its space; nothing: level at its foot
};

/// Adds the figure to \p scene, a step beside the foot of a tree, on its ground; without a tree, beside the
/// middle of what there is. It throws a shadow, and is neither picked nor framed.
void addFigure(RenderScene& scene, const std::optional<FigureTree>& tree);

} // namespace ramure
