#include "widgets/scene/scene_panel.h"

#include "core/document/commands.h"
#include "widgets/scene/scene_model.h"
#include "widgets/scene/scene_tree.h"
#include "widgets/support/core_text.h"
#include <QEvent>
#include <QHeaderView>
#include <QMenu>
#include <QVBoxLayout>
#include <algorithm>

namespace ramure {

ScenePanel::ScenePanel(Document* document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_model(new SceneModel(document, this))
    , m_view(new SceneTree(this))
{
    setObjectName(QStringLiteral("scenePanel"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_view);
    // Rows that go take their selection with them: that is no wish of the user. Connected before the view's
    // own selection model, which reacts to the same signals.
    connect(m_model, &QAbstractItemModel::rowsAboutToBeRemoved, this, [this] { m_syncing = true; });
    connect(m_model, &QAbstractItemModel::modelAboutToBeReset, this, [this] { m_syncing = true; });
    m_view->setModel(m_model);
    connect(m_model, &QAbstractItemModel::rowsRemoved, this, [this] { m_syncing = false; });
    connect(m_model, &QAbstractItemModel::modelReset, this, [this] { m_syncing = false; });
    m_view->setObjectName(QStringLiteral("sceneTree"));
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    QHeaderView* header = m_view->header();
    header->setSectionResizeMode(QHeaderView::Interactive);
    for (const int column : {SceneModel::VisibleColumn, SceneModel::LockedColumn}) {
        header->setSectionResizeMode(column, QHeaderView::Fixed);
        header->resizeSection(column, 26);
    }
    header->setContextMenuPolicy(Qt::CustomContextMenu);
    // In a narrow panel names matter most; the rest is a right click on the header away.
    m_view->setColumnHidden(SceneModel::RadiusColumn, true);
    m_view->setColumnHidden(SceneModel::LevelColumn, true);

    connect(m_document, &Document::changed, this, &ScenePanel::follow);
    connect(m_model, &SceneModel::refused, this, &ScenePanel::messageRaised);
    connect(m_model, &SceneModel::branchesReplaced, this, [this](NodeId node) {
        restoreExpanded(node);
        showSelection();
    });
    connect(m_view->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &ScenePanel::takeSelection);
    connect(m_view->selectionModel(), &QItemSelectionModel::currentChanged, this, &ScenePanel::takeSelection);
    connect(m_view, &SceneTree::stateClicked, this, &ScenePanel::toggleState);
    connect(m_view, &QTreeView::expanded, this,
            [this](const QModelIndex& index) { noteExpanded(index, true); });
    connect(m_view, &QTreeView::collapsed, this,
            [this](const QModelIndex& index) { noteExpanded(index, false); });
    connect(m_view, &QWidget::customContextMenuRequested, this, &ScenePanel::showMenu);
    connect(header, &QWidget::customContextMenuRequested, this, &ScenePanel::showHeaderMenu);
    retranslate();
    showSelection();
}

void ScenePanel::follow(const Change& change)
{
    if (change.has(changeReset))
        m_expanded.clear();
    if (change.has(changeReset | changeStructure | changeSelection))
        showSelection();
}

Selection ScenePanel::viewSelection() const
{
    Selection selection;
    const QItemSelectionModel* chosen = m_view->selectionModel();
    const QModelIndex current = chosen->currentIndex().siblingAtColumn(0);
    const auto note = [&](const QModelIndex& index) {
        const NodeId node = m_model->nodeAt(index);
        const Index branch = m_model->branchAt(index);
        if (branch == noIndex) {
            selection.nodes.push_back(node);
        } else if (selection.branchNode == noNode || selection.branchNode == node) {
            selection.branchNode = node;
            selection.branches.push_back(branch);
        }
    };
    // The tree of the active row first: branches of one tree only can be selected.
    const bool currentChosen = current.isValid() && chosen->isSelected(current);
    if (currentChosen && m_model->branchAt(current) != noIndex)
        selection.branchNode = m_model->nodeAt(current);
    for (const QModelIndex& index : chosen->selectedRows()) {
        if (index != current)
            note(index);
    }
    if (currentChosen) {
        note(current);
        if (m_model->branchAt(current) != noIndex)
            selection.activeBranch = m_model->branchAt(current);
    }
    std::ranges::sort(selection.branches);
    if (selection.activeBranch == noIndex && !selection.branches.empty())
        selection.activeBranch = selection.branches.back();
    return selection;
}

void ScenePanel::takeSelection()
{
    if (m_syncing)
        return;
    m_syncing = true;
    m_document->setSelection(viewSelection());
    m_syncing = false;
    showSelection(); // the document may have dropped something
}

QItemSelection ScenePanel::documentSelection() const
{
    const Selection& wanted = m_document->selection();
    QItemSelection selection;
    const auto add = [&](const QModelIndex& index) {
        if (index.isValid())
            selection.select(index, index.siblingAtColumn(SceneModel::columns - 1));
    };
    for (const NodeId node : wanted.nodes)
        add(m_model->nodeIndex(node));
    for (const Index branch : wanted.branches)
        add(m_model->branchIndex(wanted.branchNode, branch));
    return selection;
}

void ScenePanel::showSelection()
{
    if (m_syncing || viewSelection() == m_document->selection())
        return;
    m_syncing = true;
    const Selection& wanted = m_document->selection();
    m_view->selectionModel()->select(documentSelection(), QItemSelectionModel::ClearAndSelect);
    const QModelIndex active = wanted.activeBranch != noIndex
                                   ? m_model->branchIndex(wanted.branchNode, wanted.activeBranch)
                                   : m_model->nodeIndex(wanted.activeNode());
    if (active.isValid()) {
        m_view->selectionModel()->setCurrentIndex(active, QItemSelectionModel::NoUpdate);
        m_view->scrollTo(active);
    }
    m_syncing = false;
}

void ScenePanel::toggleState(const QModelIndex& index)
{
    const bool lock = index.column() == SceneModel::LockedColumn;
    const NodeId clicked = m_model->nodeAt(index);
    // A row of the selection speaks for all of it.
    std::vector<NodeId> nodes = m_document->selection().nodes;
    if (std::ranges::count(nodes, clicked) == 0)
        nodes = {clicked};
    const bool value = !index.data(Qt::EditRole).toBool();
    const auto done = lock ? edit::setNodeLocked(*m_document, nodes, value)
                           : edit::setNodeVisible(*m_document, nodes, value);
    if (!done)
        emit messageRaised(errorText(done.error()));
}

void ScenePanel::noteExpanded(const QModelIndex& index, bool expanded)
{
    const Index branch = m_model->branchAt(index);
    const NodeId node = m_model->nodeAt(index);
    const BranchRows* rows = m_model->branches(node);
    if (branch == noIndex || !rows)
        return;
    const std::pair key{node, rows->skeleton().key[branch]};
    if (expanded)
        m_expanded.insert(key);
    else
        m_expanded.erase(key);
}

void ScenePanel::restoreExpanded(NodeId node)
{
    const BranchRows* rows = m_model->branches(node);
    if (!rows)
        return;
    const auto from = m_expanded.lower_bound({node, 0});
    const auto to = m_expanded.upper_bound({node, ~std::uint64_t{0}});
    for (const auto& [id, key] : std::vector(from, to)) {
        if (const auto branch = rows->find(key))
            m_view->expand(m_model->branchIndex(id, *branch));
    }
}

void ScenePanel::renameActive()
{
    const QModelIndex index = m_model->nodeIndex(m_document->selection().activeNode());
    if (!index.isValid())
        return;
    m_view->setFocus(Qt::ShortcutFocusReason);
    m_view->scrollTo(index);
    m_view->edit(index);
}

void ScenePanel::showMenu(const QPoint& position)
{
    QMenu menu(this);
    menu.addActions(m_menuActions);
    if (!menu.isEmpty())
        menu.exec(m_view->viewport()->mapToGlobal(position));
}

void ScenePanel::showHeaderMenu(const QPoint& position)
{
    QMenu menu(this);
    for (int column = SceneModel::LengthColumn; column < SceneModel::columns; ++column) {
        QAction* action =
            menu.addAction(m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString());
        action->setCheckable(true);
        action->setChecked(!m_view->isColumnHidden(column));
        connect(action, &QAction::toggled, this, [this, column](bool on) {
            m_view->setColumnHidden(column, !on);
            m_view->fitNames();
        });
    }
    menu.exec(m_view->header()->mapToGlobal(position));
}

void ScenePanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

void ScenePanel::retranslate()
{
    m_view->setAccessibleName(tr("Scene"));
    m_model->retranslate();
    // As wide as their headings and usual figures.
    for (int column = SceneModel::LengthColumn; column < SceneModel::columns; ++column) {
        const QString heading = m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
        const int figure = fontMetrics().horizontalAdvance(QStringLiteral("000.000"));
        m_view->header()->resizeSection(column,
                                        std::max(figure, fontMetrics().horizontalAdvance(heading)) + 18);
    }
    m_view->fitNames();
}

} // namespace ramure
