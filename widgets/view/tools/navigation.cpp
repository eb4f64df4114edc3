#include "widgets/view/tools/navigation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ramure {

Gesture gestureFor(NavigationStyle style, Qt::MouseButton button, Qt::KeyboardModifiers modifiers)
{
    const bool shift = modifiers.testFlag(Qt::ShiftModifier);
    const bool control = modifiers.testFlag(Qt::ControlModifier);
    if (modifiers.testFlag(Qt::AltModifier)) {
        // With one button only (a trackpad): Shift and Ctrl turn it into panning and zooming.
        switch (button) {
        case Qt::LeftButton:
            return shift ? Gesture::Pan : control ? Gesture::Zoom : Gesture::Orbit;
        case Qt::MiddleButton:
            return style == NavigationStyle::Maya ? Gesture::Pan : Gesture::Orbit;
        case Qt::RightButton:
            return Gesture::Zoom;
        default:
            return Gesture::None;
        }
    }
    if (button == Qt::LeftButton)
        return Gesture::Select;
    if (button == Qt::MiddleButton && style == NavigationStyle::Blender)
        return shift ? Gesture::Pan : control ? Gesture::Zoom : Gesture::Orbit;
    return Gesture::None;
}

void applyDrag(Camera& camera, Gesture gesture, QPointF pixels, QSize size)
{
    const double height = std::max(1, size.height());
    const double width = std::max(1, size.width());
    switch (gesture) {
    case Gesture::Orbit: {
        // Once across the height of the picture is half a turn.
        const double perPixel = std::numbers::pi / height;
        camera.orbit(-pixels.x() * perPixel, pixels.y() * perPixel);
        break;
    }
    case Gesture::Pan:
        camera.pan({2.0 * pixels.x() / width, -2.0 * pixels.y() / height}, width / height);
        break;
    case Gesture::Zoom:
        camera.zoom(std::exp((pixels.y() - pixels.x()) * 3.0 / height), camera.target);
        break;
    case Gesture::None:
    case Gesture::Select:
    case Gesture::Pull:
    case Gesture::Wind:
    case Gesture::Limb:
    case Gesture::Aim:
    case Gesture::Ring:
    case Gesture::Gizmo:
        break;
    }
}

double wheelFactor(double eighths)
{
    return std::pow(0.86, std::clamp(eighths / 120.0, -10.0, 10.0));
}

} // namespace ramure
