// The joints of arms, and the meshes that they wear.
#include "core/qt/document/document_command.h"
#include "core/rig/arm/arm_chain.h"
#include "core/rig/arm/arm_shape.h"
#include "core/scene/world_transforms.h"
#include <glm/matrix.hpp>

namespace ramure {

namespace {

struct JointsTarget
{
    using Value = std::vector<ArmJoint>;

    NodeId node;

    [[nodiscard]] Value get(const Node& from) const { return from.params.joints; }
    void set(Node& into, Value value) const { into.params.joints = std::move(value); }
    void describe(Change& change) const
    {
        change.kinds |= changeJoints;
        change.firstStale = Stage::Mesh;
        addOnce(change.nodes, node);
    }
    bool operator==(const JointsTarget&) const = default;
};

struct ArmTarget
{
    using Value = ArmState;

    NodeId node;

    [[nodiscard]] Value get(const Node& from) const { return armState(from); }
    void set(Node& into, Value value) const
    {
        into.params.joints = std::move(value.joints);
        into.params.arm.follows = value.follows;
        into.params.arm.target = value.target;
        into.animation = std::move(value.animation);
    }
    void describe(Change& change) const
    {
        change.kinds |= changeJoints | changeParams | changeTracks;
        change.firstStale = Stage::Mesh;
        addOnce(change.nodes, node);
        addOnce(change.params, paramId(*findParam("arm.follows")));
        addOnce(change.params, paramId(*findParam("arm.target")));
    }
    static void count(MemoryCount& memory, const Value& value) { memory.add(value.animation); }
    bool operator==(const ArmTarget&) const = default;
};

/// The tracks of joints from \p from on go \p by further; going back, those of that one are lost.
NodeAnimation movedJointTracks(const NodeAnimation& animation, std::size_t from, int by)
{
    NodeAnimation moved;
    for (const auto& [channel, track] : animation.tracks()) {
        Channel to = channel;
        if (channel.part == ChannelPart::Joint && channel.component >= from) {
            const int joint = channel.component + by;
            const bool taken = by < 0 && channel.component == from;
            if (taken || joint >= static_cast<int>(mostArmJoints))
                continue;
            to.component = static_cast<std::uint8_t>(joint);
        }
        moved.set(to, track);
    }
    return moved;
}

Expected<void> noJoint(const Node& arm, std::size_t at)
{
    return fail(ErrorCode::Unknown, RAMURE_NOOP("\"%1\" has no joint %2"),
                {arm.name, std::to_string(at + 1)});
}

struct ArmMeshTarget
{
    using Value = SharedValue<TriangleMesh>;

    NodeId node;

    [[nodiscard]] Value get(const Node& from) const { return from.mesh; }
    void set(Node& into, Value value) const { into.mesh = std::move(value); }
    void describe(Change& change) const
    {
        change.kinds |= changeJoints;
        change.firstStale = Stage::Mesh;
        addOnce(change.nodes, node);
    }
    static void count(MemoryCount& memory, const Value& mesh) { memory.add(mesh); }
    bool operator==(const ArmMeshTarget&) const = default;
};

} // namespace

Expected<void> edit::setArmMesh(Document& document, NodeId arm, SharedValue<TriangleMesh> mesh,
                                const QString& text)
{
    RAMURE_TRY(editableArm(document.scene(), arm));
    if (mesh)
        if (auto checked = checkArmMesh(*mesh); !checked)
            return checked;
    pushSet<ArmMeshTarget>(document, {{{arm}, std::move(mesh)}}, text);
    return {};
}

Expected<const Node*> editableArm(const Scene& scene, NodeId id)
{
    RAMURE_TRY(checkEditable(scene, id));
    const Node* arm = scene.find(id);
    if (arm->kind != NodeKind::Arm)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" is no arm"), {arm->name});
    return arm;
}

ArmState armState(const Node& arm)
{
    return {arm.params.joints, arm.params.arm.follows, arm.params.arm.target, arm.animation};
}

Expected<void> edit::setArm(Document& document, NodeId node, ArmState state, const QString& text,
                            GestureId gesture)
{
    RAMURE_TRY(editableArm(document.scene(), node));
    if (auto checked = checkArm(state.joints); !checked)
        return checked;
    if (auto checked = checkValue(*findParam("arm.target"), state.target); !checked)
        return checked;
    for (const auto& [channel, track] : state.animation.tracks())
        if (!hasChannel(NodeKind::Arm, channel))
            return fail(ErrorCode::Invalid, RAMURE_NOOP("there is no track \"%1\" for this kind of node"),
                        {channelKey(channel)});
    pushSet<ArmTarget>(document, {{{node}, std::move(state)}}, text, gesture);
    return {};
}

Expected<void> edit::addJoint(Document& document, NodeId node, std::size_t at)
{
    const auto arm = editableArm(document.scene(), node);
    RAMURE_TRY(arm);
    ArmState state = armState(**arm);
    if (at >= state.joints.size())
        return noJoint(**arm, at);
    const ArmJoint copy = state.joints[at];
    state.joints.insert(state.joints.begin() + static_cast<std::ptrdiff_t>(at) + 1, copy);
    state.animation = movedJointTracks(state.animation, at + 1, 1);
    return setArm(document, node, std::move(state), DocumentCommand::tr("Add a joint"));
}

Expected<void> edit::removeJoint(Document& document, NodeId node, std::size_t at)
{
    const auto arm = editableArm(document.scene(), node);
    RAMURE_TRY(arm);
    ArmState state = armState(**arm);
    if (at >= state.joints.size())
        return noJoint(**arm, at);
    state.joints.erase(state.joints.begin() + static_cast<std::ptrdiff_t>(at));
    state.animation = movedJointTracks(state.animation, at, -1);
    return setArm(document, node, std::move(state), DocumentCommand::tr("Remove joint %1").arg(at + 1));
}

Expected<void> edit::setJoints(Document& document, NodeId node, std::vector<ArmJoint> joints,
                               const QString& text, GestureId gesture)
{
    RAMURE_TRY(editableArm(document.scene(), node));
    if (auto checked = checkArm(joints); !checked)
        return checked;
    pushSet<JointsTarget>(document, {{{node}, std::move(joints)}}, text, gesture);
    return {};
}

} // namespace ramure
