#include "widgets/view/tools/gizmo/gizmo_handles.h"

#include "core/math/drag_maths.h"
#include <QColor>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace ramure {
namespace {

constexpr double planeFrom = 26.0, planeTo = 44.0; ///< logical pixels, of the little squares
constexpr double centreReach = 9.0;
constexpr double tolerance = 7.0;
constexpr double leastAxis = 0.12;  ///< of its length: shorter it is seen from its end
constexpr double leastPlane = 0.12; ///< cosine between its normal and the line of sight
constexpr int arcCorners = 64;

double squareLength(QPointF v)
{
    return v.x() * v.x() + v.y() * v.y();
}

double distanceTo(QPointF a, QPointF b, QPointF at)
{
    const QPointF way = b - a;
    const double square = squareLength(way);
    const double part = square > 0.0 ? std::clamp(QPointF::dotProduct(at - a, way) / square, 0.0, 1.0) : 0.0;
    return std::sqrt(squareLength(a + part * way - at));
}

double distanceTo(const QPolygonF& line, QPointF at)
{
    double least = 1e9;
    for (qsizetype i = 1; i < line.size(); ++i)
        least = std::min(least, distanceTo(line[i - 1], line[i], at));
    return least;
}

} // namespace

glm::dvec3 gizmoSight(const PickView& view, const glm::dvec3& pivot)
{
    if (view.camera.orthographic)
        return view.camera.backward();
    const glm::dvec3 way = view.camera.eye() - pivot;
    return glm::length(way) > 1e-12 ? glm::normalize(way) : view.camera.backward();
}

QColor gizmoColour(int axis)
{
    constexpr std::array<QRgb, 3> colours{0xffe8483f, 0xff62b83a, 0xff4a86f5};
    return QColor(colours[static_cast<std::size_t>(axis)]);
}

std::optional<QPointF> gizmoPixel(const PickView& view, const glm::dvec3& world)
{
    const auto at = view.pixel(world);
    return at ? std::optional(QPointF(at->x, at->y)) : std::nullopt;
}

double gizmoMetres(const PickView& view, const GizmoPlace& place, double pixels)
{
    return pixels * view.camera.metresPerPixel(place.pivot, view.size.y);
}

QPolygonF gizmoRing(const PickView& view, const GizmoPlace& place, const glm::dvec3& axis, double pixels,
                    bool half)
{
    const double radius = gizmoMetres(view, place, pixels);
    const glm::dvec3 eye = gizmoSight(view, place.pivot);
    glm::dvec3 zero = eye - glm::dot(eye, axis) * axis;
    half = half && glm::length(zero) > 0.1; // seen from its axis it is whole
    zero = glm::length(zero) > 1e-6 ? glm::normalize(zero) : anyPerpendicular(axis);
    const double reach = half ? 0.5 * std::numbers::pi : std::numbers::pi;
    QPolygonF line;
    for (int i = 0; i <= arcCorners; ++i) {
        const glm::dvec3 way = turnAbout(axis, reach * (2.0 * i / arcCorners - 1.0)) * zero;
        if (const auto at = gizmoPixel(view, place.pivot + radius * way))
            line << *at;
    }
    return line;
}

std::optional<QLineF> gizmoAxisLine(const PickView& view, const GizmoPlace& place, int axis)
{
    const auto from = gizmoPixel(view, place.pivot);
    const double reach = gizmoMetres(view, place, gizmoReach);
    const auto to = gizmoPixel(view, place.pivot + reach * place.axes[axis]);
    if (!from || !to || squareLength(*to - *from) < leastAxis * leastAxis * gizmoReach * gizmoReach)
        return std::nullopt;
    return QLineF(*from + (14.0 / gizmoReach) * (*to - *from), *to);
}

std::optional<QPolygonF> gizmoPlaneSquare(const PickView& view, const GizmoPlace& place, int axis)
{
    if (std::abs(glm::dot(gizmoSight(view, place.pivot), place.axes[axis])) < leastPlane)
        return std::nullopt;
    const glm::dvec3 a = place.axes[(axis + 1) % 3], b = place.axes[(axis + 2) % 3];
    const double from = gizmoMetres(view, place, planeFrom), to = gizmoMetres(view, place, planeTo);
    QPolygonF square;
    for (const auto& [x, y] :
         {std::pair{from, from}, std::pair{to, from}, std::pair{to, to}, std::pair{from, to}}) {
        const auto at = gizmoPixel(view, place.pivot + x * a + y * b);
        if (!at)
            return std::nullopt;
        square << *at;
    }
    return square;
}

namespace {

std::optional<GizmoHandle> ringAt(const PickView& view, QPointF at, const GizmoPlace& place)
{
    std::optional<GizmoHandle> found;
    double least = tolerance;
    const auto consider = [&](const QPolygonF& line, GizmoHandle handle) {
        const double away = distanceTo(line, at);
        if (away >= least)
            return;
        least = away;
        found = handle;
    };
    for (int axis = 0; axis < 3; ++axis)
        consider(gizmoRing(view, place, place.axes[axis], gizmoRingReach, true), {GizmoPart::Axis, axis});
    consider(gizmoRing(view, place, gizmoSight(view, place.pivot), gizmoViewRingReach, false),
             {GizmoPart::View, 0});
    return found;
}

} // namespace

std::optional<GizmoHandle> gizmoHandleAt(const PickView& view, const glm::dvec2& pixel,
                                         const GizmoPlace& place, TransformTool tool)
{
    const QPointF at(pixel.x, pixel.y);
    const auto centre = gizmoPixel(view, place.pivot);
    if (!transforms(tool) || !centre)
        return std::nullopt;
    if (tool == TransformTool::Rotate)
        return ringAt(view, at, place);
    if (squareLength(at - *centre) <= centreReach * centreReach)
        return GizmoHandle{GizmoPart::Centre, 0};
    std::optional<GizmoHandle> found;
    double least = tolerance;
    for (int axis = 0; axis < 3; ++axis) {
        const auto line = gizmoAxisLine(view, place, axis);
        if (!line || distanceTo(line->p1(), line->p2(), at) >= least)
            continue;
        least = distanceTo(line->p1(), line->p2(), at);
        found = GizmoHandle{GizmoPart::Axis, axis};
    }
    if (found)
        return found;
    for (int axis = 0; axis < 3; ++axis)
        if (const auto square = gizmoPlaneSquare(view, place, axis);
            square && square->containsPoint(at, Qt::WindingFill))
            return GizmoHandle{GizmoPart::Plane, axis};
    return std::nullopt;
}

std::optional<QPointF> gizmoGrip(const PickView& view, const GizmoPlace& place, TransformTool tool,
                                 const GizmoHandle& handle)
{
    if (tool == TransformTool::Rotate) {
        const bool own = handle.part == GizmoPart::Axis;
        const QPolygonF ring =
            own ? gizmoRing(view, place, place.axes[handle.axis], gizmoRingReach, true)
                : gizmoRing(view, place, gizmoSight(view, place.pivot), gizmoViewRingReach, false);
        return ring.isEmpty() ? std::nullopt : std::optional(ring[ring.size() / 3]);
    }
    if (handle.part == GizmoPart::Axis) {
        const auto line = gizmoAxisLine(view, place, handle.axis);
        return line ? std::optional(line->pointAt(0.85)) : std::nullopt;
    }
    if (handle.part == GizmoPart::Plane) {
        const auto square = gizmoPlaneSquare(view, place, handle.axis);
        return square ? std::optional(0.5 * (square->at(0) + square->at(2))) : std::nullopt;
    }
    return gizmoPixel(view, place.pivot);
}

} // namespace ramure
