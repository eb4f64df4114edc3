#include "widgets/view/tools/limb_pose.h"

#include "core/rig/pose/bend_pose.h"
#include <algorithm>

namespace ramure {

LimbPose::LimbPose(NodeId node, std::shared_ptr<const SimplifiedSkeleton> skeleton,
                   std::vector<glm::dvec3> atGrab)
    : m_node(node)
    , m_skeleton(std::move(skeleton))
    , m_edits{{0, atGrab}}
    , m_bends(std::move(atGrab))
{
}

void LimbPose::setBends(std::vector<glm::dvec3> bends)
{
    if (m_bends == bends)
        return;
    m_bends = std::move(bends);
    m_motion.reset();
}

void LimbPose::noteEdit(quint64 revision, std::vector<glm::dvec3> bends)
{
    m_edits.push_back({revision, std::move(bends)});
}

std::size_t LimbPose::editOf(quint64 revision) const
{
    const auto later =
        std::ranges::find_if(m_edits, [revision](const Made& edit) { return edit.revision > revision; });
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(later - m_edits.begin(), 1) - 1);
}

void LimbPose::noteWish(quint64 serial, quint64 revision)
{
    m_wishes.emplace_back(serial, editOf(revision));
}

void LimbPose::noteShown(quint64 serial)
{
    const auto wish = std::ranges::find(m_wishes, serial, &std::pair<quint64, std::size_t>::first);
    if (wish == m_wishes.end())
        return; // wished for before the grab
    m_shown = wish->second;
    m_wishes.erase(m_wishes.begin(), wish + 1);
    m_motion.reset();
}

bool LimbPose::isRest() const
{
    return !m_held && m_bends == m_edits[m_shown].bends;
}

std::shared_ptr<const MotionFrame> LimbPose::motion(const std::shared_ptr<const MotionFrame>& frame)
{
    if (m_motion && m_motionOf == frame)
        return m_motion;
    const Skeleton& skeleton = m_skeleton->skeleton;
    const std::vector<glm::dvec3>& atGrab = m_edits.front().bends;
    const std::vector<RigidTransform> wanted = bendPose(skeleton, atGrab, m_bends);
    auto bones = std::make_shared<std::vector<RigidTransform>>(wanted);
    if (m_shown > 0) {
        const std::vector<RigidTransform> shown = bendPose(skeleton, atGrab, m_edits[m_shown].bends);
        for (std::size_t b = 0; b < shown.size(); ++b)
            (*bones)[b] = wanted[b] * shown[b].inverse();
    }
    NodeMotion motion;
    double thickest = 0.0;
    for (Index b = 0; b < skeleton.size(); ++b) {
        motion.box.add(wanted[b].point(skeleton.p0[b]));
        motion.box.add(wanted[b].point(skeleton.p1[b]));
        thickest = std::max(thickest, skeleton.a0[b]);
    }
    motion.box = motion.box.grown(thickest + 0.1 * motion.box.radius()); // room for leaves
    motion.bones = std::move(bones);
    motion.method = SkinMethod::Rigid;
    motion.step = 1; // it moves
    auto made = frame ? std::make_shared<MotionFrame>(*frame) : std::make_shared<MotionFrame>();
    made->nodes[m_node] = std::move(motion);
    m_motionOf = frame;
    m_motion = std::move(made);
    return m_motion;
}

} // namespace ramure
