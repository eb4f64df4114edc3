/// \file
/// The trees that ship with the program: those of SPEC A1, and three of "The Algorithmic Beauty of Plants".
#pragma once

#include "core/base/error.h"
#include "core/params/param_def.h"
#include <span>
#include <string_view>

namespace ramure {

struct Preset
{
    const char* name;        ///< "SmallTree": `preset:SmallTree` on the command line
    const char* description; ///< English, context "core"
    NodeParams params;
};

std::span<const Preset> presets();
/// Error: Unknown, with the names there are.
Expected<NodeParams> presetParams(std::string_view name);
/// The value that an unchanged node of this preset has; of no preset, or of one that there is not, the
/// default.
ParamValue presetValue(std::string_view preset, const ParamDef& def);

} // namespace ramure
