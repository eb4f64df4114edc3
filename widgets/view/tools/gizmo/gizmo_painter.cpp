// How the gizmo looks.
#include "widgets/view/tools/gizmo/gizmo_handles.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

namespace ramure {
namespace {

const QColor bright(255, 214, 64);
const QColor haloColour(16, 22, 28, 150); ///< around everything: coloured lines are seen on any ground

QColor inkOf(const QColor& colour, bool hovered)
{
    return hovered ? bright : colour;
}

void stroke(QPainter& painter, const QPolygonF& line, const QColor& ink, double width)
{
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(haloColour, width + 2.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
    painter.setPen(QPen(ink, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
}

/// An arrow's head, or a scale's box.
void paintEnd(QPainter& painter, const QLineF& line, const QColor& ink, bool box)
{
    QPointF way = line.p2() - line.p1();
    way /= std::max(1e-6, std::hypot(way.x(), way.y()));
    const QPointF across(-way.y(), way.x()), end = line.p2();
    painter.setPen(QPen(haloColour, 1.2));
    painter.setBrush(ink);
    if (box)
        painter.drawPolygon(QPolygonF({end - 5.0 * way - 5.0 * across, end + 5.0 * way - 5.0 * across,
                                       end + 5.0 * way + 5.0 * across, end - 5.0 * way + 5.0 * across}));
    else
        painter.drawPolygon(
            QPolygonF({end + 9.0 * way, end - 6.0 * way - 6.0 * across, end - 6.0 * way + 6.0 * across}));
}

void paintAxes(QPainter& painter, const PickView& view, const GizmoPlace& place, bool boxes,
               const std::optional<GizmoHandle>& hovered)
{
    for (int axis = 0; axis < 3; ++axis) {
        const auto square = gizmoPlaneSquare(view, place, axis);
        if (!square)
            continue;
        const bool over = hovered == GizmoHandle{GizmoPart::Plane, axis};
        QColor ink = inkOf(gizmoColour(axis), over);
        painter.setPen(QPen(ink, 1.4));
        ink.setAlpha(over ? 190 : 96);
        painter.setBrush(ink);
        painter.drawPolygon(*square);
    }
    // Those further from the eye first.
    std::array<int, 3> order{0, 1, 2};
    const glm::dvec3 eye = gizmoSight(view, place.pivot);
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return glm::dot(eye, place.axes[a]) < glm::dot(eye, place.axes[b]); });
    for (const int axis : order) {
        const auto line = gizmoAxisLine(view, place, axis);
        if (!line)
            continue;
        const bool over = hovered == GizmoHandle{GizmoPart::Axis, axis};
        const QColor ink = inkOf(gizmoColour(axis), over);
        stroke(painter, QPolygonF({line->p1(), line->p2()}), ink, over ? 3.6 : 2.6);
        paintEnd(painter, *line, ink, boxes);
    }
}

} // namespace

void paintGizmo(QPainter& painter, const PickView& view, const GizmoPlace& place, TransformTool tool,
                const std::optional<GizmoHandle>& hovered)
{
    const auto centre = gizmoPixel(view, place.pivot);
    if (!transforms(tool) || !centre)
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    if (tool != TransformTool::Rotate) {
        paintAxes(painter, view, place, tool == TransformTool::Scale, hovered);
        const bool over = hovered && hovered->part == GizmoPart::Centre;
        painter.setPen(QPen(haloColour, 1.4));
        painter.setBrush(over ? bright : QColor(250, 250, 250, 225));
        if (tool == TransformTool::Scale)
            painter.drawRect(QRectF(*centre - QPointF(5.5, 5.5), QSizeF(11.0, 11.0)));
        else
            painter.drawEllipse(*centre, 6.0, 6.0);
        return;
    }
    const glm::dvec3 eye = gizmoSight(view, place.pivot);
    const bool overView = hovered && hovered->part == GizmoPart::View;
    stroke(painter, gizmoRing(view, place, eye, gizmoViewRingReach, false),
           inkOf(QColor(245, 245, 245), overView), overView ? 2.8 : 1.6);
    for (int axis = 0; axis < 3; ++axis) {
        const bool over = hovered == GizmoHandle{GizmoPart::Axis, axis};
        stroke(painter, gizmoRing(view, place, place.axes[axis], gizmoRingReach, true),
               inkOf(gizmoColour(axis), over), over ? 3.6 : 2.6);
    }
    painter.setPen(QPen(haloColour, 1.2));
    painter.setBrush(QColor(250, 250, 250, 225));
    painter.drawEllipse(*centre, 3.5, 3.5);
}

} // namespace ramure
