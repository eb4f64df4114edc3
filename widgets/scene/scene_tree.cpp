#include "widgets/scene/scene_tree.h"

#include "widgets/scene/scene_model.h"
#include <QHeaderView>
#include <QMouseEvent>
#include <QScrollBar>

namespace ramure {

SceneTree::SceneTree(QWidget* parent)
    : QTreeView(parent)
{
    setUniformRowHeights(true); // 10,000 rows are laid out without measuring each
    setSelectionMode(ExtendedSelection);
    setDragDropMode(DragDrop);
    setDefaultDropAction(Qt::MoveAction);
    setEditTriggers(EditKeyPressed);
    setExpandsOnDoubleClick(false);
    setIndentation(12);
    setAllColumnsShowFocus(true);
    header()->setSectionsMovable(false);
    header()->setMinimumSectionSize(24);
    header()->setStretchLastSection(false);
    // Queued: the rows are laid out by then.
    connect(this, &QTreeView::expanded, this, &SceneTree::fitNames, Qt::QueuedConnection);
    connect(this, &QTreeView::collapsed, this, &SceneTree::fitNames, Qt::QueuedConnection);
    connect(verticalScrollBar(), &QScrollBar::valueChanged, this, &SceneTree::fitNames, Qt::QueuedConnection);
    connect(header(), &QHeaderView::sectionCountChanged, this, &SceneTree::fitNames, Qt::QueuedConnection);
}

void SceneTree::fitNames()
{
    if (!model())
        return;
    int others = 0;
    for (int column = 1; column < header()->count(); ++column)
        others += isColumnHidden(column) ? 0 : columnWidth(column);
    const int width = std::max(viewport()->width() - others, sizeHintForColumn(SceneModel::NameColumn));
    if (columnWidth(SceneModel::NameColumn) != width)
        setColumnWidth(SceneModel::NameColumn, width);
}

void SceneTree::resizeEvent(QResizeEvent* event)
{
    QTreeView::resizeEvent(event);
    fitNames();
}

QModelIndex SceneTree::stateAt(const QMouseEvent* event) const
{
    const QModelIndex index = indexAt(event->position().toPoint());
    const auto* scene = qobject_cast<const SceneModel*>(model());
    const bool state =
        index.column() == SceneModel::VisibleColumn || index.column() == SceneModel::LockedColumn;
    if (!state || !scene || scene->branchAt(index) != noIndex || event->button() != Qt::LeftButton)
        return {};
    return index;
}

void SceneTree::mousePressEvent(QMouseEvent* event)
{
    const QModelIndex index = stateAt(event);
    if (index.isValid())
        emit stateClicked(index);
    else
        QTreeView::mousePressEvent(event);
}

void SceneTree::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (stateAt(event).isValid()) {
        mousePressEvent(event);
        return;
    }
    QTreeView::mouseDoubleClickEvent(event);
    const QModelIndex index = indexAt(event->position().toPoint());
    if (index.isValid() && index.column() == SceneModel::NameColumn &&
        (model()->flags(index) & Qt::ItemIsEditable))
        edit(index);
}

} // namespace ramure
