/// \file
/// Whether a parameter has keys.
#pragma once

#include <cstdint>

namespace ramure {

enum class KeyState : std::uint8_t {
    None,     ///< no keys
    Animated, ///< keys, but not at the frame on show
    Here,     ///< a key at the frame on show, of every node
};

} // namespace ramure
