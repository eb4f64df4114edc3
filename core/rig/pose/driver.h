/// \file
/// What makes poses: tree physics, keyframe tracks, inverse kinematics. The timeline knows only this.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/rig/pose/pose.h"

namespace ramure {

/// Not thread-safe: a driver may keep what it computed on the way (physics does).
class PoseDriver
{
public:
    virtual ~PoseDriver() = default;
    [[nodiscard]] virtual std::size_t boneCount() const = 0;
    /// The pose at a time, which may lie anywhere: the same time always gives the same pose, in whatever
    /// order times are asked for. Times before 0 give that at 0. \p out is reused, not reallocated, where it
    /// fits. Errors: Invalid (not a finite time), Cancelled (\p out is unchanged then).
    virtual Expected<void> poseAt(double timeSeconds, Pose& out, const Progress& progress) = 0;

    PoseDriver() = default;
    PoseDriver(const PoseDriver&) = delete;
    PoseDriver& operator=(const PoseDriver&) = delete;
};

} // namespace ramure
