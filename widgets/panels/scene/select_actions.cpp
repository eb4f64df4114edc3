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
    , m_set(set)
{
    addSteps();
    const auto nodes = [this] { return !m_document->selection().nodes.empty(); };
    const auto any = [this] { return hasAny(); };
    const auto shift = [this](int by) {
        report(edit::shiftNodes(*m_document, m_document->selection().nodes, by));
    };
    set->add(this, {{"select.search", Actions::tr("&Find in the scene"), "search",
                     Qt::CTRL | Qt::SHIFT | Qt::Key_F, QString(), [this] { emit searchRequested(); }},
                    {"select.isolate", Actions::tr("&Isolate"), nullptr, Qt::SHIFT | Qt::Key_I,
                     Actions::tr("Show only the selected branches, or nodes; again: show all"),
                     [this] { isolate(); }, [this, any] { return any() || m_isolation->isActive(); }},
                    {"select.showAll", Actions::tr("Sho&w all"), nullptr, Qt::ALT | Qt::Key_H, QString(),
                     [this] { showAll(); }, [this] { return isAnyHidden(); }},
                    {"select.up", Actions::tr("Move &up"), nullptr, Qt::ALT | Qt::Key_Up, QString(),
                     [shift] { shift(-1); }, nodes},
                    {"select.down", Actions::tr("Move &down"), nullptr, Qt::ALT | Qt::Key_Down, QString(),
                     [shift] { shift(1); }, nodes},
                    {"select.copyNames", Actions::tr("Copy the na&me"), "copy",
                     Qt::CTRL | Qt::SHIFT | Qt::Key_N, QString(), [this] { copyNames(); }, any}});
    connect(isolation, &Isolation::changed, this, &SelectActions::update);
    connect(m_document, &Document::changed, this, &SelectActions::follow);
    update();
}

void SelectActions::addSteps()
{
    const auto any = [this] { return hasAny(); };
    const auto step = [this](SelectionStep kind) {
        return [this, kind] { m_document->setSelection(afterStep(*m_document, kind)); };
    };
    m_set->add(
        this,
        {{"select.parent", Actions::tr("&Parents"), nullptr, Qt::ALT | Qt::Key_Left,
          Actions::tr("Select the parents of the selected branches"), step(SelectionStep::Parent), any},
         {"select.children", Actions::tr("&Children"), nullptr, Qt::ALT | Qt::Key_Right,
          Actions::tr("Select the children of the selected branches"), step(SelectionStep::Children), any},
         {"select.siblings", Actions::tr("&Siblings"), nullptr, Qt::SHIFT | Qt::Key_S,
          Actions::tr("Select all with the same parent"), step(SelectionStep::Siblings), any},
         {"select.subtree", Actions::tr("Sub&tree"), nullptr, Qt::SHIFT | Qt::Key_T,
          Actions::tr("Add everything that grows from the selected ones"), step(SelectionStep::Subtree), any},
         {"select.level", Actions::tr("All of the same &order"), nullptr, Qt::SHIFT | Qt::Key_L,
          Actions::tr("Select all as deep as the selected ones"), step(SelectionStep::Order), any}});
}

void SelectActions::fillMenu(QMenu* menu)
{
    m_set->fill(menu, {"select.search", nullptr});
    menu->addActions(stepActions());
    menu->addSeparator();
    menu->addActions(rowActions());
}

QList<QAction*> SelectActions::stepActions() const
{
    return m_set->find(
        {"select.parent", "select.children", "select.siblings", "select.subtree", "select.level"});
}

QList<QAction*> SelectActions::rowActions() const
{
    return m_set->find({"select.isolate", "select.showAll", "select.up", "select.down", "select.copyNames"});
}

void SelectActions::follow(const Change& change)
{
    if (change.has(changeSelection | changeStructure | changeReset | changeNodeState))
        update();
}

void SelectActions::update()
{
    m_set->update(this);
}

bool SelectActions::hasAny() const
{
    return !m_document->selection().nodes.empty() || !m_document->selection().branches.empty();
}

bool SelectActions::isAnyHidden() const
{
    return m_isolation->isActive() ||
           std::ranges::any_of(m_document->scene().nodes(), [](const Node& node) { return !node.visible; });
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
