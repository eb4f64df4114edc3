/// \file
/// Skins: what of a rest mesh follows which bones, and the mesh that a pose makes of it. One description for
/// the processor (files, picking, checks) and for the vertex shader.
///
/// A bone is a branch of the skeleton that the mesh was made of; bones beyond those are loose things such as
/// apples. A vertex follows one to three bones. Vertices that follow each other and the same bones with the
/// same weights make a run: their transform is made once.
#pragma once

#include "core/params/skin_params.h"
#include "core/rig/pose/pose.h"
#include "core/surface/foliage/foliage.h"
#include "core/surface/mesher/branch_mesh.h"
#include <memory>
#include <span>

namespace ramure {

/// Unused places hold the first bone again with weight 0. Weights fall from first to last; their sum is 1.
struct SkinInfluence
{
    std::array<Index, 3> bone;
    std::array<float, 3> weight;
    bool operator==(const SkinInfluence&) const = default;
};

struct SkinRun
{
    Index firstVertex; ///< up to where the next run begins
    SkinInfluence influence;
    /// 1/m: how much weight passes from the first bone to the second along Z of the rest mesh; 0 where it
    /// does not change, or so slowly that normals need not know.
    float slope = 0.0F;
    bool operator==(const SkinRun&) const = default;
};

struct Skin
{
    std::vector<SkinRun> runs; ///< by ascending vertex; the first begins at 0
    Index vertices = 0;
    Index bones = 0; ///< a pose needs at least so many

    [[nodiscard]] const SkinInfluence& of(Index vertex) const; ///< O(log runs)
};

/// The skin of the continuous mesh. Rigid: a vertex follows its branch. Smooth: near the start of a branch it
/// follows its parent too, less and less over the height up to which the fork's tubes hang together, walls
/// the tubes they lie between; the cross-section that children start from follows the parent alone. Nothing
/// can tear, since forks share their vertices. \param skeleton that the mesh was made of; \param smooth for
/// Linear and DualQuaternion. Errors: Invalid where mesh and skeleton do not belong together.
Expected<Skin> bindBranches(const BranchMesh& mesh, const Skeleton& skeleton, bool smooth);

/// The places where the leaves of a plant hang: each hangs on the triangle of the bark nearest to its foot.
struct BarkAnchors
{
    Skin leaves; ///< each like a vertex of its own: what its triangle follows at that place
    /// Leaves whose triangle bends, since its corners follow different bones: how it goes exactly. Three
    /// corners of each, and their shares in the place.
    std::vector<Index> bent;
    std::vector<glm::vec3> corners;
    std::vector<glm::dvec3> shares;
    Skin cornerSkin;
};
/// \param bark bindBranches of that mesh. Errors: Invalid as above.
Expected<BarkAnchors> bindAnchors(std::span<const FoliageItem> items, const BranchMesh& branches,
                                  const Skeleton& skeleton, const Skin& bark);

/// Makes the skin of leaves or apples: each piece follows as a whole the skin of its branch at the place of
/// its anchor. \param items from which the mesh was made, in their order, equally many vertices each \param
/// smooth as in bindBranches. Errors: Invalid as above.
Expected<Skin> bindFoliage(const TriangleMesh& mesh, std::span<const FoliageItem> items,
                           const BranchMesh& branches, const Skeleton& skeleton, bool smooth);

/// Every vertex follows the branch that the mesh names for it.
Skin bindRigidly(const TriangleMesh& mesh);
/// Every piece follows a bone of its own: \p firstBone, firstBone + 1 … \param vertices of all pieces, which
/// have equally many. Errors: Invalid as above.
Expected<Skin> bindLoose(Index vertices, std::size_t pieces, Index firstBone);

/// Moves skins into one pose after the other; keeps its buffers.
class Deformer
{
public:
    Deformer();
    ~Deformer();
    Deformer(Deformer&&) noexcept;
    Deformer& operator=(Deformer&&) noexcept;

    /// The pose that is used from now on; it is copied.
    void setPose(std::span<const RigidTransform> pose, SkinMethod method);
    /// Positions and unit normals of a mesh in the pose. Normals follow the mixed transform: its cofactors
    /// for Linear, its rotation for the others; where a run has a slope, the cofactors of the whole
    /// deformation, which also leans as the weights change. Rest and result may not overlap; \p normals may
    /// be empty for none. \pre spans as long as the skin has vertices; the pose has at least skin.bones.
    void deform(std::span<const glm::vec3> restPositions, std::span<const glm::vec3> restNormals,
                const Skin& skin, std::span<glm::vec3> positions, std::span<glm::vec3> normals) const;

private:
    struct Bones;
    std::unique_ptr<Bones> m_bones;
};

/// A mesh in a pose, at once.
TriangleMesh deformed(const TriangleMesh& rest, const Skin& skin, std::span<const RigidTransform> pose,
                      SkinMethod method);

/// How a small rigid thing at \p place goes along: its place as skinMatrix has it, turned by the mean
/// rotation.
RigidTransform skinTransform(const SkinInfluence& influence, std::span<const RigidTransform> pose,
                             SkinMethod method, const glm::dvec3& place);
/// The transform of one influence: rigid for Rigid and DualQuaternion.
glm::dmat4 skinMatrix(const SkinInfluence& influence, std::span<const RigidTransform> pose,
                      SkinMethod method);

} // namespace ramure
