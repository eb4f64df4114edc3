#include "widgets/panels/scene/select_actions.h"

#include "widgets/base/action_set.h"
#include "widgets/base/targets.h"
#include "widgets/base/texts/branch_names.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/panels/scene/isolation.h"
#include "widgets/panels/scene/node_edits.h"
#include <QClipboard>
#include <QGuiApplication>
#include <QMenu>
#include <algorithm>
#include <vector>

namespace ramure {

SelectActions::SelectActions(Document* document, Isolation* isolation, ActionSet* set, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_isolation(isolation)
    , m_parent(set->add({"select.parent", QT_TRANSLATE_NOOP("Actions", "&Parents"), nullptr,
                         QKeySequence(Qt::ALT | Qt::Key_Left),
                         QT_TRANSLATE_NOOP("Actions", "Select what the selected ones spring from")}))
    , m_children(set->add({"select.children", QT_TRANSLATE_NOOP("Actions", "&Children"), nullptr,
                           QKeySequence(Qt::ALT | Qt::Key_Right),
                           QT_TRANSLATE_NOOP("Actions", "Select what springs from the selected ones")}))
    , m_siblings(set->add({"select.siblings", QT_TRANSLATE_NOOP("Actions", "&Siblings"), nullptr,
                           QKeySequence(Qt::SHIFT | Qt::Key_S),
                           QT_TRANSLATE_NOOP("Actions", "Select all with the same parent")}))
    , m_subtree(set->add({"select.subtree", QT_TRANSLATE_NOOP("Actions", "Sub&tree"), nullptr,
                          QKeySequence(Qt::SHIFT | Qt::Key_T),
                          QT_TRANSLATE_NOOP("Actions", "Add everything that grows from the selected ones")}))
    , m_level(set->add({"select.level", QT_TRANSLATE_NOOP("Actions", "All of the &level"), nullptr,
                        QKeySequence(Qt::SHIFT | Qt::Key_L),
                        QT_TRANSLATE_NOOP("Actions", "Select all as deep as the selected ones")}))
    , m_search(set->add({"select.search", QT_TRANSLATE_NOOP("Actions", "&Find in the scene"), "search",
                         QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_F)}))
    , m_isolate(set->add(
          {"select.isolate", QT_TRANSLATE_NOOP("Actions", "&Isolate"), nullptr,
           QKeySequence(Qt::SHIFT | Qt::Key_I),
           QT_TRANSLATE_NOOP("Actions", "Show only the selected branches, or nodes; again: show all")}))
    , m_showAll(set->add({"select.showAll", QT_TRANSLATE_NOOP("Actions", "Sho&w all"), nullptr,
                          QKeySequence(Qt::ALT | Qt::Key_H)}))
    , m_up(set->add({"select.up", QT_TRANSLATE_NOOP("Actions", "Move &up"), nullptr,
                     QKeySequence(Qt::ALT | Qt::Key_Up)}))
    , m_down(set->add({"select.down", QT_TRANSLATE_NOOP("Actions", "Move &down"), nullptr,
                       QKeySequence(Qt::ALT | Qt::Key_Down)}))
    , m_copyNames(set->add({"select.copyNames", QT_TRANSLATE_NOOP("Actions", "Copy the na&me"), "copy",
                            QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_N)}))
{
    const std::pair<QAction*, SelectionStep> steps[] = {
        {m_parent, SelectionStep::Parent},     {m_children, SelectionStep::Children},
        {m_siblings, SelectionStep::Siblings}, {m_subtree, SelectionStep::Subtree},
        {m_level, SelectionStep::Level},
    };
    for (const auto& [action, kind] : steps)
        connect(action, &QAction::triggered, this, [this, wish = kind] { step(wish); });
    connect(m_search, &QAction::triggered, this, &SelectActions::searchRequested);
    connect(m_isolate, &QAction::triggered, this, &SelectActions::isolate);
    connect(m_showAll, &QAction::triggered, this, &SelectActions::showAll);
    connect(isolation, &Isolation::changed, this, &SelectActions::update);
    connect(m_up, &QAction::triggered, this,
            [this] { report(edit::shiftNodes(*m_document, m_document->selection().nodes, -1)); });
    connect(m_down, &QAction::triggered, this,
            [this] { report(edit::shiftNodes(*m_document, m_document->selection().nodes, 1)); });
    connect(m_copyNames, &QAction::triggered, this, &SelectActions::copyNames);
    connect(m_document, &Document::changed, this, &SelectActions::follow);
    update();
}

void SelectActions::fillMenu(QMenu* menu)
{
    menu->addAction(m_search);
    menu->addSeparator();
    menu->addActions(stepActions());
    menu->addSeparator();
    menu->addActions(rowActions());
}

QList<QAction*> SelectActions::stepActions() const
{
    return {m_parent, m_children, m_siblings, m_subtree, m_level};
}

QList<QAction*> SelectActions::rowActions() const
{
    return {m_isolate, m_showAll, m_up, m_down, m_copyNames};
}

void SelectActions::follow(const Change& change)
{
    if (change.has(changeSelection | changeStructure | changeReset | changeNodeState))
        update();
}

void SelectActions::update()
{
    const Selection& selection = m_document->selection();
    const bool nodes = !selection.nodes.empty();
    const bool any = nodes || !selection.branches.empty();
    for (QAction* action : stepActions() + QList<QAction*>{m_copyNames, m_isolate})
        action->setEnabled(any);
    m_up->setEnabled(nodes);
    m_down->setEnabled(nodes);
    const auto& all = m_document->scene().nodes();
    m_isolate->setEnabled(any || m_isolation->isActive());
    m_showAll->setEnabled(m_isolation->isActive() ||
                          std::ranges::any_of(all, [](const Node& node) { return !node.visible; }));
}

void SelectActions::step(SelectionStep step)
{
    m_document->setSelection(afterStep(*m_document, step));
}

/// Where branches are selected it is about them: a way of looking. Hiding nodes is an edit of the scene.
void SelectActions::isolate()
{
    const Selection& selection = m_document->selection();
    if (!selection.branches.empty() || (selection.nodes.empty() && m_isolation->isActive()))
        m_isolation->toggleSelected();
    else
        report(edit::isolateNodes(*m_document, targetNodes(*m_document)));
}

void SelectActions::showAll()
{
    m_isolation->clear();
    report(edit::showAllNodes(*m_document));
}

void SelectActions::copyNames()
{
    const Selection& selection = m_document->selection();
    QStringList names;
    for (const NodeId id : selection.nodes)
        names += QString::fromStdString(m_document->scene().find(id)->name);
    const NodeResult* result =
        selection.branches.empty() ? nullptr : m_document->result(selection.branchNode);
    if (result && result->tree.simplified) {
        const BranchRows rows(result->tree);
        const BranchNames called;
        std::vector<bool> isNamed(rows.axisCount(), false); // as a whole
        for (const Index branch : selection.branches) {
            const Index axis = rows.axisOf(branch);
            const auto limb = rows.branches(axis);
            const auto isSelected = [&](Index b) {
                return std::ranges::binary_search(selection.branches, b);
            };
            if (branch == limb.front() && std::ranges::all_of(limb, isSelected)) {
                isNamed[axis] = true;
                names += called.axis(rows, axis);
            } else if (!isNamed[axis]) {
                names += called.branch(rows, branch);
            }
        }
    }
    QGuiApplication::clipboard()->setText(names.join(u'\n'));
}

void SelectActions::report(const Expected<void>& done)
{
    if (!done)
        emit messageRaised(errorText(done.error()));
}

} // namespace ramure
