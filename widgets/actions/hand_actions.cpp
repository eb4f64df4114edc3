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
    , m_set(set)
{
    set->add(this, {{"hand.keepSelected", Actions::tr("Keep onl&y this limb"), nullptr, noKeys,
                     Actions::tr("Removes everything except the limb of the active branch, its twigs and the "
                                 "wood down to the ground"),
                     [this] { keepSelected(); }, [this] { return hasBranch(); }},
                    {"hand.toggleLeaves", Actions::tr("Leaves of the l&imb on or off"), nullptr, noKeys,
                     Actions::tr("The leaves of the selected limbs go, or come back"),
                     [this] { report(toggleLeaves(*m_document, LimbFinder().selected(*m_document))); },
                     [this] { return hasBranch(); }}});
    for (const HandToolRow& row : handTools()) {
        QAction* action = set->add(this, {row.id,
                                          Actions::tr(row.text),
                                          row.icon,
                                          QKeySequence(row.key),
                                          Actions::tr(row.tip),
                                          [this, tool = row.tool] { m_settings->setTool(tool); },
                                          {},
                                          [this, tool = row.tool] { return m_settings->tool() == tool; }});
        action->setEnabled(host->viewport() != nullptr);
        tools->addAction(action);
        m_tools += action;
    }
    const auto follow = [this] { m_set->update(this); };
    connect(m_settings, &HandSettings::toolChanged, this, follow);
    connect(m_document, &Document::changed, this, [follow](const Change& change) {
        if (change.has(changeSelection | changeReset | changeResults))
            follow();
    });
    follow();
}

void HandActions::keepSelected()
{
    const Selection& selection = m_document->selection();
    if (const auto limb = LimbFinder().startOf(*m_document, selection.branchNode, selection.activeBranch))
        report(keepLimb(*m_document, *limb));
}

bool HandActions::hasBranch() const
{
    return m_document->selection().activeBranch != noIndex;
}

void HandActions::fillMenu(QMenu* editMenu)
{
    m_menu = editMenu->addMenu(tr("Shape &by hand"));
    for (const QList<QAction*>& group : toolGroups()) {
        m_menu->addActions(group);
        m_menu->addSeparator();
    }
    m_set->fill(m_menu, {"hand.keepSelected", "hand.toggleLeaves"});
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
    QList<QAction*> actions = m_set->find({"hand.keepSelected", "hand.toggleLeaves"});
    if (m_menu)
        actions += m_menu->menuAction();
    return actions;
}

void HandActions::report(const Expected<void>& done)
{
    if (!done)
        emit messageRaised(errorText(done.error()));
}

} // namespace ramure
