/// \file
/// One tree on the player's thread: its run, with the hand in it and with what was baked of it.
#pragma once

#include "core/evaluate/tree_run.h"
#include "core/qt/session/motion/motion_request.h"
#include "core/rig/physics/physics_bake.h"

namespace ramure {

class TreeActor
{
public:
    /// \param shape,params of the frame's time; physics moves on its own.
    Expected<void> prepare(const MotionTree& wanted, const TreeResult& shape, const NodeParams& params,
                           const MotionRequest& request, std::size_t memoryBytes);
    /// The baked run in place of what is computed, where it is of use. Error: why it is not; it is told once.
    Expected<void> takeBake(const MotionTree& wanted, const Progress& progress);
    void forgetHand(); ///< \pre prepare() went well
    [[nodiscard]] BakeState bakeState() const;
    void addBand(const TimelineSettings& timeline, std::vector<FrameState>& states) const;

    [[nodiscard]] TreeRun& run() { return m_run; }

private:
    [[nodiscard]] bool isBakeOfUse() const;
    [[nodiscard]] bool isBakeHere() const;

    TreeRun m_run;
    std::string m_bakeFile;
    int m_bakeVersion = 0;
    std::optional<BakeLabel> m_bake; ///< of a file that may become of use
    std::int64_t m_bakedStep = -1;   ///< the last one of the file, where it was loaded
    bool m_lookAtBake = false;       ///< tree, parameters or hand are others than when the file was looked at
};

} // namespace ramure
