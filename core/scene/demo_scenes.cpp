#include "core/scene/demo_scenes.h"

#include "core/math/angle.h"
#include "core/math/reproducible.h"
#include "core/scene/arm_demo.h"
#include "core/scene/recipe_demo.h"

#include <array>
#include <glm/gtc/quaternion.hpp>

namespace ramure {
namespace {

constexpr Ticks duration = 5 * ticksPerSecond;

using TrackPtr = NodeAnimation::TrackPtr;

glm::dquat aboutX(double angle)
{
    return maths::angleAxis(angle, glm::dvec3(1.0, 0.0, 0.0));
}

glm::dquat aboutY(double angle)
{
    return maths::angleAxis(angle, glm::dvec3(0.0, 1.0, 0.0));
}

glm::dquat aboutZ(double angle)
{
    return maths::angleAxis(angle, glm::dvec3(0.0, 0.0, 1.0));
}

OrientationKey linearKey(Ticks time, const glm::dquat& value)
{
    OrientationKey key;
    key.time = time;
    key.mode = KeyMode::Linear;
    key.value = value;
    return key;
}

/// All keys are finite numbers: the tracks are always valid.
TrackPtr orientations(std::vector<OrientationKey> keys, Ticks loop = 0)
{
    auto track = *OrientationTrack::fromKeys(std::move(keys));
    track.loop = loop;
    track.settleEnds();
    return std::make_shared<const AnyTrack>(std::move(track));
}

/// One key at the beginning: the value throughout.
TrackPtr constant(double value)
{
    Key key;
    key.mode = KeyMode::Linear;
    key.value = value;
    return std::make_shared<const AnyTrack>(*Track::fromKeys({key}));
}

void setVector(NodeAnimation& animation, ChannelPart part, const std::array<TrackPtr, 3>& tracks)
{
    for (std::uint8_t c = 0; c < 3; ++c)
        animation.set({part, c, 0}, tracks[c]);
}

TimelineSettings fiveSeconds()
{
    TimelineSettings settings;
    settings.lastFrame = 120;
    return settings;
}

Scene sceneOf(std::vector<Node> nodes)
{
    auto scene = Scene::fromNodes(std::move(nodes));
    scene->setTimeline(fiveSeconds());
    return std::move(*scene);
}

/// Rolls along a circle. Keys a quarter turn apart: the shorter way between keys three quarters apart would
/// be backwards.
Scene movingCylinder()
{
    std::vector<OrientationKey> about, roll;
    for (int i = 0; i < 4; ++i) {
        about.push_back(linearKey(duration * i / 3, aboutY(i * 90.0 * oneDegree)));
        roll.push_back(linearKey(duration * i / 3, aboutZ(i * 90.0 * oneDegree)));
    }
    Node node;
    node.id = 1;
    node.kind = NodeKind::Primitive;
    node.name = "Cylinder";
    node.params.primitive.radius = 1.0;
    node.params.primitive.axis = PrimitiveAxis::Z;
    node.params.surface.color = {0.85, 0.45, 0.2};
    node.animation.set({ChannelPart::GlobalOrientation, 0, 0}, orientations(std::move(about)));
    setVector(node.animation, ChannelPart::LocalTranslation, {constant(0.0), constant(0.0), constant(-5.0)});
    node.animation.set({ChannelPart::LocalOrientation, 0, 0}, orientations(std::move(roll)));
    return sceneOf({std::move(node)});
}

constexpr int childCount = 4, levelCount = 5;

/// What the children of one place have in common: tracks are shared by all of them.
struct ChildTracks
{
    std::array<TrackPtr, 3> translation{constant(0.0), constant(1.0), constant(0.0)};
    std::array<TrackPtr, 3> scale{constant(0.75), constant(0.75), constant(0.75)};
    std::array<TrackPtr, childCount> orientation;

    ChildTracks()
    {
        for (std::size_t i = 0; i < orientation.size(); ++i) {
            const glm::dquat out = aboutY((35.0 + double(i) * 90.0) * oneDegree);
            const glm::dquat bent = out * aboutX(45.0 * oneDegree), straight = out * aboutX(35.0 * oneDegree);
            orientation[i] = orientations(
                {linearKey(0, bent), linearKey(duration / 2, straight), linearKey(duration, bent)}, duration);
        }
    }
};

Node cylinderOfTree(NodeId id, NodeId parent, std::string name)
{
    Node node;
    node.id = id;
    node.parent = parent;
    node.kind = NodeKind::Primitive;
    node.name = std::move(name);
    node.params.primitive.radius = 1.0;
    node.params.local.scale = {0.15, 1.0, 0.15};
    node.params.surface.color = {0.55, 0.35, 0.17};
    return node;
}

void addChildren(std::vector<Node>& nodes, NodeId parent, const std::string& name, int level,
                 const ChildTracks& tracks)
{
    for (std::size_t i = 0; i < tracks.orientation.size() && level <= levelCount; ++i) {
        const auto id = static_cast<NodeId>(nodes.size() + 1);
        const std::string own =
            std::string(name).append(level == 1 ? " " : ".").append(std::to_string(i + 1));
        Node node = cylinderOfTree(id, parent, own);
        setVector(node.animation, ChannelPart::GlobalTranslation, tracks.translation);
        node.animation.set({ChannelPart::GlobalOrientation, 0, 0}, tracks.orientation[i]);
        setVector(node.animation, ChannelPart::GlobalScale, tracks.scale);
        nodes.push_back(std::move(node));
        addChildren(nodes, id, own, level + 1, tracks);
    }
}

Scene movingTree()
{
    std::vector<Node> nodes{cylinderOfTree(1, noNode, "Trunk")};
    addChildren(nodes, 1, "Branch", 1, ChildTracks());
    return sceneOf(std::move(nodes));
}

constexpr std::array demos{
    DemoScene{"MovingCylinder", RAMURE_NOOP("Moving cylinder"), movingCylinder},
    DemoScene{"MovingTree", RAMURE_NOOP("Moving tree"), movingTree},
    DemoScene{"Arm", RAMURE_NOOP("Articulated arm"), armDemo},
    DemoScene{"Recipes", RAMURE_NOOP("Six recipes"), recipeDemo},
};

} // namespace

std::span<const DemoScene> demoScenes()
{
    return demos;
}

Expected<Scene> demoScene(std::string_view name)
{
    std::string names;
    for (const DemoScene& demo : demos) {
        if (name == demo.name)
            return demo.make();
        names.append(names.empty() ? "" : ", ").append(demo.name);
    }
    return fail(ErrorCode::Unknown, RAMURE_NOOP("unknown demo \"%1\": one of %2 expected"),
                {std::string(name), names});
}

} // namespace ramure
