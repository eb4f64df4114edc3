/// \file
/// The trees that ship with the program: the presets of the coursework (SPEC A1), three trees of "The
/// Algorithmic Beauty of Plants", then species.
#pragma once

#include "core/base/error.h"
#include "core/params/param_def.h"
#include <array>
#include <span>
#include <string_view>

namespace ramure {

struct Preset
{
    const char* name;        ///< "SmallTree": `preset:SmallTree` on the command line
    const char* description; ///< English, context "core"
    NodeParams params;
    const char* latin = "";    ///< Latin name of a species: "Populus tremuloides"
    const char* group = "";    ///< English, context "core": they stand together
    std::array<int, 3> ages{}; ///< years, of one that grows by years: young, mature, old
};

/// Group by group.
std::span<const Preset> presets();
/// The four of SPEC A1, which are the first.
std::span<const Preset> courseworkPresets();
/// Error: Unknown, with the names there are.
Expected<NodeParams> presetParams(std::string_view name);
/// The value that an unchanged node of this preset has; of no preset, or of one that there is not, the
/// default.
ParamValue presetValue(std::string_view preset, const ParamDef& def);

} // namespace ramure
