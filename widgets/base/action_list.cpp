#include "widgets/base/action_list.h"

#include "widgets/base/action_set.h"
#include <functional>

namespace ramure {
namespace {

/// Calls \p visit with every action below \p menu and the titles that lead to it. Menus are two levels deep.
void walk(const QMenu& menu, const QString& above, const std::function<void(QAction*, const QString&)>& visit)
{
    for (QAction* action : menu.actions()) {
        if (action->isSeparator())
            continue;
        const QString text = above + plainText(action->text());
        if (const QMenu* below = action->menu())
            walk(*below, text + QStringLiteral(" › "), visit);
        else
            visit(action, text);
    }
}

} // namespace

QString plainText(QString text)
{
    text.replace(QStringLiteral("&&"), QStringLiteral("\u0001"));
    text.remove(u'&').remove(u'…');
    return text.replace(u'\u0001', u'&');
}

void adoptMenuActions(ActionSet& set, const QList<QMenu*>& menus)
{
    for (const QMenu* menu : menus)
        walk(*menu, {}, [&set](QAction* action, const QString&) { set.adopt(action); });
}

QList<ListedAction> listedActions(const ActionSet& set, const QList<QMenu*>& menus)
{
    QList<ListedAction> listed;
    for (const QMenu* menu : menus) {
        const QString title = plainText(menu->title());
        walk(*menu, {}, [&](QAction* action, const QString& text) {
            if (!action->objectName().isEmpty() && set.find(action->objectName()) == action)
                listed += {action, title, text};
        });
    }
    return listed;
}

} // namespace ramure
