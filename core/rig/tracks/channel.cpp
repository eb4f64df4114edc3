#include "core/rig/tracks/channel.h"

#include <array>
#include <charconv>

namespace ramure {

static constexpr std::array<const char*, 6> partKeys{"global.translation", "global.orientation",
                                                     "global.scale",       "local.translation",
                                                     "local.orientation",  "local.scale"};
static constexpr std::array<const char*, 3> axisKeys{".x", ".y", ".z"};

static int componentsOf(ParamType type)
{
    switch (type) {
    case ParamType::Real:
    case ParamType::Int:
        return 1;
    case ParamType::Vec3:
        return 3;
    default:
        return 0; // switches, texts and choices do not glide
    }
}

std::vector<Channel> channelsOf(NodeKind kind)
{
    std::vector<Channel> channels;
    const bool hasGeometry = kind != NodeKind::Group;
    for (std::size_t i = 0; i < partKeys.size(); ++i) {
        const auto part = static_cast<ChannelPart>(i);
        if (!hasGeometry && part >= ChannelPart::LocalTranslation)
            continue;
        const int count = Channel{part, 0, 0}.isOrientation() ? 1 : 3;
        for (int c = 0; c < count; ++c)
            channels.push_back({part, static_cast<std::uint8_t>(c), 0});
    }
    for (const ParamDef& def : paramTable()) {
        if (!hasParam(kind, def) || (def.flags & paramAnimatable) == 0)
            continue;
        for (int c = 0; c < componentsOf(def.type); ++c)
            channels.push_back({ChannelPart::Parameter, static_cast<std::uint8_t>(c), paramId(def)});
    }
    return channels;
}

std::vector<Channel> jointChannels(std::size_t joint)
{
    std::vector<Channel> channels;
    for (std::size_t number = 0; number < jointTable().size(); ++number)
        channels.push_back(
            {ChannelPart::Joint, static_cast<std::uint8_t>(joint), static_cast<ParamId>(number)});
    return channels;
}

bool hasChannel(NodeKind kind, const Channel& channel)
{
    if (channel.part == ChannelPart::Joint)
        return kind == NodeKind::Arm && channel.component < mostArmJoints &&
               channel.param < jointTable().size();
    if (channel.part == ChannelPart::Parameter) {
        if (channel.param >= paramTable().size())
            return false;
        const ParamDef& def = paramTable()[channel.param];
        return hasParam(kind, def) && (def.flags & paramAnimatable) != 0 &&
               channel.component < componentsOf(def.type);
    }
    const bool local = channel.part >= ChannelPart::LocalTranslation;
    return channel.param == 0 && channel.component < (channel.isOrientation() ? 1 : 3) &&
           !(local && kind == NodeKind::Group);
}

std::string channelKey(const Channel& channel)
{
    if (const JointDef* joint = channel.jointDef())
        return std::string("joints[")
            .append(std::to_string(channel.component))
            .append("].")
            .append(joint->key);
    const ParamDef* def = channel.def();
    std::string key = def ? def->key : partKeys[static_cast<std::size_t>(channel.part)];
    if (def ? def->type == ParamType::Vec3 : !channel.isOrientation())
        key += axisKeys[channel.component];
    return key;
}

/// "joints[2].phi.angle".
static std::optional<Channel> jointFromKey(std::string_view key)
{
    constexpr std::string_view start("joints[");
    const std::size_t end = key.find("].");
    if (key.substr(0, start.size()) != start || end == std::string_view::npos)
        return std::nullopt;
    std::size_t joint = 0;
    const char* last = key.data() + end;
    const auto [stop, error] = std::from_chars(key.data() + start.size(), last, joint);
    const auto number = jointNumber(key.substr(end + 2));
    if (error != std::errc() || stop != last || joint >= mostArmJoints || !number)
        return std::nullopt;
    const Channel channel{ChannelPart::Joint, static_cast<std::uint8_t>(joint),
                          static_cast<ParamId>(*number)};
    return channelKey(channel) == key ? std::optional(channel) : std::nullopt; // not "joints[02]"
}

Expected<Channel> channelFromKey(std::string_view key, NodeKind kind)
{
    if (const auto joint = jointFromKey(key); joint && hasChannel(kind, *joint))
        return *joint;
    for (const Channel& channel : channelsOf(kind))
        if (channelKey(channel) == key)
            return channel;
    return fail(ErrorCode::Unknown, RAMURE_NOOP("there is no track \"%1\" for this kind of node"),
                {std::string(key)});
}

double restValue(const NodeParams& params, const Channel& channel)
{
    if (const JointDef* joint = channel.jointDef())
        return channel.component < params.joints.size() ? joint->of(params.joints[channel.component]) : 0.0;
    const ParamDef* def = channel.def();
    if (!def)
        return channel.isScale() ? 1.0 : 0.0;
    const ParamValue value = def->get(params);
    if (const auto* vector = std::get_if<glm::dvec3>(&value))
        return (*vector)[channel.component];
    if (const auto* whole = std::get_if<std::int64_t>(&value))
        return double(*whole);
    const auto* real = std::get_if<double>(&value);
    return real ? *real : 0.0;
}

std::size_t keyCount(const AnyTrack& track)
{
    return std::visit([](const auto& held) { return held.size(); }, track);
}

bool isEmpty(const AnyTrack& track)
{
    return keyCount(track) == 0;
}

const KeyShape& keyShape(const AnyTrack& track, std::size_t index)
{
    return std::visit([index](const auto& held) -> const KeyShape& { return held.keys()[index]; }, track);
}

} // namespace ramure
