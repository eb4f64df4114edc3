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
{
    m_settings->restore(preferences->toolSettings());
    m_settings->radians.set(preferences->angleUnit() == AngleUnit::Radians);
    const auto exists = [this] { return m_host->viewport() != nullptr; };
    addTools(exists);
    addGestures(exists);
    addSwitches(exists);
    if (Viewport* view = host->viewport()) {
        view->setGestureKeys([this] {
            QStringList keys;
            for (const QAction* gesture : m_gestures)
                keys << gesture->shortcut().toString(QKeySequence::NativeText);
            keys.removeAll(QString());
            return keys.join(u' ');
        });
    }
    connect(m_settings, &GizmoSettings::changed, this, [this] {
        take();
        m_preferences->toolSettings.set(m_settings->saved());
    });
    connect(m_hand, &HandSettings::toolChanged, this, &TransformActions::take);
    connect(preferences, &Preferences::changed, this,
            [this] { m_settings->radians.set(m_preferences->angleUnit() == AngleUnit::Radians); });
    take();
}

void TransformActions::addTools(const std::function<bool()>& exists)
{
    const auto choose = [this](TransformTool tool) {
        return [this, tool] {
            m_hand->setTool(HandTool::None);
            m_settings->tool.set(tool);
        };
    };
    const auto isChosen = [this](TransformTool tool) {
        return [this, tool] { return m_hand->tool() == HandTool::None && m_settings->tool() == tool; };
    };
    using enum TransformTool;
    m_own = m_set->add(
        this,
        {{"tool.select", Actions::tr("&Select tool"), "tool-select", Qt::Key_Q,
          Actions::tr("Select nodes and branches; no handles"), choose(Select), exists, isChosen(Select)},
         {"tool.move", Actions::tr("M&ove tool"), "tool-move", Qt::Key_W,
          Actions::tr("Handles that move the selected nodes. Ctrl: in steps, Shift: finely"), choose(Move),
          exists, isChosen(Move)},
         {"tool.rotate", Actions::tr("Ro&tate tool"), "tool-rotate", Qt::Key_E,
          Actions::tr("Rings that turn the selected nodes. Ctrl: in steps, Shift: finely"), choose(Rotate),
          exists, isChosen(Rotate)},
         {"tool.scale", Actions::tr("Sc&ale tool"), "tool-scale", Qt::Key_T,
          Actions::tr("Boxes that scale the selected nodes. Ctrl: in steps, Shift: finely"), choose(Scale),
          exists, isChosen(Scale)},
         {"tool.measure", Actions::tr("Tape m&easure"), "tool-measure", Qt::SHIFT | Qt::Key_Q,
          Actions::tr("Click or drag from one place to another: how far they are from each "
                      "other, in metres. Over a branch: its diameter"),
          choose(Measure), exists, isChosen(Measure)}});
    for (QAction* action : m_own)
        m_tools->addAction(action);
    auto* spaces = new QActionGroup(this);
    const auto addSpace = [&](const char* id, const QString& text, TransformSpace space) {
        spaces->addAction(m_set->add(this, {id,
                                            text,
                                            nullptr,
                                            {},
                                            {},
                                            [this, space] { m_settings->space.set(space); },
                                            exists,
                                            [this, space] { return m_settings->space() == space; }}));
    };
    addSpace("tool.local", Actions::tr("&Local axes"), TransformSpace::Local);
    addSpace("tool.parent", Actions::tr("Axes of the &parent"), TransformSpace::Parent);
    addSpace("tool.world", Actions::tr("Axes of the &world"), TransformSpace::World);
}

void TransformActions::addGestures(const std::function<bool()>& exists)
{
    // After the menu has closed and given the focus back: the gesture needs it.
    const auto begin = [view = m_host->viewport()](TransformTool tool) {
        return [view, tool] {
            QMetaObject::invokeMethod(
                view, [view, tool] { view->beginTransform(tool); }, Qt::QueuedConnection);
        };
    };
    m_gestures = m_set->add(
        this,
        {{"transform.move", Actions::tr("&Move"), nullptr, Qt::Key_G,
          Actions::tr("Move with the mouse, or type: X 1.5 Enter"), begin(TransformTool::Move), exists},
         {"transform.rotate", Actions::tr("&Rotate"), nullptr, Qt::Key_R,
          Actions::tr("Rotate with the mouse, or type: Y 90 Enter"), begin(TransformTool::Rotate), exists},
         {"transform.scale", Actions::tr("S&cale"), nullptr, Qt::Key_S,
          Actions::tr("Scale with the mouse, or type: 2 Enter"), begin(TransformTool::Scale), exists}});
}

void TransformActions::addSwitches(const std::function<bool()>& exists)
{
    GizmoSettings* s = m_settings;
    m_set->add(this,
               {{"tool.snap", Actions::tr("S&nap to steps"), "snap", noKeys,
                 Actions::tr("Dragged values go in steps; Ctrl while dragging: the other way round"),
                 [s] { s->snaps.set(!s->snaps()); }, exists, [s] { return s->snaps(); }},
                {"view.path", Actions::tr("Motion &path"), "path", Qt::SHIFT | Qt::Key_P,
                 Actions::tr("The way of the selected nodes over all frames, with its keys"),
                 [s] { s->showsPath.set(!s->showsPath()); }, exists, [s] { return s->showsPath(); }},
                {"view.ghosts", Actions::tr("G&hosts"), "ghosts", Qt::SHIFT | Qt::Key_O,
                 Actions::tr("Translucent copies of the selected nodes at frames before and after this one"),
                 [s] { s->showsGhosts.set(!s->showsGhosts()); }, exists, [s] { return s->showsGhosts(); }},
                {"tool.settings", Actions::tr("Steps and &ghosts…"), "tool-settings", noKeys,
                 Actions::tr("Snapping steps and number of ghosts"), [this] { showSettings(); }}});
}

void TransformActions::take()
{
    m_set->update(this);
    if (m_spaceBox)
        m_spaceBox->setCurrentIndex(int(m_settings->space()));
}

void TransformActions::fillMenu(QMenu* editMenu)
{
    QMenu* menu = editMenu->addMenu(tr("Trans&form"));
    menu->addActions(m_gestures);
    menu->addSeparator();
    menu->addActions(m_own);
    m_set->fill(menu,
                {nullptr, "tool.local", "tool.parent", "tool.world", nullptr, "tool.snap", "tool.settings"});
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
            [this](int index) { m_settings->space.set(static_cast<TransformSpace>(index)); });
    bar->addWidget(m_spaceBox);
    m_set->fill(bar, {"tool.snap", "tool.settings"});
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
