/// \file
/// Whether a parameter has keys.
#pragma once

#include "core/params/param_def.h"
#include <cstdint>

namespace ramure {

enum class KeyState : std::uint8_t {
    None,     ///< no keys
    Animated, ///< keys, but not at the frame on show
    Here,     ///< a key at the frame on show, of every node
};

/// True for parameters that may have keys, as the parameter table says, and for the placement of a node.
bool isKeyable(const ParamDef& def);

} // namespace ramure
