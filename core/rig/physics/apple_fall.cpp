#include "core/rig/physics/apple_fall.h"

#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ramure {
namespace {

/// Slower than this an apple lies still, m/s.
constexpr double stillApple = 0.01;
/// Bounces within one step; after that it stays on the ground.
constexpr int mostBounces = 8;
/// Rolling slows an apple by this share of what sliding would.
constexpr double rollingShare = 0.1;

/// Seconds until the centre is at \p height, falling; none where it never is.
double timeToFall(double y, double speedUp, double gravity, double height)
{
    const double drop = std::max(y - height, 0.0);
    if (gravity <= 0.0)
        return speedUp < 0.0 ? drop / -speedUp : HUGE_VAL;
    const double root = std::sqrt(speedUp * speedUp + 2.0 * gravity * drop);
    return speedUp > 0.0 ? (speedUp + root) / gravity : 2.0 * drop / std::max(root - speedUp, 1e-300);
}

void turnApple(LooseApple& apple, double seconds)
{
    const double angle = glm::length(apple.spin) * seconds;
    if (!(angle > 0.0))
        return;
    apple.orientation =
        glm::normalize(maths::angleAxis(angle, apple.spin / glm::length(apple.spin)) * apple.orientation);
}

/// As a ball that rolls without sliding turns.
glm::dvec3 rollingSpin(const glm::dvec3& velocity, double radius)
{
    return radius > 0.0 ? glm::dvec3(velocity.z, 0.0, -velocity.x) / radius : glm::dvec3(0.0);
}

void fly(LooseApple& apple, double gravity, double seconds)
{
    apple.position += seconds * apple.velocity;
    apple.position.y -= 0.5 * gravity * seconds * seconds;
    apple.velocity.y -= gravity * seconds;
    turnApple(apple, seconds);
}

/// Slows the part of the velocity along the ground by at most \p loss, m/s.
void brake(LooseApple& apple, double loss)
{
    const double speed = maths::hypot(apple.velocity.x, apple.velocity.z);
    const double kept = speed > loss ? (speed - loss) / speed : 0.0;
    apple.velocity.x *= kept;
    apple.velocity.z *= kept;
}

void roll(LooseApple& apple, const PhysicsParams& params, double gravity, double radius, double seconds)
{
    apple.position.y = radius;
    apple.velocity.y = 0.0;
    brake(apple, rollingShare * params.appleFriction * gravity * seconds);
    apple.spin = rollingSpin(apple.velocity, radius);
    apple.position += seconds * apple.velocity;
    turnApple(apple, seconds);
    if (glm::length(apple.velocity) < stillApple && gravity > 0.0) {
        apple.velocity = apple.spin = glm::dvec3(0.0);
        apple.resting = true;
    }
}

} // namespace

void stepLooseApple(LooseApple& apple, const PhysicsParams& params, double radius, double seconds)
{
    const double gravity = earthGravity * params.gravity;
    if (apple.resting && gravity > 0.0)
        return;
    apple.resting = false;
    apple.position.y = std::max(apple.position.y, radius);
    double left = seconds;
    for (int bounce = 0; bounce < mostBounces; ++bounce) {
        const double fall = timeToFall(apple.position.y, apple.velocity.y, gravity, radius);
        if (!(fall < left))
            return fly(apple, gravity, left);
        fly(apple, gravity, fall);
        left -= fall;
        apple.position.y = radius;
        const double impact = std::max(-apple.velocity.y, 0.0);
        apple.velocity.y = params.appleBounce * impact;
        brake(apple, params.appleFriction * (impact + apple.velocity.y));
        apple.spin = rollingSpin(apple.velocity, radius);
        // A bounce that is over within this step is none.
        if (2.0 * apple.velocity.y <= gravity * seconds)
            break;
    }
    roll(apple, params, gravity, radius, left);
}

} // namespace ramure
