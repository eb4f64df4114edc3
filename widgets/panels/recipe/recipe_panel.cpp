#include "widgets/panels/recipe/recipe_panel.h"

#include "core/generators/tree_life.h"
#include "core/params/tree_edit_table.h"
#include "core/qt/document/commands.h"
#include "core/recipe/axis_filter.h"
#include "widgets/base/empty_page.h"
#include "widgets/base/named.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/icons.h"
#include "widgets/panels/recipe/recipe_model.h"
#include "widgets/view/tools/limb_finder.h"
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QStackedWidget>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>
#include <optional>

namespace ramure {

RecipePanel::RecipePanel(Document* document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_model(new RecipeModel(document, this))
    , m_pages(new QStackedWidget(this))
    , m_empty(new EmptyPage(this))
    , m_list(new QWidget(this))
    , m_title(new QLabel(m_list))
    , m_view(new QTreeView(m_list))
    , m_copyMenu(new QMenu(this))
{
    build();
    connect(m_model, &RecipeModel::refused, this, &RecipePanel::messageRaised);
    connect(m_model, &QAbstractItemModel::modelAboutToBeReset, this, [this] {
        const auto ids = selectedIds();
        m_kept = {ids.begin(), ids.end()};
        const auto places = m_model->placesOf(m_view->currentIndex());
        m_current = places.empty() ? 0 : m_model->idAt(places.front());
        m_open.clear();
        for (int row = 0; row < m_model->rowCount(); ++row)
            if (const QModelIndex index = m_model->index(row, 0); m_view->isExpanded(index))
                m_open.insert(m_model->idAt(m_model->placesOf(index).front()));
    });
    connect(m_model, &RecipeModel::listChanged, this, &RecipePanel::follow);
    connect(m_view->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
        updateButtons();
        chooseStep();
        if (m_view->hasFocus() && !m_restores)
            selectBranches();
    });
    connect(m_view, &QTreeView::clicked, this, &RecipePanel::selectBranches);
    connect(m_view, &QWidget::customContextMenuRequested, this, &RecipePanel::showMenu);
    connect(m_copyMenu, &QMenu::aboutToShow, this, &RecipePanel::fillCopyMenu);
    const auto name = [](QToolButton* button, const QString& text) {
        button->setToolTip(text);
        button->setAccessibleName(text);
    };
    name(m_up, tr("Move up (Alt+Up): the step acts before the one above"));
    name(m_down, tr("Move down (Alt+Down): the step acts after the one below"));
    name(m_copy, tr("Copy the selected steps to another tree"));
    name(m_delete, tr("Delete the selected steps (Del)"));
    name(m_add, tr("Add a step to the recipe"));
    m_view->setAccessibleName(tr("Steps of the recipe"));
    follow();
}

void RecipePanel::build()
{
    m_view->setObjectName(QStringLiteral("editList"));
    m_view->setModel(m_model);
    m_view->setRootIsDecorated(false);
    m_view->setUniformRowHeights(true);
    m_view->setAllColumnsShowFocus(true);
    m_view->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_view->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_view->setDragDropMode(QAbstractItemView::InternalMove);
    m_view->setDefaultDropAction(Qt::MoveAction);
    m_view->setDropIndicatorShown(true);
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    m_view->setTextElideMode(Qt::ElideRight);
    m_view->header()->setSectionsMovable(false);
    m_view->header()->setStretchLastSection(false);
    m_view->header()->setSectionResizeMode(RecipeModel::Limb, QHeaderView::Stretch);
    m_view->setColumnWidth(RecipeModel::Name, 170);
    m_view->setColumnWidth(RecipeModel::Time, 56);
    m_view->installEventFilter(this);
    auto* row = layoutOf<QHBoxLayout>(nullptr, 2, {10, 6, 6, 6});
    row->addWidget(m_title, 1);
    m_title->setObjectName(QStringLiteral("partTitle"));
    const auto button = [&](const char* name, const char* picture) {
        auto* made = new QToolButton(m_list);
        made->setObjectName(QLatin1String(name));
        made->setIcon(icon(picture));
        made->setFocusPolicy(Qt::TabFocus);
        row->addWidget(made);
        return made;
    };
    m_add = button("stepAdd", "add");
    m_add->setPopupMode(QToolButton::InstantPopup);
    m_up = button("editUp", "fold-up");
    m_down = button("editDown", "fold-open");
    m_copy = button("editCopy", "copy");
    m_delete = button("editDelete", "delete");
    m_copy->setMenu(m_copyMenu);
    m_copy->setPopupMode(QToolButton::InstantPopup);
    connect(m_up, &QToolButton::clicked, this, [this] { moveCurrent(-1); });
    connect(m_down, &QToolButton::clicked, this, [this] { moveCurrent(1); });
    connect(m_delete, &QToolButton::clicked, this, &RecipePanel::removeSelected);
    auto* column = layoutOf<QVBoxLayout>(m_list, 0);
    column->addLayout(row);
    column->addWidget(m_view, 1);
    m_pages->addWidget(m_empty);
    m_pages->addWidget(m_list);
    auto* layout = layoutOf<QVBoxLayout>(this);
    layout->addWidget(m_pages);
}

void RecipePanel::follow()
{
    const Node* node = m_document->scene().find(m_model->tree());
    m_pages->setCurrentWidget(m_model->rowCount() > 0 ? m_list : static_cast<QWidget*>(m_empty));
    m_empty->setText(tr("Select a tree: its recipe is listed here, the steps that make it one after the "
                        "other."));
    if (node)
        m_title->setText(QString::fromStdString(node->name));
    m_view->setRootIsDecorated(m_model->hasGroups());
    for (int row = 0; row < m_model->rowCount(); ++row)
        if (const QModelIndex index = m_model->index(row, 0); m_model->isGroup(index))
            m_view->setExpanded(index, m_open.contains(m_model->idAt(m_model->placesOf(index).front())));
    QItemSelection again;
    for (const std::uint64_t id : m_kept)
        if (const int row = m_model->rowOf(id); row >= 0)
            again.select(m_model->indexOf(row), m_model->indexOf(row, RecipeModel::Columns - 1));
    for (int row = 0; row < m_model->rowCount(); ++row) {
        const QModelIndex index = m_model->index(row, 0);
        const auto isKept = [this](int place) { return m_kept.contains(m_model->idAt(place)); };
        if (m_model->isGroup(index) && std::ranges::all_of(m_model->placesOf(index), isKept))
            again.select(index, m_model->index(row, RecipeModel::Columns - 1));
    }
    if (!m_view->selectionModel()->hasSelection() && !again.isEmpty()) {
        m_restores = true; // nobody has chosen anything
        m_view->selectionModel()->select(again, QItemSelectionModel::ClearAndSelect);
        if (const int row = m_model->rowOf(m_current); row >= 0)
            m_view->selectionModel()->setCurrentIndex(m_model->indexOf(row), QItemSelectionModel::NoUpdate);
        m_restores = false;
    }
    updateButtons();
    chooseStep();
}

/// Properties show the values of the one step that is selected.
void RecipePanel::chooseStep()
{
    const auto ids = selectedIds();
    emit stepChosen(m_model->tree(), ids.size() == 1 ? ids.front() : RecipeModel::sourceId);
}

void RecipePanel::select(quint64 step)
{
    if (const int row = m_model->rowOf(step); row >= 0)
        m_view->setCurrentIndex(m_model->indexOf(row));
}

void RecipePanel::setAddMenu(QMenu* menu)
{
    m_add->setMenu(menu);
}

std::vector<std::uint64_t> RecipePanel::selectedIds() const
{
    std::set<int> places; // a group and an edit in it may both be selected
    for (const QModelIndex& index : m_view->selectionModel()->selectedRows())
        for (const int place : m_model->placesOf(index))
            places.insert(place);
    std::vector<std::uint64_t> ids;
    for (const int place : places)
        if (m_model->idAt(place) != RecipeModel::sourceId)
            ids.push_back(m_model->idAt(place));
    return ids;
}

void RecipePanel::updateButtons()
{
    const auto ids = selectedIds();
    const int row = ids.size() == 1 ? m_model->rowOf(ids.front()) : -1;
    const auto isTree = [](const Node& node) { return node.kind == NodeKind::Tree; };
    m_up->setEnabled(row > 1);
    m_down->setEnabled(row >= 1 && row < m_model->editCount());
    m_delete->setEnabled(!ids.empty());
    m_copy->setEnabled(!ids.empty() && std::ranges::count_if(m_document->scene().nodes(), isTree) > 1);
}

void RecipePanel::removeSelected()
{
    if (const auto ids = selectedIds(); !ids.empty())
        report(edit::removeTreeEdits(*m_document, m_model->tree(), ids));
}

void RecipePanel::moveCurrent(int rows)
{
    const auto ids = selectedIds();
    if (ids.size() != 1)
        return;
    const int to = m_model->rowOf(ids.front()) + rows;
    if (to >= 1 && to <= m_model->editCount())
        report(edit::moveTreeEdit(*m_document, m_model->tree(), ids.front(), to - 1));
}

void RecipePanel::selectBranches()
{
    Selection next;
    next.nodes = {m_model->tree()};
    for (const std::uint64_t id : selectedIds()) {
        const auto limb = m_model->branchesAt(m_model->rowOf(id));
        next.branches.insert(next.branches.end(), limb.begin(), limb.end());
    }
    if (!next.branches.empty()) {
        next.branchNode = m_model->tree();
        next.activeBranch = next.branches.front();
        std::ranges::sort(next.branches);
        const auto twice = std::unique(next.branches.begin(), next.branches.end());
        next.branches.erase(twice, next.branches.end());
    }
    m_document->setSelection(std::move(next));
}

std::vector<std::uint64_t> RecipePanel::chosenAxes() const
{
    std::vector<std::uint64_t> addresses;
    for (const LimbHit& limb : LimbFinder().selected(*m_document))
        if (limb.node == m_model->tree())
            addresses.push_back(limb.address);
    return addresses;
}

void RecipePanel::actOnChosenAxes(std::uint64_t step)
{
    report(edit::setStepParam(*m_document, m_model->tree(), step, *findParam("step.where"),
                              AxisFilter::ofAxes(chosenAxes())));
}

void RecipePanel::freeze()
{
    const auto places = m_model->placesOf(m_view->currentIndex());
    if (!places.empty())
        report(edit::freezeTree(*m_document, m_model->tree(), m_model->idAt(places.back())));
}

/// Whether later years of a growing tree answer the chosen cuts.
void RecipePanel::addAnswer(QMenu& menu)
{
    const Node* node = m_document->scene().find(m_model->tree());
    const double age = node ? growthYears(node->params) : 0.0;
    std::vector<TreeEdit> edits = node ? node->params.edits : std::vector<TreeEdit>();
    const auto ids = selectedIds();
    std::vector<TreeEdit*> chosen;
    for (TreeEdit& edit : edits)
        if (canLiveOn(edit) && std::ranges::count(ids, edit.id) > 0)
            chosen.push_back(&edit);
    if (age <= 0.0 || chosen.empty())
        return;
    const bool all = std::ranges::all_of(chosen, [](const TreeEdit* edit) { return edit->year > 0.0; });
    for (TreeEdit* edit : chosen)
        edit->year = all ? 0.0 : edit->year > 0.0 ? edit->year : age;
    QAction* answer = menu.addAction(tr("The tree answers in later years"), this, [this, edits, all] {
        report(
            edit::setTreeEdits(*m_document, m_model->tree(), edits,
                               all ? tr("Cut the tree as it has grown") : tr("Let the tree answer a cut")));
    });
    answer->setCheckable(true);
    answer->setChecked(all);
}

void RecipePanel::fillCopyMenu()
{
    m_copyMenu->clear();
    for (const Node& node : m_document->scene().nodes()) {
        if (node.kind != NodeKind::Tree || node.id == m_model->tree())
            continue;
        QString name = QString::fromStdString(node.name);
        m_copyMenu->addAction(
            icon("tree"), name.replace(u'&', QStringLiteral("&&")), this, [this, to = node.id] {
                report(edit::copyTreeEdits(*m_document, m_model->tree(), selectedIds(), {to}));
            });
    }
}

void RecipePanel::showMenu(const QPoint& at)
{
    const auto ids = selectedIds();
    if (!m_view->indexAt(at).isValid())
        return;
    QMenu menu(this);
    const auto addFreeze = [&] {
        menu.addAction(icon("lock"), tr("Freeze up to here"), this, &RecipePanel::freeze)
            ->setEnabled(ids.size() <= 1 &&
                         !m_model->isFrozen(m_model->placesOf(m_view->currentIndex()).back()));
    };
    if (ids.empty()) { // the source
        addFreeze();
        menu.exec(m_view->viewport()->mapToGlobal(at));
        return;
    }
    QAction* rename = menu.addAction(icon("rename"), tr("Rename"), this,
                                     [this] { m_view->edit(m_view->currentIndex().siblingAtColumn(0)); });
    rename->setEnabled(ids.size() == 1);
    menu.addAction(icon("duplicate"), tr("Duplicate"), this,
                   [this] { report(edit::duplicateTreeEdits(*m_document, m_model->tree(), selectedIds())); });
    for (const bool on : {true, false})
        menu.addAction(on ? tr("Switch on") : tr("Switch off"), this, [this, on] {
            report(edit::setTreeEditsEnabled(*m_document, m_model->tree(), selectedIds(), on));
        });
    const int row = ids.size() == 1 ? m_model->rowOf(ids.front()) : 0;
    const bool hasWhere = row > 0 && std::ranges::count(stepParams(m_model->editAt(row).operation),
                                                        findParam("step.where")) > 0;
    menu.addAction(icon("tool-select"), tr("Act on the selected branches only"), this,
                   [this, &ids] { actOnChosenAxes(ids.front()); })
        ->setEnabled(hasWhere && !chosenAxes().empty());
    if (row > 0 && m_model->editAt(row).operation == EditOperation::Frozen)
        menu.addAction(icon("unlock"), tr("Thaw: the steps above run again"), this,
                       &RecipePanel::removeSelected);
    else
        addFreeze();
    addAnswer(menu);
    menu.addSeparator();
    const auto addMove = [&](const QToolButton* button, const QString& text, int rows, Qt::Key key) {
        QAction* move = menu.addAction(button->icon(), text, this, [this, rows] { moveCurrent(rows); });
        move->setShortcut(Qt::ALT | key);
        move->setEnabled(button->isEnabled());
    };
    addMove(m_up, tr("Move up"), -1, Qt::Key_Up);
    addMove(m_down, tr("Move down"), 1, Qt::Key_Down);
    m_copyMenu->setTitle(tr("Copy to"));
    menu.addMenu(m_copyMenu)->setEnabled(m_copy->isEnabled());
    menu.addAction(icon("save"), tr("Keep as a preset of steps"), this,
                   [this] { emit saveRequested(m_model->tree(), selectedIds()); });
    menu.addSeparator();
    menu.addAction(icon("delete"), tr("Delete"), this, &RecipePanel::removeSelected);
    menu.exec(m_view->viewport()->mapToGlobal(at));
}

void RecipePanel::report(const Expected<void>& done)
{
    if (!done)
        emit messageRaised(errorText(done.error()));
}

/// Delete and F2 are of the rows here, not of the tree.
bool RecipePanel::eventFilter(QObject* watched, QEvent* event)
{
    if (watched != m_view || (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress))
        return QWidget::eventFilter(watched, event);
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool moves =
        key->modifiers() == Qt::AltModifier && (key->key() == Qt::Key_Up || key->key() == Qt::Key_Down);
    const bool plain = key->modifiers() == Qt::NoModifier;
    const bool deletes = plain && key->key() == Qt::Key_Delete;
    if (event->type() == QEvent::ShortcutOverride) {
        if (moves || deletes || (plain && (key->key() == Qt::Key_F2 || key->key() == Qt::Key_Space)))
            event->accept();
        return event->isAccepted();
    }
    if (moves)
        moveCurrent(key->key() == Qt::Key_Up ? -1 : 1);
    else if (deletes)
        removeSelected();
    return moves || deletes || QWidget::eventFilter(watched, event);
}

} // namespace ramure
