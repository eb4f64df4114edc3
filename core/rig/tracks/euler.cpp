#include "core/rig/tracks/euler.h"

#include "core/math/angle.h"
#include "core/math/reproducible.h"
#include <cmath>

namespace ramure {
namespace {

/// The angle that turns alike and lies nearest to \p near.
double turnedNear(double angle, double near)
{
    constexpr double whole = 2.0 * pi;
    return angle + whole * std::nearbyint((near - angle) / whole);
}

double distance(const glm::dvec3& a, const glm::dvec3& b)
{
    return std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z);
}

} // namespace

glm::dvec3 anglesOf(const glm::dquat& orientation, const glm::dvec3& near)
{
    return anglesOf(glm::mat3_cast(orientation), near);
}

glm::dvec3 anglesOf(const glm::dmat3& rotation, const glm::dvec3& near)
{
    const glm::dmat3& r = rotation;
    const double cosY = maths::hypot(r[0][0], r[0][1]);
    const double y = maths::atan2(-r[0][2], cosY);
    const auto alike = [&near](double a, double b, double c) {
        return glm::dvec3(turnedNear(a, near.x), turnedNear(b, near.y), turnedNear(c, near.z));
    };
    constexpr double upright = 1e-9;
    if (cosY <= upright) { // X and Z turn about one axis: Z stays as it was
        const double sum = maths::atan2(-r[2][1], r[1][1]);
        return alike(y > 0.0 ? sum + near.z : sum - near.z, y, near.z);
    }
    const double x = maths::atan2(r[1][2], r[2][2]), z = maths::atan2(r[0][1], r[0][0]);
    const glm::dvec3 one = alike(x, y, z), other = alike(x + pi, pi - y, z + pi);
    return distance(one, near) <= distance(other, near) ? one : other;
}

glm::dquat orientationOf(const glm::dvec3& angles)
{
    const auto about = [&angles](int axis) {
        glm::dvec3 unit(0.0);
        unit[axis] = 1.0;
        return maths::angleAxis(angles[axis], unit);
    };
    return glm::normalize(about(2) * about(1) * about(0));
}

std::vector<glm::dvec3> anglesOfKeys(const OrientationTrack& track)
{
    constexpr std::size_t many = 1000;
    constexpr double smallTurn = 0.9; // cosine of half an angle: where nothing can be mistaken
    constexpr int steps = 6;
    std::vector<glm::dvec3> angles;
    angles.reserve(track.size());
    glm::dvec3 near(0.0);
    TrackCursor cursor;
    for (std::size_t i = 0; i < track.size(); ++i) {
        const OrientationKey& key = track.keys()[i];
        if (i > 0 && track.size() <= many &&
            std::abs(glm::dot(track.keys()[i - 1].value, key.value)) < smallTurn) {
            const double from = secondsOf(track.keys()[i - 1].time), to = secondsOf(key.time);
            for (int k = 1; k < steps; ++k)
                near = anglesOf(valueAt(track, from + (to - from) * k / steps, cursor), near);
        }
        near = anglesOf(key.value, near);
        angles.push_back(near);
    }
    return angles;
}

} // namespace ramure
