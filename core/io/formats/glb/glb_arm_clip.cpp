#include "core/io/formats/glb/glb_arm_clip.h"

#include <algorithm>
#include <set>

namespace ramure::glb {

namespace {

constexpr std::size_t mostKeys = 100'000;

/// The nodes from one joint, without it, down to the next one; before the first joint none.
std::vector<Index> wayTo(const FileNodes& nodes, Index joint, Index above)
{
    std::vector<Index> way{joint};
    for (Index at = nodes.all[joint].parent; above != noIndex && at != above && at != noIndex;
         at = nodes.all[at].parent)
        way.push_back(at);
    std::ranges::reverse(way);
    return way;
}

std::set<Ticks> timesOf(const std::vector<std::vector<Index>>& ways, const Clip& clip)
{
    std::set<Ticks> times;
    for (const std::vector<Index>& way : ways)
        for (const Index node : way)
            if (const auto moves = clip.moves.find(node); moves != clip.moves.end())
                for (const auto& [channel, track] : moves->second.tracks())
                    if (keyCount(*track) > 1)
                        for (std::size_t i = 0; i < keyCount(*track) && times.size() < mostKeys; ++i)
                            times.insert(keyShape(*track, i).time);
    return times;
}

} // namespace

NodeAnimation armTracks(const ChainArm& arm, const Chain& chain, const FileNodes& nodes, const Clip& clip,
                        std::span<const Index> joints)
{
    std::vector<std::vector<Index>> ways;
    for (std::size_t j = 0; j < joints.size(); ++j)
        ways.push_back(wayTo(nodes, joints[j], j == 0 ? noIndex : joints[j - 1]));
    std::vector<std::array<std::vector<Key>, 2>> keys(joints.size());
    std::vector<ArmJoint> pose = arm.joints;
    for (const Ticks time : timesOf(ways, clip)) {
        std::vector<glm::dmat4> transforms;
        glm::dmat4 at(1.0);
        for (const std::vector<Index>& way : ways) {
            for (const Index node : way) {
                const auto moves = clip.moves.find(node);
                at = at * (moves == clip.moves.end()
                               ? nodes.all[node].local
                               : transformAt(moves->second, ChannelPart::GlobalTranslation, secondsOf(time)));
            }
            transforms.push_back(at);
        }
        poseArm(arm, chain, transforms, pose);
        for (std::size_t j = 0; j < pose.size(); ++j)
            for (const int which : {0, 1}) {
                Key& key = keys[j][static_cast<std::size_t>(which)].emplace_back();
                key.time = time;
                key.mode = KeyMode::Linear;
                key.value = which == 0 ? pose[j].phi.angleRad : pose[j].theta.angleRad;
            }
    }
    NodeAnimation out;
    for (std::size_t j = 0; j < joints.size() && !keys[j][0].empty(); ++j)
        for (const char* name : {"phi", "theta"}) {
            const auto channel =
                channelFromKey("joints[" + std::to_string(j) + "]." + name + ".angle", NodeKind::Arm);
            auto track = Track::fromKeys(std::move(keys[j][name[0] == 'p' ? 0 : 1]));
            if (channel && track)
                out.set(*channel, std::move(*track));
        }
    return out;
}

} // namespace ramure::glb
