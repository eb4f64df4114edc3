// What an artist sets on single branches by hand.
#include "core/math/finite.h"
#include "core/qt/document/document_command.h"
#include "core/skeleton/edit_places.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace ramure {

namespace {

struct BranchTarget
{
    using Value = BranchParams;

    NodeId node;
    std::uint64_t key;
    Stage stale = Stage::Sections; ///< the first stage that the change concerns

    [[nodiscard]] Value get(const Node& from) const
    {
        const auto it = from.params.branches.find(key);
        return it == from.params.branches.end() ? Value{} : it->second;
    }
    /// Defaults are not kept: a branch that was set back is as one never touched.
    void set(Node& into, const Value& value) const
    {
        if (value.changesNothing())
            into.params.branches.erase(key);
        else
            into.params.branches[key] = value;
    }
    void describe(Change& change) const
    {
        change.kinds |= changeBranches;
        change.firstStale = stale;
        addOnce(change.nodes, node);
    }
    bool operator==(const BranchTarget&) const = default;
};
using BranchEntry = SetCommand<BranchTarget>::Entry;

Expected<void> checkTree(const Document& document, NodeId node)
{
    if (auto allowed = checkEditable(document.scene(), node); !allowed)
        return allowed;
    const Node& tree = *document.scene().find(node);
    if (tree.kind != NodeKind::Tree)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" has no branches"), {tree.name});
    return {};
}

/// Edits of branches that had none learn where these stand in the tree that is shown: that is the one in
/// which the artist chose them.
void pushEdits(Document& document, NodeId node, std::vector<BranchEntry> entries, const QString& text,
               GestureId gesture)
{
    BranchEdits edits;
    for (const BranchEntry& entry : entries)
        if (!entry.value.changesNothing())
            edits[entry.target.key] = entry.value;
    const NodeResult* shown = document.result(node);
    if (shown && shown->tree.skeleton && shown->tree.simplified)
        rememberPlaces(*shown->tree.skeleton, *shown->tree.simplified, edits);
    for (BranchEntry& entry : entries)
        entry.value = edits[entry.target.key]; // set back: as one never touched
    pushSet<BranchTarget>(document, std::move(entries), text, gesture);
}

Expected<void> checkBends(const std::map<std::uint64_t, glm::dvec3>& bendRad)
{
    for (const auto& [key, bend] : bendRad)
        if (!isFinite(bend))
            return fail(ErrorCode::Invalid, RAMURE_NOOP("the bend of a branch must be finite"));
    return {};
}

} // namespace

Expected<void> edit::turnBranches(Document& document, NodeId node,
                                  const std::map<std::uint64_t, glm::dvec3>& bendRad, GestureId gesture)
{
    if (auto allowed = checkTree(document, node); !allowed)
        return allowed;
    if (auto checked = checkBends(bendRad); !checked)
        return checked;
    std::vector<BranchEntry> entries;
    for (const auto& [key, bend] : bendRad) {
        const BranchTarget target{node, key, Stage::Simplified};
        BranchParams values = target.get(*document.scene().find(node));
        values.bendRad = bend;
        entries.push_back({target, values});
    }
    const int count = static_cast<int>(entries.size());
    const bool straightens =
        std::ranges::all_of(bendRad, [](const auto& entry) { return entry.second == glm::dvec3(0.0); });
    pushEdits(document, node, std::move(entries),
              straightens ? DocumentCommand::tr("Straighten %n branch(es)", nullptr, count)
                          : DocumentCommand::tr("Bend %n branch(es)", nullptr, count),
              gesture);
    return {};
}

Expected<void> edit::setBranchBends(Document& document, NodeId node,
                                    const std::map<std::uint64_t, glm::dvec3>& bendRad)
{
    if (auto allowed = checkTree(document, node); !allowed)
        return allowed;
    const Node& tree = *document.scene().find(node);
    if (auto checked = checkBends(bendRad); !checked)
        return checked;
    std::map<std::uint64_t, glm::dvec3> all = bendRad;
    for (const auto& [key, values] : tree.params.branches)
        all.try_emplace(key, 0.0);
    std::vector<BranchEntry> entries;
    int turned = 0;
    for (const auto& [key, bend] : all) {
        const BranchTarget target{node, key, Stage::Simplified};
        BranchParams values = target.get(tree);
        if (values.bendRad == bend)
            continue;
        ++turned;
        values.bendRad = bend;
        entries.push_back({target, values});
    }
    pushEdits(document, node, std::move(entries), DocumentCommand::tr("Turn %n branch(es)", nullptr, turned),
              0);
    return {};
}

Expected<void> edit::setBranchRoll(Document& document, NodeId node, const std::vector<std::uint64_t>& keys,
                                   double rollRad, GestureId gesture)
{
    if (auto allowed = checkTree(document, node); !allowed)
        return allowed;
    const Node& tree = *document.scene().find(node);
    if (!std::isfinite(rollRad))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("a roll must be a finite angle"));
    std::vector<std::uint64_t> once = keys;
    std::sort(once.begin(), once.end());
    once.erase(std::unique(once.begin(), once.end()), once.end());
    std::vector<BranchEntry> entries;
    for (const std::uint64_t key : once) {
        const BranchTarget target{node, key};
        BranchParams values = target.get(tree);
        values.rollRad = rollRad;
        entries.push_back({target, values});
    }
    pushEdits(document, node, std::move(entries),
              DocumentCommand::tr("Roll %n branch(es)", nullptr, static_cast<int>(once.size())), gesture);
    return {};
}

Expected<void> edit::removeBranchEdits(Document& document, NodeId node,
                                       const std::vector<std::uint64_t>& names)
{
    if (auto allowed = checkTree(document, node); !allowed)
        return allowed;
    const std::set<std::uint64_t> once(names.begin(), names.end());
    std::vector<BranchEntry> entries;
    for (const std::uint64_t name : once)
        entries.push_back({{node, name, Stage::Simplified}, {}});
    const int count = static_cast<int>(entries.size());
    pushSet<BranchTarget>(document, std::move(entries),
                          DocumentCommand::tr("Delete %n edit(s) of branches", nullptr, count));
    return {};
}

} // namespace ramure
