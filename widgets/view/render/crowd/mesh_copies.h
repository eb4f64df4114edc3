/// \file
/// Leaves and apples as copies of one small mesh each. They are drawn instead of the merged mesh that files
/// and checks use.
#pragma once

#include "core/math/box.h"
#include "core/surface/foliage/foliage.h"
#include <array>
#include <cstdint>
#include <glm/vec4.hpp>
#include <memory>
#include <vector>

namespace ramure {

/// One copy, in the layout that the vertex shader reads.
struct MeshCopy
{
    glm::vec3 position{0.0f};
    float size = 1.0f;
    glm::vec4 turn{0.0f, 0.0f, 0.0f, 1.0f}; ///< a quaternion, x y z w
    Index branch = noIndex;
    glm::u8vec4 tint{255}; ///< sRGB, times the shape's own
};

/// How much is drawn of each copy.
enum class LeafDetail : std::uint8_t {
    Least, ///< a few triangles (far_shape.h): from far away
    Few,   ///< a leaf's outline
    All,
};

/// Any beginning of the copies is spread over the whole tree: fewer of them still are its crown.
struct MeshCopies
{
    struct Faces
    {
        Index from = 0, count = 0;
    };
    TriangleMesh shape;               ///< once in each detail, the finest first
    std::array<Faces, 3> detail;      ///< faces of the shape, by LeafDetail
    float reach = 0.0f;               ///< m, across the largest copy
    std::vector<glm::u8vec4> colours; ///< sRGB, per vertex of the shape; empty: white
    std::vector<MeshCopy> copies;

    [[nodiscard]] Faces faces(LeafDetail how = LeafDetail::All) const { return detail[std::size_t(how)]; }
    /// Which of the merged mesh's pieces a copy is.
    [[nodiscard]] std::size_t pieceOf(std::size_t copy) const;
};

/// Returns a mesh as the shape of copies that somebody else places; there are none yet. \pre it has normals
MeshCopies shapeOf(const TriangleMesh& mesh);

/// Around all copies of a mesh, as the merged mesh has it.
Box boxAround(const std::vector<FoliageItem>& items, const TriangleMesh& one);

/// Nothing where there are no items. \param shown per branch, whether it is; empty: all are.
MeshCopies leafCopies(const Foliage& foliage, double alpha, FoliageModel model,
                      const std::vector<bool>& shown = {});
MeshCopies appleCopies(const Foliage& foliage, double alpha, FoliageModel model,
                       const std::vector<bool>& shown = {});

} // namespace ramure
