/// \file
/// The demo scenes of SPEC B3.
#pragma once

#include "core/base/error.h"
#include "core/scene/scene.h"
#include <span>
#include <string_view>

namespace ramure {

struct DemoScene
{
    const char* name;  ///< "MovingCylinder": `demo:MovingCylinder` on the command line
    const char* label; ///< English, context "core"
    Scene (*make)();
};

std::span<const DemoScene> demoScenes();
/// Error: Unknown, with the names there are.
Expected<Scene> demoScene(std::string_view name);

} // namespace ramure
