#include "widgets/actions/view_actions.h"

#include "widgets/actions/bookmark_actions.h"
#include "widgets/actions/camera_actions.h"
#include "widgets/base/action_set.h"
#include "widgets/base/theme/language.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/view/light_dialog.h"
#include "widgets/view/viewport.h"
#include "widgets/view/viewport_host.h"
#include <QActionGroup>
#include <QMenu>
#include <algorithm>
#include <cmath>

namespace ramure {

ViewActions::ViewActions(Document* document, ViewportHost* host, Preferences* preferences, ActionSet* set,
                         QObject* parent)
    : QObject(parent)
    , m_host(host)
    , m_preferences(preferences)
    , m_bookmarks(new BookmarkActions(document, host, set, this))
    , m_cameras(new CameraActions(document, host, set, this))
{
    connect(m_bookmarks, &BookmarkActions::messageRaised, this, &ViewActions::messageRaised);
    connect(m_cameras, &CameraActions::messageRaised, this, &ViewActions::messageRaised);
    addFraming(set);
    addAxes(set);
    addMoves(set);
    addModes(set);
    addSwitches(set);
    addLight(set);
    addPreferences(set);
    // Without OpenGL there is nothing to frame and no mode to see.
    if (!host->viewport()) {
        QList<QAction*> dead = m_axes + m_moves + m_modes->actions() + m_shading->actions() + m_switches;
        dead += m_qualities->actions() + m_gameWinds->actions() + m_gameWindStrengths->actions();
        dead += {m_frameAll, m_frameSelection, m_light};
        for (QAction* action : dead)
            action->setEnabled(false);
    }
    connect(preferences, &Preferences::changed, this, &ViewActions::takePreferences);
    takePreferences();
}

void ViewActions::addFraming(ActionSet* set)
{
    m_frameAll = set->add({"view.frameAll", QT_TRANSLATE_NOOP("Actions", "Frame &all"), "frame-all",
                           QKeySequence(Qt::Key_Home),
                           QT_TRANSLATE_NOOP("Actions", "Frame all that is shown, wherever keys move it to "
                                                        "on the timeline")});
    m_frameSelection = set->add({"view.frameSelection", QT_TRANSLATE_NOOP("Actions", "&Frame the selection"),
                                 "frame-selection", QKeySequence(Qt::Key_F),
                                 QT_TRANSLATE_NOOP("Actions", "Frame the selected branches or nodes as they "
                                                              "stand now, or everything where none is "
                                                              "selected")});
    if (Viewport* view = m_host->viewport()) {
        connect(m_frameAll, &QAction::triggered, view, &Viewport::frameAll);
        connect(m_frameSelection, &QAction::triggered, view, &Viewport::frameSelection);
    }
}

void ViewActions::addAxes(ActionSet* set)
{
    Viewport* view = m_host->viewport();
    struct Side
    {
        ActionSpec spec;
        AxisView view;
    };
    const Side axes[] = {
        {{"view.front", QT_TRANSLATE_NOOP("Actions", "&Front"), nullptr, QKeySequence(Qt::Key_1)},
         AxisView::Front},
        {{"view.back", QT_TRANSLATE_NOOP("Actions", "&Back"), nullptr, {}}, AxisView::Back},
        {{"view.right", QT_TRANSLATE_NOOP("Actions", "&Right"), nullptr, QKeySequence(Qt::Key_3)},
         AxisView::Right},
        {{"view.left", QT_TRANSLATE_NOOP("Actions", "&Left"), nullptr, {}}, AxisView::Left},
        {{"view.top", QT_TRANSLATE_NOOP("Actions", "&Top"), nullptr, QKeySequence(Qt::Key_7)}, AxisView::Top},
        {{"view.bottom", QT_TRANSLATE_NOOP("Actions", "B&ottom"), nullptr, {}}, AxisView::Bottom},
    };
    for (const Side& axis : axes) {
        QAction* action = set->add(axis.spec);
        m_axes += action;
        if (view)
            connect(action, &QAction::triggered, view, [view, side = axis.view] { view->setAxisView(side); });
    }
    QAction* opposite = set->add(
        {"view.opposite", QT_TRANSLATE_NOOP("Actions", "O&pposite side"), nullptr, QKeySequence(Qt::Key_9),
         QT_TRANSLATE_NOOP("Actions", "Look from the other side: from the front "
                                      "becomes from the back, from above from below")});
    m_axes += opposite;
    if (view)
        connect(opposite, &QAction::triggered, view, &Viewport::turnOpposite);
}

/// The keys of Blender's number pad, which are also those above the letters.
void ViewActions::addMoves(ActionSet* set)
{
    struct Move
    {
        ActionSpec spec;
        double yaw, pitch, zoom; ///< steps of Viewport
    };
    const Move moves[] = {
        {{"view.orbitLeft", QT_TRANSLATE_NOOP("Actions", "Orbit &left"), nullptr, QKeySequence(Qt::Key_4)},
         -1.0,
         0.0,
         0.0},
        {{"view.orbitRight", QT_TRANSLATE_NOOP("Actions", "Orbit &right"), nullptr, QKeySequence(Qt::Key_6)},
         1.0,
         0.0,
         0.0},
        {{"view.orbitUp", QT_TRANSLATE_NOOP("Actions", "Orbit &up"), nullptr, QKeySequence(Qt::Key_8)},
         0.0,
         1.0,
         0.0},
        {{"view.orbitDown", QT_TRANSLATE_NOOP("Actions", "Orbit &down"), nullptr, QKeySequence(Qt::Key_2)},
         0.0,
         -1.0,
         0.0},
        {{"view.zoomIn", QT_TRANSLATE_NOOP("Actions", "Zoom &in"), nullptr, QKeySequence(Qt::Key_Plus)},
         0.0,
         0.0,
         1.0},
        {{"view.zoomOut", QT_TRANSLATE_NOOP("Actions", "Zoom &out"), nullptr, QKeySequence(Qt::Key_Minus)},
         0.0,
         0.0,
         -1.0},
    };
    for (const Move& move : moves) {
        QAction* action = set->add(move.spec);
        m_moves += action;
        if (Viewport* view = m_host->viewport())
            connect(action, &QAction::triggered, view,
                    [view, yaw = move.yaw, pitch = move.pitch, zoom = move.zoom] {
                        if (zoom != 0.0)
                            view->zoomBy(std::pow(Viewport::zoomStep, -zoom));
                        else
                            view->orbitBy(yaw * Viewport::orbitStepRad, pitch * Viewport::orbitStepRad);
                    });
    }
}

static constexpr ModeRow<WindProfile> gameWinds[] = {
    {WindProfile::None, "view.gameWind.off", nullptr, QT_TRANSLATE_NOOP("Actions", "&Off"), nullptr},
    {WindProfile::Plain, "view.gameWind.plain", nullptr, QT_TRANSLATE_NOOP("Actions", "&Any shader (_WIND)"),
     QT_TRANSLATE_NOOP("Actions",
                       "Trees at rest move as a shader moves them that reads the attribute _WIND")},
    {WindProfile::Crysis, "view.gameWind.crysis", nullptr, QT_TRANSLATE_NOOP("Actions", "&CryEngine"),
     QT_TRANSLATE_NOOP("Actions", "Trees at rest move as CryEngine moves them by the colours of vertices")},
    {WindProfile::Unity, "view.gameWind.unity", nullptr, QT_TRANSLATE_NOOP("Actions", "&Unity"),
     QT_TRANSLATE_NOOP("Actions", "Trees at rest move as the shader of Unity's Tree Creator moves them")},
    {WindProfile::PivotPainter, "view.gameWind.pivotPainter", nullptr,
     QT_TRANSLATE_NOOP("Actions", "U&nreal (Pivot Painter 2)"),
     QT_TRANSLATE_NOOP("Actions",
                       "Trees at rest move as the foliage shader of the Unreal Engine moves them")}};
static constexpr ModeRow<double> gameWindStrengths[] = {
    {0.3, "view.gameWind.breeze", nullptr, QT_TRANSLATE_NOOP("Actions", "&Breeze (0.3)"),
     QT_TRANSLATE_NOOP("Actions", "Three tenths of a strong wind")},
    {0.6, "view.gameWind.wind", nullptr, QT_TRANSLATE_NOOP("Actions", "&Wind (0.6)"),
     QT_TRANSLATE_NOOP("Actions", "Six tenths of a strong wind")},
    {1.0, "view.gameWind.strong", nullptr, QT_TRANSLATE_NOOP("Actions", "&Strong wind (1)"),
     QT_TRANSLATE_NOOP("Actions", "The top of a tree leans by a tenth of its height")}};

/// One action for each row of a table of modes; the one of the present mode is checked.
template <class Row, class Mode>
static QActionGroup* addChoices(ActionSet* set, ViewSettings* settings, std::span<const Row> rows,
                                bool hasKeys, Mode (ViewSettings::*get)() const,
                                void (ViewSettings::*choose)(Mode), void (ViewSettings::*changed)(Mode))
{
    auto* group = new QActionGroup(settings);
    int key = Qt::Key_0;
    for (const Row& row : rows) {
        const bool hasKey = hasKeys && ++key <= Qt::Key_9;
        QAction* action = set->add({row.action, row.text, row.icon,
                                    hasKey ? QKeySequence(Qt::ALT | Qt::Key(key)) : QKeySequence(), row.tip});
        action->setCheckable(true);
        action->setChecked((settings->*get)() == row.mode);
        group->addAction(action);
        QObject::connect(action, &QAction::triggered, settings,
                         [settings, choose, mode = row.mode] { (settings->*choose)(mode); });
        QObject::connect(settings, changed, action,
                         [action, mode = row.mode](Mode now) { action->setChecked(now == mode); });
    }
    return group;
}

void ViewActions::addModes(ActionSet* set)
{
    m_modes = addChoices(set, m_host->settings(), displayModes(), true, &ViewSettings::displayMode,
                         &ViewSettings::setDisplayMode, &ViewSettings::displayModeChanged);
    m_shading = addChoices(set, m_host->settings(), shadingModes(), false, &ViewSettings::shadingMode,
                           &ViewSettings::setShadingMode, &ViewSettings::shadingModeChanged);
    m_qualities = addChoices(set, m_host->settings(), qualities(), false, &ViewSettings::quality,
                             &ViewSettings::setQuality, &ViewSettings::qualityChanged);
    m_gameWinds =
        addChoices(set, m_host->settings(), std::span<const ModeRow<WindProfile>>(gameWinds), false,
                   &ViewSettings::gameWind, &ViewSettings::setGameWind, &ViewSettings::gameWindChanged);
    m_gameWindStrengths =
        addChoices(set, m_host->settings(), std::span<const ModeRow<double>>(gameWindStrengths), false,
                   &ViewSettings::gameWindStrength, &ViewSettings::setGameWindStrength,
                   &ViewSettings::gameWindStrengthChanged);
}

void ViewActions::addSwitches(ActionSet* set)
{
    ViewSettings* settings = m_host->settings();
    const auto add = [&](const ActionSpec& spec, bool on, auto setter, auto signal) {
        QAction* action = set->add(spec);
        action->setCheckable(true);
        action->setChecked(on);
        connect(action, &QAction::toggled, settings, setter);
        connect(settings, signal, action, &QAction::setChecked);
        m_switches += action;
    };
    add({"view.leaves", QT_TRANSLATE_NOOP("Actions", "&Leaves"), "leaf", {}}, settings->leavesVisible(),
        &ViewSettings::setLeavesVisible, &ViewSettings::leavesVisibleChanged);
    add({"view.apples", QT_TRANSLATE_NOOP("Actions", "F&ruit"), "apple", {}}, settings->applesVisible(),
        &ViewSettings::setApplesVisible, &ViewSettings::applesVisibleChanged);
    add({"view.grid", QT_TRANSLATE_NOOP("Actions", "&Grid"), "grid", QKeySequence(Qt::SHIFT | Qt::Key_G)},
        settings->gridVisible(), &ViewSettings::setGridVisible, &ViewSettings::gridVisibleChanged);
    add({"view.ground",
         QT_TRANSLATE_NOOP("Actions", "G&round"),
         nullptr,
         {},
         QT_TRANSLATE_NOOP("Actions", "Without the ground, what lies below it can be seen")},
        settings->groundVisible(), &ViewSettings::setGroundVisible, &ViewSettings::groundVisibleChanged);
    add({"view.outline", QT_TRANSLATE_NOOP("Actions", "O&utline of the selection"), nullptr,
         QKeySequence(Qt::SHIFT | Qt::Key_E),
         QT_TRANSLATE_NOOP("Actions",
                           "An orange line around what is selected, seen through leaves and branches "
                           "for a second after it was selected")},
        settings->outlineVisible(), &ViewSettings::setOutlineVisible, &ViewSettings::outlineVisibleChanged);
    if (Viewport* view = m_host->viewport())
        view->setOutlineKey(
            [outline = m_switches.last()] { return outline->shortcut().toString(QKeySequence::NativeText); });
    add({"view.crowns",
         QT_TRANSLATE_NOOP("Actions", "&Crown to fill"),
         nullptr,
         {},
         QT_TRANSLATE_NOOP("Actions",
                           "The envelope and the points that a selected tree grows to fill, where it "
                           "grows by space colonisation")},
        settings->crownsVisible(), &ViewSettings::setCrownsVisible, &ViewSettings::crownsVisibleChanged);
    add({"view.orthographic", QT_TRANSLATE_NOOP("Actions", "&Orthographic"), "orthographic",
         QKeySequence(Qt::Key_5)},
        settings->orthographic(), &ViewSettings::setOrthographic, &ViewSettings::orthographicChanged);
}

void ViewActions::addLight(ActionSet* set)
{
    m_light =
        set->add({"view.light",
                  QT_TRANSLATE_NOOP("Actions", "L&ight and backdrop…"),
                  nullptr,
                  {},
                  QT_TRANSLATE_NOOP("Actions", "Where the sun stands, and what lies behind the trees")});
    ViewSettings* settings = m_host->settings();
    // Light is the document's, quality the machine's: that alone is remembered.
    const QString key = QStringLiteral("quality");
    const int usual = static_cast<int>(settings->quality());
    const int quality = m_preferences->viewLight().value(key, usual).toInt();
    settings->setQuality(static_cast<Quality>(std::clamp(quality, 0, static_cast<int>(Quality::Best))));
    connect(settings, &ViewSettings::qualityChanged, this, [this, key](Quality chosen) {
        m_preferences->setViewLight({{key, static_cast<int>(chosen)}});
    });
    connect(m_light, &QAction::triggered, this, [this, settings] {
        QWidget* window = m_host->window();
        auto* dialog = window->findChild<LightDialog*>();
        if (!dialog) {
            dialog = new LightDialog(settings, window);
            dialog->setAttribute(Qt::WA_DeleteOnClose);
        }
        dialog->show();
        dialog->raise();
        dialog->activateWindow();
    });
}

void ViewActions::addPreferences(ActionSet* set)
{
    m_themes = new QActionGroup(this);
    m_units = new QActionGroup(this);
    m_languages = new QActionGroup(this);
    const auto add = [&](QActionGroup* group, const ActionSpec& spec, const QVariant& value) {
        QAction* action = set->add(spec);
        action->setCheckable(true);
        action->setData(value);
        group->addAction(action);
    };
    add(m_themes, {"view.theme.system", QT_TRANSLATE_NOOP("Actions", "As the &system"), nullptr, {}},
        static_cast<int>(ThemeChoice::System));
    add(m_themes, {"view.theme.light", QT_TRANSLATE_NOOP("Actions", "&Light"), nullptr, {}},
        static_cast<int>(ThemeChoice::Light));
    add(m_themes, {"view.theme.dark", QT_TRANSLATE_NOOP("Actions", "&Dark"), nullptr, {}},
        static_cast<int>(ThemeChoice::Dark));
    add(m_units, {"view.degrees", QT_TRANSLATE_NOOP("Actions", "&Degrees"), nullptr, {}},
        static_cast<int>(AngleUnit::Degrees));
    add(m_units, {"view.radians", QT_TRANSLATE_NOOP("Actions", "&Radians"), nullptr, {}},
        static_cast<int>(AngleUnit::Radians));
    add(m_languages, {"view.language.system", QT_TRANSLATE_NOOP("Actions", "As the &system"), nullptr, {}},
        QString());
    connect(m_themes, &QActionGroup::triggered, this, [this](QAction* action) {
        m_preferences->setTheme(static_cast<ThemeChoice>(action->data().toInt()));
    });
    connect(m_units, &QActionGroup::triggered, this, [this](QAction* action) {
        m_preferences->setAngleUnit(static_cast<AngleUnit>(action->data().toInt()));
    });
    // Languages are called by their own names in every language.
    for (const auto& [code, name] : Language::available()) {
        auto* action = new QAction(name, this);
        action->setObjectName(QStringLiteral("view.language.") + code);
        action->setCheckable(true);
        action->setData(code);
        m_languages->addAction(action);
    }
    connect(m_languages, &QActionGroup::triggered, this, [this](QAction* action) {
        m_preferences->setLanguage(action->data().toString());
        emit messageRaised(tr("The language changes when Ramure is started again."));
    });
}

void ViewActions::takePreferences()
{
    const auto check = [](QActionGroup* group, const QVariant& value) {
        for (QAction* action : group->actions())
            action->setChecked(action->data() == value);
    };
    check(m_themes, static_cast<int>(m_preferences->theme()));
    check(m_units, static_cast<int>(m_preferences->angleUnit()));
    check(m_languages, m_preferences->language());
}

QList<QAction*> ViewActions::modeActions() const
{
    return m_modes->actions();
}

void ViewActions::fillMenu(QMenu* menu, const QList<QAction*>& panels, QAction* resetLayout)
{
    menu->addActions({m_frameAll, m_frameSelection});
    menu->addMenu(tr("&View from"))->addActions(m_axes);
    menu->addMenu(tr("M&ove the view"))->addActions(m_moves);
    m_bookmarks->fillMenu(menu);
    m_cameras->fillMenu(menu);
    menu->addSeparator();
    menu->addActions(m_modes->actions());
    menu->addSeparator();
    menu->addActions(m_shading->actions());
    menu->addSeparator();
    menu->addActions(m_qualities->actions());
    menu->addSeparator();
    menu->addActions(m_switches);
    menu->addActions(m_trail);
    QMenu* gameWind = menu->addMenu(tr("Wind of a ga&me"));
    gameWind->addActions(m_gameWinds->actions());
    gameWind->addSeparator();
    gameWind->addActions(m_gameWindStrengths->actions());
    menu->addAction(m_light);
    menu->addSeparator();
    QMenu* panelMenu = menu->addMenu(tr("Pa&nels"));
    panelMenu->addActions(panels);
    panelMenu->addSeparator();
    panelMenu->addAction(resetLayout);
    menu->addMenu(tr("&Theme"))->addActions(m_themes->actions());
    menu->addMenu(tr("&Angles in"))->addActions(m_units->actions());
    menu->addMenu(tr("&Language"))->addActions(m_languages->actions());
}

} // namespace ramure
