// The edits of trees: every command leads from one list to another.
#include "core/params/tree_edit_table.h"
#include "core/pipeline/freeze.h"
#include "core/pipeline/tree_context.h"
#include "core/qt/document/document_command.h"
#include "core/skeleton/branch_steps.h"

#include <QCoreApplication>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>

namespace ramure {

namespace {

/// What leads from one list of edits to another: a range of the first and what stands in its place.
struct EditsChange
{
    NodeId node = noNode;
    std::size_t at = 0, count = 0;
    std::vector<TreeEdit> with;

    [[nodiscard]] bool isNothing() const { return count == 0 && with.empty(); }
    /// Makes it, and becomes the way back.
    void exchange(std::vector<TreeEdit>& list)
    {
        const auto first = list.begin() + static_cast<std::ptrdiff_t>(at);
        const auto last = first + static_cast<std::ptrdiff_t>(count);
        std::vector<TreeEdit> before(std::make_move_iterator(first), std::make_move_iterator(last));
        count = with.size();
        list.insert(list.erase(first, last), std::make_move_iterator(with.begin()),
                    std::make_move_iterator(with.end()));
        with = std::move(before);
    }
};

EditsChange changeBetween(NodeId node, const std::vector<TreeEdit>& from, const std::vector<TreeEdit>& to)
{
    const auto [a, b] = std::ranges::mismatch(from, to);
    auto fromEnd = from.end();
    auto toEnd = to.end();
    while (fromEnd != a && toEnd != b && *(fromEnd - 1) == *(toEnd - 1)) {
        --fromEnd;
        --toEnd;
    }
    return {node, static_cast<std::size_t>(a - from.begin()), static_cast<std::size_t>(fromEnd - a),
            std::vector<TreeEdit>(b, toEnd)};
}

/// Keeps what differs, not the lists: a tree may have a thousand edits, and a session as many steps.
class EditsCommand final : public DocumentCommand
{
public:
    EditsCommand(Document& document, std::vector<EditsChange> changes, Stage stale, GestureId gesture,
                 const QString& text)
        : DocumentCommand(document, gesture, text)
        , m_changes(std::move(changes))
        , m_stale(stale)
    {
    }
    bool mergeWith(const DocumentCommand& other) override
    {
        const auto* next = dynamic_cast<const EditsCommand*>(&other);
        if (!next || next->gesture() != gesture() ||
            !std::ranges::equal(m_changes, next->m_changes, {}, &EditsChange::node, &EditsChange::node))
            return false;
        // Both are done: from the list of now back over the other to the one before both.
        for (std::size_t i = 0; i < m_changes.size(); ++i) {
            const std::vector<TreeEdit>& now = document().scene().find(m_changes[i].node)->params.edits;
            std::vector<TreeEdit> before = now;
            EditsChange(next->m_changes[i]).exchange(before);
            m_changes[i].exchange(before);
            m_changes[i] = changeBetween(m_changes[i].node, now, before);
        }
        m_stale = std::min(m_stale, next->m_stale);
        setObsolete(std::ranges::all_of(m_changes, &EditsChange::isNothing));
        return true;
    }
    void swap() override
    {
        Change change;
        change.kinds = changeBranches;
        change.firstStale = m_stale;
        for (const EditsChange& part : m_changes)
            change.nodes.push_back(part.node);
        document().applyChange(change, [this](Scene& scene) {
            for (EditsChange& part : m_changes)
                if (Node* node = scene.find(part.node))
                    part.exchange(node->params.edits);
        });
    }
    void countMemory(MemoryCount& memory) const override
    {
        memory.add(sizeof(*this) + m_changes.size() * sizeof(EditsChange));
        for (const EditsChange& part : m_changes)
            for (const TreeEdit& edit : part.with)
                memory.add(edit);
    }

private:
    std::vector<EditsChange> m_changes; ///< each node once
    Stage m_stale;                      ///< Placement: only names change, nothing is made anew
};

using Lists = std::map<NodeId, std::vector<TreeEdit>>; ///< by tree: all its edits

/// Pushes unless nothing would change.
void pushLists(Document& document, const Lists& lists, const QString& text, GestureId gesture = 0,
               Stage stale = Stage::Skeleton)
{
    std::vector<EditsChange> changes;
    for (const auto& [id, list] : lists)
        changes.push_back(changeBetween(id, document.scene().find(id)->params.edits, list));
    if (!std::ranges::all_of(changes, &EditsChange::isNothing))
        document.push(std::make_unique<EditsCommand>(document, std::move(changes), stale, gesture, text));
}

using Ids = std::vector<std::uint64_t>;

Expected<const Node*> editableTree(const Document& document, NodeId id)
{
    RAMURE_TRY(checkEditable(document.scene(), id));
    const Node* const tree = document.scene().find(id);
    if (tree->kind != NodeKind::Tree)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" has no branches"), {tree->name});
    return tree;
}

/// The tree's list, where it has edits with all these ids.
Expected<std::vector<TreeEdit>> editsWith(const Document& document, NodeId id, const Ids& ids)
{
    const auto tree = editableTree(document, id);
    RAMURE_TRY(tree);
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
    RAMURE_TRY(tree);
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
    pushLists(document, {{id, std::move(list)}}, putText(edits), gesture);
    return ids;
}

Expected<void> edit::setTreeEdits(Document& document, NodeId id, std::vector<TreeEdit> edits,
                                  const QString& text)
{
    RAMURE_TRY(editableTree(document, id));
    RAMURE_TRY(checkTreeEdits(edits));
    pushLists(document, {{id, std::move(edits)}}, text);
    return {};
}

Expected<void> edit::setStepParam(Document& document, NodeId id, std::uint64_t step, const ParamDef& def,
                                  const ParamValue& value, GestureId gesture)
{
    auto list = editsWith(document, id, {step});
    RAMURE_TRY(list);
    TreeEdit& edit = *std::ranges::find(*list, step, &TreeEdit::id);
    NodeParams values = *edit.values;
    if (std::ranges::count(stepParams(edit.operation), &def) == 0) {
        auto error = fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" has no such parameter"),
                          {labelOf(edit).toStdString()});
        error.value().path = def.key;
        return error;
    }
    RAMURE_TRY(setParam(values, def, value));
    edit.values = StepValues(std::move(values));
    const QString text = DocumentCommand::tr("Change %1 of %2", "a parameter, a step")
                             .arg(QCoreApplication::translate("core", def.label), labelOf(edit));
    pushLists(document, {{id, std::move(*list)}}, text, gesture);
    return {};
}

/// Where a branch begins, and the step that rolls it there.
struct RollPlace
{
    BranchStart start;
    std::optional<std::size_t> step; ///< in the tree's list
};

/// In the tree that is shown: that is the one in which the artist chose them. Nothing for a branch that it
/// has not.
static std::vector<std::optional<RollPlace>>
rollPlaces(const TreeResult& tree, const std::vector<TreeEdit>& steps, const std::vector<std::uint64_t>& keys)
{
    constexpr double sameSpot = 1e-6;
    const TreeAxes axes = axesOf(*tree.skeleton);
    std::unordered_map<std::uint64_t, Index> branches;
    for (Index i = 0; i < tree.simplified->skeleton.size(); ++i)
        branches.emplace(tree.simplified->skeleton.key[i], i);
    std::vector<std::optional<RollPlace>> places;
    for (const std::uint64_t key : keys) {
        const auto branch = branches.find(key);
        auto& place = places.emplace_back();
        if (branch == branches.end())
            continue;
        place = RollPlace{branchStart(axes, *tree.simplified, branch->second), std::nullopt};
        for (std::size_t i = 0; i < steps.size(); ++i) {
            const EditReport none;
            const EditReport& report = tree.edits ? *tree.edits : none;
            const auto what = std::ranges::find(report, steps[i].id, &EditOutcome::id);
            const std::uint64_t address = what == report.end() ? steps[i].target.address : what->address;
            if (steps[i].operation == EditOperation::Roll && address == place->start.address &&
                std::abs(steps[i].from - place->start.share) < sameSpot)
                place->step = i;
        }
    }
    return places;
}

static const TreeResult* shownTree(const Document& document, NodeId id)
{
    const NodeResult* shown = document.result(id);
    return shown && shown->tree.skeleton && shown->tree.simplified ? &shown->tree : nullptr;
}

std::vector<double> edit::branchRolls(const Document& document, NodeId id, const Ids& keys)
{
    std::vector<double> rolls(keys.size(), 0.0);
    const Node* const tree = document.scene().find(id);
    const TreeResult* const shown = shownTree(document, id);
    if (!tree || !shown ||
        std::ranges::count(tree->params.edits, EditOperation::Roll, &TreeEdit::operation) == 0)
        return rolls;
    const auto places = rollPlaces(*shown, tree->params.edits, keys);
    for (std::size_t i = 0; i < keys.size(); ++i)
        if (places[i] && places[i]->step)
            rolls[i] = tree->params.edits[*places[i]->step].angleRad;
    return rolls;
}

Expected<void> edit::setBranchRoll(Document& document, NodeId id, const Ids& keys, double rollRad,
                                   GestureId gesture)
{
    const auto tree = editableTree(document, id);
    RAMURE_TRY(tree);
    if (!std::isfinite(rollRad))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("a roll must be a finite angle"));
    const TreeResult* const shown = shownTree(document, id);
    if (!shown)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" has not grown yet"), {(*tree)->name});
    std::vector<TreeEdit> list = (*tree)->params.edits;
    std::set<std::uint64_t> gone;
    std::optional<EditContext> context;
    for (const auto& place : rollPlaces(*shown, list, keys)) {
        if (!place)
            return fail(ErrorCode::Unknown, RAMURE_NOOP("the tree has no such limb"));
        if (place->step && rollRad == 0.0)
            gone.insert(list[*place->step].id);
        else if (place->step)
            list[*place->step].angleRad = rollRad;
        if (place->step || rollRad == 0.0)
            continue;
        if (!context)
            context = contextOf(*shown, (*tree)->params);
        auto target = context->target(place->start.address);
        RAMURE_TRY(target);
        TreeEdit step;
        step.operation = EditOperation::Roll;
        step.target = std::move(*target);
        step.from = place->start.share;
        step.angleRad = rollRad;
        step.id = newEditId(list, step);
        list.push_back(std::move(step));
    }
    std::erase_if(list, [&gone](const TreeEdit& step) { return gone.contains(step.id); });
    pushLists(document, {{id, std::move(list)}},
              DocumentCommand::tr("Roll %n branch(es)", nullptr, static_cast<int>(keys.size())), gesture);
    return {};
}

Expected<void> edit::freezeTree(Document& document, NodeId id, std::uint64_t step)
{
    const auto list = editsWith(document, id, step == 0 ? Ids() : Ids{step});
    RAMURE_TRY(list);
    const auto at = step == 0 ? 0 : std::ranges::find(*list, step, &TreeEdit::id) - list->begin() + 1;
    auto frozen = frozenBehind(document.scene().find(id)->params, static_cast<std::size_t>(at));
    RAMURE_TRY(frozen);
    pushLists(document, {{id, std::move(*frozen)}}, DocumentCommand::tr("Freeze the steps above"));
    return {};
}

Expected<void> edit::duplicateTreeEdits(Document& document, NodeId id, const Ids& ids)
{
    auto list = editsWith(document, id, ids);
    RAMURE_TRY(list);
    for (const std::uint64_t wanted : ids) {
        const auto at = std::ranges::find(*list, wanted, &TreeEdit::id);
        TreeEdit copy = *at;
        copy.id = newEditId(*list, copy);
        list->insert(at + 1, std::move(copy));
    }
    pushLists(document, {{id, std::move(*list)}},
              DocumentCommand::tr("Duplicate %n step(s)", nullptr, static_cast<int>(ids.size())));
    return {};
}

Expected<void> edit::removeTreeEdits(Document& document, NodeId id, const Ids& ids, GestureId gesture)
{
    auto list = editsWith(document, id, ids);
    RAMURE_TRY(list);
    std::erase_if(*list, [&ids](const TreeEdit& edit) { return std::ranges::count(ids, edit.id) > 0; });
    pushLists(document, {{id, std::move(*list)}},
              DocumentCommand::tr("Delete %n edit(s) of the tree", nullptr, static_cast<int>(ids.size())),
              gesture);
    return {};
}

Expected<void> edit::setTreeEditsEnabled(Document& document, NodeId id, const Ids& ids, bool enabled)
{
    auto list = editsWith(document, id, ids);
    RAMURE_TRY(list);
    for (TreeEdit& edit : *list)
        if (std::ranges::count(ids, edit.id) > 0)
            edit.enabled = enabled;
    const int count = static_cast<int>(ids.size());
    pushLists(document, {{id, std::move(*list)}},
              enabled ? DocumentCommand::tr("Switch %n edit(s) on", nullptr, count)
                      : DocumentCommand::tr("Switch %n edit(s) off", nullptr, count));
    return {};
}

Expected<void> edit::renameTreeEdit(Document& document, NodeId id, std::uint64_t wanted, const QString& name)
{
    auto list = editsWith(document, id, {wanted});
    RAMURE_TRY(list);
    std::ranges::find(*list, wanted, &TreeEdit::id)->name = name.toStdString();
    pushLists(document, {{id, std::move(*list)}}, DocumentCommand::tr("Rename edit"), 0, Stage::Placement);
    return {};
}

Expected<void> edit::moveTreeEdit(Document& document, NodeId id, std::uint64_t wanted, int row)
{
    auto list = editsWith(document, id, {wanted});
    RAMURE_TRY(list);
    const auto at = std::ranges::find(*list, wanted, &TreeEdit::id);
    TreeEdit moved = std::move(*at);
    list->erase(at);
    const auto last = static_cast<std::ptrdiff_t>(list->size());
    list->insert(list->begin() + std::clamp<std::ptrdiff_t>(row, 0, last), std::move(moved));
    pushLists(document, {{id, std::move(*list)}}, DocumentCommand::tr("Move edit"));
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
    Lists lists;
    for (const NodeId id : to) {
        const auto tree = editableTree(document, id);
        RAMURE_TRY(tree);
        std::vector<TreeEdit>& list = lists[id] = (*tree)->params.edits;
        for (const TreeEdit& edit : copied)
            put(list, edit);
    }
    pushLists(document, lists,
              DocumentCommand::tr("Copy %n edit(s) of the tree", nullptr, static_cast<int>(copied.size())));
    return {};
}

} // namespace ramure
