/// \file
/// Limbs that leave a thicker sibling, the stem, to its side: seen so that each of them shows where its axis
/// comes out of the stem's wood, and has a piece of that wood for itself.
#pragma once

#include "core/base/index.h"
#include <glm/vec3.hpp>
#include <span>

namespace ramure {

/// A child of a fork. Lengths in metres.
struct StemLimb
{
    glm::dvec3 direction{0.0}; ///< unit, from the fork to its end
    double length = 0.0;       ///< m, of that way
    double radius = 0.0;       ///< m, at the fork
    bool hasChildren = false;
};

enum class LimbAtFork : std::uint8_t {
    Stands,  ///< it comes out beside the fork; or it is too thick for a limb
    Inside,  ///< it ends in the stem's wood
    Beyond,  ///< it comes out nearer to the stem's next fork, or further on
    Crowded, ///< the stem forks again before it is clear of the limb
};
LimbAtFork limbAtFork(const StemLimb& limb, const StemLimb& stem);

/// Where a limb starts so that it comes out of the stem right above the fork, and goes straight from there to
/// its end. \returns m along the stem from the fork; below 0 in the wood beneath it.
double limbStart(const StemLimb& limb, const StemLimb& stem);

/// Does a child that is thin beside two others, or more, end in the wood of their fork? \param below the
/// branch that forks: its direction, and its radius there.
bool endsInFork(std::span<const StemLimb> children, std::size_t child, const StemLimb& below);

/// Is one of two siblings of these radii so thin that it is a limb of the other?
bool areStemAndLimb(double oneRadius, double otherRadius);
/// The thickest child, where all others are limbs of it; noIndex: they are not.
Index stemOf(std::span<const StemLimb> children);
/// Is there a stem, and room around it for all limbs beside each other? \param share of the room that they
/// need
bool standAroundStem(std::span<const StemLimb> children, double share = 1.0);

} // namespace ramure
