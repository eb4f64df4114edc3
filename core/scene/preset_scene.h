/// \file
/// Trees of a preset, as nodes that remember it.
#pragma once

#include "core/scene/scene.h"
#include <string_view>

namespace ramure {

/// A tree with the preset's parameters and name; it has no id yet. Error: Unknown, with the names there are.
Expected<Node> presetTree(std::string_view preset);
/// A scene with this tree alone. Error: likewise.
Expected<Scene> presetScene(std::string_view preset);

} // namespace ramure
