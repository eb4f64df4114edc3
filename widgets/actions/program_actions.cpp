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
    , m_welcome(set->add({"file.welcome", QT_TRANSLATE_NOOP("Actions", "&Welcome page"), "welcome",
                          QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_W),
                          QT_TRANSLATE_NOOP("Actions", "Presets as pictures, recent files, first keys")}))
    , m_editPreferences(set->add({"edit.preferences", QT_TRANSLATE_NOOP("Actions", "&Preferences…"),
                                  "preferences", QKeySequence(Qt::CTRL | Qt::Key_Comma),
                                  QT_TRANSLATE_NOOP("Actions", "Theme, language, units, mouse, autosave")}))
    , m_shortcuts(set->add({"help.shortcuts", QT_TRANSLATE_NOOP("Actions", "&Keyboard shortcuts…"),
                            "keyboard", QKeySequence(Qt::SHIFT | Qt::Key_F1),
                            QT_TRANSLATE_NOOP("Actions", "See and change the keys of all actions")}))
    , m_about(set->add({"help.about", QT_TRANSLATE_NOOP("Actions", "&About Ramure"), "about", {}}))
{
    m_about->setMenuRole(QAction::AboutRole);
    m_editPreferences->setMenuRole(QAction::PreferencesRole);
    connect(m_editPreferences, &QAction::triggered, this, &ProgramActions::showPreferences);
    connect(m_shortcuts, &QAction::triggered, this, &ProgramActions::showShortcuts);
    connect(m_about, &QAction::triggered, this, &ProgramActions::showAbout);
    connect(m_preferences, &Preferences::changed, this, &ProgramActions::takePreferences);
    takePreferences();
    connect(m_view, &ViewSettings::groundVisibleChanged, m_preferences, &Preferences::setGroundVisible);
}

void ProgramActions::setMenus(const QList<QMenu*>& menus)
{
    m_menus = menus;
    adoptMenuActions(*m_set, menus);
    m_set->setShortcuts(m_preferences->shortcuts());
}

void ProgramActions::takePreferences()
{
    m_view->setNavigationStyle(m_preferences->navigationStyle());
    m_view->setGroundVisible(m_preferences->groundVisible());
}

void ProgramActions::showPreferences()
{
    openDialog(new PreferencesDialog(m_preferences, m_window));
}

void ProgramActions::showShortcuts()
{
    openDialog(new ShortcutsDialog(m_set, m_menus, m_preferences, m_window));
}

void ProgramActions::showAbout()
{
    openDialog(new AboutDialog(m_window));
}

} // namespace ramure
