/// \file
/// The formulas of Weber and Penn 1995 (doi 10.1145/218380.218427) for one stem: how long, how thick, at what
/// angle and with how many stems of its own. Lengths in metres, angles in rad; offsets o are measured along
/// the carrying stem from its foot. Nothing here draws random numbers.
#pragma once

#include "core/params/weber_penn_params.h"

namespace ramure {

/// Returns the paper's ShapeRatio: the length of a limb, as a share of the longest, at the \p ratio of the
/// crown above it (0 top, 1 base). For the shape Envelope it is envelopeRatio.
double shapeRatio(const WeberPennParams& params, CrownShape shape, double ratio);
/// Half the width of the pruning envelope as a share of its widest, likewise; 0 outside 0..1.
double envelopeRatio(const WeberPennParams& params, double ratio);

/// Returns the length of a stem of \p level >= 1 that starts at \p offset on a parent of length \p
/// parentLength. \p base (m) is the bare part at the parent's foot and counts for the trunk alone. \p share
/// is the varied length of the level.
double stemLength(const WeberPennParams& params, std::size_t level, double share, double parentLength,
                  double offset, double base);
/// Down angle before chance varies it; where downAngleV is negative, by the place.
double stemDownAngle(const WeberPennLevel& level, double parentLength, double offset, double base);
/// Returns the number of stems of \p level on a parent. \p length is the parent's; \p parentLength and \p
/// offset belong to the stem below it.
int stemCount(const WeberPennParams& params, std::size_t level, double length, double parentLength,
              double offset);
/// Radius at the share \p z of a stem's length without flare and lobes. \p radius at its foot.
double taperedRadius(double taper, double radius, double length, double z);
/// Returns the factor on the trunk's radius at the share \p z: flare, and its lobes on average.
double trunkFactor(const WeberPennParams& params, double z);

} // namespace ramure
