/// \file
/// OpenGL before and around the application object.
#pragma once

#include <QString>

namespace ramure {

/// Shared contexts and the default surface format (3.3 core, 24-bit depth, 4 samples). Call in main() before
/// the application object is made.
void prepareOpenGl();

/// Can this process open a window with an OpenGL 3.3 core context? Where it cannot, \p reason says why
/// (English, context "render"). Needs an application object. Asks once, then remembers nothing: cheap enough
/// for a start-up.
bool openGlAvailable(QString* reason = nullptr);

} // namespace ramure
