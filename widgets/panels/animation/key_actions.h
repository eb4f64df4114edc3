/// \file
/// All that is done with keys, as actions and menus: for the menu bar, the dock and the shortcuts dialog.
#pragma once

#include "core/rig/tracks/key.h"
#include "core/rig/tracks/track.h"
#include "widgets/base/action_set.h"
#include <QList>
#include <QObject>
#include <functional>
#include <vector>

class QAction;
class QMenu;
class QWidget;

namespace ramure {

class KeyCommands;

class KeyActions : public QObject
{
    Q_OBJECT
public:
    /// Neither is owned; both must outlive the object.
    KeyActions(KeyCommands* commands, ActionSet* set, QObject* parent = nullptr);

    /// May be called for several menus; the submenus belong to them.
    void fillMenu(QMenu* menu);
    [[nodiscard]] QAction* insertAction() const { return m_set->find("keys.insert"); }
    /// Checkable: edits of parameters become keys.
    [[nodiscard]] QAction* autoAction() const { return m_set->find("keys.auto"); }
    [[nodiscard]] QAction* previousAction() const { return m_set->find("keys.previous"); }
    [[nodiscard]] QAction* nextAction() const { return m_set->find("keys.next"); }
    /// New menus with pictures, for the parent's tool buttons or other menus.
    QMenu* insertMenu(QWidget* parent) const;
    QMenu* modeMenu(QWidget* parent) const;
    QMenu* easingMenu(QWidget* parent) const;
    QMenu* handleMenu(QWidget* parent) const;
    QMenu* extrapolationMenu(QWidget* parent) const;

private:
    void addEdits();
    void addSelects();

    KeyCommands* m_commands;
    ActionSet* m_set;
    QList<QAction*> m_inserts;
    QList<QAction*> m_edits;
    QList<QAction*> m_selects;
};

} // namespace ramure
