// What the rows of the scene model say, and how they are edited and dragged.
#include "core/qt/document/commands.h"
#include "core/scene/kinds/node_kinds.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/icons.h"
#include "widgets/panels/scene/scene_model.h"
#include <QGuiApplication>
#include <QIODevice>
#include <QLocale>
#include <QMimeData>
#include <QPalette>
#include <algorithm>
#include <optional>

namespace ramure {
namespace {

const QString nodesMime = QStringLiteral("application/x-ramure-nodes");

std::vector<NodeId> nodesOf(const QMimeData* data)
{
    std::vector<NodeId> nodes;
    QDataStream stream(data->data(nodesMime));
    while (!stream.atEnd() && stream.status() == QDataStream::Ok) {
        NodeId node = noNode;
        stream >> node;
        nodes.push_back(node);
    }
    return nodes;
}

QString metres(double value)
{
    return QLocale().toString(value, 'f', value < 0.01 ? 4 : 3);
}

} // namespace

QVariant SceneModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    if (role == isSwitchRole)
        return rowAt(index).kind == SceneRow::Node &&
               (index.column() == VisibleColumn || index.column() == LockedColumn);
    if (role == Qt::TextAlignmentRole && index.column() >= LengthColumn)
        return QVariant::fromValue(Qt::Alignment(Qt::AlignRight | Qt::AlignVCenter));
    const SceneRow row = rowAt(index);
    if (role == Qt::DisplayRole && index.column() == ChildrenColumn) {
        const std::size_t count = countToTell(row);
        return count == 0 ? QString() : QLocale().toString(qulonglong(count));
    }
    if (row.kind == SceneRow::Branch)
        return branchData(*item(row.node).branches, row.index, index.column(), role);
    if (row.kind == SceneRow::Branches)
        return branchesData(*item(row.node).branches, row.index, index.column(), role);
    if (row.kind == SceneRow::Axis)
        return axisData(*item(row.node).branches, row.index, index.column(), role);
    const Node* node = m_document->scene().find(row.node);
    return node ? nodeData(*node, index.column(), role) : QVariant();
}

QVariant SceneModel::nodeData(const Node& node, int column, int role) const
{
    const bool shown = m_document->scene().isShown(node.id);
    if (role == Qt::ForegroundRole && node.kind == NodeKind::Unknown)
        return QGuiApplication::palette().color(QPalette::Disabled, QPalette::Text);
    switch (column) {
    case NameColumn:
        if (role == Qt::DisplayRole || role == Qt::EditRole)
            return QString::fromStdString(node.name);
        if (role == Qt::DecorationRole)
            return icon(kindRow(node.kind).icon);
        if (role == Qt::ToolTipRole)
            return coreText(kindRow(node.kind).tip).arg(QString::fromStdString(node.name)) +
                   branchCount(node.id);
        break;
    case VisibleColumn:
        if (role == Qt::DecorationRole)
            return icon(node.visible ? "eye" : "eye-off");
        if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole)
            return !node.visible ? tr("Hidden") : shown ? tr("Visible") : tr("Hidden by its parent");
        if (role == Qt::EditRole)
            return node.visible;
        break;
    case LockedColumn:
        if (role == Qt::DecorationRole)
            return icon(node.locked ? "lock" : "unlock");
        if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole)
            return node.locked ? tr("Locked: cannot be changed") : tr("Not locked");
        if (role == Qt::EditRole)
            return node.locked;
        break;
    default:
        break;
    }
    return {};
}

/// A line for the tool tip of a tree; nothing of what has no branches.
QString SceneModel::branchCount(NodeId node) const
{
    const auto skeleton = skeletonOf(node);
    return skeleton
               ? u'\n' + tr("%Ln branch(es) in all", nullptr, static_cast<int>(skeleton->skeleton.size()))
               : QString();
}

QString SceneModel::numberInReports(Index branch)
{
    return tr("Branch %1 in reports and files").arg(branch);
}

QVariant SceneModel::axisData(const BranchRows& rows, Index axis, int column, int role) const
{
    const Index foot = rows.branches(axis).front();
    if (column == NameColumn && role == Qt::DecorationRole)
        return icon("branch");
    if (column == NameColumn && role == Qt::ToolTipRole)
        return rows.branches(axis).size() > 1 ? m_names.way(rows, axis)
                                              : m_names.way(rows, axis) + u'\n' + numberInReports(foot);
    if (role != Qt::DisplayRole)
        return {};
    switch (column) {
    case NameColumn:
        return m_names.axis(rows, axis);
    case LengthColumn:
        return metres(rows.length(axis));
    case RadiusColumn:
        return metres(rows.skeleton().a0[foot]);
    case OrderColumn:
        return QLocale().toString(rows.skeleton().level[foot]);
    default:
        return {};
    }
}

QVariant SceneModel::branchesData(const BranchRows& rows, Index axis, int column, int role) const
{
    if (column == NameColumn && role == Qt::DisplayRole)
        return tr("%Ln branch(es)", nullptr, static_cast<int>(rows.branches(axis).size()));
    if (column == NameColumn && role == Qt::ToolTipRole)
        return tr("The branches of %1 one by one, from foot to tip").arg(m_names.axis(rows, axis));
    if (column == NameColumn && role == Qt::DecorationRole)
        return icon("branch-on");
    return {};
}

QVariant SceneModel::branchData(const BranchRows& rows, Index branch, int column, int role) const
{
    const Skeleton& bones = rows.skeleton();
    if (column == NameColumn && role == Qt::DecorationRole)
        return icon("branch-on");
    if (column == NameColumn && role == Qt::ToolTipRole)
        return m_names.branch(rows, branch) + u'\n' + numberInReports(branch);
    if (role != Qt::DisplayRole)
        return {};
    switch (column) {
    case NameColumn:
        return m_names.part(rows, branch);
    case LengthColumn:
        return metres(bones.length(branch));
    case RadiusColumn:
        return metres(bones.a0[branch]);
    case OrderColumn:
        return QLocale().toString(bones.level[branch]);
    default:
        return {};
    }
}

QVariant SceneModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole && section >= LengthColumn)
        return QVariant::fromValue(Qt::Alignment(Qt::AlignRight | Qt::AlignVCenter));
    if (role == Qt::DisplayRole) {
        switch (section) {
        case NameColumn:
            return tr("Name");
        case LengthColumn:
            return tr("Length (m)");
        case RadiusColumn:
            return tr("Radius (m)");
        case ChildrenColumn:
            return tr("Children");
        case OrderColumn:
            return tr("Order");
        default:
            return {};
        }
    }
    if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole) {
        switch (section) {
        case VisibleColumn:
            return tr("Visible");
        case LockedColumn:
            return tr("Locked");
        case LengthColumn:
            return tr("Length in metres");
        case RadiusColumn:
            return tr("Radius at the lower end, in metres");
        case ChildrenColumn:
            return tr("Rows below it; of a single branch that was searched for: the branches that begin at "
                      "its end");
        case OrderColumn:
            return tr("Depth of brackets: 0 is the trunk");
        default:
            break;
        }
    }
    return {};
}

Qt::ItemFlags SceneModel::flags(const QModelIndex& index) const
{
    if (!index.isValid())
        return Qt::ItemIsDropEnabled; // the top level
    Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    const SceneRow row = rowAt(index);
    const Node* node = m_document->scene().find(row.node);
    if (row.kind != SceneRow::Node || !node)
        return flags;
    flags |= Qt::ItemIsDropEnabled;
    if (!node->locked)
        flags |= Qt::ItemIsDragEnabled;
    if (!node->locked && index.column() == NameColumn)
        flags |= Qt::ItemIsEditable;
    return flags;
}

bool SceneModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    const auto [kind, node, none] = rowAt(index);
    if (role != Qt::EditRole || kind != SceneRow::Node || node == noNode)
        return false;
    switch (index.column()) {
    case NameColumn:
        return report(edit::setNodeName(*m_document, node, value.toString().trimmed()));
    case VisibleColumn:
        return report(edit::setNodeVisible(*m_document, {node}, value.toBool()));
    case LockedColumn:
        return report(edit::setNodeLocked(*m_document, {node}, value.toBool()));
    default:
        return false;
    }
}

QStringList SceneModel::mimeTypes() const
{
    return {nodesMime};
}

QMimeData* SceneModel::mimeData(const QModelIndexList& indexes) const
{
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    for (const QModelIndex& index : indexes) {
        if (index.column() == NameColumn && rowAt(index).kind == SceneRow::Node)
            stream << nodeAt(index);
    }
    if (bytes.isEmpty())
        return nullptr;
    auto* data = new QMimeData;
    data->setData(nodesMime, bytes);
    return data;
}

bool SceneModel::canDropMimeData(const QMimeData* data, Qt::DropAction action, int, int,
                                 const QModelIndex& parent) const
{
    if (action != Qt::MoveAction || !data->hasFormat(nodesMime) || rowAt(parent).kind != SceneRow::Node)
        return false;
    const NodeId target = nodeAt(parent);
    return std::ranges::none_of(nodesOf(data), [&](NodeId node) {
        return node == target || m_document->scene().isAncestor(node, target);
    });
}

bool SceneModel::dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                              const QModelIndex& parent)
{
    if (!canDropMimeData(data, action, row, column, parent))
        return false;
    const Scene& scene = m_document->scene();
    const NodeId target = nodeAt(parent);
    std::vector<NodeId> nodes = nodesOf(data);
    // Of a node and something below it only the upper one moves.
    const std::vector<NodeId> all = nodes;
    std::erase_if(nodes, [&](NodeId node) {
        return !scene.find(node) ||
               std::ranges::any_of(all, [&](NodeId other) { return scene.isAncestor(other, node); });
    });
    if (nodes.empty())
        return false;
    int to = row < 0 ? static_cast<int>(scene.children(target).size()) : row;
    std::optional<OneStep> step;
    if (nodes.size() > 1)
        step.emplace(*m_document, tr("Move nodes"));
    const double time = m_time ? m_time() : 0.0;
    bool moved = true;
    for (const NodeId node : nodes) {
        // The document counts the row without the node itself.
        if (scene.find(node)->parent == target && scene.row(node) < to)
            --to;
        moved = report(edit::moveNode(*m_document, node, target, to, m_dropKeepsWorld, time)) && moved;
        ++to;
    }
    return moved;
}

} // namespace ramure
