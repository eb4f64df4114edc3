/// \file
/// Gestures that belong to a step of undo that is there already.
#pragma once

#include "core/document/commands.h"

namespace ramure {

/// When \p gesture, which is held, is kept, it does not become a step of its own: the step that is the last
/// one now takes it in. Where the file was saved meanwhile, or something else was done, it is one of its own.
void joinToLastStep(Document& document, GestureId gesture);

} // namespace ramure
