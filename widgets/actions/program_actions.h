/// \file
/// Actions for the program rather than the scene: welcome page, preferences, shortcuts, About.
#pragma once

#include <QList>
#include <QObject>

class QAction;
class QMenu;
class QWidget;

namespace ramure {

class ActionSet;
class Preferences;
class ViewSettings;

class ProgramActions : public QObject
{
    Q_OBJECT
public:
    /// Nothing is owned; all must outlive the actions. \p window is the parent of dialogs.
    ProgramActions(ActionSet* set, Preferences* preferences, ViewSettings* view, QWidget* window);

    /// When the menus are filled: takes their actions into the set and gives them the user's shortcuts.
    void setMenus(const QList<QMenu*>& menus);

private:
    void takePreferences();

    ActionSet* m_set;
    Preferences* m_preferences;
    ViewSettings* m_view;
    QWidget* m_window;
    QList<QMenu*> m_menus;
};

} // namespace ramure
