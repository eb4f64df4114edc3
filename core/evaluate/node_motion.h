/// \file
/// How one tree or arm stands at a time: a rest mesh, its skin, and the bones of then. And what makes such
/// motions: the physics of a tree, the inverse kinematics of an arm.
#pragma once

#include "core/math/box.h"
#include "core/rig/arm/arm_solver.h"
#include "core/rig/physics/physics_state.h"
#include "core/rig/pose/skin.h"
#include "core/rig/tracks/timeline_settings.h"
#include "core/scene/scene.h"
#include <memory>
#include <vector>

namespace ramure {

/// What views show of an arm on its way.
struct ArmProgress
{
    NodeId node = noNode;
    std::vector<double> angles;
    std::vector<ArmLimit> limits; ///< by angle
    ArmFigures figures;           ///< of the solver
    double residual = 0.0;        ///< m, from the arm's own tip to the target
    std::vector<float> residuals; ///< of the arm, by ticks; at most 4096
    bool moves = false;
};

/// One tree or arm. Skins belong to exactly the meshes named here: a view that shows others shows them at
/// rest.
struct NodeMotion
{
    std::shared_ptr<const BranchMesh> mesh;
    std::shared_ptr<const TriangleMesh> leavesMesh, applesMesh;
    std::shared_ptr<const Skin> branches, leaves, apples;
    SkinMethod method = SkinMethod::DualQuaternion;
    /// One per branch of the simplified skeleton, then one per apple, then, where leaves swing on their
    /// petioles, one per leaf; tree space.
    std::shared_ptr<const std::vector<RigidTransform>> bones;
    Index firstLeaf = noIndex; ///< the bone of the first leaf; noIndex: they go with their branches
    Box box;                   ///< of the moved tree, tree space; a little generous
    PhysicsFigures figures;
    std::shared_ptr<const ArmProgress> arm; ///< of arms only
    bool reshapes = false;                  ///< of arms only: tracks change the mesh that follows the bones
    std::int64_t step = 0;                  ///< of the physics
    double stepSeconds = 0.0; ///< what one step took, mean over those computed for this frame; 0 = none was

    /// At rest there is nothing to deform.
    [[nodiscard]] bool moves() const { return step > 0; }
};

/// Not thread-safe: a run keeps what it computed on the way.
class NodeRun
{
public:
    virtual ~NodeRun() = default;
    /// At a time, which may lie anywhere: the same time always gives the same, in whatever order times are
    /// asked for; times before 0 give that at 0. \p timeline says whether, and where, the end of a loop
    /// blends into its beginning. Errors: Invalid (not a finite time, or too late), Cancelled.
    virtual Expected<NodeMotion> motionAt(double seconds, const TimelineSettings& timeline,
                                          const Progress& progress) = 0;

    NodeRun() = default;
    NodeRun(const NodeRun&) = delete;
    NodeRun& operator=(const NodeRun&) = delete;
};

} // namespace ramure
