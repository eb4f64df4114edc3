/// \file
/// The formulas of Weber and Penn 1995 (doi 10.1145/218380.218427) for one stem: how long, how thick, at what
/// angle and with how many stems of its own. Lengths in metres, angles in rad; offsets o are measured along
/// the carrying stem from its foot. Nothing here draws random numbers.
#pragma once

#include "core/params/weber_penn_params.h"

namespace ramure {

/// The paper's ShapeRatio: length of a limb, as a share of the longest, at the \p ratio of the crown above
/// it (0 top, 1 base). Of Envelope, envelopeRatio.
double shapeRatio(const WeberPennParams& params, CrownShape shape, double ratio);
/// Half the width of the pruning envelope as a share of its widest, likewise; 0 outside 0..1.
double envelopeRatio(const WeberPennParams& params, double ratio);

/// Of a stem of \p level >= 1 that starts at \p offset on one of length \p parentLength, the share of whose
/// foot \p base is bare (m; of the trunk alone). \p share is the level's length, varied.
double stemLength(const WeberPennParams& params, std::size_t level, double share, double parentLength,
                  double offset, double base);
/// Down angle before chance varies it; where downAngleV is negative, by the place.
double stemDownAngle(const WeberPennLevel& level, double parentLength, double offset, double base);
/// Stems of \p level that a stem carries. \p length its own, \p parentLength and \p offset of what carries
/// it.
int stemCount(const WeberPennParams& params, std::size_t level, double length, double parentLength,
              double offset);
/// Radius at the share \p z of a stem's length without flare and lobes. \p radius at its foot.
double taperedRadius(double taper, double radius, double length, double z);
/// By what the trunk is thicker at the share \p z: flare, and its lobes on average.
double trunkFactor(const WeberPennParams& params, double z);

} // namespace ramure
