/// \file
/// Arms at a time, as inverse kinematics has turned them by then: for files and pictures. The editor plays
/// with core/session/player.h, which gives the same angles.
#pragma once

#include "core/evaluate/arm_run.h"
#include <map>

namespace ramure {

/// Keeps one run per arm, so that the frames of a sequence cost one run together. Not thread-safe.
class MovingArms
{
public:
    /// \param timeline says whether, and where, the end of a loop blends into its beginning.
    explicit MovingArms(const TimelineSettings& timeline = {});

    /// The joints of an arm at a time: those it has, as their tracks have them, turned towards its target
    /// where it follows one; at 0 s they stand as they are. Errors: Invalid (checkArm; a time that is no
    /// number or beyond a day), Cancelled.
    Expected<std::vector<ArmJoint>> jointsAt(const Node& arm, double seconds, const Progress& progress = {});
    /// The scene with all its arms turned so. Errors as above, path = the arm's name.
    Expected<Scene> at(const Scene& scene, double seconds, const Progress& progress = {});

private:
    TimelineSettings m_timeline;
    std::map<NodeId, ArmRun> m_runs;
};

} // namespace ramure
