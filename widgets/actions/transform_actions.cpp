#include "widgets/actions/transform_actions.h"

#include "widgets/actions/tool_settings_dialog.h"
#include "widgets/base/action_set.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/view/tools/hand_settings.h"
#include "widgets/view/viewport.h"
#include "widgets/view/viewport_host.h"
#include <QActionGroup>
#include <QComboBox>
#include <QMenu>
#include <QToolBar>

namespace ramure {

TransformActions::TransformActions(ViewportHost* host, Preferences* preferences, ActionSet* set,
                                   QWidget* window)
    : QObject(window)
    , m_host(host)
    , m_set(set)
    , m_preferences(preferences)
    , m_window(window)
    , m_settings(host->settings()->gizmo())
    , m_hand(host->settings()->hand())
    , m_tools(new QActionGroup(this))
    , m_spaces(new QActionGroup(this))
{
    m_settings->restore(preferences->toolSettings());
    m_settings->setRadians(preferences->angleUnit() == AngleUnit::Radians);
    addTools(set);
    addGestures(set);
    addSwitches(set);
    if (Viewport* view = host->viewport()) {
        view->setGestureKeys([this] {
            QStringList keys;
            for (const QAction* gesture : m_gestures)
                keys << gesture->shortcut().toString(QKeySequence::NativeText);
            keys.removeAll(QString());
            return keys.join(u' ');
        });
    } else {
        for (QAction* action : m_own + m_spaces->actions() + m_gestures + viewActions())
            action->setEnabled(false);
        m_snap->setEnabled(false);
    }
    connect(m_settings, &GizmoSettings::changed, this, [this] {
        take();
        m_preferences->setToolSettings(m_settings->saved());
    });
    connect(m_hand, &HandSettings::toolChanged, this, &TransformActions::take);
    connect(preferences, &Preferences::changed, this,
            [this] { m_settings->setRadians(m_preferences->angleUnit() == AngleUnit::Radians); });
    take();
}

void TransformActions::addTools(ActionSet* set)
{
    const std::pair<ActionSpec, TransformTool> tools[] = {
        {{"tool.select", QT_TRANSLATE_NOOP("Actions", "&Select tool"), "tool-select", QKeySequence(Qt::Key_Q),
          QT_TRANSLATE_NOOP("Actions", "Select nodes and branches; no handles")},
         TransformTool::Select},
        {{"tool.move", QT_TRANSLATE_NOOP("Actions", "M&ove tool"), "tool-move", QKeySequence(Qt::Key_W),
          QT_TRANSLATE_NOOP("Actions",
                            "Handles that move the selected nodes. Ctrl: in steps, Shift: finely")},
         TransformTool::Move},
        {{"tool.rotate", QT_TRANSLATE_NOOP("Actions", "Ro&tate tool"), "tool-rotate", QKeySequence(Qt::Key_E),
          QT_TRANSLATE_NOOP("Actions", "Rings that turn the selected nodes. Ctrl: in steps, Shift: finely")},
         TransformTool::Rotate},
        {{"tool.scale", QT_TRANSLATE_NOOP("Actions", "Sc&ale tool"), "tool-scale", QKeySequence(Qt::Key_T),
          QT_TRANSLATE_NOOP("Actions", "Boxes that scale the selected nodes. Ctrl: in steps, Shift: finely")},
         TransformTool::Scale},
    };
    for (const auto& [spec, tool] : tools) {
        QAction* action = set->add(spec);
        action->setCheckable(true);
        action->setData(int(tool));
        m_tools->addAction(action);
        m_own += action;
        connect(action, &QAction::triggered, m_settings, [this, value = tool] {
            m_hand->setTool(HandTool::None);
            m_settings->setTool(value);
        });
    }
    const std::pair<ActionSpec, TransformSpace> spaces[] = {
        {{"tool.local", QT_TRANSLATE_NOOP("Actions", "&Local axes"), nullptr, {}}, TransformSpace::Local},
        {{"tool.parent", QT_TRANSLATE_NOOP("Actions", "Axes of the &parent"), nullptr, {}},
         TransformSpace::Parent},
        {{"tool.world", QT_TRANSLATE_NOOP("Actions", "Axes of the &world"), nullptr, {}},
         TransformSpace::World},
    };
    for (const auto& [spec, space] : spaces) {
        QAction* action = set->add(spec);
        action->setCheckable(true);
        action->setData(int(space));
        m_spaces->addAction(action);
        connect(action, &QAction::triggered, m_settings,
                [this, value = space] { m_settings->setSpace(value); });
    }
}

void TransformActions::addGestures(ActionSet* set)
{
    const std::pair<ActionSpec, TransformTool> gestures[] = {
        {{"transform.move", QT_TRANSLATE_NOOP("Actions", "&Move"), nullptr, QKeySequence(Qt::Key_G),
          QT_TRANSLATE_NOOP("Actions", "Move with the mouse, or type: X 1.5 Enter")},
         TransformTool::Move},
        {{"transform.rotate", QT_TRANSLATE_NOOP("Actions", "&Rotate"), nullptr, QKeySequence(Qt::Key_R),
          QT_TRANSLATE_NOOP("Actions", "Rotate with the mouse, or type: Y 90 Enter")},
         TransformTool::Rotate},
        {{"transform.scale", QT_TRANSLATE_NOOP("Actions", "S&cale"), nullptr, QKeySequence(Qt::Key_S),
          QT_TRANSLATE_NOOP("Actions", "Scale with the mouse, or type: 2 Enter")},
         TransformTool::Scale},
    };
    for (const auto& [spec, tool] : gestures) {
        QAction* action = set->add(spec);
        m_gestures += action;
        // After the menu has closed and given the focus back: the gesture needs it.
        if (Viewport* view = m_host->viewport())
            connect(
                action, &QAction::triggered, view, [view, value = tool] { view->beginTransform(value); },
                Qt::QueuedConnection);
    }
}

void TransformActions::addSwitches(ActionSet* set)
{
    m_snap =
        set->add({"tool.snap",
                  QT_TRANSLATE_NOOP("Actions", "S&nap to steps"),
                  "snap",
                  {},
                  QT_TRANSLATE_NOOP("Actions",
                                    "Dragged values go in steps; Ctrl while dragging: the other way round")});
    m_path = set->add(
        {"view.path", QT_TRANSLATE_NOOP("Actions", "Motion &path"), "path",
         QKeySequence(Qt::SHIFT | Qt::Key_P),
         QT_TRANSLATE_NOOP("Actions", "The way of the selected nodes over all frames, with its keys")});
    m_ghosts =
        set->add({"view.ghosts", QT_TRANSLATE_NOOP("Actions", "G&hosts"), "ghosts",
                  QKeySequence(Qt::SHIFT | Qt::Key_O),
                  QT_TRANSLATE_NOOP("Actions", "Translucent copies of the selected nodes at frames before "
                                               "and after this one")});
    m_edit = set->add({"tool.settings",
                       QT_TRANSLATE_NOOP("Actions", "Steps and &ghosts…"),
                       "tool-settings",
                       {},
                       QT_TRANSLATE_NOOP("Actions", "What values snap to, how many ghosts there are")});
    for (QAction* action : {m_snap, m_path, m_ghosts})
        action->setCheckable(true);
    connect(m_snap, &QAction::toggled, m_settings, &GizmoSettings::setSnaps);
    connect(m_path, &QAction::toggled, m_settings, &GizmoSettings::setShowsPath);
    connect(m_ghosts, &QAction::toggled, m_settings, &GizmoSettings::setShowsGhosts);
    connect(m_edit, &QAction::triggered, this, &TransformActions::showSettings);
}

QList<QAction*> TransformActions::toolActions() const
{
    return m_own;
}

QList<QAction*> TransformActions::viewActions() const
{
    return {m_path, m_ghosts};
}

void TransformActions::take()
{
    const bool any = m_hand->tool() == HandTool::None;
    for (QAction* action : m_own)
        action->setChecked(any && action->data().toInt() == int(m_settings->tool()));
    for (QAction* action : m_spaces->actions())
        action->setChecked(action->data().toInt() == int(m_settings->space()));
    m_snap->setChecked(m_settings->snaps());
    m_path->setChecked(m_settings->showsPath());
    m_ghosts->setChecked(m_settings->showsGhosts());
    if (m_spaceBox)
        m_spaceBox->setCurrentIndex(int(m_settings->space()));
}

void TransformActions::fillMenu(QMenu* editMenu)
{
    QMenu* menu = editMenu->addMenu(tr("Trans&form"));
    menu->addActions(m_gestures);
    menu->addSeparator();
    menu->addActions(m_own);
    menu->addSeparator();
    menu->addActions(m_spaces->actions());
    menu->addSeparator();
    menu->addActions({m_snap, m_edit});
}

void TransformActions::fillToolBar(QToolBar* bar)
{
    m_spaceBox = new QComboBox(bar);
    m_spaceBox->setObjectName(QStringLiteral("transformSpace"));
    m_spaceBox->addItems({tr("Local"), tr("Parent"), tr("World")});
    m_spaceBox->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_spaceBox->setFocusPolicy(Qt::TabFocus); // a click leaves the keys with the view
    m_spaceBox->setEnabled(m_host->viewport() != nullptr);
    connect(m_spaceBox, &QComboBox::activated, m_settings,
            [this](int index) { m_settings->setSpace(static_cast<TransformSpace>(index)); });
    bar->addWidget(m_spaceBox);
    bar->addActions({m_snap, m_edit});
    m_spaceBox->setToolTip(tr("Axes along which nodes are moved, turned and scaled"));
    m_spaceBox->setAccessibleName(tr("Axes of the tools"));
    take();
}

void TransformActions::nameTarget(const QString& words)
{
    const QString texts[] = {tr("&Move %1"), tr("&Rotate %1"), tr("S&cale %1")}; // in the order of the table
    for (qsizetype i = 0; i < m_gestures.size(); ++i)
        m_set->setText(m_gestures[i], words.isEmpty() ? QString() : texts[i].arg(words));
}

void TransformActions::showSettings()
{
    auto* dialog = m_window->findChild<ToolSettingsDialog*>();
    if (!dialog) {
        dialog = new ToolSettingsDialog(m_settings, m_window);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
    }
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

} // namespace ramure
