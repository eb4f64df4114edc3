/// \file
/// What each step did to a tree.
#pragma once

#include "core/base/error.h"
#include <cstdint>
#include <vector>

namespace ramure {

enum class EditState : std::uint8_t {
    Off,        ///< switched off: its place was not searched
    Frozen,     ///< did not run: a later step holds its result
    Waits,      ///< it belongs to a later age of the tree
    ByAddress,  ///< acts where it was made
    ByLikeness, ///< acts on a limb that resembles its target
    Unplaced,   ///< there is nothing like it
    Idle,       ///< its limb exists, but the step can do nothing to it
};

struct EditOutcome
{
    std::uint64_t id = 0; ///< TreeEdit::id
    EditState state = EditState::Off;
    Error why{};               ///< Unplaced and Idle
    std::uint64_t address = 0; ///< address of the axis it found in this tree; 0: none
    double seconds = 0.0;      ///< time that it took
    /// Addresses of the axes that its condition selected; empty if it has none.
    std::vector<std::uint64_t> axes{};
};

/// One per edit, in their order.
using EditReport = std::vector<EditOutcome>;

} // namespace ramure
