#include "widgets/actions/hand_actions.h"

#include "widgets/base/action_set.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/view/tools/hand/hand_edit.h"
#include "widgets/view/tools/hand_settings.h"
#include "widgets/view/viewport_host.h"
#include <QActionGroup>
#include <QMenu>

namespace ramure {

HandActions::HandActions(Document* document, ViewportHost* host, QActionGroup* tools, ActionSet* set,
                         QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_settings(host->settings()->hand())
    , m_keep(
          set->add({"hand.keepSelected",
                    QT_TRANSLATE_NOOP("Actions", "Keep onl&y this limb"),
                    nullptr,
                    {},
                    QT_TRANSLATE_NOOP("Actions", "All goes but the limb of the active branch, what grows on "
                                                 "it and the way down to the ground")}))
    , m_leaves(set->add({"hand.toggleLeaves",
                         QT_TRANSLATE_NOOP("Actions", "Leaves of the l&imb on or off"),
                         nullptr,
                         {},
                         QT_TRANSLATE_NOOP("Actions", "The leaves of the selected limbs go, or come back")}))
{
    for (const HandToolRow& row : handTools()) {
        QAction* action = set->add({row.id, row.text, row.icon, QKeySequence(row.key), row.tip});
        action->setCheckable(true);
        action->setData(int(row.tool));
        action->setEnabled(host->viewport() != nullptr);
        tools->addAction(action);
        m_tools += action;
        connect(action, &QAction::triggered, m_settings,
                [this, tool = row.tool] { m_settings->setTool(tool); });
    }
    connect(m_settings, &HandSettings::toolChanged, this, &HandActions::followTool);
    connect(m_keep, &QAction::triggered, this, [this] {
        const Selection& selection = m_document->selection();
        if (const auto limb = LimbFinder().startOf(*m_document, selection.branchNode, selection.activeBranch))
            report(keepLimb(*m_document, *limb));
    });
    connect(m_leaves, &QAction::triggered, this,
            [this] { report(toggleLeaves(*m_document, LimbFinder().selected(*m_document))); });
    connect(m_document, &Document::changed, this, [this](const Change& change) {
        if (change.has(changeSelection | changeReset | changeResults))
            followSelection();
    });
    followSelection();
}

void HandActions::fillMenu(QMenu* editMenu)
{
    m_menu = editMenu->addMenu(tr("Shape &by hand"));
    for (const QList<QAction*>& group : toolGroups()) {
        m_menu->addActions(group);
        m_menu->addSeparator();
    }
    m_menu->addActions({m_keep, m_leaves});
}

QList<QList<QAction*>> HandActions::toolGroups() const
{
    QList<QList<QAction*>> groups;
    for (std::size_t i = 0; i < handTools().size(); ++i) {
        if (i == 0 || handTools()[i].group != handTools()[i - 1].group)
            groups.emplace_back();
        groups.back() += m_tools[qsizetype(i)];
    }
    return groups;
}

QList<QAction*> HandActions::branchActions() const
{
    QList<QAction*> actions{m_keep, m_leaves};
    if (m_menu)
        actions += m_menu->menuAction();
    return actions;
}

void HandActions::followTool()
{
    for (QAction* action : m_tools)
        action->setChecked(action->data().toInt() == int(m_settings->tool()));
}

void HandActions::followSelection()
{
    const bool any = m_document->selection().activeBranch != noIndex;
    for (QAction* action : {m_keep, m_leaves})
        action->setEnabled(any);
}

void HandActions::report(const Expected<void>& done)
{
    if (!done)
        emit messageRaised(errorText(done.error()));
}

} // namespace ramure
