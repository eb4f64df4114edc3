/// \file
/// Pictures of the scene as a viewport shows it, without cube and overlays.
#pragma once

#include "core/base/error.h"
#include "widgets/view/viewport.h"
#include <QImage>

namespace ramure {

/// Null image where there is no OpenGL context.
[[nodiscard]] QImage screenshot(Viewport& view, const ViewPicture& wish = {});
/// Writes a file (PNG by the ending). Errors: Io, Unknown (ending, no picture).
Expected<void> saveScreenshot(Viewport& view, const QString& path, const ViewPicture& wish = {});
/// Puts a picture on the clipboard.
void copyScreenshot(Viewport& view);

} // namespace ramure
