#include "widgets/panels/scene/scene_panel.h"

#include "core/qt/document/commands.h"
#include "widgets/base/empty_page.h"
#include "widgets/base/named.h"
#include "widgets/base/targets.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/icons.h"
#include "widgets/panels/scene/scene_model.h"
#include "widgets/panels/scene/scene_results.h"
#include "widgets/panels/scene/scene_search.h"
#include "widgets/panels/scene/scene_tree.h"
#include "widgets/panels/scene/select_actions.h"
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
    auto* layout = layoutOf<QVBoxLayout>(this, 0);
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

    connectParts();
}

void ScenePanel::connectParts()
{
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
    connect(m_search, &SceneSearch::leftDownwards, this, &ScenePanel::enterList);
    // What is selected and not listed goes, too.
    connect(m_list, &SceneTree::nothingClicked, this, [this] { m_document->setSelection({}); });
    m_view->setAccessibleName(tr("Scene"));
    m_view->setEmptyText(emptySceneText());
    m_list->setAccessibleName(tr("Found in the scene"));
    // As wide as their headings and usual figures.
    for (int column = SceneModel::LengthColumn; column < SceneModel::columns; ++column) {
        const QString heading = m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
        const int figure = fontMetrics().horizontalAdvance(QStringLiteral("000.000"));
        const int width = std::max(figure, fontMetrics().horizontalAdvance(heading)) + 18;
        m_view->header()->resizeSection(column, width);
        m_list->header()->resizeSection(column, width);
    }
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
    connect(view, &SceneTree::pointed, this, [this](const QModelIndex& index) {
        const QModelIndex row = toScene(index);
        const auto branches = m_model->branchesAt(row);
        emit pointedAt(m_model->nodeAt(row), {branches.begin(), branches.end()});
    });
    connect(view, &SceneTree::frameRequested, this, &ScenePanel::frameRequested);
    connect(view, &QWidget::customContextMenuRequested, this, &ScenePanel::showMenu);
    connect(view->header(), &QWidget::customContextMenuRequested, this, &ScenePanel::showHeaderMenu);
}

void ScenePanel::setMenuActions(const QList<QAction*>& actions, const SelectActions* selects,
                                const QList<QAction*>& branches)
{
    m_branchActions = branches;
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

/// \param whole all of its axis is selected: the row of the axis stands for it.
QModelIndex ScenePanel::branchRow(NodeId node, Index branch, bool whole) const
{
    if (isSearching())
        return whole || m_results->listsBranches() ? m_results->branchIndex(node, branch) : QModelIndex();
    const BranchRows* rows = m_model->fetchBranches(node);
    if (!rows || branch >= rows->skeleton().size())
        return {};
    return whole ? m_model->axisIndex(node, rows->axisOf(branch)) : m_model->branchIndex(node, branch);
}

Selection ScenePanel::viewSelection() const
{
    Selection selection;
    const QItemSelectionModel* chosen = presentView()->selectionModel();
    const QModelIndex current = chosen->currentIndex().siblingAtColumn(0);
    const auto note = [&](const QModelIndex& index) {
        const NodeId node = m_model->nodeAt(index);
        const std::span<const Index> branches = m_model->branchesAt(index);
        if (branches.empty()) {
            selection.nodes.push_back(node);
        } else if (selection.branchNode == noNode || selection.branchNode == node) {
            selection.branchNode = node;
            selection.branches.insert(selection.branches.end(), branches.begin(), branches.end());
        }
    };
    // The tree of the active row first: branches of one tree only can be selected.
    const bool currentChosen = current.isValid() && chosen->isSelected(current);
    const QModelIndex active = toScene(current);
    if (currentChosen && !m_model->branchesAt(active).empty())
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
        if (const auto branches = m_model->branchesAt(active); !branches.empty())
            selection.activeBranch = branches.front();
    }
    // An axis may be selected beside one of its branches.
    std::ranges::sort(selection.branches);
    selection.branches.erase(std::unique(selection.branches.begin(), selection.branches.end()),
                             selection.branches.end());
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
    std::vector<QModelIndex> rows = selectedBranchRows();
    // Neighbours become one range: thousands of branches are a few hundred of them.
    const auto above = [this](const QModelIndex& index) {
        const SceneRow row = SceneModel::rowAt(index);
        const BranchRows* tree = isSearching() ? nullptr : m_model->branches(row.node);
        if (!tree)
            return std::pair(SceneRow::Node, noIndex);
        return row.kind == SceneRow::Axis ? std::pair(row.kind, tree->above(row.index))
                                          : std::pair(row.kind, tree->axisOf(row.index));
    };
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

bool ScenePanel::isWhole(const BranchRows& rows, Index axis) const
{
    return std::ranges::all_of(rows.branches(axis), [this](Index branch) {
        return std::ranges::binary_search(m_document->selection().branches, branch);
    });
}

std::vector<QModelIndex> ScenePanel::selectedBranchRows() const
{
    const Selection& wanted = m_document->selection();
    std::vector<QModelIndex> found;
    const BranchRows* rows = wanted.branches.empty() ? nullptr : m_model->fetchBranches(wanted.branchNode);
    if (!rows)
        return found;
    std::vector<bool> whole(rows->axisCount(), false);
    for (const Index branch : wanted.branches) {
        if (branch >= rows->skeleton().size())
            break;
        const Index axis = rows->axisOf(branch);
        const bool first = rows->place(branch) == 0; // ascending: it comes before the others of its axis
        if (first)
            whole[axis] = isWhole(*rows, axis);
        if (whole[axis] && !first && !(isSearching() && m_results->listsBranches()))
            continue;
        if (const QModelIndex row = branchRow(wanted.branchNode, branch, whole[axis]); row.isValid())
            found.push_back(row);
    }
    return found;
}

QModelIndex ScenePanel::activeRow() const
{
    const Selection& wanted = m_document->selection();
    const BranchRows* rows =
        wanted.activeBranch == noIndex ? nullptr : m_model->fetchBranches(wanted.branchNode);
    if (!rows || wanted.activeBranch >= rows->skeleton().size())
        return nodeRow(wanted.activeNode());
    return branchRow(wanted.branchNode, wanted.activeBranch,
                     isWhole(*rows, rows->axisOf(wanted.activeBranch)));
}

/// As far as the view has rows for it.
bool ScenePanel::isSelectionShown() const
{
    Selection shown = viewSelection();
    Selection wanted = m_document->selection();
    // Any branch of an axis may be the active one.
    const auto current = m_model->branchesAt(toScene(presentView()->selectionModel()->currentIndex()));
    if (!current.empty() && current.front() == shown.activeBranch &&
        std::ranges::count(current, wanted.activeBranch) > 0)
        shown.activeBranch = wanted.activeBranch;
    if (isSearching()) {
        wanted = listed(std::move(wanted));
        if (wanted.activeBranch == noIndex)
            wanted.activeBranch = shown.activeBranch;
    }
    return shown == wanted;
}

/// What of it the search has found.
Selection ScenePanel::listed(Selection selection) const
{
    std::erase_if(selection.nodes, [this](NodeId node) { return !m_results->nodeIndex(node).isValid(); });
    std::erase_if(selection.branches, [&](Index branch) {
        return !m_results->branchIndex(selection.branchNode, branch).isValid();
    });
    if (selection.branches.empty())
        selection.branchNode = noNode;
    if (std::ranges::count(selection.branches, selection.activeBranch) == 0)
        selection.activeBranch = noIndex;
    return selection;
}

/// From the search to its results: from there on commands act on what is seen, at first on the first row.
void ScenePanel::enterList()
{
    if (isSearching()) {
        Selection seen = listed(m_document->selection());
        const bool none = seen == Selection();
        m_document->setSelection(std::move(seen));
        if (none && m_results->rowCount() > 0)
            m_list->setCurrentIndex(m_results->index(0, 0));
    }
    presentView()->setFocus(Qt::OtherFocusReason);
}

void ScenePanel::showSelection()
{
    if (m_syncing || isSelectionShown())
        return;
    m_syncing = true;
    SceneTree* view = presentView();
    const QItemSelection ranges = documentSelection();
    if (std::max(ranges.size(), view->selectionModel()->selection().size()) > manyRanges) {
        view->selectionModel()->reset();
        view->viewport()->update();
    }
    view->selectionModel()->select(ranges, QItemSelectionModel::ClearAndSelect);
    const QModelIndex active = activeRow();
    if (active.isValid()) {
        view->selectionModel()->setCurrentIndex(active, QItemSelectionModel::NoUpdate);
        view->scrollTo(active);
    }
    m_syncing = false;
}

void ScenePanel::showPointed(NodeId node, Index branch)
{
    QModelIndex row = nodeRow(node);
    // Nothing is fetched nor unfolded for it.
    if (isSearching() && branch != noIndex && m_results->branchIndex(node, branch).isValid())
        row = m_results->branchIndex(node, branch);
    else if (!isSearching() && branch != noIndex && m_model->branches(node))
        row = m_model->branchIndex(node, branch);
    for (QModelIndex above = row.parent(); above.isValid(); above = above.parent()) {
        if (!presentView()->isExpanded(above))
            row = above;
    }
    presentView()->setPointed(row);
}

void ScenePanel::showResults()
{
    m_stack->setCurrentWidget(presentView());
    m_search->showCounts(m_results->nodeCount(), m_results->branchCount(), m_results->listsBranches());
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
    // A row of the selection speaks for all of it that is seen.
    std::vector<NodeId> nodes =
        isSearching() ? listed(m_document->selection()).nodes : m_document->selection().nodes;
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
    const SceneRow row = SceneModel::rowAt(index);
    const auto branches = m_model->branchesAt(index);
    if (branches.empty())
        return;
    const Unfolded key{row.node, m_model->branches(row.node)->skeleton().key[branches.front()], row.kind};
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
    const auto from = m_expanded.lower_bound({node, 0, SceneRow::Node});
    const auto to = m_expanded.upper_bound({node, ~std::uint64_t{0}, SceneRow::Branch});
    for (const auto& [id, key, kind] : std::vector(from, to)) {
        const auto foot = rows->find(key);
        if (!foot || rows->place(*foot) > 0)
            continue;
        const QModelIndex axis = m_model->axisIndex(id, rows->axisOf(*foot));
        if (kind == SceneRow::Axis)
            m_view->expand(axis);
        else if (rows->branches(rows->axisOf(*foot)).size() > 1)
            m_view->expand(m_model->index(0, 0, axis));
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
    if (isSearching())
        m_document->setSelection(listed(m_document->selection()));
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
    if (!m_document->selection().branches.empty())
        menu.addActions(m_branchActions);
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

} // namespace ramure
