/// \file
/// Which mouse gesture means what, in each navigation style; and what a gesture does to the camera.
#pragma once

#include "widgets/base/navigation_style.h"
#include "widgets/view/render/camera.h"
#include <QPointF>
#include <QSize>

namespace ramure {

enum class Gesture : quint8 {
    None,
    Orbit,
    Pan,
    Zoom,
    Select,
    Pull,  ///< a branch that moves
    Wind,  ///< the arrow of the wind
    Limb,  ///< a branch at rest, the limb follows
    Aim,   ///< the target of an arm
    Ring,  ///< an angle of one of its joints
    Gizmo, ///< the selected nodes
};

/// The gesture that begins when \p button goes down. Left alone selects, Alt+left orbits, in both styles.
Gesture gestureFor(NavigationStyle style, Qt::MouseButton button, Qt::KeyboardModifiers modifiers);

/// Applies a drag of \p pixels (logical, y down) in a picture of \p size. Gestures that do not move the
/// camera change nothing.
void applyDrag(Camera& camera, Gesture gesture, QPointF pixels, QSize size);

/// Distance factor of a wheel turn in eighths of a degree: 120 = one notch of a usual mouse.
double wheelFactor(double eighths);

} // namespace ramure
