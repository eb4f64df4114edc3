// The angles of an arm's joints, turned by the rings around them.
#include "widgets/base/texts/core_text.h"
#include "widgets/view/tools/arm/arm_rings.h"
#include "widgets/view/tools/tool_table.h"
#include <QCoreApplication>

namespace ramure {
namespace {

class JointTool : public Tool
{
    Q_DECLARE_TR_FUNCTIONS(ramure::JointTool)
public:
    using Tool::Tool;

    bool press(const ToolPoint& point) override;
    void drag(const ToolPoint& point) override;
    void release(const ToolPoint&) override { m_context.document.keepGesture(m_gesture); }
    void cancel() override { m_context.document.giveUpGesture(m_gesture); }
    [[nodiscard]] QString hint(Qt::KeyboardModifiers) const override
    {
        return tr("The joint turns · release: done");
    }
    [[nodiscard]] QString hintAt(const ToolPoint& point) const override
    {
        return ringUnder(point.view, point.pixel(), rings()) ? tr("Drag: turn the joint") : QString();
    }
    void paint(QPainter& painter, const PickView& view) override
    {
        paintRings(painter, view, rings(), isBusy() ? std::optional(m_ring) : std::nullopt);
    }

private:
    [[nodiscard]] std::vector<ArmRing> rings() const;

    std::size_t m_ring = 0; ///< of those of the active arm
    ArmRing m_atPress;
    double m_from = 0.0; ///< rad, where it was taken
    GestureId m_gesture = 0;
};

/// Of the active arm at rest; empty while it moves.
std::vector<ArmRing> JointTool::rings() const
{
    const NodeId active = m_context.document.selection().activeNode();
    const Scene& all = m_context.document.scene();
    const ArmProgress* progress = m_context.reach.progress();
    const Node* node = all.find(active);
    const bool follows =
        node && node->params.arm.follows && m_context.player && m_context.player->frame() > 0;
    const bool moves =
        follows || m_context.isPlaying() || (progress && progress->node == active && progress->moves);
    return moves || !all.isShown(active) || all.isLocked(active) ? std::vector<ArmRing>()
                                                                 : armRings(all, active, m_context.seconds());
}

bool JointTool::press(const ToolPoint& point)
{
    if (point.button != Qt::LeftButton || point.held != Qt::NoModifier)
        return false;
    const auto all = rings();
    const auto found = ringUnder(point.view, point.pixel(), all);
    const auto angle = found ? ringAngle(point.view, point.pixel(), all[*found]) : std::nullopt;
    if (!angle)
        return false;
    m_ring = *found;
    m_atPress = all[*found];
    m_from = *angle;
    m_gesture = newGesture();
    m_context.document.holdGesture(m_gesture);
    return true;
}

void JointTool::drag(const ToolPoint& point)
{
    const NodeId arm = m_context.document.selection().activeNode();
    const Node* node = m_context.document.scene().find(arm);
    const auto angle = ringAngle(point.view, point.pixel(), m_atPress);
    if (!node || !angle || m_atPress.joint >= node->params.joints.size())
        return;
    const double turned = turnedBy(m_atPress.angle, m_from, *angle);
    const Channel channel{ChannelPart::Joint, static_cast<std::uint8_t>(m_atPress.joint),
                          static_cast<ParamId>(jointAngleNumber(m_atPress.phi))};
    m_context.host.repaint();
    if (m_context.keys && m_context.keys->takes(arm, channel)) {
        if (const auto done = m_context.keys->set(arm, channel, turned, m_gesture); !done)
            m_context.host.raiseMessage(errorText(done.error()));
        return;
    }
    std::vector<ArmJoint> joints = node->params.joints;
    ArmJoint& joint = joints[m_atPress.joint];
    (m_atPress.phi ? joint.phi : joint.theta).angleRad = turned;
    edit::setJoints(m_context.document, arm, std::move(joints), tr("Turn joint %1").arg(m_atPress.joint + 1),
                    m_gesture);
}

} // namespace

std::unique_ptr<Tool> makeJointTool(ToolContext& context)
{
    return std::make_unique<JointTool>(context);
}

} // namespace ramure
