/// \file
/// The trees that ship with the program (SPEC A1).
#pragma once

#include "core/base/error.h"
#include "core/params/node_params.h"
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

} // namespace ramure
