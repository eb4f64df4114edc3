#include "widgets/scene/scene_model.h"

#include "widgets/support/core_text.h"
#include <algorithm>
#include <utility>

namespace ramure {
namespace {

// Internal ids: a node's id, or with the highest bit set the node's id and a branch.
static_assert(sizeof(quintptr) == 8, "internal ids hold a node and a branch");
constexpr quintptr branchBit = quintptr{1} << 63;

quintptr branchId(NodeId node, Index branch)
{
    return branchBit | (quintptr{node} << 32) | branch;
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

NodeId SceneModel::nodeAt(const QModelIndex& index) const
{
    if (!index.isValid())
        return noNode;
    return static_cast<NodeId>((index.internalId() & branchBit) ? (index.internalId() & ~branchBit) >> 32
                                                                : index.internalId());
}

Index SceneModel::branchAt(const QModelIndex& index) const
{
    if (!index.isValid() || !(index.internalId() & branchBit))
        return noIndex;
    return static_cast<Index>(index.internalId() & 0xFFFFFFFFu);
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
    return createIndex(rowOf(node), column, quintptr{node});
}

QModelIndex SceneModel::branchIndex(NodeId node, Index branch, int column)
{
    const BranchRows* rows = fetchBranches(node);
    if (!rows || branch >= rows->skeleton().size())
        return {};
    int row = static_cast<int>(rows->row(branch));
    if (rows->above(branch) == noIndex)
        row += static_cast<int>(item(node).children.size());
    return createIndex(row, column, branchId(node, branch));
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
    const NodeId node = nodeAt(parent);
    const Index above = branchAt(parent);
    const auto at = static_cast<std::size_t>(row);
    if (above != noIndex)
        return createIndex(row, column,
                           branchId(node, item(node).branches->at(above, static_cast<Index>(row))));
    const auto& children = item(node).children;
    if (at < children.size())
        return createIndex(row, column, quintptr{children[at]});
    return createIndex(row, column, branchId(node, item(node).branches->tops()[at - children.size()]));
}

QModelIndex SceneModel::parent(const QModelIndex& index) const
{
    const NodeId node = nodeAt(index);
    if (node == noNode)
        return {};
    const Index branch = branchAt(index);
    if (branch == noIndex)
        return nodeIndex(item(node).parent);
    const BranchRows& rows = *item(node).branches;
    const Index above = rows.above(branch);
    if (above == noIndex)
        return nodeIndex(node);
    int row = static_cast<int>(rows.row(above));
    if (rows.above(above) == noIndex)
        row += static_cast<int>(item(node).children.size());
    return createIndex(row, 0, branchId(node, above));
}

int SceneModel::rowCount(const QModelIndex& parent) const
{
    if (parent.column() > 0)
        return 0;
    const Item& above = item(nodeAt(parent));
    const Index branch = branchAt(parent);
    if (branch != noIndex)
        return static_cast<int>(above.branches->rowCount(branch));
    return static_cast<int>(above.children.size() + (above.branches ? above.branches->tops().size() : 0));
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
    if (!parent.isValid() || parent.column() > 0 || branchAt(parent) != noIndex)
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
    if (tree.branches && !tree.branches->tops().empty()) {
        beginRemoveRows(parent, first, first + static_cast<int>(tree.branches->tops().size()) - 1);
        tree.branches.reset();
        endRemoveRows();
    }
    tree.branches.reset();
    if (!skeleton || skeleton->skeleton.empty())
        return;
    auto rows = std::make_unique<BranchRows>(skeleton);
    beginInsertRows(parent, first, first + static_cast<int>(rows->tops().size()) - 1);
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
    if (change.has(changeStructure))
        syncStructure();
    if (change.has(changeNodeState | changeParams)) {
        for (const NodeId node : change.nodes) {
            if (m_items.contains(node) && node != noNode)
                emit dataChanged(nodeIndex(node, 0), nodeIndex(node, columns - 1));
        }
    }
    if (change.has(changeResults)) {
        for (const NodeId node : change.nodes) {
            syncBranches(node);
            tellBranchCount(node);
        }
    }
}

void SceneModel::tellBranchCount(NodeId node)
{
    const auto found = m_items.find(node);
    if (found == m_items.end() || node == noNode)
        return;
    const auto skeleton = skeletonOf(node);
    const Index count = skeleton ? skeleton->skeleton.size() : 0;
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
