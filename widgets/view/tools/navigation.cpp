#include "widgets/view/tools/navigation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ramure {

CameraDrag cameraDragFor(NavigationStyle style, Qt::MouseButton button, Qt::KeyboardModifiers modifiers)
{
    const bool shift = modifiers.testFlag(Qt::ShiftModifier);
    const bool control = modifiers.testFlag(Qt::ControlModifier);
    if (modifiers.testFlag(Qt::AltModifier)) {
        // With one button only (a trackpad): Shift and Ctrl turn it into panning and zooming.
        switch (button) {
        case Qt::LeftButton:
            return shift ? CameraDrag::Pan : control ? CameraDrag::Zoom : CameraDrag::Orbit;
        case Qt::MiddleButton:
            return style == NavigationStyle::Maya ? CameraDrag::Pan : CameraDrag::Orbit;
        case Qt::RightButton:
            return CameraDrag::Zoom;
        default:
            return CameraDrag::None;
        }
    }
    if (button == Qt::MiddleButton && style == NavigationStyle::Blender)
        return shift ? CameraDrag::Pan : control ? CameraDrag::Zoom : CameraDrag::Orbit;
    return CameraDrag::None;
}

void applyDrag(Camera& camera, CameraDrag drag, QPointF pixels, QSize size)
{
    const double height = std::max(1, size.height());
    const double width = std::max(1, size.width());
    switch (drag) {
    case CameraDrag::Orbit: {
        // Once across the height of the picture is half a turn.
        const double perPixel = std::numbers::pi / height;
        camera.orbit(-pixels.x() * perPixel, pixels.y() * perPixel);
        break;
    }
    case CameraDrag::Pan:
        camera.pan({2.0 * pixels.x() / width, -2.0 * pixels.y() / height}, width / height);
        break;
    case CameraDrag::Zoom:
        camera.zoom(std::exp((pixels.y() - pixels.x()) * 3.0 / height), camera.target);
        break;
    case CameraDrag::None:
        break;
    }
}

double wheelFactor(double eighths)
{
    return std::pow(0.86, std::clamp(eighths / 120.0, -10.0, 10.0));
}

} // namespace ramure
