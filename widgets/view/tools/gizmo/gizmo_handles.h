/// \file
/// The handles of the transform gizmo: where they are on the screen, which one is under the cursor, how they
/// are drawn. Always of one size on the screen. Functions of cameras and plain data: tested without OpenGL.
#pragma once

#include "widgets/view/render/pick/pick_scene.h"
#include "widgets/view/tools/gizmo_settings.h"
#include <QColor>
#include <QLineF>
#include <QPolygonF>
#include <optional>

class QPainter;

namespace ramure {

/// The movement that a handle, or a locked axis, allows.
enum class GizmoPart : quint8 {
    Axis,   ///< along, about or stretched along one axis
    Plane,  ///< in the plane across an axis; scale: along the two axes of that plane
    Centre, ///< move: in the plane of the picture; scale: all ways alike
    View,   ///< turn: about the line of sight
};

struct GizmoHandle
{
    GizmoPart part = GizmoPart::Centre;
    int axis = 0; ///< 0, 1, 2 = x, y, z; of Axis and Plane
    bool operator==(const GizmoHandle&) const = default;
};

/// The place of the gizmo in the world.
struct GizmoPlace
{
    glm::dvec3 pivot{0.0};
    glm::dmat3 axes{1.0}; ///< unit, right angled
};

/// Logical pixels: of an axis seen from the side, of the rings.
inline constexpr double gizmoReach = 92.0, gizmoRingReach = 84.0, gizmoViewRingReach = 100.0;

/// Logical pixels from the upper left corner; nothing for points behind the eye.
std::optional<QPointF> gizmoPixel(const PickView& view, const glm::dvec3& world);
/// Metres of so many logical pixels at the pivot.
double gizmoMetres(const PickView& view, const GizmoPlace& place, double pixels);
/// A ring about the pivot, or the half of it that faces the eye.
QPolygonF gizmoRing(const PickView& view, const GizmoPlace& place, const glm::dvec3& axis, double pixels,
                    bool half);

/// From the pivot to the eye, unit.
glm::dvec3 gizmoSight(const PickView& view, const glm::dvec3& pivot);
/// Returns an axis, from near the middle to its end. Nothing if it is seen from its end.
std::optional<QLineF> gizmoAxisLine(const PickView& view, const GizmoPlace& place, int axis);
/// Returns the little square across an axis. Nothing if it is seen from its edge.
std::optional<QPolygonF> gizmoPlaneSquare(const PickView& view, const GizmoPlace& place, int axis);

/// The handle under the cursor; none with the tool Select. Axes seen from their end and planes seen from
/// their edge have no handle: nothing sensible could be dragged there.
std::optional<GizmoHandle> gizmoHandleAt(const PickView& view, const glm::dvec2& pixel,
                                         const GizmoPlace& place, TransformTool tool);
/// A point of the handle on the screen, for tests and for teaching: pressing there takes it.
std::optional<QPointF> gizmoGrip(const PickView& view, const GizmoPlace& place, TransformTool tool,
                                 const GizmoHandle& handle);

/// \param hovered drawn bright
void paintGizmo(QPainter& painter, const PickView& view, const GizmoPlace& place, TransformTool tool,
                const std::optional<GizmoHandle>& hovered);
/// The colours of x, y, z.
QColor gizmoColour(int axis);

} // namespace ramure
