#include "core/scene/node_transform.h"

#include "core/math/angle.h"
#include "core/math/drag_maths.h"
#include "core/math/finite.h"
#include "core/rig/tracks/euler.h"
#include "core/rig/tracks/keyed_track.h"
#include "core/scene/world_transforms.h"
#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <set>

namespace ramure {
namespace {

constexpr double dust = 1e-12; ///< relative: what rounding leaves of nothing
constexpr double leastScale = 1e-4, mostScale = 1e4, mostPlace = 1e6; ///< ranges of the parameter table
constexpr double mostAngle = 199.0 * pi;
constexpr std::size_t orientation = 3; ///< of GlobalTracks

/// Translation, rotation and scale that change, what they stand in, and where behind them the node's origin
/// lies.
struct Carrier
{
    glm::dmat4 above{1.0};
    glm::dvec3 translation{0.0};
    glm::dmat3 rotation{1.0};
    glm::dvec3 scale{1.0};
    glm::dvec3 offset{0.0};
};

double numberOf(const NodeAnimation::TrackPtr& track, double seconds, double rest)
{
    return track ? valueAt(std::get<Track>(*track), seconds) : rest;
}

glm::dquat turnOf(const NodeAnimation::TrackPtr& track, double seconds)
{
    return track ? valueAt(std::get<OrientationTrack>(*track), seconds) : glm::dquat(1.0, 0.0, 0.0, 0.0);
}

Carrier carrierOf(const TransformStart& start)
{
    const PlacementParams& placement = start.values.placement;
    if (!start.keys)
        return {start.parentWorld * start.track, placement.translation, rotationMatrix(placement.rotation),
                placement.scale, glm::dvec3(0.0)};
    Carrier carrier;
    carrier.above = start.parentWorld;
    for (std::size_t c = 0; c < 3; ++c) {
        const auto i = static_cast<glm::length_t>(c);
        carrier.translation[i] = numberOf(start.values.tracks[c], start.seconds, 0.0);
        carrier.scale[i] = numberOf(start.values.tracks[orientation + 1 + c], start.seconds, 1.0);
    }
    carrier.rotation = glm::mat3_cast(turnOf(start.values.tracks[orientation], start.seconds));
    carrier.offset = placement.translation;
    return carrier;
}

glm::dmat3 stretch(const WorldTransform& transform)
{
    const glm::dmat3& f = transform.frame;
    glm::dmat3 result(0.0);
    for (int i = 0; i < 3; ++i)
        result += transform.factors[i] * glm::outerProduct(f[i], f[i]);
    return result;
}

double clampedScale(double scale, double before)
{
    return before > 0.0 ? std::clamp(scale, leastScale, mostScale) : scale;
}

void scaleAxes(Carrier& carrier, const WorldTransform& transform)
{
    const glm::dmat3 grow = stretch(transform);
    const glm::dmat3 axes = glm::dmat3(carrier.above) * carrier.rotation;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 axis = axes[i] / glm::length(axes[i]);
        const glm::dvec3 grown = grow * axis;
        double factor = std::copysign(glm::length(grown), glm::dot(grown, axis));
        if (std::abs(factor - 1.0) < dust)
            factor = 1.0;
        carrier.scale[i] = clampedScale(carrier.scale[i] * factor, carrier.scale[i]);
    }
}

void turn(Carrier& carrier, const WorldTransform& transform)
{
    const glm::dmat3 above = nearestRotation(glm::dmat3(carrier.above));
    const glm::dmat3 turned = turnAbout(transform.axis, transform.angleRad);
    carrier.rotation = glm::transpose(above) * turned * above * carrier.rotation;
}

/// \p by without the dust in components that ought not to change.
glm::dvec3 cleaned(glm::dvec3 by, double size)
{
    for (int i = 0; i < 3; ++i)
        if (std::abs(by[i]) <= dust * size)
            by[i] = 0.0;
    return by;
}

void carry(Carrier& carrier, const TransformStart& start, const WorldTransform& transform)
{
    const Carrier before = carrier;
    if (transform.factors != glm::dvec3(1.0))
        scaleAxes(carrier, transform);
    if (transform.angleRad != 0.0)
        turn(carrier, transform);
    // From differences, so that what stays, stays exactly.
    const glm::dmat3 into = glm::inverse(glm::dmat3(carrier.above));
    const glm::dvec3 way = transform.at(start.origin()) - start.origin();
    const glm::dvec3 swing = before.rotation * (before.scale * before.offset) -
                             carrier.rotation * (carrier.scale * carrier.offset);
    const double size = std::max(glm::length(into * way), glm::length(before.scale * before.offset));
    carrier.translation =
        glm::clamp(before.translation + cleaned(into * way + swing, size), -mostPlace, mostPlace);
}

/// Angles of this rotation, near \p old and inside the range of the parameter; what only rounding tells from
/// \p old is \p old.
glm::dvec3 anglesNear(const glm::dmat3& rotation, const glm::dvec3& old)
{
    glm::dvec3 angles = anglesOf(rotation, old);
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        double& angle = angles[axis];
        if (std::abs(angle) > mostAngle)
            angle = std::remainder(angle, 2.0 * pi);
        if (std::abs(angle - old[axis]) < 1e-14 * std::max(1.0, std::abs(old[axis])))
            angle = old[axis];
    }
    return angles;
}

Expected<void> setNumber(NodeAnimation::TrackPtr& track, Ticks time, double before, double now)
{
    if (!track && before == now)
        return {};
    auto made = withKey<Track>(track, time, now);
    RAMURE_TRY(made);
    track = std::move(*made);
    return {};
}

Expected<NodeTransform> withKeys(const TransformStart& start, const Carrier& before, const Carrier& now)
{
    NodeTransform values = start.values;
    const Ticks time = ticksOf(start.seconds);
    for (std::size_t c = 0; c < 3; ++c) {
        const auto i = static_cast<glm::length_t>(c);
        if (now.translation != before.translation)
            RAMURE_TRY(setNumber(values.tracks[c], time, before.translation[i], now.translation[i]));
        auto& scale = values.tracks[orientation + 1 + c];
        if (now.scale != before.scale)
            RAMURE_TRY(setNumber(scale, time, before.scale[i], now.scale[i]));
    }
    if (now.rotation != before.rotation) {
        auto made = withKey<OrientationTrack>(values.tracks[orientation], time,
                                              glm::normalize(glm::quat_cast(now.rotation)));
        RAMURE_TRY(made);
        values.tracks[orientation] = std::move(*made);
    }
    return values;
}

} // namespace

glm::dvec3 WorldTransform::at(const glm::dvec3& world) const
{
    glm::dvec3 away = world - pivot;
    if (factors != glm::dvec3(1.0))
        away = stretch(*this) * away;
    if (angleRad != 0.0)
        away = turnAbout(axis, angleRad) * away;
    return factors == glm::dvec3(1.0) && angleRad == 0.0 ? world + move : pivot + away + move;
}

Channel globalChannel(std::size_t index)
{
    if (index < orientation)
        return {ChannelPart::GlobalTranslation, static_cast<std::uint8_t>(index), 0};
    if (index == orientation)
        return {ChannelPart::GlobalOrientation, 0, 0};
    return {ChannelPart::GlobalScale, static_cast<std::uint8_t>(index - orientation - 1), 0};
}

GlobalTracks globalTracks(const NodeAnimation& animation)
{
    GlobalTracks tracks;
    for (std::size_t i = 0; i < tracks.size(); ++i)
        tracks[i] = animation.find(globalChannel(i));
    return tracks;
}

std::vector<TransformStart> transformStarts(const Scene& scene, const std::vector<NodeId>& nodes,
                                            double seconds, bool keys)
{
    std::vector<TransformStart> starts;
    if (nodes.empty())
        return starts;
    std::map<NodeId, TransformStart> all; // one pass over the scene: thousands may be selected
    const std::set<NodeId> asked(nodes.begin(), nodes.end());
    std::set<NodeId> below, dead;
    std::map<NodeId, glm::dmat4> worlds;
    for (const Node& node : scene.nodes()) {
        const auto parent = worlds.find(node.parent);
        TransformStart start;
        start.node = node.id;
        start.parentWorld = parent == worlds.end() ? glm::dmat4(1.0) : parent->second;
        start.world = worldUnder(start.parentWorld, node, seconds);
        worlds.emplace(node.id, start.world);
        if (!node.visible || node.locked || dead.contains(node.parent))
            dead.insert(node.id);
        const bool follows = below.contains(node.parent) || asked.contains(node.parent);
        if (follows)
            below.insert(node.id);
        if (follows || dead.contains(node.id) || !asked.contains(node.id))
            continue;
        start.seconds = seconds;
        start.values = {node.params.tree, globalTracks(node.animation)};
        start.track = transformAt(node.animation, ChannelPart::GlobalTranslation, seconds);
        start.keys = keys && std::any_of(start.values.tracks.begin(), start.values.tracks.end(),
                                         [](const auto& track) { return track != nullptr; });
        const glm::dmat3 above(start.keys ? start.parentWorld : start.parentWorld * start.track);
        if (std::abs(glm::determinant(above)) > 1e-30)
            all.emplace(node.id, std::move(start));
    }
    for (const NodeId id : nodes)
        if (const auto found = all.find(id); found != all.end()) {
            starts.push_back(std::move(found->second));
            all.erase(found);
        }
    return starts;
}

glm::dvec3 pivotOf(const std::vector<TransformStart>& starts)
{
    glm::dvec3 sum(0.0);
    for (const TransformStart& start : starts)
        sum += start.origin();
    return sum / double(std::max<std::size_t>(starts.size(), 1));
}

glm::dmat3 transformAxes(const std::vector<TransformStart>& starts, TransformSpace space)
{
    if (starts.empty() || space == TransformSpace::World)
        return glm::dmat3(1.0);
    const TransformStart& active = starts.back();
    return squareFrame(glm::dmat3(space == TransformSpace::Local ? active.world : active.parentWorld));
}

Expected<NodeTransform> transformed(const TransformStart& start, const WorldTransform& transform)
{
    if (!isFinite(transform.move) || !isFinite(transform.factors) || !isFinite(transform.pivot) ||
        !isFinite(transform.axis) || !std::isfinite(transform.angleRad))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the place in the world is not a finite one"));
    const bool rests = transform.move == glm::dvec3(0.0) && transform.factors == glm::dvec3(1.0) &&
                       transform.angleRad == 0.0;
    if (rests)
        return start.values;
    const Carrier before = carrierOf(start);
    Carrier now = before;
    carry(now, start, transform);
    if (start.keys)
        return withKeys(start, before, now);
    NodeTransform values = start.values;
    values.placement.translation = now.translation;
    values.placement.scale = now.scale;
    if (transform.angleRad != 0.0)
        values.placement.rotation = anglesNear(now.rotation, values.placement.rotation);
    return values;
}

} // namespace ramure
