/// \file
/// Fills the notches of forks so far that a ball of a given size touches their ground: the morphological
/// closing (dilation, then erosion) of what is inside, here alone. What is left outside is a union of such
/// balls, so no notch is sharper than they are.
#pragma once

#include "core/skeleton/skeleton.h"
#include <vector>

namespace ramure {

/// A ball that rolls along a notch: its place and its size.
struct NotchBall
{
    glm::dvec3 centre{0.0}; ///< m
    double radius = 0.0;    ///< m, up to the distance `inner` from the centre; from there on to `outer` less
    double inner = 0.0, outer = 0.0;
};

/// What the radius in a notch is asked to be, of the thinner branch's.
inline constexpr double leastFillet = 0.5;

/// One for every branch that leaves a fork beside its thickest one. \param skeleton of the print
std::vector<NotchBall> notchBalls(const Skeleton& skeleton);

/// Distances on a lattice, negative inside, in steps of the lattice; exact as far as `band`, and beyond it
/// only known to be larger.
struct DistanceBox
{
    glm::ivec3 size{0};
    float band = 3.0F;
    std::vector<float> values; ///< x first

    [[nodiscard]] std::size_t index(int x, int y, int z) const
    {
        return (std::size_t(z) * std::size_t(size.y) + std::size_t(y)) * std::size_t(size.x) + std::size_t(x);
    }
};

/// \param ball in steps of the lattice, from its first point. \returns by point its distance with the notch
/// filled: nowhere more than before.
std::vector<float> withFilledNotch(const DistanceBox& box, const NotchBall& ball);

} // namespace ramure
