/// \file
/// The objects that tools work with. They know no window, so tools are tested without one.
#pragma once

#include "core/qt/document/document.h"
#include "core/qt/session/arm/arm_reach.h"
#include "core/qt/session/motion/auto_key.h"
#include "core/qt/session/motion/player.h"
#include "widgets/view/tools/gizmo_settings.h"
#include "widgets/view/tools/hand_settings.h"
#include "widgets/view/tools/limb_finder.h"
#include "widgets/view/tools/limb_pose.h"
#include "widgets/view/tools/tool_host.h"

namespace ramure {

class PendingPick;

/// How long a press or a click may hold the interface up.
inline constexpr std::chrono::milliseconds pickPatience(8);
/// The same of a press that shapes a tree: it cannot be put off, as it goes on as a drag.
inline constexpr std::chrono::milliseconds shapePatience(250);

/// Nothing is owned except for objects that the tools make.
struct ToolContext
{
    ToolHost& host;
    Document& document;
    GizmoSettings& gizmo;
    HandSettings& hand;
    ArmReach& reach;
    Player* player = nullptr;               ///< null: nothing plays
    AutoKey* keys = nullptr;                ///< null: no edit becomes a key
    std::function<QString()> gestureKeys{}; ///< the keys that begin to move, rotate and scale: "G R S"
    PendingPick* picks = nullptr;

    /// A limb that follows the hand, from then on until its mesh is shown.
    std::unique_ptr<LimbPose> limbPose{};

    LimbFinder limbs{}; ///< finds limbs under the cursor

    NodeId hoverNode = noNode; ///< under the cursor while nothing goes on
    Index hoverBranch = noIndex;

    /// To be called when its mesh is shown.
    void forgetLimbAtRest()
    {
        if (limbPose && limbPose->isRest())
            limbPose.reset();
    }
    [[nodiscard]] bool isPlaying() const { return player && player->isPlaying(); }
    [[nodiscard]] double seconds() const { return player ? player->timeSeconds() : 0.0; }
    /// While everything moves, the object under the cursor is not determined: it may be a branch.
    [[nodiscard]] bool isOverBranch() const
    {
        return isPlaying() || (document.scene().find(hoverNode) && hoverBranch != noIndex);
    }
};

} // namespace ramure
