/// \file
/// Texture coordinates of a branch mesh: each tube unrolled along its own axis (SPEC A9).
///
/// u goes around a tube, v along it, both in tiles: a texture that repeats after every tile fits. One seam
/// per tube, from the valley of its fork to its tip; a whole number of tiles goes around, so that the picture
/// meets itself along all of it. The number stays from where an axis begins to its tip, so that tiles grow as
/// the wood does and are never cut off: it changes at forks alone, by about as much as what goes around does,
/// in the valley where there is new bark. Along a tube and into its children, on the arc of the parent's last
/// cross-section that a child shares, coordinates go on (u up to whole tiles). Roots, and limbs that leave a
/// thicker stem to its side, begin anew, their tiles as large as the root of their radius says. Where a tube
/// bends, tiles are smaller on the inside, so that squares stay squares. Flat ends and tips are mapped as
/// discs.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/surface/mesher/branch_mesh.h"
#include <glm/vec2.hpp>

namespace ramure {

/// Coordinates per corner of a triangle: positions are never split, equal coordinates of a vertex are stored
/// once.
struct TextureCoordinates
{
    std::vector<glm::vec2> uv;       ///< tiles
    std::vector<Index> vertex;       ///< per coordinate: the vertex of the mesh
    std::vector<float> radius;       ///< per coordinate: m, of the wood there, which says how old its bark is
    std::vector<glm::uvec3> corners; ///< per triangle of the mesh: its corners' coordinates
    double tileSize = 0.0;           ///< m, where the thickest root begins
    Index apart = 0; ///< triangles with coordinates of their own: where the mesh itself is folded
    bool operator==(const TextureCoordinates&) const = default;
};

/// The mesh with one vertex per coordinate, for what knows no other texture coordinates: graphics cards.
TriangleMesh splitByTexture(const BranchMesh& mesh, const TextureCoordinates& coordinates);

/// Gives the mesh that they are of its coordinates, and each vertex the radius of the thickest wood there.
void wear(TriangleMesh& mesh, const TextureCoordinates& coordinates);

/// A tile size of 0 lets four tiles go around the thickest root. There are four at least around a root, and
/// two around any branch. One pass, in time that grows as the mesh does. Errors: those of checkPart; Invalid
/// (a tile too small for the tree, path "texture.tileSize"; triangles without tubes); Cancelled.
Expected<TextureCoordinates> textureCoordinates(const BranchMesh& mesh, const TextureParams& params,
                                                const Progress& progress = {});

} // namespace ramure
