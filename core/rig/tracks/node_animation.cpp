#include "core/rig/tracks/node_animation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ramure {

NodeAnimation::TrackPtr NodeAnimation::find(const Channel& channel) const
{
    const auto found = m_tracks.find(channel);
    return found == m_tracks.end() ? nullptr : found->second;
}

void NodeAnimation::set(const Channel& channel, TrackPtr track)
{
    if (!track || isEmpty(*track))
        m_tracks.erase(channel);
    else
        m_tracks[channel] = std::move(track);
}

void NodeAnimation::set(const Channel& channel, AnyTrack track)
{
    set(channel, std::make_shared<const AnyTrack>(std::move(track)));
}

bool NodeAnimation::movesParams() const
{
    return !m_tracks.empty() && m_tracks.rbegin()->first.part >= ChannelPart::Parameter;
}

bool NodeAnimation::movesNode() const
{
    return !m_tracks.empty() && m_tracks.begin()->first.part < ChannelPart::Parameter;
}

bool NodeAnimation::operator==(const NodeAnimation& other) const
{
    return std::equal(m_tracks.begin(), m_tracks.end(), other.m_tracks.begin(), other.m_tracks.end(),
                      [](const auto& a, const auto& b) {
                          return a.first == b.first && (a.second == b.second || *a.second == *b.second);
                      });
}

static double numberAt(const NodeAnimation& animation, const Channel& channel, double seconds, double rest)
{
    const auto found = animation.tracks().find(channel);
    const auto* track = found == animation.tracks().end() ? nullptr : std::get_if<Track>(found->second.get());
    return track ? valueAt(*track, seconds) : rest;
}

glm::dmat4 transformAt(const NodeAnimation& animation, ChannelPart first, double seconds)
{
    if (!animation.movesNode())
        return glm::dmat4(1.0);
    const auto part = [first](int behind) {
        return static_cast<ChannelPart>(static_cast<int>(first) + behind);
    };
    glm::dvec3 translation(0.0), scale(1.0);
    for (std::uint8_t c = 0; c < 3; ++c) {
        translation[c] = numberAt(animation, {part(0), c, 0}, seconds, 0.0);
        scale[c] = numberAt(animation, {part(2), c, 0}, seconds, 1.0);
    }
    glm::dmat3 rotation(1.0);
    if (const auto held = animation.find({part(1), 0, 0}))
        if (const auto* track = std::get_if<OrientationTrack>(held.get()))
            rotation = glm::mat3_cast(valueAt(*track, seconds));
    return {glm::dvec4(rotation[0] * scale.x, 0.0), glm::dvec4(rotation[1] * scale.y, 0.0),
            glm::dvec4(rotation[2] * scale.z, 0.0), glm::dvec4(translation, 1.0)};
}

/// One component of a parameter takes a number.
static void assignNumber(NodeParams& params, const Channel& channel, double number)
{
    const ParamDef& def = *channel.def();
    ParamValue value = def.get(params);
    if (auto* vector = std::get_if<glm::dvec3>(&value))
        (*vector)[channel.component] = number;
    else if (auto* whole = std::get_if<std::int64_t>(&value))
        *whole = std::llround(std::clamp(number, def.hardMin, def.hardMax));
    else if (auto* real = std::get_if<double>(&value))
        *real = number;
    def.assign(params, clampValue(def, value));
}

void moveJoints(std::vector<ArmJoint>& joints, const NodeAnimation& animation, double seconds)
{
    bool any = false;
    const auto& tracks = animation.tracks();
    for (auto at = tracks.lower_bound({ChannelPart::Joint, 0, 0}); at != tracks.end(); ++at) {
        const auto* track = std::get_if<Track>(at->second.get());
        const JointDef* def = at->first.jointDef();
        if (!track || !def || at->first.component >= joints.size())
            continue;
        def->of(joints[at->first.component]) =
            std::clamp(valueAt(*track, seconds), def->hardMin, def->hardMax);
        any = true;
    }
    for (ArmJoint& joint : joints)
        if (any) {
            settleAngle(joint.phi);
            settleAngle(joint.theta);
        }
}

NodeParams paramsAt(const NodeParams& params, const NodeAnimation& animation, double seconds)
{
    NodeParams now = params;
    for (const auto& [channel, held] : animation.tracks())
        if (const auto* track = std::get_if<Track>(held.get()); track && channel.def())
            assignNumber(now, channel, valueAt(*track, seconds));
    moveJoints(now.joints, animation, seconds);
    return now;
}

std::pair<Ticks, Ticks> rangeOf(const NodeAnimation& animation)
{
    std::pair<Ticks, Ticks> range{std::numeric_limits<Ticks>::max(), std::numeric_limits<Ticks>::min()};
    for (const auto& [channel, track] : animation.tracks()) {
        range.first = std::min(range.first, keyShape(*track, 0).time);
        range.second = std::max(range.second, keyShape(*track, keyCount(*track) - 1).time);
    }
    return range;
}

} // namespace ramure
