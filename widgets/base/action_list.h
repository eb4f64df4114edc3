/// \file
/// The actions as the menus hold them, for the dialog of shortcuts.
#pragma once

#include <QKeySequence>
#include <QList>
#include <QMenu>
#include <QString>

namespace ramure {

class ActionSet;

struct ListedAction
{
    QAction* action = nullptr;
    QString menu; ///< title of the top menu, without its mnemonic
    QString text; ///< "View from › Front": the way below that menu
};

/// Adds the named actions of the menus and their submenus to the set.
void adoptMenuActions(ActionSet& set, const QList<QMenu*>& menus);
/// Lists the actions of the set in the order of the menus.
QList<ListedAction> listedActions(const ActionSet& set, const QList<QMenu*>& menus);
/// Returns the text without mnemonics and dots.
QString plainText(QString text);

} // namespace ramure
