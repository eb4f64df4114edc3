/// \file
/// Channels: what of a node can have a track.
#pragma once

#include "core/params/joint_table.h"
#include "core/params/param_def.h"
#include "core/rig/tracks/track.h"
#include <compare>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ramure {

/// A track of either kind.
using AnyTrack = std::variant<Track, OrientationTrack>;

/// The parts of channels, in the order in which timelines show them.
enum class ChannelPart : std::uint8_t {
    GlobalTranslation, ///< handed on to the children (SPEC B2)
    GlobalOrientation,
    GlobalScale,
    LocalTranslation, ///< shapes the node's own geometry only
    LocalOrientation,
    LocalScale,
    Parameter, ///< a row of the parameter table with paramAnimatable
    Joint,     ///< a number of an arm's joint: a row of the joint table
};

/// Names one track of a node. Numbers have a channel each: three of a translation, of a scale and of a vector
/// parameter. An orientation is one channel.
struct Channel
{
    ChannelPart part = ChannelPart::GlobalTranslation;
    std::uint8_t component = 0; ///< 0, 1, 2 = x, y, z; of joints which one, from the foot on; else 0
    ParamId param = 0;          ///< parameter, for ChannelPart::Parameter; for joints the row of their table
    auto operator<=>(const Channel&) const = default;

    [[nodiscard]] bool isOrientation() const
    {
        return part == ChannelPart::GlobalOrientation || part == ChannelPart::LocalOrientation;
    }
    [[nodiscard]] bool isScale() const
    {
        return part == ChannelPart::GlobalScale || part == ChannelPart::LocalScale;
    }
    [[nodiscard]] const ParamDef* def() const
    {
        return part == ChannelPart::Parameter ? &paramTable()[param] : nullptr;
    }
    [[nodiscard]] const JointDef* jointDef() const
    {
        return part == ChannelPart::Joint ? &jointTable()[param] : nullptr;
    }
};

/// Returns all channels that a node of this kind may have, in order, without those of joints.
std::vector<Channel> channelsOf(NodeKind kind);
/// All numbers of one joint.
std::vector<Channel> jointChannels(std::size_t joint);
/// Returns true if nodes of this kind have the channel. An arm has mostArmJoints joints, as many as it may
/// get.
bool hasChannel(NodeKind kind, const Channel& channel);
/// "global.translation.x", "local.orientation", "physics.windStrength", "primitive.size.y",
/// "joints[2].phi.angle": unique, used by files.
std::string channelKey(const Channel& channel);
/// Error: Unknown, where no channel of this kind of node has this key.
Expected<Channel> channelFromKey(std::string_view key, NodeKind kind);
/// Returns the value of a channel without a track: 0 for translations, 1 for scales, the parameter's value
/// for parameters, 0 for joints that the arm does not have. Orientations are excluded; they rest at the
/// identity.
double restValue(const NodeParams& params, const Channel& channel);

/// \name Keys of tracks of either kind
/// \{
[[nodiscard]] std::size_t keyCount(const AnyTrack& track);
[[nodiscard]] const KeyShape& keyShape(const AnyTrack& track, std::size_t index);
[[nodiscard]] bool isEmpty(const AnyTrack& track);
/// \}

} // namespace ramure
