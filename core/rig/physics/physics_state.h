/// \file
/// All that changes from step to step, as plain values: copy it to keep a moment, give it back to return
/// there.
#pragma once

#include "core/base/index.h"
#include "core/params/physics_params.h"
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

namespace ramure {

/// An apple that was shaken off.
struct LooseApple
{
    Index apple = 0; ///< position in Foliage::apples
    bool resting = false;
    glm::dvec3 position{0.0}; ///< place of the centre, tree space, m
    glm::dquat orientation{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 velocity{0.0}; ///< m/s
    glm::dvec3 spin{0.0};     ///< rad/s
    bool operator==(const LooseApple&) const = default;
};

enum class LimbPhase : std::uint8_t {
    Hanging, ///< in its place, as its stump carries it
    Tearing, ///< turns about its foot: what held it gives way
    Falling,
    Resting
};

/// A limb that was cut, as one rigid body; its branches go on swinging on it.
struct FallingLimb
{
    LimbPhase phase = LimbPhase::Hanging;
    std::int64_t calm = 0;                   ///< steps that it has hardly moved
    glm::dvec3 centre{0.0};                  ///< centre of mass, tree space, m
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0}; ///< from rest
    glm::dvec3 velocity{0.0};                ///< m/s
    glm::dvec3 spin{0.0};                    ///< rad/s
    bool operator==(const FallingLimb&) const = default;
};

/// The hand that pulls a branch: a spring from a point of the branch to a target.
struct Pull
{
    Index branch = 0;       ///< index in the skeleton
    double along = 1.0;     ///< 0 at p0 .. 1 at p1
    glm::dvec3 target{0.0}; ///< tree space, m
    double strength = 1.0;  ///< 0 .. 100; 1 bends a twig easily and a trunk a little
    bool operator==(const Pull&) const = default;
};

/// The weight under which the shape at rest stands still, as it was when the run began. Without gravity:
/// none.
struct HeldWeight
{
    double gravity = 0.0, restitution = 0.0, appleMass = 0.0;
    bool operator==(const HeldWeight&) const = default;
};
/// Returns the weight that a run holds which begins with \p params.
HeldWeight heldWeight(const PhysicsParams& params);

/// One channel per column, all slots of a channel side by side.
struct PhysicsState
{
    enum Channel : std::uint8_t {
        RotW,
        RotX,
        RotY,
        RotZ, ///< from rest to now, tree space; all modes
        VelX,
        VelY,
        VelZ, ///< m/s; faithful: that of SPEC A7; robust: of p1
        BendX,
        BendY,
        BendZ, ///< robust only: tan(angle / 2) about an axis, relative to the rest frame
        RateX,
        RateY,
        RateZ, ///< robust only: per second
    };
    static constexpr int faithfulChannels = 7;
    static constexpr int robustChannels = 13;

    std::int64_t step = 0;
    double timeSeconds = 0.0; ///< sum of the steps so far
    /// The last change of the step's length: timeSeconds = clockTime + (step - clockStep) * clockStepSeconds,
    /// so that t = k dt holds to the last bit.
    double clockTime = 0.0, clockStepSeconds = 0.0;
    std::int64_t clockStep = 0;
    PhysicsMode mode = PhysicsMode::Robust;
    HeldWeight held; ///< the same throughout a run; the robust step reads it
    Index slotCount = 0;
    std::vector<double> values;     ///< channels * slots
    std::vector<LooseApple> loose;  ///< in the order in which they fell
    std::vector<FallingLimb> limbs; ///< one for each of TreeBody::limbs

    [[nodiscard]] std::span<double> channel(int c)
    {
        return {values.data() + std::size_t(c) * slotCount, slotCount};
    }
    [[nodiscard]] std::span<const double> channel(int c) const
    {
        return {values.data() + std::size_t(c) * slotCount, slotCount};
    }
    [[nodiscard]] int channels() const
    {
        return mode == PhysicsMode::Faithful ? faithfulChannels : robustChannels;
    }
    [[nodiscard]] std::size_t bytes() const;
    bool operator==(const PhysicsState&) const = default;
};

/// Figures of a run for the plot, the command line and the tests.
struct PhysicsFigures
{
    double lengthError = 0.0;    ///< worst | |p1 - p0| / rest length - 1 |
    double kineticEnergy = 0.0;  ///< half the sum of mass * velocity²; mass as in SPEC A7
    glm::dvec3 tip{0.0};         ///< p1 of the first terminal branch, tree space
    double largestTurnRad = 0.0; ///< largest angle between a branch now and at rest
};

} // namespace ramure
