/// \file
/// All tracks of one node, and the values they give at a time.
#pragma once

#include "core/rig/tracks/channel.h"
#include <glm/mat4x4.hpp>
#include <map>
#include <memory>

namespace ramure {

/// Cheap to copy: tracks are shared and never changed in place.
class NodeAnimation
{
public:
    using TrackPtr = std::shared_ptr<const AnyTrack>;

    [[nodiscard]] const std::map<Channel, TrackPtr>& tracks() const { return m_tracks; }
    [[nodiscard]] bool empty() const { return m_tracks.empty(); }
    /// Null if the channel has no track. An orientation channel always gives an OrientationTrack, the others
    /// always a Track.
    [[nodiscard]] TrackPtr find(const Channel& channel) const;
    /// A track without keys, or null, is none: the channel rests. \pre the kind of track fits the channel.
    void set(const Channel& channel, TrackPtr track);
    void set(const Channel& channel, AnyTrack track);
    /// A track of a parameter or of a joint.
    [[nodiscard]] bool movesParams() const;
    /// A track of the global or local transform.
    [[nodiscard]] bool movesNode() const;
    bool operator==(const NodeAnimation& other) const;

private:
    std::map<Channel, TrackPtr> m_tracks; ///< none is null or empty
};

/// Translation, orientation and scale at a time, composed T * R * S, each once (SPEC B1). Channels without a
/// track rest (0, identity, 1). \param first GlobalTranslation or LocalTranslation.
glm::dmat4 transformAt(const NodeAnimation& animation, ChannelPart first, double seconds);
/// Returns the parameters at a time. Those with tracks take the track's value, kept within the hard range;
/// whole numbers are rounded. Joints are settled by settleAngle. Tracks of joints that the arm does not have
/// are ignored.
NodeParams paramsAt(const NodeParams& params, const NodeAnimation& animation, double seconds);
/// The joints alone, as paramsAt.
void moveJoints(std::vector<ArmJoint>& joints, const NodeAnimation& animation, double seconds);
/// First and last key of all tracks. \pre not empty.
std::pair<Ticks, Ticks> rangeOf(const NodeAnimation& animation);

} // namespace ramure
