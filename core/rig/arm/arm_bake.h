/// \file
/// The motion of an arm as keys: what inverse kinematics does over a range of frames becomes tracks of the
/// joints' angles.
#pragma once

#include "core/rig/arm/arm_driver.h"
#include "core/rig/tracks/timeline_settings.h"
#include <optional>

namespace ramure {

/// From the first frame on every \c every-th one, and the last one in any case.
struct ArmBakeRange
{
    std::int64_t firstFrame = 0;
    std::int64_t lastFrame = 0; ///< not before firstFrame
    std::int64_t every = 1;     ///< at least 1
};

struct ArmBakeOptions
{
    double toleranceRad = 0.0; ///< keys that a straight line comes as near to are left out; 0 = a key a frame
    bool target = true;        ///< the target gets keys too, one each where it stands still
    std::optional<ArmBakeRange> range{}; ///< nothing: all frames of the timeline
};

/// The tracks of the arm with keys at frames of the range, LINEAR, angles without jumps from pi to -pi.
/// Tracks that are there already stay as they are. At every frame with a key the keyed arm, without inverse
/// kinematics, is where the solver had it: exactly, or to the tolerance in each angle.
/// Errors: Invalid (checkArm, an arm that follows no target, a tolerance that is negative or no number, a
/// range that ends before it begins or leaves the timeline's bounds, a step below 1),
/// those of ArmDriver::momentAt.
Expected<NodeAnimation> bakeArm(const NodeParams& params, const NodeAnimation& animation,
                                const TimelineSettings& timeline, const ArmBakeOptions& options,
                                const Progress& progress = {});

/// Indices of the points that are needed for straight lines between them to pass all others within
/// \p tolerance (Douglas and Peucker 1973, vertical distance); all where that is 0. First and last always;
/// ascending. One value throughout: the first alone. \pre as many times as values, ascending
std::vector<std::size_t> neededPoints(std::span<const double> times, std::span<const double> values,
                                      double tolerance);

} // namespace ramure
