// The edits of trees: every command sets the whole list of a tree, which is what undo gives back.
#include "core/document/document_command.h"
#include "core/params/tree_edit_table.h"

#include <QCoreApplication>

namespace ramure {

namespace {

struct EditsTarget
{
    using Value = std::vector<TreeEdit>;
    static constexpr CommandId id = CommandId::SetTreeEdits;

    NodeId node;
    Stage stale = Stage::Skeleton; ///< Placement: only names change, nothing is made anew

    [[nodiscard]] Value get(const Node& from) const { return from.params.edits; }
    void set(Node& into, Value value) const { into.params.edits = std::move(value); }
    void describe(Change& change) const
    {
        change.kinds |= changeBranches;
        change.firstStale = std::min(change.firstStale, stale);
        addOnce(change.nodes, node);
    }
    bool operator==(const EditsTarget&) const = default;
};
using EditsEntry = SetCommand<EditsTarget>::Entry;
using Ids = std::vector<std::uint64_t>;

Expected<const Node*> editableTree(const Document& document, NodeId id)
{
    if (auto allowed = checkEditable(document.scene(), id); !allowed)
        return fail(std::move(allowed.error()));
    const Node* const tree = document.scene().find(id);
    if (tree->kind != NodeKind::Tree)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" has no branches"), {tree->name});
    return tree;
}

/// The tree's list, where it has edits with all these ids.
Expected<std::vector<TreeEdit>> editsWith(const Document& document, NodeId id, const Ids& ids)
{
    const auto tree = editableTree(document, id);
    if (!tree)
        return fail(tree.error());
    const std::vector<TreeEdit>& edits = (*tree)->params.edits;
    for (const std::uint64_t wanted : ids)
        if (std::ranges::find(edits, wanted, &TreeEdit::id) == edits.end())
            return fail(ErrorCode::Unknown, RAMURE_NOOP("\"%1\" has no such edit"), {(*tree)->name});
    return edits;
}

/// In its place where its id is there, else at the end.
void put(std::vector<TreeEdit>& list, const TreeEdit& edit)
{
    const auto at = std::ranges::find(list, edit.id, &TreeEdit::id);
    if (at == list.end())
        list.push_back(edit);
    else
        *at = edit;
}

QString labelOf(const TreeEdit& edit)
{
    return QCoreApplication::translate("core", infoOf(edit.operation).label);
}

QString putText(const std::vector<TreeEdit>& edits)
{
    return edits.size() == 1
               ? labelOf(edits.front())
               : DocumentCommand::tr("Shape %n limb(s)", nullptr, static_cast<int>(edits.size()));
}

} // namespace

Expected<std::vector<std::uint64_t>> edit::putTreeEdits(Document& document, NodeId id,
                                                        std::vector<TreeEdit> edits, GestureId gesture)
{
    const auto tree = editableTree(document, id);
    if (!tree)
        return fail(tree.error());
    std::vector<TreeEdit> list = (*tree)->params.edits;
    Ids ids;
    for (std::size_t i = 0; i < edits.size(); ++i) {
        if (auto ok = checkTreeEdit(edits[i]); !ok) {
            ok.error().path = "edits[" + std::to_string(i) + "]." + ok.error().path;
            return fail(std::move(ok.error()));
        }
        if (edits[i].id == 0)
            edits[i].id = newEditId(list, edits[i]);
        put(list, edits[i]);
        ids.push_back(edits[i].id);
    }
    pushSet<EditsTarget>(document, {EditsEntry{{id}, std::move(list)}}, putText(edits), gesture);
    return ids;
}

Expected<void> edit::removeTreeEdits(Document& document, NodeId id, const Ids& ids, GestureId gesture)
{
    auto list = editsWith(document, id, ids);
    if (!list)
        return fail(std::move(list.error()));
    std::erase_if(*list, [&ids](const TreeEdit& edit) { return std::ranges::count(ids, edit.id) > 0; });
    pushSet<EditsTarget>(
        document, {EditsEntry{{id}, std::move(*list)}},
        DocumentCommand::tr("Delete %n edit(s) of the tree", nullptr, static_cast<int>(ids.size())), gesture);
    return {};
}

Expected<void> edit::setTreeEditsEnabled(Document& document, NodeId id, const Ids& ids, bool enabled)
{
    auto list = editsWith(document, id, ids);
    if (!list)
        return fail(std::move(list.error()));
    for (TreeEdit& edit : *list)
        if (std::ranges::count(ids, edit.id) > 0)
            edit.enabled = enabled;
    const int count = static_cast<int>(ids.size());
    pushSet<EditsTarget>(document, {EditsEntry{{id}, std::move(*list)}},
                         enabled ? DocumentCommand::tr("Switch %n edit(s) on", nullptr, count)
                                 : DocumentCommand::tr("Switch %n edit(s) off", nullptr, count));
    return {};
}

Expected<void> edit::renameTreeEdit(Document& document, NodeId id, std::uint64_t wanted, const QString& name)
{
    auto list = editsWith(document, id, {wanted});
    if (!list)
        return fail(std::move(list.error()));
    std::ranges::find(*list, wanted, &TreeEdit::id)->name = name.toStdString();
    pushSet<EditsTarget>(document, {EditsEntry{{id, Stage::Placement}, std::move(*list)}},
                         DocumentCommand::tr("Rename edit"));
    return {};
}

Expected<void> edit::moveTreeEdit(Document& document, NodeId id, std::uint64_t wanted, int row)
{
    auto list = editsWith(document, id, {wanted});
    if (!list)
        return fail(std::move(list.error()));
    const auto at = std::ranges::find(*list, wanted, &TreeEdit::id);
    TreeEdit moved = std::move(*at);
    list->erase(at);
    const auto last = static_cast<std::ptrdiff_t>(list->size());
    list->insert(list->begin() + std::clamp<std::ptrdiff_t>(row, 0, last), std::move(moved));
    pushSet<EditsTarget>(document, {EditsEntry{{id}, std::move(*list)}}, DocumentCommand::tr("Move edit"));
    return {};
}

Expected<void> edit::copyTreeEdits(Document& document, NodeId from, const Ids& ids,
                                   const std::vector<NodeId>& to)
{
    const Node* const source = document.scene().find(from);
    if (!source)
        return unknownNode(from);
    std::vector<TreeEdit> copied;
    for (const TreeEdit& edit : source->params.edits)
        if (std::ranges::count(ids, edit.id) > 0)
            copied.push_back(edit);
    if (copied.empty())
        return fail(ErrorCode::Unknown, RAMURE_NOOP("\"%1\" has no such edit"), {source->name});
    std::vector<EditsEntry> entries;
    std::vector<NodeId> trees;
    for (const NodeId id : to)
        addOnce(trees, id);
    for (const NodeId id : trees) {
        const auto tree = editableTree(document, id);
        if (!tree)
            return fail(tree.error());
        std::vector<TreeEdit> list = (*tree)->params.edits;
        for (const TreeEdit& edit : copied)
            put(list, edit);
        entries.push_back({{id}, std::move(list)});
    }
    pushSet<EditsTarget>(
        document, std::move(entries),
        DocumentCommand::tr("Copy %n edit(s) of the tree", nullptr, static_cast<int>(copied.size())));
    return {};
}

} // namespace ramure
