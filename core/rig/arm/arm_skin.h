/// \file
/// The skin of an arm (SPEC C3): a cylinder along Z around the straight arm, or any mesh that stands there,
/// bound to the segments by the height of its vertices.
#pragma once

#include "core/params/arm_params.h"
#include "core/rig/pose/skin.h"
#include "core/surface/mesh/triangle_mesh.h"

namespace ramure {

/// A regular grid rolled up, with flat ends; as long as the arm. Each vertex's \c branch is the segment it is
/// nearest to. Texture coordinates: once around, and in circumferences along.
/// Errors: those of checkArm and checkPart.
Expected<TriangleMesh> armCylinder(std::span<const ArmJoint> joints, const ArmSkinParams& params);

/// Binds a mesh that surrounds the straight arm, its foot at the origin. Rigid: every vertex follows the
/// segment that its height lies in, below and above the arm the first and the last. Smooth: within \p window
/// of a joint (at most half of either segment) the two segments share it, linearly by height.
/// \pre checkArm; window is not negative
Skin bindArm(const TriangleMesh& mesh, std::span<const ArmJoint> joints, bool smooth, double window);

} // namespace ramure
