/// \file
/// What became of the edits of a tree.
#pragma once

#include "core/base/error.h"
#include <cstdint>
#include <vector>

namespace ramure {

enum class EditState : std::uint8_t {
    Off,        ///< switched off: nobody looked for its place
    Frozen,     ///< did not run: a later step holds what it made
    Waits,      ///< of a later age of the tree
    ByAddress,  ///< acts where it was made
    ByLikeness, ///< acts on what looks like it
    Unplaced,   ///< there is nothing like it
    Idle,       ///< its limb is there, but nothing can be done to it
};

struct EditOutcome
{
    std::uint64_t id = 0; ///< TreeEdit::id
    EditState state = EditState::Off;
    Error why{};               ///< Unplaced and Idle
    std::uint64_t address = 0; ///< of the axis in this tree that its target is; 0: none
    double seconds = 0.0;      ///< that it took
    /// Addresses of the axes that its condition named; empty where it has none.
    std::vector<std::uint64_t> axes{};
};

/// One per edit, in their order.
using EditReport = std::vector<EditOutcome>;

} // namespace ramure
