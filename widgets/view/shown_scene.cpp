#include "widgets/view/shown_scene.h"

#include "core/rig/arm/arm_chain.h"
#include "core/rig/arm/arm_driver.h"

namespace ramure {

std::shared_ptr<const MotionFrame> ReachPose::motion(const std::shared_ptr<const MotionFrame>& frame,
                                                     const Scene& scene, const ArmProgress& progress)
{
    if (m_made && m_of == frame)
        return m_made;
    const Node* node = scene.find(progress.node);
    if (!node || node->kind != NodeKind::Arm || 2 * node->params.joints.size() != progress.angles.size())
        return frame;
    auto made = frame ? std::make_shared<MotionFrame>(*frame) : std::make_shared<MotionFrame>();
    std::vector<ArmJoint> joints = armSource(node->params, node->animation)(0.0).joints;
    setArmAngles(joints, progress.angles);
    made->nodes[progress.node] = armMotion(node->params, joints);
    m_of = frame;
    m_made = std::move(made);
    return m_made;
}

void ShownScene::update(const std::shared_ptr<const RenderScene>& rest,
                        const std::shared_ptr<const MotionFrame>& motion, const DefectMark& defect,
                        GizmoTrail& trail, const GizmoTrail::TreeOf& trees)
{
    if (m_scene && m_rest == rest && m_motion == motion && m_trail == trail.revision() &&
        m_defect == defect.revision())
        return;
    const bool moves = motion && MovingScene::moves(*rest, *motion);
    m_scene = moves ? std::make_shared<const RenderScene>(m_moving.moved(*rest, *motion)) : rest;
    m_rest = rest;
    m_motion = motion;
    m_trail = trail.revision();
    m_defect = defect.revision();
    if (defect.isShown()) {
        auto marked = std::make_shared<RenderScene>(*m_scene); // of shared blocks: quickly copied
        defect.addTo(*marked);
        m_scene = std::move(marked);
    }
    m_toPickIn = m_scene;
    if (trail.isEmpty())
        return;
    auto more = std::make_shared<RenderScene>(*m_scene);
    trail.addTo(*more, trees);
    m_scene = std::move(more);
}

} // namespace ramure
