/// \file
/// All that is done with keys, as actions and menus: for the menu bar, the dock and the shortcuts dialog.
#pragma once

#include "core/rig/tracks/key.h"
#include "core/rig/tracks/track.h"
#include <QList>
#include <QObject>
#include <functional>
#include <vector>

class QAction;
class QMenu;
class QWidget;

namespace ramure {

class ActionSet;
class KeyCommands;

class KeyActions : public QObject
{
    Q_OBJECT
public:
    /// Neither is owned; both must outlive the object.
    KeyActions(KeyCommands* commands, ActionSet* set, QObject* parent = nullptr);

    /// May be called for several menus; the submenus belong to them.
    void fillMenu(QMenu* menu);
    [[nodiscard]] QAction* insertAction() const { return m_insert; }
    /// Checkable: edits of parameters become keys.
    [[nodiscard]] QAction* autoAction() const { return m_auto; }
    [[nodiscard]] QAction* previousAction() const { return m_previous; }
    [[nodiscard]] QAction* nextAction() const { return m_next; }
    /// New menus with pictures, for the parent's tool buttons or other menus.
    QMenu* insertMenu(QWidget* parent) const;
    QMenu* modeMenu(QWidget* parent) const;
    QMenu* easingMenu(QWidget* parent) const;
    QMenu* handleMenu(QWidget* parent) const;
    QMenu* extrapolationMenu(QWidget* parent) const;

private:
    void addInserts(ActionSet* set);
    void addCopies(ActionSet* set);
    void addEdits(ActionSet* set);
    void addSelects(ActionSet* set);

    KeyCommands* m_commands;
    QAction* m_insert;
    QAction* m_removeHere;
    QAction* m_auto;
    QAction* m_previous;
    QAction* m_next;
    QList<QAction*> m_inserts;
    QList<QAction*> m_edits;
    QList<QAction*> m_selects;
};

} // namespace ramure
