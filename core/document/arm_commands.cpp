// The joints of arms.
#include "core/arm/arm_chain.h"
#include "core/document/document_command.h"

namespace ramure {

namespace {

struct JointsTarget
{
    using Value = std::vector<ArmJoint>;
    static constexpr CommandId id = CommandId::SetJoints;

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

} // namespace

Expected<void> edit::setJoints(Document& document, NodeId node, std::vector<ArmJoint> joints,
                               const QString& text, GestureId gesture)
{
    if (auto allowed = checkEditable(document.scene(), node); !allowed)
        return allowed;
    const Node& arm = *document.scene().find(node);
    if (arm.kind != NodeKind::Arm)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" is no arm"), {arm.name});
    if (auto checked = checkArm(joints); !checked)
        return checked;
    pushSet<JointsTarget>(document, {{{node}, std::move(joints)}}, text, gesture);
    return {};
}

} // namespace ramure
