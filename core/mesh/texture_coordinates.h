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
/// Where a tube bends so much at its first whole cross-section that it cannot be laid flat in one piece
/// without stretching 8 of 100 triangles by 1.25, it is cut there all around, and the seam below is
/// open: the picture slips at the bend by about a tile along it.
#pragma once

#include "core/mesh/branch_mesh.h"
#include <glm/vec2.hpp>

namespace ramure {

struct TextureOptions
{
    /// m, the side of one tile; 0 = the largest tile of which a few still go around the thinnest branch.
    double tileSize = 0.0;
};

/// Coordinates per corner of a triangle: positions are never split, equal coordinates of a vertex are stored
/// once.
struct TextureCoordinates
{
    std::vector<glm::vec2> uv;       ///< tiles
    std::vector<Index> vertex;       ///< per coordinate: the vertex of the mesh
    std::vector<glm::uvec3> corners; ///< per triangle of the mesh: its corners' coordinates
    double tileSize = 0.0;           ///< m, as used
    Index cut = 0;                   ///< tubes that are cut around their first whole cross-section
    Index apart = 0; ///< triangles with coordinates of their own: where the mesh itself is folded
    bool operator==(const TextureCoordinates&) const = default;
};

/// The mesh with one vertex per coordinate, for what knows no other texture coordinates: graphics cards.
TriangleMesh splitByTexture(const BranchMesh& mesh, const TextureCoordinates& coordinates);

/// Errors: Invalid (a tile size that is negative, not finite or too small for the tree; triangles without
/// tubes), Cancelled.
Expected<TextureCoordinates> textureCoordinates(const BranchMesh& mesh, const TextureOptions& options,
                                                const Progress& progress = {});

} // namespace ramure
