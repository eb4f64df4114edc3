#include "widgets/scene/scene_panel.h"

#include "core/document/commands.h"
#include "widgets/scene/scene_model.h"
#include "widgets/scene/scene_results.h"
#include "widgets/scene/scene_search.h"
#include "widgets/scene/scene_tree.h"
#include "widgets/scene/select_actions.h"
#include "widgets/support/core_text.h"
#include "widgets/support/preferences.h"
#include "widgets/support/targets.h"
#include "widgets/theme/icons.h"
#include <QEvent>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QStackedLayout>
#include <QVBoxLayout>
#include <algorithm>

namespace ramure {
namespace {

/// From so many ranges on the old selection is dropped before the new one comes: comparing them, which Qt
/// does to tell what differs, takes the product of both.
constexpr int manyRanges = 64;

/// Of a column in the settings.
QString columnKey(SceneModel::Column column)
{
    constexpr const char* keys[SceneModel::columns] = {"name",   "visible",  "locked", "length",
                                                       "radius", "children", "level"};
    return QString::fromLatin1(keys[column]);
}

} // namespace

ScenePanel::ScenePanel(Document* document, Preferences* preferences, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_preferences(preferences)
    , m_model(new SceneModel(document, this))
    , m_results(new SceneResults(document, m_model, this))
    , m_search(new SceneSearch(this))
    , m_view(new SceneTree(this))
    , m_list(new SceneTree(this))
{
    setObjectName(QStringLiteral("scenePanel"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_search);
    m_stack = new QStackedLayout;
    layout->addLayout(m_stack, 1);
    // Rows that go take their selection with them: that is no wish of the user. Connected before the views'
    // own selection models, which react to the same signals.
    for (QAbstractItemModel* model :
         {static_cast<QAbstractItemModel*>(m_model), static_cast<QAbstractItemModel*>(m_results)}) {
        connect(model, &QAbstractItemModel::rowsAboutToBeRemoved, this, [this] { m_syncing = true; });
        connect(model, &QAbstractItemModel::modelAboutToBeReset, this, [this] { m_syncing = true; });
    }
    m_view->setModel(m_model);
    m_list->setModel(m_results);
    for (QAbstractItemModel* model :
         {static_cast<QAbstractItemModel*>(m_model), static_cast<QAbstractItemModel*>(m_results)}) {
        connect(model, &QAbstractItemModel::rowsRemoved, this, [this] { m_syncing = false; });
        connect(model, &QAbstractItemModel::modelReset, this, [this] { m_syncing = false; });
    }
    prepareView(m_view, "sceneTree");
    prepareView(m_list, "sceneResults");
    m_list->setRootIsDecorated(false);
    m_list->setDragDropMode(QAbstractItemView::NoDragDrop);
    showColumns();

    connect(m_document, &Document::changed, this, &ScenePanel::follow);
    connect(m_model, &SceneModel::refused, this, &ScenePanel::messageRaised);
    connect(m_view, &SceneTree::dragged, this, [this](bool keepsWorld) {
        m_model->setDropKeepsWorld(keepsWorld);
        emit messageRaised(
            keepsWorld ? tr("Drop: the node stays where it is in the world (with Shift: keeps its values)")
                       : tr("Drop: the node keeps its position, rotation and scale in the new parent"));
    });
    connect(m_model, &SceneModel::branchesReplaced, this, [this](NodeId node) {
        restoreExpanded(node);
        showSelection();
    });
    connect(m_results, &QAbstractItemModel::modelReset, this, &ScenePanel::showResults);
    connect(m_view, &QTreeView::expanded, this,
            [this](const QModelIndex& index) { noteExpanded(index, true); });
    connect(m_view, &QTreeView::collapsed, this,
            [this](const QModelIndex& index) { noteExpanded(index, false); });
    connect(m_search, &SceneSearch::queryChanged, this, [this](const SceneQuery& query) {
        m_searching = !query.isEmpty();
        m_results->setQuery(query);
    });
    connect(m_search, &SceneSearch::selectAllRequested, this, &ScenePanel::selectResults);
    connect(m_search, &SceneSearch::leftDownwards, this,
            [this] { presentView()->setFocus(Qt::OtherFocusReason); });
    retranslate();
    showSelection();
}

void ScenePanel::prepareView(SceneTree* view, const char* name)
{
    view->setObjectName(QLatin1String(name));
    view->prepareColumns();
    m_stack->addWidget(view);
    connect(view->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this, view] {
        if (view == presentView())
            takeSelection();
    });
    connect(view->selectionModel(), &QItemSelectionModel::currentChanged, this, [this, view] {
        if (view == presentView())
            takeSelection();
    });
    connect(view, &SceneTree::stateClicked, this, &ScenePanel::toggleState);
    connect(view, &SceneTree::frameRequested, this, &ScenePanel::frameRequested);
    connect(view, &QWidget::customContextMenuRequested, this, &ScenePanel::showMenu);
    connect(view->header(), &QWidget::customContextMenuRequested, this, &ScenePanel::showHeaderMenu);
}

void ScenePanel::setMenuActions(const QList<QAction*>& actions, const SelectActions* selects)
{
    m_menuActions = actions;
    m_selects = selects;
}

void ScenePanel::setTime(std::function<double()> time)
{
    m_model->setTime(std::move(time));
}

void ScenePanel::follow(const Change& change)
{
    if (change.has(changeReset)) {
        m_expanded.clear();
        m_search->clear();
    }
    if (change.has(changeReset | changeStructure | changeSelection))
        showSelection();
}

QModelIndex ScenePanel::toScene(const QModelIndex& index) const
{
    return index.model() == m_results ? m_results->toScene(index) : index;
}

QModelIndex ScenePanel::nodeRow(NodeId node) const
{
    return isSearching() ? m_results->nodeIndex(node) : m_model->nodeIndex(node);
}

QModelIndex ScenePanel::branchRow(NodeId node, Index branch) const
{
    return isSearching() ? m_results->branchIndex(node, branch) : m_model->branchIndex(node, branch);
}

Selection ScenePanel::viewSelection() const
{
    Selection selection;
    const QItemSelectionModel* chosen = presentView()->selectionModel();
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
    const QModelIndex active = toScene(current);
    if (currentChosen && m_model->branchAt(active) != noIndex)
        selection.branchNode = m_model->nodeAt(active);
    // Range by range: whole rows are selected, and selectedRows() would look through all ranges for each row.
    for (const QItemSelectionRange& range : chosen->selection()) {
        for (int row = range.top(); row <= range.bottom(); ++row) {
            const QModelIndex index = range.model()->index(row, 0, range.parent());
            if (index != current)
                note(toScene(index));
        }
    }
    if (currentChosen) {
        note(active);
        if (m_model->branchAt(active) != noIndex)
            selection.activeBranch = m_model->branchAt(active);
    }
    std::ranges::sort(selection.branches);
    if (selection.activeBranch == noIndex && !selection.branches.empty())
        selection.activeBranch = selection.branches.back();
    return selection;
}

/// What is selected and not among the results stays selected while rows are added to it and taken from it.
void ScenePanel::addUnlisted(Selection& chosen) const
{
    const Selection& before = m_document->selection();
    std::vector<NodeId> nodes;
    for (const NodeId node : before.nodes)
        if (!m_results->nodeIndex(node).isValid())
            nodes.push_back(node);
    chosen.nodes.insert(chosen.nodes.begin(), nodes.begin(), nodes.end());
    if (chosen.branchNode != noNode && chosen.branchNode != before.branchNode)
        return; // branches of one tree only can be selected
    for (const Index branch : before.branches) {
        if (m_results->branchIndex(before.branchNode, branch).isValid())
            continue;
        chosen.branchNode = before.branchNode;
        chosen.branches.push_back(branch);
    }
    std::ranges::sort(chosen.branches);
    if (chosen.activeBranch == noIndex && !chosen.branches.empty())
        chosen.activeBranch = chosen.branches.back();
}

void ScenePanel::takeSelection()
{
    if (m_syncing)
        return;
    m_syncing = true;
    Selection chosen = viewSelection();
    if (isSearching() && m_list->isAdding())
        addUnlisted(chosen);
    m_document->setSelection(std::move(chosen));
    m_syncing = false;
    showSelection(); // the document may have dropped something
}

QItemSelection ScenePanel::documentSelection() const
{
    const Selection& wanted = m_document->selection();
    QItemSelection selection;
    const auto add = [&](const QModelIndex& first, const QModelIndex& last) {
        if (first.isValid() && last.isValid())
            selection.append({first, last.siblingAtColumn(SceneModel::columns - 1)});
    };
    // Siblings one below the other are one range: views look through all of them for each row they draw.
    for (std::size_t i = 0; i < wanted.nodes.size(); ++i) {
        const QModelIndex first = nodeRow(wanted.nodes[i]);
        QModelIndex last = first;
        for (; i + 1 < wanted.nodes.size(); ++i) {
            const QModelIndex next = nodeRow(wanted.nodes[i + 1]);
            if (!last.isValid() || next != last.siblingAtRow(last.row() + 1))
                break;
            last = next;
        }
        add(first, last);
    }
    std::vector<QModelIndex> rows;
    rows.reserve(wanted.branches.size());
    for (const Index branch : wanted.branches)
        rows.push_back(branchRow(wanted.branchNode, branch));
    // Neighbours become one range: thousands of branches are a few hundred of them.
    const auto above = [this](const QModelIndex& index) {
        const BranchRows* tree = isSearching() ? nullptr : m_model->branches(m_model->nodeAt(index));
        return tree ? tree->above(m_model->branchAt(index)) : noIndex;
    };
    std::erase_if(rows, [](const QModelIndex& index) { return !index.isValid(); });
    std::ranges::sort(rows, {},
                      [&](const QModelIndex& index) { return std::pair(above(index), index.row()); });
    for (std::size_t first = 0, last = 0; first < rows.size(); first = last + 1) {
        last = first;
        while (last + 1 < rows.size() && rows[last + 1].row() == rows[last].row() + 1 &&
               above(rows[last + 1]) == above(rows[last]))
            ++last;
        add(rows[first], rows[last]);
    }
    return selection;
}

/// As far as the view has rows for it.
bool ScenePanel::isSelectionShown() const
{
    const Selection shown = viewSelection();
    Selection wanted = m_document->selection();
    if (isSearching()) {
        std::erase_if(wanted.nodes, [this](NodeId node) { return !m_results->nodeIndex(node).isValid(); });
        std::erase_if(wanted.branches, [&](Index branch) {
            return !m_results->branchIndex(wanted.branchNode, branch).isValid();
        });
        if (wanted.branches.empty())
            wanted.branchNode = noNode;
        if (std::ranges::count(wanted.branches, wanted.activeBranch) == 0)
            wanted.activeBranch = shown.activeBranch;
    }
    return shown == wanted;
}

void ScenePanel::showSelection()
{
    if (m_syncing || isSelectionShown())
        return;
    m_syncing = true;
    const Selection& wanted = m_document->selection();
    SceneTree* view = presentView();
    const QItemSelection ranges = documentSelection();
    if (std::max(ranges.size(), view->selectionModel()->selection().size()) > manyRanges) {
        view->selectionModel()->reset();
        view->viewport()->update();
    }
    view->selectionModel()->select(ranges, QItemSelectionModel::ClearAndSelect);
    const QModelIndex active = wanted.activeBranch != noIndex
                                   ? branchRow(wanted.branchNode, wanted.activeBranch)
                                   : nodeRow(wanted.activeNode());
    if (active.isValid()) {
        view->selectionModel()->setCurrentIndex(active, QItemSelectionModel::NoUpdate);
        view->scrollTo(active);
    }
    m_syncing = false;
}

void ScenePanel::showResults()
{
    m_stack->setCurrentWidget(presentView());
    m_search->showCounts(m_results->nodeCount(), m_results->branchCount());
    showSelection();
}

void ScenePanel::selectResults()
{
    if (!isSearching() || m_results->rowCount() == 0)
        return;
    const std::vector<NodeId> targets = targetNodes(*m_document);
    const Selection all = m_results->everything(targets.empty() ? noNode : targets.back());
    m_document->setSelection(all);
    if (static_cast<int>(all.branches.size()) < m_results->branchCount())
        emit messageRaised(tr("Branches of one tree are selected at a time: now those of %1.")
                               .arg(m_model->nodeIndex(all.branchNode).data().toString()));
}

void ScenePanel::toggleState(const QModelIndex& index)
{
    const bool lock = index.column() == SceneModel::LockedColumn;
    const NodeId clicked = m_model->nodeAt(toScene(index));
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
    const NodeId active = m_document->selection().activeNode();
    if (!m_model->nodeIndex(active).isValid())
        return;
    if (!nodeRow(active).isValid())
        m_search->clear();
    SceneTree* view = presentView();
    view->setFocus(Qt::ShortcutFocusReason);
    view->scrollTo(nodeRow(active));
    view->edit(nodeRow(active));
}

void ScenePanel::focusSearch()
{
    m_search->field()->setFocus(Qt::ShortcutFocusReason);
    m_search->field()->selectAll();
}

void ScenePanel::showMenu(const QPoint& position)
{
    QMenu menu(this);
    const QIcon frameIcon = icon("frame-selection");
    QAction* frame = menu.addAction(frameIcon, tr("Frame in the view"), this, &ScenePanel::frameRequested);
    frame->setEnabled(m_document->selection() != Selection());
    if (m_selects) {
        menu.addMenu(tr("Select"))->addActions(m_selects->stepActions());
        menu.addSeparator();
        menu.addActions(m_selects->rowActions());
    }
    menu.addSeparator();
    menu.addActions(m_menuActions);
    if (!isSearching()) {
        menu.addSeparator();
        const QModelIndex current = m_view->currentIndex();
        QAction* unfold = menu.addAction(tr("Unfold all below"), m_view,
                                         [this, current] { m_view->expandRecursively(current); });
        unfold->setEnabled(current.isValid());
        menu.addAction(tr("Fold everything"), m_view, &QTreeView::collapseAll);
    }
    menu.addSeparator();
    fillColumnMenu(menu.addMenu(tr("Columns"))); // the headings are beyond the keyboard's reach
    menu.exec(presentView()->viewport()->mapToGlobal(position));
}

void ScenePanel::showColumns()
{
    // In a narrow panel names matter most; the rest is a right click on the header away.
    const QStringList usual{columnKey(SceneModel::VisibleColumn), columnKey(SceneModel::LockedColumn),
                            columnKey(SceneModel::LengthColumn), columnKey(SceneModel::ChildrenColumn)};
    const QStringList shown = m_preferences->sceneColumns().value_or(usual);
    for (int column = SceneModel::VisibleColumn; column < SceneModel::columns; ++column) {
        const bool hidden = !shown.contains(columnKey(static_cast<SceneModel::Column>(column)));
        m_view->setColumnHidden(column, hidden);
        m_list->setColumnHidden(column, hidden);
    }
}

void ScenePanel::chooseColumn(SceneModel::Column column, bool on)
{
    QStringList shown;
    for (int each = SceneModel::VisibleColumn; each < SceneModel::columns; ++each)
        if (each == column ? on : !m_view->isColumnHidden(each))
            shown += columnKey(static_cast<SceneModel::Column>(each));
    m_preferences->setSceneColumns(shown);
    showColumns();
}

void ScenePanel::fillColumnMenu(QMenu* menu)
{
    for (int column = SceneModel::VisibleColumn; column < SceneModel::columns; ++column) {
        QString name = m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
        if (name.isEmpty())
            name = m_model->headerData(column, Qt::Horizontal, Qt::AccessibleTextRole).toString();
        QAction* action = menu->addAction(name);
        action->setCheckable(true);
        action->setChecked(!m_view->isColumnHidden(column));
        connect(action, &QAction::toggled, this,
                [this, column](bool on) { chooseColumn(static_cast<SceneModel::Column>(column), on); });
    }
}

void ScenePanel::showHeaderMenu(const QPoint& position)
{
    QMenu menu(this);
    fillColumnMenu(&menu);
    menu.exec(presentView()->header()->mapToGlobal(position));
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
    m_list->setAccessibleName(tr("Found in the scene"));
    m_model->retranslate();
    m_results->retranslate();
    // As wide as their headings and usual figures.
    for (int column = SceneModel::LengthColumn; column < SceneModel::columns; ++column) {
        const QString heading = m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
        const int figure = fontMetrics().horizontalAdvance(QStringLiteral("000.000"));
        const int width = std::max(figure, fontMetrics().horizontalAdvance(heading)) + 18;
        m_view->header()->resizeSection(column, width);
        m_list->header()->resizeSection(column, width);
    }
}

} // namespace ramure
