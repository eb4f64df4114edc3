/// \file
/// One of the items that a parameter offers for a choice.
#pragma once

namespace ramure {

struct EnumItem
{
    const char* name;  ///< "faithful"
    const char* label; ///< English, context "core"
};

} // namespace ramure
