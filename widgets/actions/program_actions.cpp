#include "widgets/actions/program_actions.h"

#include "widgets/base/action_set.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/about_dialog.h"
#include "widgets/dialogs/preferences_dialog.h"
#include "widgets/dialogs/shortcuts_dialog.h"
#include "widgets/view/view_settings.h"

namespace ramure {
namespace {

template <class Dialog> void openDialog(Dialog* dialog)
{
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

} // namespace

ProgramActions::ProgramActions(ActionSet* set, Preferences* preferences, ViewSettings* view, QWidget* window)
    : QObject(window)
    , m_set(set)
    , m_preferences(preferences)
    , m_view(view)
    , m_window(window)
{
    set->add(this,
             {{"file.welcome", Actions::tr("&Welcome page"), "welcome", Qt::CTRL | Qt::SHIFT | Qt::Key_W,
               Actions::tr("Presets as pictures, recent files, first keys")},
              {"edit.preferences", Actions::tr("&Preferences…"), "preferences", Qt::CTRL | Qt::Key_Comma,
               Actions::tr("Theme, language, units, mouse, autosave"),
               [this] { openDialog(new PreferencesDialog(m_preferences, m_window)); }},
              {"help.shortcuts", Actions::tr("&Keyboard shortcuts…"), "keyboard", Qt::SHIFT | Qt::Key_F1,
               Actions::tr("See and change the keys of all actions"),
               [this] { openDialog(new ShortcutsDialog(m_set, m_menus, m_preferences, m_window)); }},
              {"help.about", Actions::tr("&About Ramure"), "about", noKeys, QString(),
               [this] { openDialog(new AboutDialog(m_window)); }}});
    set->find("help.about")->setMenuRole(QAction::AboutRole);
    set->find("edit.preferences")->setMenuRole(QAction::PreferencesRole);
    connect(m_preferences, &Preferences::changed, this, &ProgramActions::takePreferences);
    takePreferences();
    m_view->groundVisible.follow(this, [this] { m_preferences->groundVisible.set(m_view->groundVisible()); });
}

void ProgramActions::setMenus(const QList<QMenu*>& menus)
{
    m_menus = menus;
    adoptMenuActions(*m_set, menus);
    m_set->setShortcuts(m_preferences->shortcuts());
}

void ProgramActions::takePreferences()
{
    m_view->navigationStyle.set(m_preferences->navigationStyle());
    m_view->groundVisible.set(m_preferences->groundVisible());
}

} // namespace ramure
