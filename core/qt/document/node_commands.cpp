// State of nodes: name and preset, visible, locked.
#include "core/qt/document/document_command.h"
#include "core/qt/document/origin_commands.h"

namespace ramure {

namespace {

struct NodeState
{
    std::string name;
    bool visible = true;
    bool locked = false;
    std::string preset{};
    bool operator==(const NodeState&) const = default;
};

struct StateTarget
{
    using Value = NodeState;

    NodeId node;

    [[nodiscard]] Value get(const Node& from) const
    {
        return {from.name, from.visible, from.locked, from.preset};
    }
    void set(Node& into, Value value) const
    {
        into.name = std::move(value.name);
        into.visible = value.visible;
        into.locked = value.locked;
        into.preset = std::move(value.preset);
    }
    void describe(Change& change) const
    {
        change.kinds |= changeNodeState;
        addOnce(change.nodes, node);
    }
    bool operator==(const StateTarget&) const = default;
};
using StateEntry = SetCommand<StateTarget>::Entry;

/// \p nodes exist, each once.
template <class Member, class Value>
void pushState(Document& document, const std::vector<NodeId>& nodes, Member member, const Value& value,
               const QString& text)
{
    std::vector<StateEntry> entries;
    for (const NodeId id : nodes) {
        NodeState state = StateTarget{id}.get(*document.scene().find(id));
        state.*member = value;
        entries.push_back({{id}, std::move(state)});
    }
    pushSet<StateTarget>(document, std::move(entries), text);
}

} // namespace

Expected<void> edit::setNodeName(Document& document, NodeId node, const QString& name)
{
    const auto ids = editable(document.scene(), {node});
    RAMURE_TRY(ids);
    pushState(document, *ids, &NodeState::name, name.toStdString(), DocumentCommand::tr("Rename"));
    return {};
}

Expected<void> edit::setNodeOrigin(Document& document, NodeId node, const std::string& name,
                                   const std::string& preset, const QString& text)
{
    const auto ids = editable(document.scene(), {node});
    RAMURE_TRY(ids);
    NodeState state = StateTarget{node}.get(*document.scene().find(node));
    state.name = name;
    state.preset = preset;
    pushSet<StateTarget>(document, {{{node}, std::move(state)}}, text);
    return {};
}

Expected<void> edit::setNodeVisible(Document& document, const std::vector<NodeId>& nodes, bool visible)
{
    const auto ids = editable(document.scene(), nodes);
    RAMURE_TRY(ids);
    pushState(document, *ids, &NodeState::visible, visible,
              visible ? DocumentCommand::tr("Show") : DocumentCommand::tr("Hide"));
    return {};
}

Expected<void> edit::setNodeLocked(Document& document, const std::vector<NodeId>& nodes, bool locked)
{
    std::vector<NodeId> once;
    for (const NodeId id : nodes) {
        if (!document.scene().find(id))
            return unknownNode(id);
        addOnce(once, id);
    }
    pushState(document, once, &NodeState::locked, locked,
              locked ? DocumentCommand::tr("Lock") : DocumentCommand::tr("Unlock"));
    return {};
}

} // namespace ramure
