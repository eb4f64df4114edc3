/// \file
/// How branches leave a fork: not at once with their own radius, which would leave a ledge around the end of
/// what carries them, but as wide as that end, and narrowing from there.
#pragma once

#include "core/surface/mesher/skeleton_normalise.h"

namespace ramure {

/// Sets MeshBranch::spread and spreadDecay of all branches but limbs beside a stem and what stands on a root
/// plate. All children of a fork begin so many times as wide as the thickest of them has to be to fill the
/// parent's end, at most mostSpread. What a branch has more than its own radius falls to 1/e within \p length
/// times the mean of the diameters that it begins with and that it has of its own; its children go on with
/// what is left at its end. \param length 0: every branch has its own radius everywhere.
void spreadAboveForks(NormalSkeleton& skeleton, double length);

/// The same of limbs beside a stem: they have a collar, so much wider than their own radius as \p collar says
/// within the stem's wood and where they leave it, which falls to 1/e within collarLength times their
/// diameter. Call it first: where a limb's first piece ends on its collar, what it carries goes on with it.
void makeCollars(NormalSkeleton& skeleton, double collar);

inline constexpr double collarLength = 0.75; ///< diameters

inline constexpr double mostSpread = 2.0; ///< of a branch's own radius, beyond it

/// Thin children that are no limbs around one stem leave as limbs a little below the fork. There the branch
/// that forks is divided: its upper part (MeshBranch::isPiece) goes straight on, has the same source, and is
/// the last child of the lower one. Those that point along the branch, would cross a sibling on their way, or
/// find no room on it, stay.
void partForks(NormalSkeleton& skeleton);

} // namespace ramure
