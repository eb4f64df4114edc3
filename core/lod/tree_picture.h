/// \file
/// The last level of a tree: crossed cards that show the whole of it, each from its side.
#pragma once

#include "core/base/error.h"
#include "core/lod/card_atlas.h"

namespace ramure {

/// Cards that stand, evenly turned about the trunk.
inline constexpr int billboardCards = 3;

struct TreePicture
{
    std::shared_ptr<const CardAtlas> atlas;
    TriangleMesh cards; ///< two triangles each, with normals and coordinates
};

/// Cards around all that the surfaces show. Of copies, the leaves, each card has those that are near to it:
/// where several cards are behind each other they show as many as the tree has. \param surfaces in the space
/// of the tree. \param foot where the cards cross. Error: Invalid (the surfaces show nothing).
Expected<TreePicture> treePicture(const std::vector<ShownSurface>& surfaces, const glm::dvec3& foot);

} // namespace ramure
