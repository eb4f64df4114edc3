/// \file
/// The camera: a turntable around a target. Plain mathematics in doubles, no OpenGL, no widget.
///
/// Yaw 0 and pitch 0 look along -Z with +Y up (the front view); yaw turns to the right side, pitch lifts the
/// eye. Screen coordinates are ndc: x to the right, y up, both -1..1 in the picture. "aspect" is width /
/// height.
#pragma once

#include "core/math/box.h"
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <optional>
#include <span>

namespace ramure {

enum class AxisView : std::uint8_t { Front, Back, Right, Left, Top, Bottom };

/// A half-line; the direction is unit.
struct ViewRay
{
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0, 0.0, -1.0};
};

/// Near and far plane as distances along the view direction; near may be negative in orthographic views.
struct DepthRange
{
    double near = 0.1;
    double far = 100.0;
};

class Camera
{
public:
    static constexpr double usualMargin = 1.06; ///< size of the picture relative to the framed objects

    glm::dvec3 target{0.0, 1.0, 0.0};
    double distance = 5.0;     ///< from the eye to the target, m
    double yawRad = 0.6;       ///< kept in (-pi, pi]
    double pitchRad = 0.12;    ///< -pi/2 .. pi/2
    double rollRad = 0.0;      ///< about the line of sight, anticlockwise as the eye sees the camera turn
    double fovRad = 0.69;      ///< vertical opening
    bool orthographic = false; ///< shows as much at the target as the perspective does
    glm::dvec2 shift{0.0};     ///< ndc by which all that is shown is moved, as by a lens that is shifted

    /// From the target to the eye.
    [[nodiscard]] glm::dvec3 backward() const;
    [[nodiscard]] glm::dvec3 right() const;
    [[nodiscard]] glm::dvec3 up() const;
    [[nodiscard]] glm::dvec3 eye() const { return target + distance * backward(); }
    /// Height of the picture in metres at the target.
    [[nodiscard]] double heightAtTarget() const;

    [[nodiscard]] glm::dmat4 viewMatrix() const;
    /// The planes that hold \p box (world) and keep the depth buffer precise; any box, also one behind the
    /// eye.
    [[nodiscard]] DepthRange depthRange(const Box& box) const;
    /// OpenGL clip space.
    [[nodiscard]] glm::dmat4 projectionMatrix(double aspect, const DepthRange& range) const;
    [[nodiscard]] ViewRay ray(const glm::dvec2& ndc, double aspect) const;
    /// Nothing for points at or behind the eye.
    [[nodiscard]] std::optional<glm::dvec2> project(const glm::dvec3& world, double aspect) const;
    /// Metres per pixel at a point, for tolerances. \p pixelHeight of the picture.
    [[nodiscard]] double metresPerPixel(const glm::dvec3& world, double pixelHeight) const;

    /// Brings it upright.
    void orbit(double deltaYawRad, double deltaPitchRad);
    /// Moves the picture so that the point at the target follows the cursor by \p deltaNdc.
    void pan(const glm::dvec2& deltaNdc, double aspect);
    /// Scales the distance by \p factor (< 1 comes closer); \p fixedPoint keeps its place in the picture.
    void zoom(double factor, const glm::dvec3& fixedPoint);
    /// The point under the cursor on the plane through the target that faces the eye.
    [[nodiscard]] glm::dvec3 pointAtTargetDepth(const glm::dvec2& ndc, double aspect) const;
    /// Places target and distance so that the whole box fills the picture up to the margin. Empty boxes: no
    /// change.
    void frame(const Box& box, double aspect, double margin = usualMargin);
    /// The same for points: as close as they allow, centred in the picture. No points: no change.
    void frame(std::span<const glm::dvec3> points, double aspect, double margin = usualMargin);
    /// The same for a camera that then turns about its target, all around: from no side does a point leave
    /// the picture. Keeps yaw and pitch; the target comes to stand in the upright middle of the points.
    void frameAllAround(std::span<const glm::dvec3> points, double aspect, double margin = usualMargin);
    void setAxisView(AxisView view);
    void turnOpposite(); ///< to the other side, from above to below

    bool operator==(const Camera&) const = default;
};

/// Between two cameras, t in 0..1: angles the shorter way, distances geometrically. For animated view
/// changes.
Camera mixed(const Camera& from, const Camera& to, double t);

} // namespace ramure
