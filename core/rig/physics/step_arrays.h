/// \file
/// What the inner loops of a step read and write: arrays by slot. Made once for a set of parameters; only the
/// two steps and tree_physics.cpp use it.
#pragma once

#include "core/rig/physics/physics_state.h"
#include "core/rig/physics/tree_body.h"
#include "core/rig/physics/wind.h"
#include <vector>

namespace ramure {

/// Depends on the apples that still hang.
struct Masses
{
    std::vector<Index> loose;    ///< that these are for, sorted
    std::vector<double> mass;    ///< SPEC A7: a1, the apple's, and those of the children
    std::vector<double> bare;    ///< the same without any apple
    std::vector<double> windage; ///< 1 / sqrt(mass)
};
Masses massesOf(const TreeBody& body, double appleMass, std::vector<Index> loose);

/// The robust mode's constants: each branch a damped spring with its own rate. See robust_step.h.
struct Springs
{
    double seconds = 0.0;       ///< of the substep that keep* are for
    std::vector<double> rate;   ///< rad/s, undamped
    std::vector<double> give;   ///< how far a load of 1 turns it, as a share of the whole
    std::vector<double> drag;   ///< the same for the air that the branch is carried through, rad s / m
    std::vector<double> weight; ///< load of gravity
    std::vector<double> keepXX, keepXV, keepVX, keepVV; ///< (bend - target, rate) one substep later
};

/// Rotations of this step, by slot; outlives the step only to save its memory.
struct StepRotations
{
    std::vector<double> w, x, y, z;
    void resize(std::size_t count);
};

struct StepInputs
{
    const TreeBody& body;
    const PhysicsParams& params;
    const Masses& masses;
    const Springs& springs;
    const std::vector<double>& held; ///< heldLoads(); the robust step's
    const WindField& wind;
    StepRotations& rotations;
};

} // namespace ramure
