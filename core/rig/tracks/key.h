/// \file
/// A key: a value at a time, and how the value goes on to the next key.
#pragma once

#include "core/rig/tracks/ticks.h"
#include <array>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>

namespace ramure {

/// How a value goes from its key to the next one. The names in files are those of keyModeName().
enum class KeyMode : std::uint8_t {
    Constant, ///< stays until the next key
    Linear,
    Bezier, ///< by the handles of this key and the next
    Cubic,  ///< the spline of SPEC B1 through the four keys around (orientations: squad, or that spline)
    Sine,   ///< from here on Blender's easings (ANIMATION 4.1)
    Quad,
    CubicEase,
    Quart,
    Quint,
    Expo,
    Circ,
    Back,
    Bounce,
    Elastic,
};
inline constexpr int keyModeCount = 14;
/// The first easing; all behind it are easings.
inline constexpr KeyMode firstEasingMode = KeyMode::Sine;

/// At which end an easing shows its character.
enum class Easing : std::uint8_t { Auto, In, Out, InOut };
inline constexpr int easingCount = 4;

/// How a Bezier handle is placed.
enum class HandleType : std::uint8_t {
    Free,        ///< stays where it was put
    Aligned,     ///< stays where it was put, in line with the other handle
    Vector,      ///< a third of the way to the neighbour
    Auto,        ///< smooth, may overshoot
    AutoClamped, ///< smooth, never beyond the values of the keys (Blender's default)
};
inline constexpr int handleTypeCount = 5;

/// From its key: seconds and units of the value. dt <= 0 for the handle before, >= 0 for the one behind.
struct Handle
{
    double dt = 0.0;
    double dv = 0.0;
    bool operator==(const Handle&) const = default;
};

/// The members that keys of all tracks share.
struct KeyShape
{
    Ticks time = 0;
    KeyMode mode = KeyMode::Bezier; ///< the way to the next key
    Easing easing = Easing::Auto;
    HandleType before = HandleType::AutoClamped;
    HandleType behind = HandleType::AutoClamped;
    double back = 1.70158;      ///< for Back: how far it overshoots
    double amplitude = 0.8;     ///< for Elastic: in units of the value; 0 = as large as the change
    double period = 4.1 / 24.0; ///< for Elastic: seconds; 0 = 0.3 of the way (InOut: 0.45)
    bool operator==(const KeyShape&) const = default;
};

struct Key : KeyShape
{
    double value = 0.0;
    Handle in, out; ///< only those of Free and Aligned are kept as they are given; the track makes the others
    bool operator==(const Key&) const = default;
};

struct OrientationKey : KeyShape
{
    glm::dquat value{1.0, 0.0, 0.0, 0.0}; ///< unit; the sign is chosen by the track
    std::array<Handle, 4> in{}, out{};    ///< handles of w, x, y, z; used if the track blends by components
    bool operator==(const OrientationKey&) const = default;
};

/// "CONSTANT", "LINEAR", "BEZIER", "SPLINE" (KeyMode::Cubic), "SINE", "QUAD", "CUBIC" (the easing) ...
const char* keyModeName(KeyMode mode);
/// "AUTO", "EASE_IN", "EASE_OUT", "EASE_IN_OUT".
const char* easingName(Easing easing);
/// "FREE", "ALIGNED", "VECTOR", "AUTO", "AUTO_CLAMPED".
const char* handleTypeName(HandleType type);

} // namespace ramure
