#include "widgets/view/render/camera.h"

#include "core/math/angle.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <vector>

namespace ramure {
namespace {

constexpr double minDistance = 1e-4;
constexpr double maxDistance = 1e6;

double wrapped(double angle)
{
    const double turned = std::remainder(angle, 2.0 * pi);
    return turned <= -pi ? pi : turned;
}

/// How far points reach to both sides when each is moved onto the plane of the target along the frustum's
/// side.
struct Extent
{
    double low = -std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
};

Extent extentOf(std::span<const glm::dvec2> points, double slope)
{
    Extent extent;
    for (const glm::dvec2& p : points) {
        extent.high = std::max(extent.high, p.x + p.y * slope);
        extent.low = std::max(extent.low, -p.x + p.y * slope);
    }
    return extent;
}

/// Where the eye must stand, seen from \p distance, for equal room on both sides.
double middleOf(std::span<const glm::dvec2> points, const Extent& extent, double slope, double distance)
{
    double from = extent.high - distance * slope;
    double to = distance * slope - extent.low;
    for (int round = 0; round < 20 && from < to; ++round) {
        const double middle = 0.5 * (from + to);
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        for (const glm::dvec2& p : points) {
            const double at = (p.x - middle) / std::max(distance - p.y, 1e-9 * distance);
            low = std::min(low, at);
            high = std::max(high, at);
        }
        (low + high > 0.0 ? from : to) = middle;
    }
    return 0.5 * (from + to);
}

} // namespace

glm::dvec3 Camera::backward() const
{
    return {std::sin(yawRad) * std::cos(pitchRad), std::sin(pitchRad), std::cos(yawRad) * std::cos(pitchRad)};
}

glm::dvec3 Camera::right() const
{
    const glm::dvec3 level(std::cos(yawRad), 0.0, -std::sin(yawRad));
    if (rollRad == 0.0)
        return level;
    return std::cos(rollRad) * level + std::sin(rollRad) * glm::cross(backward(), level);
}

glm::dvec3 Camera::up() const
{
    return glm::cross(backward(), right());
}

double Camera::heightAtTarget() const
{
    return 2.0 * distance * std::tan(0.5 * fovRad);
}

glm::dmat4 Camera::viewMatrix() const
{
    // Written out: lookAt would divide by zero for the straight views from above and below.
    const glm::dvec3 x = right();
    const glm::dvec3 y = up();
    const glm::dvec3 z = backward();
    const glm::dvec3 e = eye();
    glm::dmat4 view(1.0);
    for (int i = 0; i < 3; ++i) {
        view[i][0] = x[i];
        view[i][1] = y[i];
        view[i][2] = z[i];
    }
    view[3] = glm::dvec4(-glm::dot(x, e), -glm::dot(y, e), -glm::dot(z, e), 1.0);
    return view;
}

DepthRange Camera::depthRange(const Box& box) const
{
    double low = distance;
    double high = distance;
    for (int i = 0; i < 8 && !box.empty(); ++i) {
        const double depth = -glm::dot(box.corner(i) - eye(), backward());
        low = i == 0 ? depth : std::min(low, depth);
        high = i == 0 ? depth : std::max(high, depth);
    }
    const double margin = 0.01 * (high - low) + 1e-3 * distance;
    if (orthographic)
        return {low - margin, high + margin};
    const double far = std::max(high + margin, 1e-3 * distance);
    return {std::max(low - margin, 2e-4 * far), far};
}

glm::dmat4 Camera::projectionMatrix(double aspect, const DepthRange& range) const
{
    const double half = 0.5 * heightAtTarget();
    const glm::dmat4 straight =
        orthographic ? glm::ortho(-half * aspect, half * aspect, -half, half, range.near, range.far)
                     : glm::perspective(fovRad, aspect, range.near, range.far);
    return shift == glm::dvec2(0.0) ? straight
                                    : glm::translate(glm::dmat4(1.0), glm::dvec3(shift, 0.0)) * straight;
}

ViewRay Camera::ray(const glm::dvec2& shown, double aspect) const
{
    const glm::dvec2 ndc = shown - shift;
    const double half = 0.5 * heightAtTarget();
    const glm::dvec3 onTarget = target + ndc.x * half * aspect * right() + ndc.y * half * up();
    if (orthographic)
        return {onTarget + distance * backward(), -backward()};
    return {eye(), glm::normalize(onTarget - eye())};
}

std::optional<glm::dvec2> Camera::project(const glm::dvec3& world, double aspect) const
{
    const glm::dvec3 offset = world - eye();
    const double depth = -glm::dot(offset, backward());
    if (!orthographic && depth <= 1e-9 * distance)
        return std::nullopt;
    const double half = (orthographic ? 0.5 * heightAtTarget() : depth * std::tan(0.5 * fovRad));
    return shift + glm::dvec2(glm::dot(offset, right()) / (half * aspect), glm::dot(offset, up()) / half);
}

double Camera::metresPerPixel(const glm::dvec3& world, double pixelHeight) const
{
    if (orthographic)
        return heightAtTarget() / pixelHeight;
    const double depth = std::max(0.0, -glm::dot(world - eye(), backward()));
    return 2.0 * depth * std::tan(0.5 * fovRad) / pixelHeight;
}

void Camera::orbit(double deltaYawRad, double deltaPitchRad)
{
    yawRad = wrapped(yawRad + deltaYawRad);
    pitchRad = std::clamp(pitchRad + deltaPitchRad, -0.5 * pi, 0.5 * pi);
    rollRad = 0.0;
}

void Camera::pan(const glm::dvec2& deltaNdc, double aspect)
{
    const double half = 0.5 * heightAtTarget();
    target -= deltaNdc.x * half * aspect * right() + deltaNdc.y * half * up();
}

void Camera::zoom(double factor, const glm::dvec3& fixedPoint)
{
    if (!(factor > 0.0))
        return;
    const double next = std::clamp(distance * factor, minDistance, maxDistance);
    const double applied = next / distance;
    target = fixedPoint + applied * (target - fixedPoint);
    distance = next;
}

glm::dvec3 Camera::pointAtTargetDepth(const glm::dvec2& ndc, double aspect) const
{
    const double half = 0.5 * heightAtTarget();
    return target + ndc.x * half * aspect * right() + ndc.y * half * up();
}

void Camera::frame(const Box& box, double aspect, double margin)
{
    if (box.empty())
        return;
    std::array<glm::dvec3, 8> corners;
    for (int i = 0; i < 8; ++i)
        corners[std::size_t(i)] = box.corner(i);
    frame(corners, aspect, margin);
}

// Each side of the frustum touches the point that lies farthest out along its normal; two opposite sides give
// the distance that both allow. The pair that did not decide has room to spare: the middle is found by
// halving.
void Camera::frame(std::span<const glm::dvec3> points, double aspect, double margin)
{
    if (points.empty())
        return;
    Box box;
    for (const glm::dvec3& point : points)
        box.add(point);
    const double slope = std::tan(0.5 * fovRad) / margin;
    std::vector<glm::dvec2> across, along; // offset on the screen, and towards the eye
    across.reserve(points.size());
    along.reserve(points.size());
    for (const glm::dvec3& point : points) {
        const glm::dvec3 offset = point - box.centre();
        const double near = orthographic ? 0.0 : glm::dot(offset, backward());
        across.emplace_back(glm::dot(offset, right()), near);
        along.emplace_back(glm::dot(offset, up()), near);
    }
    const Extent x = extentOf(across, slope * aspect);
    const Extent y = extentOf(along, slope);
    const double needed =
        std::max((x.high + x.low) / (2.0 * slope * aspect), (y.high + y.low) / (2.0 * slope));
    target = box.centre() + middleOf(across, x, slope * aspect, needed) * right() +
             middleOf(along, y, slope, needed) * up();
    // A single point still gets a picture: some centimetres of it.
    distance = std::clamp(needed, box.radius() > 0.0 ? minDistance : 0.1, maxDistance);
}

// What turns is a stack of rings: the widest of some hundred layers, which is little wider than the points.
void Camera::frameAllAround(std::span<const glm::dvec3> points, double aspect, double margin)
{
    Box box;
    for (const glm::dvec3& point : points)
        box.add(point);
    if (box.empty())
        return;
    constexpr std::size_t layers = 128;
    constexpr int corners = 48; // of a ring, outside it
    const glm::dvec3 middle = box.centre();
    std::array<double, layers> radii;
    radii.fill(-1.0);
    const double height = std::max(box.size().y, 1e-12);
    for (const glm::dvec3& point : points) {
        const auto layer = static_cast<std::size_t>(double(layers) * (point.y - box.min.y) / height);
        double& radius = radii[std::min(layer, layers - 1)];
        radius = std::max(radius, std::hypot(point.x - middle.x, point.z - middle.z));
    }
    std::vector<glm::dvec3> rings;
    for (std::size_t layer = 0; layer < layers; ++layer) {
        const double radius = radii[layer] / std::cos(pi / corners);
        for (int i = 0; i < corners && radius >= 0.0; ++i) {
            const double angle = yawRad + 2.0 * pi * i / corners;
            const glm::dvec3 at(middle.x + radius * std::sin(angle), 0.0,
                                middle.z + radius * std::cos(angle));
            for (const double y : {double(layer), double(layer + 1)})
                rings.emplace_back(at.x, box.min.y + height * y / layers, at.z);
        }
    }
    frame(rings, aspect, margin);
    // Onto the axis, along the line of sight: the picture stays what it is.
    const glm::dvec3 away(middle.x - target.x, 0.0, middle.z - target.z);
    const double level = std::cos(pitchRad);
    const double along =
        level > 1e-6 ? glm::dot(away, glm::dvec3(std::sin(yawRad), 0.0, std::cos(yawRad))) / level : 0.0;
    target += along * backward();
    target.x = middle.x;
    target.z = middle.z;
    if (!orthographic)
        distance = std::max(distance - along, minDistance);
}

void Camera::turnOpposite()
{
    // Straight above and straight below, left stays left.
    const bool straight = std::abs(pitchRad) > 0.5 * pi - 1e-6;
    orbit(straight ? 0.0 : pi, -2.0 * pitchRad);
}

void Camera::setAxisView(AxisView view)
{
    pitchRad = 0.0;
    rollRad = 0.0;
    switch (view) {
    case AxisView::Front:
        yawRad = 0.0;
        break;
    case AxisView::Back:
        yawRad = pi;
        break;
    case AxisView::Right:
        yawRad = 0.5 * pi;
        break;
    case AxisView::Left:
        yawRad = -0.5 * pi;
        break;
    case AxisView::Top:
        yawRad = 0.0;
        pitchRad = 0.5 * pi;
        break;
    case AxisView::Bottom:
        yawRad = 0.0;
        pitchRad = -0.5 * pi;
        break;
    }
}

Camera mixed(const Camera& from, const Camera& to, double t)
{
    Camera result = to;
    if (t >= 1.0)
        return result;
    result.target = glm::mix(from.target, to.target, t);
    result.distance = from.distance * std::pow(to.distance / from.distance, t);
    result.yawRad = wrapped(from.yawRad + t * wrapped(to.yawRad - from.yawRad));
    result.pitchRad = glm::mix(from.pitchRad, to.pitchRad, t);
    result.rollRad = wrapped(from.rollRad + t * wrapped(to.rollRad - from.rollRad));
    result.fovRad = glm::mix(from.fovRad, to.fovRad, t);
    return result;
}

} // namespace ramure
