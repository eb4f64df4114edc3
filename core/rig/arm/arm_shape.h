/// \file
/// The visible shape of an arm: a mesh around the straight arm, and the segments that its vertices follow.
#pragma once

#include "core/params/node_params.h"
#include "core/rig/pose/skin.h"
#include "core/surface/mesh/triangle_mesh.h"
#include <span>

namespace ramure {

struct ArmShape
{
    TriangleMesh mesh; ///< the arm's own space, straight along Z, the foot at 0
    Skin skin;
};

enum class ArmPart : std::uint8_t {
    Skin, ///< the bound mesh, or the cylinder of SPEC C3
    Rods, ///< joints and rods
};
/// Returns the part that the parameters let be seen.
inline ArmPart shownArmPart(const NodeParams& params)
{
    return params.armSkin.shown ? ArmPart::Skin : ArmPart::Rods;
}

/// Can an arm wear this mesh? Errors: Invalid (no triangles, a triangle of vertices that there are not,
/// positions that are not finite, over ten million vertices), path "mesh".
Expected<void> checkArmMesh(const TriangleMesh& mesh);

/// The mesh as large as the arm: one of its axes turned along Z, on the foot, in the middle, as high as the
/// straight arm; the same scale all around. Flat ones of no height are only moved.
TriangleMesh fittedToArm(TriangleMesh mesh, std::span<const ArmJoint> joints,
                         MeshAxis axis = MeshAxis::Longest);

/// Makes the shape to look at, with normals. \param bound null for the cylinder. Errors: those of armCylinder
/// and checkArmMesh.
Expected<ArmShape> armShape(const NodeParams& params, const TriangleMesh* bound, ArmPart part);
/// Makes the shape for files and checks: cylinder and rods are closed, with every position once and without
/// normals; a bound mesh is as it was read. It has the errors of armShape.
Expected<ArmShape> armSolid(const NodeParams& params, const TriangleMesh* bound, ArmPart part);

/// From the arm's own space (Z up) into that of its node (Y up).
TriangleMesh upright(TriangleMesh mesh);
/// The shape in the pose of the arm's joints, skinned as its parameters say, upright in its node (Y up).
TriangleMesh posedArm(const ArmShape& shape, const NodeParams& params);

} // namespace ramure
