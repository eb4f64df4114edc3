/// \file
/// Parameters of a tree's motion (SPEC A7). The member initialisers are the defaults.
#pragma once

#include <cstdint>

namespace ramure {

/// The values are positions in the table's list of items; files have the names.
enum class PhysicsMode : std::uint8_t {
    Faithful, ///< exactly SPEC A7
    Robust,   ///< damped springs relative to the parent, stable for every value in range
};
enum class RestFrame : std::uint8_t {
    World,  ///< a branch wants back to where it pointed at first
    Parent, ///< ... as seen from its parent
};

struct PhysicsParams
{
    PhysicsMode mode = PhysicsMode::Robust;
    double stepSeconds = 0.01;
    std::int64_t substeps = 1;
    double gravity = 1.0; ///< times the usual one
    /// Faithful: share of the speed after a step; robust: share of the swing after half a swing.
    double damping = 0.7;
    double restitution = 1000.0;             ///< stiffness
    RestFrame restFrame = RestFrame::Parent; ///< robust only: SPEC A7 is in world space
    bool settled = true; ///< robust only: the modelled shape is the one that the tree's own weight has bent
    double appleMass = 0.075;
    double windStrength = 1.0;
    double windDirection = 0.0; ///< rad, about +Y from +X
    double windGust = 0.5;
    double windTurbulence = 0.5;
    std::int64_t seed = 1;
    double appleBounce = 0.35;
    double appleFriction = 0.5;
    bool operator==(const PhysicsParams&) const = default;
};

/// Calls \p visit with every member, in one fixed order.
template <class Params, class Visit> void visitFields(Params& p, Visit&& visit)
{
    visit(p.mode), visit(p.stepSeconds), visit(p.substeps), visit(p.gravity), visit(p.damping);
    visit(p.restitution), visit(p.restFrame), visit(p.appleMass), visit(p.windStrength);
    visit(p.windDirection), visit(p.windGust), visit(p.windTurbulence), visit(p.seed);
    visit(p.appleBounce), visit(p.appleFriction), visit(p.settled);
}

} // namespace ramure
