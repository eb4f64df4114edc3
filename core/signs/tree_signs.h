/// \file
/// The signs by which wood and growth are told from a drawing: what foresters have published of each, and
/// what it is on one tree.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/params/node_params.h"
#include "core/presets/presets.h"
#include <limits>
#include <string>
#include <vector>

namespace ramure {

enum class SignState : std::uint8_t {
    NotModelled, ///< the program does not make it
    Absent,      ///< the tree has too little of what would be measured
    NoBand,      ///< measured, but nothing is published to compare it with
    Inside,      ///< of its band
    Outside,     ///< of it
};
/// "inside", "outside", "no band", "absent", "not modelled"
const char* nameOf(SignState state);

struct TreeSign
{
    const char* key = "";   ///< "branchCollar"
    const char* label = ""; ///< English: "branch collar"
    const char* unit = "";  ///< "years", or nothing
    SignState state = SignState::NotModelled;
    double value = 0.0;                                               ///< of Inside, Outside and NoBand
    double low = 0.0, high = std::numeric_limits<double>::infinity(); ///< the band, both included
    std::string note{};                                               ///< English: what was measured
};

/// Returns all signs in the order of the table. A tree that grows by years is grown several times: with light
/// from one side, leaning, and cut. \param species whose published measures count; may be null
/// Errors: those of TreePipeline::evaluate() and of growHistory().
Expected<std::vector<TreeSign>> treeSigns(const NodeParams& params, const Preset* species,
                                          const Progress& progress = {});

} // namespace ramure
