/// \file
/// A limb follows the hand at once: the scene that is shown is posed, while the mesh of the new bends is
/// still to be made, and afterwards until that mesh is shown. Knows which bends the scenes are made of; no
/// window.
#pragma once

#include "core/qt/session/motion/motion.h"
#include <QtGlobal>
#include <memory>
#include <vector>

namespace ramure {

class LimbPose
{
public:
    /// \param atGrab bends by branch of \p skeleton, of which the scene that is shown is made
    LimbPose(NodeId node, std::shared_ptr<const SimplifiedSkeleton> skeleton, std::vector<glm::dvec3> atGrab);

    /// What is to be seen from now on.
    void setBends(std::vector<glm::dvec3> bends);
    /// The document of \p revision has these bends.
    void noteEdit(quint64 revision, std::vector<glm::dvec3> bends);
    /// The scene of this serial number is made from the tree's result of \p revision.
    void noteWish(quint64 serial, quint64 revision);
    /// Notes that the scene of this wish is shown.
    void noteShown(quint64 serial);

    /// The hand has it: then it needs the pose, whatever is shown.
    void setHeld(bool held) { m_held = held; }
    [[nodiscard]] bool isHeld() const { return m_held; }
    /// Returns the bends of the document's latest edit.
    [[nodiscard]] const std::vector<glm::dvec3>& latest() const { return m_edits.back().bends; }
    /// The scene that is shown needs no pose.
    [[nodiscard]] bool isRest() const;
    /// \p frame (may be null) with the tree in its pose; the same as long as nothing changes.
    [[nodiscard]] std::shared_ptr<const MotionFrame> motion(const std::shared_ptr<const MotionFrame>& frame);
    [[nodiscard]] NodeId node() const { return m_node; }

private:
    struct Made
    {
        quint64 revision = 0;
        std::vector<glm::dvec3> bends;
    };
    [[nodiscard]] std::size_t editOf(quint64 revision) const;

    NodeId m_node;
    std::shared_ptr<const SimplifiedSkeleton> m_skeleton;
    std::vector<Made> m_edits;                             ///< ascending; the first is as it was grabbed
    std::vector<std::pair<quint64, std::size_t>> m_wishes; ///< serial, number of the edit
    std::size_t m_shown = 0;                               ///< number of the edit that is seen
    std::vector<glm::dvec3> m_bends;
    bool m_held = false;
    std::shared_ptr<const MotionFrame> m_motion, m_motionOf; ///< made; null: to be made. Made from
};

} // namespace ramure
