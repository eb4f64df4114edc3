/// \file
/// Which drag moves the camera, in each navigation style; and what it does to it.
#pragma once

#include "widgets/base/theme/navigation_style.h"
#include "widgets/view/render/camera.h"
#include <QPointF>
#include <QSize>

namespace ramure {

enum class CameraDrag : quint8 { None, Orbit, Pan, Zoom };

/// What a drag with \p button does to the camera. Alt+left orbits in both styles.
CameraDrag cameraDragFor(NavigationStyle style, Qt::MouseButton button, Qt::KeyboardModifiers modifiers);

/// Applies a drag of \p pixels (logical, y down) in a picture of \p size.
void applyDrag(Camera& camera, CameraDrag drag, QPointF pixels, QSize size);

/// Distance factor of a wheel turn in eighths of a degree: 120 = one notch of a usual mouse.
double wheelFactor(double eighths);

} // namespace ramure
