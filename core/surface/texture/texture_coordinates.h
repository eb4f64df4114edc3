/// \file
/// Texture coordinates of a branch mesh: each tube unrolled along its own axis (SPEC A9).
///
/// u goes around a tube, v along it, both in tiles: a texture that repeats after every tile fits. One seam
/// per tube, from the valley of its fork to its tip; a whole number of tiles goes around, so that the picture
/// meets itself there. Along a tube and into its children, on the arc of the parent's last cross-section that
/// a child shares, coordinates go on (u up to whole tiles). The valleys between siblings, where bark has its
/// ridges, are the borders. Where a child is thinner than its parent, the number of tiles around changes
/// between the valley and the child's first whole cross-section, on the edge of the seam there. Flat ends and
/// tips are mapped as discs.
///
/// A tube that bends so much at its first whole cross-section that more than 4 of 100 triangles would be
/// stretched by 1.25 cannot be laid flat as it is. There the two sides of its seam part, from the valley up
/// to the second whole cross-section: the picture does not meet itself across the seam there. Everywhere
/// else, along the tube and from its parent, it goes on unbroken.
#pragma once

#include "core/surface/mesher/branch_mesh.h"
#include <glm/vec2.hpp>

namespace ramure {

/// Coordinates per corner of a triangle: positions are never split, equal coordinates of a vertex are stored
/// once.
struct TextureCoordinates
{
    std::vector<glm::vec2> uv;       ///< tiles
    std::vector<Index> vertex;       ///< per coordinate: the vertex of the mesh
    std::vector<glm::uvec3> corners; ///< per triangle of the mesh: its corners' coordinates
    double tileSize = 0.0;           ///< m, as used
    Index open = 0;                  ///< tubes whose seam is open at a bend
    Index apart = 0; ///< triangles with coordinates of their own: where the mesh itself is folded
    bool operator==(const TextureCoordinates&) const = default;
};

/// The mesh with one vertex per coordinate, for what knows no other texture coordinates: graphics cards.
TriangleMesh splitByTexture(const BranchMesh& mesh, const TextureCoordinates& coordinates);

/// A tile size of 0 is the largest of which a few still go around the thinnest branch; without seams around,
/// the picture is stretched at bends. Errors: those of checkPart; Invalid (a tile too small for the tree,
/// path "texture.tileSize"; triangles without tubes); Cancelled.
Expected<TextureCoordinates> textureCoordinates(const BranchMesh& mesh, const TextureParams& params,
                                                const Progress& progress = {});

} // namespace ramure
