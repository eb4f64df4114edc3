/// \file
/// An articulated arm (SPEC C1): joints with two angles each, what they may do, and how the arm finds its
/// target. The member initialisers are the defaults; distances in metres, angles in radians.
#pragma once

#include "core/base/error.h"
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <numbers>
#include <span>
#include <vector>

namespace ramure {

/// One angle of a joint. \c limited off: it may turn for ever and is kept within -pi .. pi.
struct ArmAngle
{
    double angleRad = 0.0;
    bool limited = false;
    double minRad = -std::numbers::pi * 170.0 / 180.0; ///< counts where limited; not over maxRad
    double maxRad = std::numbers::pi * 170.0 / 180.0;
    double mostSpeed = 0.0; ///< rad/s; 0 = as fast as it likes
    bool operator==(const ArmAngle&) const = default;
};

/// Turns by phi about the axis of the segment before it, then by theta about the Y axis turned by phi; its
/// own segment follows.
struct ArmJoint
{
    double length = 1.0;
    ArmAngle phi;
    ArmAngle theta;
    bool operator==(const ArmJoint&) const = default;
};

inline constexpr std::size_t leastArmJoints = 1, mostArmJoints = 64;

/// SPEC C1: lengths 1.7, 1.5, 1.2; phi 45, 0, -30 degrees; theta 30, 20, -20 degrees. Without limits.
std::vector<ArmJoint> defaultArmJoints();

/// Errors: Invalid (no joints or over 64, lengths not above 0, numbers that are not finite, limits the wrong
/// way round, negative speeds), path "joints[2].theta.minRad".
Expected<void> checkArm(std::span<const ArmJoint> joints);

/// The values are positions in the table's list of items; files have the names.
enum class ArmSolverKind : std::uint8_t {
    LeastSquares, ///< damped least squares (Levenberg, Marquardt) with an active set for the limits
    Transpose,    ///< Jacobian transpose exactly as SPEC C2
};

struct ArmSolverParams
{
    ArmSolverKind kind = ArmSolverKind::LeastSquares;
    double gain = 0.01 * std::numbers::pi; ///< Transpose: dt of angles += dt * transposed J * (target - tip)
    std::int64_t stepsPerTick = 1;         ///< Transpose: steps for each sixtieth of a second
    double tolerance = 1e-4;               ///< m; nearer than this the target counts as reached
    bool operator==(const ArmSolverParams&) const = default;
};

/// How an arm moves and what is shown of it.
struct ArmParams
{
    bool follows = true;              ///< inverse kinematics turns the joints towards the target
    glm::dvec3 target{2.0, 1.0, 2.5}; ///< m, in the arm's own space, Z up
    double jointRadius = 0.2;         ///< m
    bool operator==(const ArmParams&) const = default;
};

/// The arm's skin, a cylinder rolled up from a regular grid (SPEC C3).
/// Which axis of a worn mesh lies along the arm.
enum class MeshAxis : std::uint8_t { Longest, X, Y, Z };

struct ArmSkinParams
{
    bool shown = true;                 ///< otherwise joints and rods are seen
    double radius = 0.5;               ///< m
    std::int64_t lengthDivisions = 94; ///< cells of the grid along the arm
    std::int64_t radialDivisions = 32; ///< and around it
    double window = 0.2;               ///< m on either side of a joint, over which segments share the skin
    MeshAxis axis = MeshAxis::Longest; ///< only for an arm with a mesh of its own
    bool weights = false;              ///< coloured by the segments that it follows
    bool operator==(const ArmSkinParams&) const = default;
};

/// A terrain around the node's origin: a square grid in X and Z, heights along Y. With a depth it is a block
/// of earth, whose bottom is level; without, a sheet.
struct TerrainParams
{
    std::int64_t seed = 1;
    double size = 12.0;           ///< m, length of a side
    double height = 1.5;          ///< m, how far the largest hills rise or fall
    double roughness = 0.5;       ///< how high hills of half the width are, against the larger ones
    std::int64_t divisions = 128; ///< cells along a side
    double depth = 0.0;           ///< m, from the lowest place down to the bottom; 0: a sheet
    bool operator==(const TerrainParams&) const = default;
};

} // namespace ramure
