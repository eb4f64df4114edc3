/// \file
/// Short grass and fallen leaves around the feet of trees. Neither is picked, framed or exported.
#pragma once

#include "core/surface/foliage/foliage.h"
#include "widgets/view/render/render_scene.h"
#include <functional>

namespace ramure {

/// Returns the height of the ground below a place, in metres. Both are in the space of the copies.
using HeightOfGround = std::function<double(const glm::dvec2&)>;

/// Returns tufts of grass a hand high, dense near the feet and sparse farther out. They stand around the
/// feet, between whose roots the litter is. A foot has none if its roots reach less than a millimetre.
MeshCopies grassAround(const std::vector<Foot>& feet, const HeightOfGround& height);

/// Returns the leaves that lie below a crown: few in summer, more as the season takes them, and brown ones of
/// last year until new ones have come. Needles and shoots lie as none. \param foliage of the tree, of a
/// plant; \param placed the same in summer, for how wide it is; \param alpha m, as for placeFoliage; \param
/// foot of the tree, in its space
MeshCopies fallenLeaves(const Foliage& foliage, const Foliage& placed, double alpha, const Foot& foot,
                        const HeightOfGround& height);

/// Return the materials of the grass and of the fallen leaves, which the copies' tints darken.
Material grassMaterial();
Material fallenMaterial();

} // namespace ramure
