#include "widgets/view/tools/arm/arm_rings.h"

#include "core/evaluate/evaluator.h"
#include "core/math/angle.h"
#include "core/rig/arm/arm_chain.h"
#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr int ringCorners = 72; ///< of a whole ring

double distanceTo(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& pixel)
{
    const glm::dvec2 way = b - a;
    const double square = glm::dot(way, way);
    const double part = square > 0.0 ? std::clamp(glm::dot(pixel - a, way) / square, 0.0, 1.0) : 0.0;
    return glm::length(a + part * way - pixel);
}

QPolygonF arc(const PickView& view, const ArmRing& ring, double from, double to)
{
    QPolygonF points;
    const int count = std::max(2, int(std::ceil(ringCorners * std::abs(to - from) / (2.0 * pi))));
    for (int i = 0; i <= count; ++i)
        if (const auto at = view.pixel(ring.at(from + (to - from) * i / count)))
            points << QPointF(at->x, at->y);
    return points;
}

/// A stroke across the ring where it may not go on.
void paintLimits(QPainter& painter, const PickView& view, const ArmRing& ring)
{
    for (const double limit : {ring.angle.minRad, ring.angle.maxRad}) {
        const glm::dvec3 way = ring.at(limit) - ring.centre;
        const auto inner = view.pixel(ring.centre + 0.85 * way);
        const auto outer = view.pixel(ring.centre + 1.15 * way);
        if (inner && outer)
            painter.drawLine(QPointF(inner->x, inner->y), QPointF(outer->x, outer->y));
    }
}

} // namespace

glm::dvec3 ArmRing::at(double angleRad) const
{
    return centre + radius * (std::cos(angleRad) * zero + std::sin(angleRad) * across);
}

std::vector<ArmRing> armRings(const Scene& scene, NodeId arm, double timeSeconds)
{
    std::vector<ArmRing> rings;
    const Node* node = scene.find(arm);
    if (!node || node->kind != NodeKind::Arm)
        return rings;
    EvaluatedScene now(scene, timeSeconds);
    const NodeParams& params = now.params(*node);
    const ArmChain chain(params.joints);
    const glm::dmat4 world = now.transforms(arm).geometry * armUpright();
    const glm::dmat3 turn(world);
    const double scale = std::cbrt(std::abs(glm::determinant(turn)));
    const double thick = std::max(params.arm.jointRadius, params.armSkin.shown ? params.armSkin.radius : 0.0);
    glm::dmat3 before(1.0); // the frame that the joint turns in
    for (std::size_t j = 0; j < params.joints.size(); ++j) {
        const ArmJoint& joint = params.joints[j];
        const double c = std::cos(joint.phi.angleRad), s = std::sin(joint.phi.angleRad);
        const glm::dvec3 turnedX = c * before[0] + s * before[1];
        const auto add = [&](bool phi, const glm::dvec3& zero, const glm::dvec3& across, double size) {
            ArmRing ring;
            ring.joint = j;
            ring.phi = phi;
            ring.centre = glm::dvec3(world * glm::dvec4(chain.points()[j], 1.0));
            ring.zero = glm::normalize(turn * zero);
            ring.across = glm::normalize(turn * across);
            ring.radius = scale * size;
            ring.angle = phi ? joint.phi : joint.theta;
            rings.push_back(ring);
        };
        add(true, before[0], before[1], 1.3 * thick + 0.02 * chain.reach());
        add(false, before[2], turnedX, 1.6 * thick + 0.03 * chain.reach());
        before = chain.frame(j);
    }
    return rings;
}

std::optional<std::size_t> ringUnder(const PickView& view, const glm::dvec2& pixel,
                                     const std::vector<ArmRing>& rings, double tolerance)
{
    std::optional<std::size_t> found;
    double nearest = tolerance;
    for (std::size_t r = 0; r < rings.size(); ++r) {
        std::optional<glm::dvec2> last;
        for (int i = 0; i <= ringCorners; ++i) {
            const auto at = view.pixel(rings[r].at(2.0 * pi * i / ringCorners));
            if (at && last && distanceTo(*last, *at, pixel) < nearest) {
                nearest = distanceTo(*last, *at, pixel);
                found = r;
            }
            last = at;
        }
    }
    return found;
}

std::optional<double> ringAngle(const PickView& view, const glm::dvec2& pixel, const ArmRing& ring)
{
    const ViewRay ray = view.camera.ray(view.ndc(pixel), view.aspect());
    const glm::dvec3 normal = glm::cross(ring.zero, ring.across);
    const double slope = glm::dot(ray.direction, normal);
    if (std::abs(slope) < 0.05 * glm::length(ray.direction))
        return std::nullopt;
    const glm::dvec3 away =
        ray.origin + ray.direction * (glm::dot(ring.centre - ray.origin, normal) / slope) - ring.centre;
    return std::atan2(glm::dot(away, ring.across), glm::dot(away, ring.zero));
}

double turnedBy(const ArmAngle& start, double fromRad, double toRad)
{
    const double angle = start.angleRad + wrappedAngle(toRad - fromRad);
    return start.limited ? std::clamp(angle, start.minRad, start.maxRad) : wrappedAngle(angle);
}

void paintRings(QPainter& painter, const PickView& view, const std::vector<ArmRing>& rings,
                std::optional<std::size_t> active)
{
    painter.setBrush(Qt::NoBrush);
    for (std::size_t r = 0; r < rings.size(); ++r) {
        const ArmRing& ring = rings[r];
        QColor colour = ring.phi ? QColor(90, 160, 255) : QColor(255, 170, 60);
        colour.setAlpha(active && *active != r ? 90 : 230);
        QColor thin = colour;
        thin.setAlpha(colour.alpha() / 3);
        painter.setPen(QPen(thin, 1.0));
        painter.drawPolyline(arc(view, ring, -pi, pi));
        painter.setPen(QPen(colour, 2.5, Qt::SolidLine, Qt::FlatCap));
        const ArmAngle& angle = ring.angle;
        painter.drawPolyline(angle.limited ? arc(view, ring, angle.minRad, angle.maxRad)
                                           : arc(view, ring, -pi, pi));
        if (angle.limited)
            paintLimits(painter, view, ring);
        const bool held = angle.limited && (angle.angleRad <= angle.minRad || angle.angleRad >= angle.maxRad);
        if (const auto knob = view.pixel(ring.at(angle.angleRad))) {
            painter.setPen(QPen(QColor(20, 30, 40, 200), 1.0));
            painter.setBrush(held ? QColor(235, 60, 50) : colour);
            const double radius = held ? 6.0 : 4.5;
            painter.drawEllipse(QPointF(knob->x, knob->y), radius, radius);
            painter.setBrush(Qt::NoBrush);
        }
    }
}

} // namespace ramure
