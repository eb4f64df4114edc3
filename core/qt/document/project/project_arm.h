/// \file
/// The "joints" of an arm in a project file, from the foot on; left out where they are the default's:
///
///     "joints": [
///         {"length": 1.5,
///          "phi": {"angle": 0.5, "limited": true, "max": 1, "min": -1, "mostSpeed": 2},
///          "theta": {"angle": 0.1}}
///     ]
///
/// Metres, radians, radians a second. What has its default is left out.
#pragma once

#include "core/base/error.h"
#include "core/params/arm_params.h"
#include <QJsonArray>

namespace ramure::json {

QJsonArray writeJoints(const std::vector<ArmJoint>& joints);
/// Errors: Invalid, path = the place inside, such as "joints[2].phi.min"; unknown keys too.
Expected<std::vector<ArmJoint>> readJoints(const QJsonValue& value);

} // namespace ramure::json
