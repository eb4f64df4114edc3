/// \file
/// Where Bezier handles stand that are not put by hand, as Blender 3.4 computes them (ANIMATION 4.1).
#pragma once

#include "core/rig/tracks/key_list.h"
#include <utility>
#include <vector>

namespace ramure {

/// Sets the handles of one curve. Vector: a third of the way to the neighbour. Auto: the mean slope of both
/// sides, flat at the ends. AutoClamped: of all smooth curves the one without a jump of the acceleration,
/// never beyond the values of the keys. Aligned: turned into line with the other side, its length kept; where
/// both are aligned, with the handle before. Free ones stay.
/// \param keys sorted, no two at one time.
void settleHandles(std::vector<Key>& keys);
/// The same where handles were settled before and only the keys \p first .. \p last have changed.
void settleHandlesAround(std::vector<Key>& keys, std::size_t first, std::size_t last);
/// The keys that settleHandlesAround(first, last) changes or looks at: the first and the last of them.
std::pair<std::size_t, std::size_t> handlesReach(const KeyList<Key>& keys, std::size_t first,
                                                 std::size_t last);
/// The same for the four curves of orientations together.
std::pair<std::size_t, std::size_t> handlesReach(const KeyList<OrientationKey>& keys, std::size_t first,
                                                 std::size_t last);
/// One component (0 = w, 1 = x, 2 = y, 3 = z) of an orientation as a key of a number.
Key componentKey(const OrientationKey& key, std::size_t component);
/// The same for a curve that goes round: behind the last key comes the second one, before the first one the
/// last but one. The two ends are one place, \p shift apart in value, and smooth like any other.
/// \pre at least two keys
void settleHandlesOfLoop(std::vector<Key>& keys, double shift);

} // namespace ramure
