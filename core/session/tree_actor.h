/// \file
/// One tree on the player's thread: its run, its skins, the hand, and what was baked of it.
#pragma once

#include "core/rig/physics/physics_bake.h"
#include "core/rig/physics/physics_cache.h"
#include "core/scene/loop_blend.h"
#include "core/session/motion_worker.h"

namespace ramure {

class TreeActor
{
public:
    Expected<void> prepare(const MotionTree& wanted, const MotionRequest& request, std::size_t memoryBytes);
    /// The baked run in place of what is computed, where it is of use. Error: why it is not; it is told once.
    Expected<void> takeBake(const MotionTree& wanted, const Progress& progress);
    [[nodiscard]] BakeState bakeState() const;
    /// \param blend of the loop's end into its beginning.
    Expected<NodeMotion> motionAt(std::int64_t step, const LoopBlend& blend, const Progress& progress);
    void addBand(const TimelineSettings& timeline, std::vector<FrameState>& states) const;

    std::unique_ptr<PhysicsCache> cache;

private:
    Expected<void> setTree(const MotionTree& wanted);
    Expected<void> setSkins(const MotionTree& wanted);
    void setParams(const PhysicsParams& params, bool live);
    void setTrackedParams(const MotionTree& wanted, const MotionRequest& request);
    [[nodiscard]] bool isBakeOfUse() const;
    [[nodiscard]] bool isBakeHere() const;

    std::shared_ptr<const SimplifiedSkeleton> m_skeleton;
    std::shared_ptr<const Foliage> m_foliage;
    double m_alpha = 0.0;
    PhysicsParams m_params;
    NodeAnimation m_animation;    ///< of the parameters, where the physics has tracks
    std::int64_t m_scripted = -1; ///< steps that have been told theirs
    bool m_mixed = false;         ///< parameters changed within the run
    std::string m_bakeFile;
    int m_bakeVersion = 0;
    std::optional<BakeLabel> m_bake; ///< of a file that may become of use
    std::int64_t m_bakedStep = -1;   ///< the last one of the file, where it was loaded
    bool m_lookAtBake = false;       ///< tree, parameters or hand are others than when the file was looked at
    NodeMotion m_motion;             ///< meshes and skins; the rest is of the frame made last
    bool m_smooth = false;
    Pose m_pose, m_earlier;
};

} // namespace ramure
