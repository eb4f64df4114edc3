/// \file
/// How one tree or arm stands at a time: a rest mesh, its skin, and the bones of then. And what makes such
/// motions: the physics of a tree, the inverse kinematics of an arm.
#pragma once

#include "core/base/progress.h"
#include "core/math/box.h"
#include "core/rig/arm/arm_solver.h"
#include "core/rig/physics/physics_state.h"
#include "core/rig/pose/skin.h"
#include "core/rig/tracks/timeline_settings.h"
#include "core/scene/scene.h"
#include "core/surface/mesh/deferred_mesh.h"
#include <memory>
#include <vector>

namespace ramure {

/// An arm on its way to its target, for views.
struct ArmProgress
{
    NodeId node = noNode;
    std::vector<double> angles;
    std::vector<ArmLimit> limits; ///< by angle
    ArmFigures figures;           ///< the solver's figures
    double residual = 0.0;        ///< m, from the arm's own tip to the target
    std::vector<float> residuals; ///< distance left to the target, one per tick; at most 4096
    bool moves = false;
};

/// One tree or arm. Skins belong to exactly the meshes named here: a view that shows others shows them at
/// rest.
struct NodeMotion
{
    std::shared_ptr<const BranchMesh> mesh;
    DeferredMesh leavesMesh, applesMesh;
    std::shared_ptr<const Skin> branches, leaves, apples;
    SkinMethod method = SkinMethod::DualQuaternion;
    /// One per branch of the simplified skeleton, then one per apple, then, where leaves swing on their
    /// petioles, one per leaf; tree space.
    std::shared_ptr<const std::vector<RigidTransform>> bones;
    Index firstLeaf = noIndex; ///< the bone of the first leaf; noIndex: they go with their branches
    Box box;                   ///< bounds of the moved tree in tree space, slightly too large
    PhysicsFigures figures;
    std::shared_ptr<const ArmProgress> arm; ///< null unless the node is an arm
    bool reshapes = false;                  ///< only for arms: tracks change the mesh that follows the bones
    std::int64_t step = 0;                  ///< step of the physics
    double stepSeconds = 0.0; ///< mean time of the steps computed for this frame; 0 = none was computed

    /// At rest there is nothing to deform.
    [[nodiscard]] bool moves() const { return step > 0; }
};

/// Not thread-safe: a run keeps its intermediate results.
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
