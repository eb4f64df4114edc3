/// \file
/// What is drawn: the scene at rest with everything in its place of now, and what is marked on it.
#pragma once

#include "core/qt/session/arm/arm_reach.h"
#include "widgets/view/defect_mark.h"
#include "widgets/view/gizmo_trail.h"
#include "widgets/view/moving_scene.h"
#include <utility>

namespace ramure {

/// A frame of motion with the arm that is on its way to a target in it.
class ReachPose
{
public:
    /// \p frame (may be null); the same as long as nothing changes.
    std::shared_ptr<const MotionFrame> motion(const std::shared_ptr<const MotionFrame>& frame,
                                              const Scene& scene, const ArmProgress& progress);
    void forget() { m_made.reset(); } ///< it is elsewhere now

private:
    std::shared_ptr<const MotionFrame> m_made, m_of; ///< made from
};

class ShownScene
{
public:
    /// \p motion may be null.
    void update(const std::shared_ptr<const RenderScene>& rest,
                const std::shared_ptr<const MotionFrame>& motion, const DefectMark& defect, GizmoTrail& trail,
                const GizmoTrail::TreeOf& trees);
    /// Null before the first.
    [[nodiscard]] const std::shared_ptr<const RenderScene>& scene() const { return m_scene; }
    /// The same without paths and ghosts: once, after it has become another one; else null.
    [[nodiscard]] std::shared_ptr<const RenderScene> takeToPickIn()
    {
        return std::exchange(m_toPickIn, nullptr);
    }

private:
    MovingScene m_moving;
    std::shared_ptr<const RenderScene> m_scene, m_toPickIn;
    // What they are made of.
    std::shared_ptr<const RenderScene> m_rest;
    std::shared_ptr<const MotionFrame> m_motion;
    quint64 m_trail = 0, m_defect = 0; ///< revisions
};

} // namespace ramure
