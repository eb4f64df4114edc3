/// \file
/// Palms, ferns and rosettes: grammars that put their leaves where they belong. Internal to the presets.
#pragma once

#include "core/params/presets.h"
#include <vector>

namespace ramure {

std::vector<Preset> organPresets();

} // namespace ramure
