/// \file
/// The demo of recipes: five trees that no generator grows alone.
#pragma once

#include "core/scene/scene.h"

namespace ramure {

/// Limbs of an oak on a drawn trunk, twigs of a grammar on colonised limbs, two sources on one parent, an old
/// oak by modifiers alone, and two stems on one foot.
Scene recipeDemo();

} // namespace ramure
