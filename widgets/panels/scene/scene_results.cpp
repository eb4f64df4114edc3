#include "widgets/panels/scene/scene_results.h"

#include "widgets/panels/scene/scene_model.h"
#include <QLocale>
#include <algorithm>

namespace ramure {

SceneResults::SceneResults(Document* document, SceneModel* scene, QObject* parent)
    : QAbstractTableModel(parent)
    , m_document(document)
    , m_scene(scene)
{
    // After the scene model, which is connected already: its rows are what this list shows.
    connect(m_document, &Document::changed, this, &SceneResults::follow);
}

void SceneResults::setQuery(const SceneQuery& query)
{
    m_query = query;
    search();
}

void SceneResults::follow(const Change& change)
{
    if (change.has(changeReset | changeStructure | changeNodeState | changeResults) &&
        (!m_query.isEmpty() || m_rows > 0))
        search();
}

void SceneResults::search()
{
    std::vector<NodeId> nodes;
    std::vector<Found> trees;
    int rows = 0;
    for (const Node& node : m_document->scene().nodes()) {
        if (m_query.matchesNode(QString::fromStdString(node.name)))
            nodes.push_back(node.id);
    }
    rows = static_cast<int>(nodes.size());
    for (const Node& node : m_document->scene().nodes()) {
        const BranchRows* branches = m_query.isEmpty() ? nullptr : m_scene->fetchBranches(node.id);
        if (!branches)
            continue;
        Found found{node.id, rows, m_query.matches(*branches, m_scene->names())};
        if (found.list.empty())
            continue;
        rows += static_cast<int>(found.list.size());
        trees.push_back(std::move(found));
    }
    beginResetModel();
    m_nodes = std::move(nodes);
    m_trees = std::move(trees);
    m_rows = rows;
    m_listsBranches = m_query.findsBranches();
    endResetModel();
}

Selection SceneResults::everything(NodeId preferred) const
{
    Selection selection;
    selection.nodes = m_nodes;
    if (m_trees.empty())
        return selection;
    auto tree = std::ranges::find(m_trees, preferred, &Found::node);
    if (tree == m_trees.end())
        tree = m_trees.begin();
    selection.branchNode = tree->node;
    selection.branches = tree->list;
    if (!listsBranches()) {
        const BranchRows& rows = *m_scene->branches(tree->node);
        selection.branches.clear();
        for (const Index axis : tree->list)
            selection.branches.insert(selection.branches.end(), rows.branches(axis).begin(),
                                      rows.branches(axis).end());
        std::ranges::sort(selection.branches);
    }
    selection.activeBranch = selection.branches.back();
    return selection;
}

QModelIndex SceneResults::toScene(const QModelIndex& index) const
{
    if (!index.isValid() || index.row() >= m_rows)
        return {};
    if (index.row() < nodeCount())
        return m_scene->nodeIndex(m_nodes[static_cast<std::size_t>(index.row())], index.column());
    const Found& tree = treeAt(index.row());
    const Index found = tree.list[static_cast<std::size_t>(index.row() - tree.first)];
    return listsBranches() ? m_scene->branchIndex(tree.node, found, index.column())
                           : m_scene->axisIndex(tree.node, found, index.column());
}

const SceneResults::Found& SceneResults::treeAt(int row) const
{
    return *std::prev(std::ranges::upper_bound(m_trees, row, {}, &Found::first));
}

QModelIndex SceneResults::nodeIndex(NodeId node) const
{
    const auto found = std::ranges::find(m_nodes, node);
    return found == m_nodes.end() ? QModelIndex() : index(static_cast<int>(found - m_nodes.begin()), 0);
}

QModelIndex SceneResults::branchIndex(NodeId node, Index branch) const
{
    const auto tree = std::ranges::find(m_trees, node, &Found::node);
    const BranchRows* rows = tree == m_trees.end() ? nullptr : m_scene->branches(node);
    if (!rows || branch >= rows->skeleton().size())
        return {};
    const Index wanted = listsBranches() ? branch : rows->axisOf(branch);
    const auto found = std::ranges::lower_bound(tree->list, wanted);
    if (found == tree->list.end() || *found != wanted)
        return {};
    return index(tree->first + static_cast<int>(found - tree->list.begin()), 0);
}

int SceneResults::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : m_rows;
}

int SceneResults::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : SceneModel::columns;
}

QVariant SceneResults::data(const QModelIndex& index, int role) const
{
    const QModelIndex there = toScene(index);
    // A branch stands alone here: without its axis above it, and with nothing below.
    if (role == Qt::DisplayRole && listsBranches() && index.row() >= nodeCount() && there.isValid()) {
        const BranchRows& rows = *m_scene->branches(m_scene->nodeAt(there));
        const Index branch = m_scene->branchesAt(there).front();
        if (index.column() == SceneModel::NameColumn)
            return m_scene->names().branch(rows, branch);
        if (index.column() == SceneModel::ChildrenColumn)
            return QLocale().toString(rows.forks(branch));
    }
    return there.isValid() ? m_scene->data(there, role) : QVariant();
}

QVariant SceneResults::headerData(int section, Qt::Orientation orientation, int role) const
{
    return m_scene->headerData(section, orientation, role);
}

Qt::ItemFlags SceneResults::flags(const QModelIndex& index) const
{
    const QModelIndex there = toScene(index);
    const Qt::ItemFlags dragging = Qt::ItemIsDragEnabled | Qt::ItemIsDropEnabled;
    return there.isValid() ? (m_scene->flags(there) & ~dragging) | Qt::ItemNeverHasChildren
                           : Qt::ItemFlags(Qt::NoItemFlags);
}

bool SceneResults::setData(const QModelIndex& index, const QVariant& value, int role)
{
    const QModelIndex there = toScene(index);
    return there.isValid() && m_scene->setData(there, value, role);
}

} // namespace ramure
