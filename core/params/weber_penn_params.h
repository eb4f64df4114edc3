/// \file
/// The parameters of Weber and Penn: "Creation and rendering of realistic trees" (SIGGRAPH 1995,
/// doi 10.1145/218380.218427), in its names. The member initialisers are the paper's quaking aspen. Angles in
/// rad, lengths in metres; "V" is how far chance varies a value to either side.
#pragma once

#include <array>
#include <cstdint>
#include <numbers>

namespace ramure {

/// In the paper's numbers, 0 to 8.
enum class CrownShape : std::uint8_t {
    Conical,
    Spherical,
    Hemispherical,
    Cylindrical,
    TaperedCylindrical,
    Flame,
    InverseConical,
    TendFlame,
    Envelope, ///< shaped by the pruning envelope
};

/// Parameters of the stems of one level; level 0 is the trunk.
struct WeberPennLevel
{
    double length = 1.0; ///< share of the parent's; of the trunk, of the scale
    double lengthV = 0.0;
    double taper = 1.0;
    std::int64_t baseSplits = 0;
    double segSplits = 0.0; ///< stems more at the end of each piece, on average
    double splitAngle = 0.0, splitAngleV = 0.0;
    std::int64_t curveRes = 3; ///< pieces
    double curve = 0.0, curveBack = 0.0, curveV = 0.0;
    double downAngle = 0.0, downAngleV = 0.0; ///< for the trunk against the vertical
    double rotate = 0.0, rotateV = 0.0;
    std::int64_t branches = 1; ///< stems of this level that a stem of the one below carries; trunks
    bool operator==(const WeberPennLevel&) const = default;
};

inline constexpr std::size_t weberPennLevels = 4;

struct WeberPennParams
{
    CrownShape shape = CrownShape::TendFlame;
    double baseSize = 0.4; ///< bare share of the trunk
    double scale = 13.0, scaleV = 3.0;
    std::int64_t levels = 3;
    double ratio = 0.015, ratioPower = 1.2;
    std::int64_t lobes = 5;
    double lobeDepth = 0.07;
    double flare = 0.6;
    double attractionUp = 0.5;
    /// M above the ground below which no limb or twig sinks; 0: they may sink below it.
    double clearance = 0.0;
    double pruneRatio = 0.0, pruneWidth = 0.5, pruneWidthPeak = 0.5;
    double prunePowerLow = 0.5, prunePowerHigh = 0.5;
    std::array<WeberPennLevel, weberPennLevels> level = aspenLevels();
    bool operator==(const WeberPennParams&) const = default;

private:
    static constexpr std::array<WeberPennLevel, weberPennLevels> aspenLevels()
    {
        constexpr double degree = std::numbers::pi / 180.0;
        std::array<WeberPennLevel, weberPennLevels> all;
        WeberPennLevel& trunk = all[0];
        trunk.curveRes = 5;
        trunk.curveV = 20 * degree;
        WeberPennLevel& limbs = all[1];
        limbs.length = 0.3;
        limbs.curveRes = 5;
        limbs.curve = -40 * degree;
        limbs.curveV = 50 * degree;
        limbs.downAngle = 60 * degree;
        limbs.downAngleV = -50 * degree;
        limbs.rotate = 140 * degree;
        limbs.branches = 50;
        WeberPennLevel& branches = all[2];
        branches.length = 0.6;
        branches.curve = -40 * degree;
        branches.curveV = 75 * degree;
        branches.downAngle = 45 * degree;
        branches.downAngleV = 10 * degree;
        branches.rotate = 140 * degree;
        branches.branches = 30;
        WeberPennLevel& twigs = all[3];
        twigs.length = 0.3;
        twigs.curveRes = 1;
        twigs.downAngle = 45 * degree;
        twigs.downAngleV = 10 * degree;
        twigs.rotate = 77 * degree;
        twigs.branches = 10;
        return all;
    }
};

} // namespace ramure
