/// \file
/// Rings around the joints of an arm, by which its angles are turned with the mouse; limits are arcs of them.
/// Functions of cameras and plain data: tested without OpenGL.
#pragma once

#include "core/scene/scene.h"
#include "widgets/view/render/pick/pick_scene.h"
#include <optional>
#include <vector>

class QPainter;

namespace ramure {

/// One angle of one joint, in the world.
struct ArmRing
{
    std::size_t joint = 0;
    bool phi = true; ///< else theta
    glm::dvec3 centre{0.0};
    glm::dvec3 zero{1.0, 0.0, 0.0};   ///< unit, from the centre to where the angle is 0
    glm::dvec3 across{0.0, 1.0, 0.0}; ///< unit, to where it is 90 degrees
    double radius = 1.0;              ///< m
    ArmAngle angle;

    [[nodiscard]] glm::dvec3 at(double angleRad) const;
};

/// Two for each joint, from the foot on, phi first. Empty for nodes that are no arms. Joints and places are
/// as their tracks have them at the time.
std::vector<ArmRing> armRings(const Scene& scene, NodeId arm, double timeSeconds = 0.0);
/// The ring nearest to the cursor within \p tolerance logical pixels.
std::optional<std::size_t> ringUnder(const PickView& view, const glm::dvec2& pixel,
                                     const std::vector<ArmRing>& rings, double tolerance = 7.0);
/// The angle at which a ring's plane lies under the cursor, -pi .. pi; nothing where it is seen from its
/// edge.
std::optional<double> ringAngle(const PickView& view, const glm::dvec2& pixel, const ArmRing& ring);
/// What becomes of an angle that was \p start when the cursor goes from one angle to another.
double turnedBy(const ArmAngle& start, double fromRad, double toRad);

/// \param active index of the ring that is turned, or none
void paintRings(QPainter& painter, const PickView& view, const std::vector<ArmRing>& rings,
                std::optional<std::size_t> active);

} // namespace ramure
