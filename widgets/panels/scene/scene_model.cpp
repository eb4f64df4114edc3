#include "widgets/panels/scene/scene_model.h"

#include "widgets/base/texts/core_text.h"
#include <algorithm>
#include <utility>

namespace ramure {
namespace {

// Internal ids: what a row stands for, in 2 bits, a node in 32 and an axis or a branch in 30.
static_assert(sizeof(quintptr) == 8, "internal ids hold a node and a branch");
constexpr int nodeShift = 30, kindShift = 62;
constexpr quintptr indexMask = (quintptr{1} << nodeShift) - 1;

constexpr quintptr inverseOf(quintptr odd)
{
    quintptr inverse = odd;
    for (int i = 0; i < 5; ++i) // each round doubles the bits that are right
        inverse *= 2 - odd * inverse;
    return inverse;
}
// Qt finds the place of a persistent index in a hash table by the last bits of its id and row. Numbers that
// follow each other would fill the table without a gap, and to take one out would need a walk through all of
// them: a factor scatters them, its inverse brings them back.
constexpr quintptr scatter = 0x1E3779B1, gather = inverseOf(scatter);
static_assert(((scatter * gather) & indexMask) == 1);

quintptr idOf(const SceneRow& row)
{
    const quintptr number = row.kind == SceneRow::Node ? row.node : row.index;
    return (quintptr{row.kind} << kindShift) | (quintptr{row.node} << nodeShift) |
           ((number * scatter) & indexMask);
}

/// The row of the single branches of an axis stands first.
std::size_t rowsBefore(const BranchRows& rows, Index axis)
{
    return rows.branches(axis).size() > 1 ? 1 : 0;
}

} // namespace

SceneModel::SceneModel(Document* document, QObject* parent)
    : QAbstractItemModel(parent)
    , m_document(document)
{
    connect(m_document, &Document::changed, this, &SceneModel::follow);
    m_items[noNode];
    syncStructure();
}

SceneModel::~SceneModel() = default;

SceneRow SceneModel::rowAt(const QModelIndex& index)
{
    if (!index.isValid())
        return {};
    const quintptr id = index.internalId();
    SceneRow row{static_cast<SceneRow::Kind>(id >> kindShift), static_cast<NodeId>(id >> nodeShift), noIndex};
    if (row.kind != SceneRow::Node)
        row.index = static_cast<Index>((id * gather) & indexMask);
    return row;
}

NodeId SceneModel::nodeAt(const QModelIndex& index) const
{
    return rowAt(index).node;
}

std::span<const Index> SceneModel::branchesAt(const QModelIndex& index) const
{
    const SceneRow row = rowAt(index);
    if (row.kind == SceneRow::Node)
        return {};
    const BranchRows& rows = *item(row.node).branches;
    if (row.kind != SceneRow::Branch)
        return rows.branches(row.index);
    return rows.branches(rows.axisOf(row.index)).subspan(rows.place(row.index), 1);
}

int SceneModel::rowOf(NodeId node) const
{
    const Item& own = item(node);
    const auto& siblings = item(own.parent).children;
    // Where it was last time, as a rule: a view asks for the row of every node that it hears of.
    if (own.row >= siblings.size() || siblings[own.row] != node)
        own.row = static_cast<std::size_t>(std::ranges::find(siblings, node) - siblings.begin());
    return static_cast<int>(own.row);
}

QModelIndex SceneModel::nodeIndex(NodeId node, int column) const
{
    if (node == noNode || !m_items.contains(node))
        return {};
    return createIndex(rowOf(node), column, idOf({SceneRow::Node, node, noIndex}));
}

/// \p row stands for something below a tree whose branches are there.
QModelIndex SceneModel::rowIndex(const SceneRow& row, int column) const
{
    const Item& tree = item(row.node);
    std::size_t at = 0;
    if (row.kind == SceneRow::Branch)
        at = tree.branches->place(row.index);
    else if (row.kind == SceneRow::Axis) {
        const Index above = tree.branches->above(row.index);
        at = tree.branches->number(row.index) +
             (above == noIndex ? tree.children.size() : rowsBefore(*tree.branches, above));
    }
    return createIndex(static_cast<int>(at), column, idOf(row));
}

QModelIndex SceneModel::axisIndex(NodeId node, Index axis, int column)
{
    const BranchRows* rows = fetchBranches(node);
    return rows && axis < rows->axisCount() ? rowIndex({SceneRow::Axis, node, axis}, column) : QModelIndex();
}

QModelIndex SceneModel::branchIndex(NodeId node, Index branch, int column)
{
    const BranchRows* rows = fetchBranches(node);
    if (!rows || branch >= rows->skeleton().size())
        return {};
    const Index axis = rows->axisOf(branch);
    const bool alone = rows->branches(axis).size() == 1;
    return rowIndex(alone ? SceneRow{SceneRow::Axis, node, axis} : SceneRow{SceneRow::Branch, node, branch},
                    column);
}

const BranchRows* SceneModel::fetchBranches(NodeId node)
{
    if (node == noNode || !m_items.contains(node))
        return nullptr;
    // Without an index where they are there: that would cost a search among the siblings for each branch.
    if (!item(node).fetched)
        fetchMore(nodeIndex(node));
    return branches(node);
}

const BranchRows* SceneModel::branches(NodeId node) const
{
    const auto found = m_items.find(node);
    return found == m_items.end() ? nullptr : found->second.branches.get();
}

QModelIndex SceneModel::index(int row, int column, const QModelIndex& parent) const
{
    if (!hasIndex(row, column, parent))
        return {};
    const SceneRow above = rowAt(parent);
    const Item& tree = item(above.node);
    const auto at = static_cast<std::size_t>(row);
    SceneRow found{SceneRow::Axis, above.node, noIndex};
    if (above.kind == SceneRow::Node && at < tree.children.size()) {
        found = {SceneRow::Node, tree.children[at], noIndex};
    } else if (above.kind == SceneRow::Node) {
        found.index = tree.branches->trunks()[at - tree.children.size()];
    } else if (above.kind == SceneRow::Branches) {
        found = {SceneRow::Branch, above.node, tree.branches->branches(above.index)[at]};
    } else if (const std::size_t before = rowsBefore(*tree.branches, above.index); at < before) {
        found = {SceneRow::Branches, above.node, above.index};
    } else {
        found.index = tree.branches->below(above.index)[at - before];
    }
    return createIndex(row, column, idOf(found));
}

QModelIndex SceneModel::parent(const QModelIndex& index) const
{
    const SceneRow row = rowAt(index);
    if (row.node == noNode)
        return {};
    const Item& tree = item(row.node);
    switch (row.kind) {
    case SceneRow::Node:
        return nodeIndex(tree.parent);
    case SceneRow::Axis:
        if (const Index above = tree.branches->above(row.index); above != noIndex)
            return rowIndex({SceneRow::Axis, row.node, above}, 0);
        return nodeIndex(row.node);
    case SceneRow::Branches:
        return rowIndex({SceneRow::Axis, row.node, row.index}, 0);
    case SceneRow::Branch:
        return rowIndex({SceneRow::Branches, row.node, tree.branches->axisOf(row.index)}, 0);
    }
    return {};
}

std::size_t SceneModel::countBelow(const SceneRow& row) const
{
    const Item& tree = item(row.node);
    switch (row.kind) {
    case SceneRow::Node:
        return tree.children.size() + (tree.branches ? tree.branches->trunks().size() : 0);
    case SceneRow::Axis:
        return rowsBefore(*tree.branches, row.index) + tree.branches->below(row.index).size();
    case SceneRow::Branches:
        return tree.branches->branches(row.index).size();
    case SceneRow::Branch:
        break;
    }
    return 0;
}

int SceneModel::rowCount(const QModelIndex& parent) const
{
    return parent.column() > 0 ? 0 : static_cast<int>(countBelow(rowAt(parent)));
}

/// Trunks count before anybody has fetched them.
std::size_t SceneModel::countToTell(const SceneRow& row) const
{
    std::size_t count = countBelow(row);
    if (row.kind == SceneRow::Node && !item(row.node).branches)
        if (const auto skeleton = skeletonOf(row.node))
            count += static_cast<std::size_t>(std::ranges::count(skeleton->skeleton.parent, noIndex));
    return count;
}

int SceneModel::columnCount(const QModelIndex&) const
{
    return columns;
}

bool SceneModel::hasChildren(const QModelIndex& parent) const
{
    return rowCount(parent) > 0 || canFetchMore(parent);
}

bool SceneModel::canFetchMore(const QModelIndex& parent) const
{
    if (!parent.isValid() || parent.column() > 0 || rowAt(parent).kind != SceneRow::Node)
        return false;
    const Node* node = m_document->scene().find(nodeAt(parent));
    return node && node->kind == NodeKind::Tree && !item(node->id).fetched;
}

void SceneModel::fetchMore(const QModelIndex& parent)
{
    if (!canFetchMore(parent))
        return;
    const NodeId node = nodeAt(parent);
    m_items.at(node).fetched = true;
    syncBranches(node);
}

std::shared_ptr<const SimplifiedSkeleton> SceneModel::skeletonOf(NodeId node) const
{
    const NodeResult* result = m_document->result(node);
    return result ? result->tree.simplified : nullptr;
}

void SceneModel::syncBranches(NodeId node)
{
    const auto found = m_items.find(node);
    if (found == m_items.end() || !found->second.fetched)
        return;
    const auto skeleton = skeletonOf(node);
    BranchRows* rows = found->second.branches.get();
    if (rows && skeleton && &rows->skeleton() == &skeleton->skeleton)
        return;
    if (rows && skeleton && rows->sameShape(skeleton->skeleton)) {
        // One signal instead of one per fork; the indices stay as they are.
        emit layoutAboutToBeChanged({QPersistentModelIndex(nodeIndex(node))}, NoLayoutChangeHint);
        rows->refresh(skeleton);
        emit layoutChanged({QPersistentModelIndex(nodeIndex(node))}, NoLayoutChangeHint);
        return;
    }
    if (rows || skeleton)
        replaceBranches(node, skeleton);
}

void SceneModel::replaceBranches(NodeId node, const std::shared_ptr<const SimplifiedSkeleton>& skeleton)
{
    Item& tree = m_items.at(node);
    const int first = static_cast<int>(tree.children.size());
    const QModelIndex parent = nodeIndex(node);
    if (tree.branches && !tree.branches->trunks().empty()) {
        beginRemoveRows(parent, first, first + static_cast<int>(tree.branches->trunks().size()) - 1);
        tree.branches.reset();
        endRemoveRows();
    }
    tree.branches.reset();
    if (!skeleton || skeleton->skeleton.empty())
        return;
    auto rows = std::make_unique<BranchRows>(m_document->result(node)->tree);
    beginInsertRows(parent, first, first + static_cast<int>(rows->trunks().size()) - 1);
    tree.branches = std::move(rows);
    endInsertRows();
    emit branchesReplaced(node);
}

void SceneModel::follow(const Change& change)
{
    if (change.has(changeReset)) {
        rebuild();
        return;
    }
    if (change.has(changeStructure)) {
        syncStructure();
        for (const Node& node : m_document->scene().nodes())
            tellCount(node.id);
    }
    if (change.has(changeNodeState | changeParams)) {
        for (const NodeId node : change.nodes) {
            if (m_items.contains(node) && node != noNode)
                emit dataChanged(nodeIndex(node, 0), nodeIndex(node, columns - 1));
        }
    }
    if (change.has(changeResults)) {
        for (const NodeId node : change.nodes) {
            syncBranches(node);
            tellCount(node);
        }
    }
}

void SceneModel::tellCount(NodeId node)
{
    const auto found = m_items.find(node);
    if (found == m_items.end() || node == noNode)
        return;
    const std::size_t count = countToTell({SceneRow::Node, node, noIndex});
    if (std::exchange(found->second.toldCount, count) != count)
        emit dataChanged(nodeIndex(node, ChildrenColumn), nodeIndex(node, ChildrenColumn));
}

void SceneModel::rebuild()
{
    beginResetModel();
    m_items.clear();
    m_items[noNode];
    for (const Node& node : m_document->scene().nodes()) {
        m_items[node.id].parent = node.parent;
        m_items[node.parent].children.push_back(node.id);
    }
    endResetModel();
}

void SceneModel::syncStructure()
{
    removeGone(noNode);
    // From the top down: whoever gets a child stands at its final place already, so that no move can make a
    // circle.
    std::vector<NodeId> waiting{noNode};
    while (!waiting.empty()) {
        const NodeId parent = waiting.back();
        waiting.pop_back();
        arrange(parent);
        const auto& children = item(parent).children;
        waiting.insert(waiting.end(), children.begin(), children.end());
    }
}

void SceneModel::removeGone(NodeId parent)
{
    std::vector<NodeId> waiting{parent};
    while (!waiting.empty()) {
        const NodeId above = waiting.back();
        waiting.pop_back();
        for (const NodeId child : std::vector<NodeId>(item(above).children)) {
            if (!m_document->scene().find(child))
                takeOut(child);
            else
                waiting.push_back(child);
        }
    }
}

void SceneModel::takeOut(NodeId node)
{
    const NodeId parent = item(node).parent;
    const int row = rowOf(node);
    beginRemoveRows(nodeIndex(parent), row, row);
    auto& siblings = m_items.at(parent).children;
    siblings.erase(siblings.begin() + row);
    std::vector<NodeId> waiting{node};
    while (!waiting.empty()) {
        const NodeId gone = waiting.back();
        waiting.pop_back();
        waiting.insert(waiting.end(), item(gone).children.begin(), item(gone).children.end());
        m_items.erase(gone);
    }
    endRemoveRows();
}

void SceneModel::arrange(NodeId parent)
{
    int row = 0;
    for (const NodeId child : m_document->scene().children(parent)) {
        if (!m_items.contains(child))
            insertItem(child, parent, row);
        else if (item(child).parent != parent || rowOf(child) != row)
            moveItem(child, parent, row);
        ++row;
    }
}

void SceneModel::insertItem(NodeId node, NodeId parent, int row)
{
    beginInsertRows(nodeIndex(parent), row, row);
    auto& siblings = m_items.at(parent).children;
    siblings.insert(siblings.begin() + row, node);
    m_items[node].parent = parent;
    endInsertRows();
}

void SceneModel::moveItem(NodeId node, NodeId newParent, int row)
{
    const NodeId oldParent = item(node).parent;
    const int oldRow = rowOf(node);
    // Qt counts the target row before the node is taken out.
    const int target = oldParent == newParent && oldRow < row ? row + 1 : row;
    if (!beginMoveRows(nodeIndex(oldParent), oldRow, oldRow, nodeIndex(newParent), target))
        return;
    auto& from = m_items.at(oldParent).children;
    from.erase(from.begin() + oldRow);
    auto& to = m_items.at(newParent).children;
    to.insert(to.begin() + row, node);
    m_items.at(node).parent = newParent;
    endMoveRows();
}

bool SceneModel::report(const Expected<void>& done)
{
    if (!done)
        emit refused(errorText(done.error()));
    return done.has_value();
}

} // namespace ramure
