/// \file
/// Arms at a time, as inverse kinematics has turned them by then: for files and pictures. The editor plays
/// with core/session/player.h, which gives the same angles.
#pragma once

#include "core/base/progress.h"
#include "core/scene/scene.h"
#include <map>
#include <memory>

namespace ramure {

/// Keeps one run per arm, so that the frames of a sequence cost one run together. Not thread-safe.
class MovingArms
{
public:
    /// \param timeline says whether, and where, the end of a loop blends into its beginning.
    explicit MovingArms(const TimelineSettings& timeline = {});
    ~MovingArms();
    MovingArms(const MovingArms&) = delete;
    MovingArms& operator=(const MovingArms&) = delete;

    /// The joints of an arm at a time: those it has, as their tracks have them, turned towards its target
    /// where it follows one; at 0 s they stand as they are. Errors: Invalid (checkArm; a time that is no
    /// number or beyond a day), Cancelled.
    Expected<std::vector<ArmJoint>> jointsAt(const Node& arm, double seconds, const Progress& progress = {});
    /// The scene with all its arms turned so. Errors as above, path = the arm's name.
    Expected<Scene> at(const Scene& scene, double seconds, const Progress& progress = {});

private:
    struct Run;
    TimelineSettings m_timeline;
    std::map<NodeId, std::unique_ptr<Run>> m_runs;
};

} // namespace ramure
