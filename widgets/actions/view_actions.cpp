#include "widgets/actions/view_actions.h"

#include "widgets/actions/bookmark_actions.h"
#include "widgets/actions/camera_actions.h"
#include "widgets/actions/sky_picture_actions.h"
#include "widgets/base/action_set.h"
#include "widgets/base/theme/language.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/view/light_dialog.h"
#include "widgets/view/outline_key.h"
#include "widgets/view/viewport.h"
#include "widgets/view/viewport_host.h"
#include <QActionGroup>
#include <QMenu>
#include <algorithm>
#include <cmath>

namespace ramure {

ViewActions::ViewActions(Document* document, ViewportHost* host, Preferences* preferences, Chooser* chooser,
                         ActionSet* set, QObject* parent)
    : QObject(parent)
    , m_host(host)
    , m_preferences(preferences)
    , m_set(set)
    , m_bookmarks(new BookmarkActions(document, host, set, this))
    , m_cameras(new CameraActions(document, host, set, this))
    , m_skyPictures(new SkyPictureActions(host, preferences, chooser, set, this))
{
    connect(m_bookmarks, &BookmarkActions::messageRaised, this, &ViewActions::messageRaised);
    connect(m_cameras, &CameraActions::messageRaised, this, &ViewActions::messageRaised);
    connect(m_skyPictures, &SkyPictureActions::messageRaised, this, &ViewActions::messageRaised);
    addFraming();
    addAxes();
    addMoves();
    addModes();
    addSwitches();
    addLight();
    addPreferences();
    set->update(this);
    // Without OpenGL there is no mode to see.
    if (!host->viewport()) {
        const QList<QAction*> dead = m_modes->actions() + m_shading->actions() + m_switches +
                                     m_qualities->actions() + m_gameWinds->actions() +
                                     m_gameWindStrengths->actions();
        for (QAction* action : dead)
            action->setEnabled(false);
    }
    connect(preferences, &Preferences::changed, this, [this] { m_set->update(this); });
}

/// Without OpenGL there is nothing to frame.
bool ViewActions::hasView() const
{
    return m_host->viewport() != nullptr;
}

void ViewActions::addFraming()
{
    Viewport* view = m_host->viewport();
    const auto exists = [this] { return hasView(); };
    m_set->add(this,
               {{"view.frameAll", Actions::tr("Frame &all"), "frame-all", Qt::Key_Home,
                 Actions::tr("Frame all that is shown, wherever keys move it to on the timeline"),
                 [view] { view->frameAll(); }, exists},
                {"view.frameSelection", Actions::tr("&Frame the selection"), "frame-selection", Qt::Key_F,
                 Actions::tr("Frame the selected branches or nodes as they stand now, or everything where "
                             "none is selected"),
                 [view] { view->frameSelection(); }, exists}});
}

void ViewActions::addAxes()
{
    Viewport* view = m_host->viewport();
    const auto exists = [this] { return hasView(); };
    const auto from = [view](AxisView side) {
        return [view, side] { view->steer([side](Camera& to) { to.setAxisView(side); }); };
    };
    using enum AxisView;
    m_axes = m_set->add(
        this, {{"view.front", Actions::tr("&Front"), nullptr, Qt::Key_1, QString(), from(Front), exists},
               {"view.back", Actions::tr("&Back"), nullptr, noKeys, QString(), from(Back), exists},
               {"view.right", Actions::tr("&Right"), nullptr, Qt::Key_3, QString(), from(Right), exists},
               {"view.left", Actions::tr("&Left"), nullptr, noKeys, QString(), from(Left), exists},
               {"view.top", Actions::tr("&Top"), nullptr, Qt::Key_7, QString(), from(Top), exists},
               {"view.bottom", Actions::tr("B&ottom"), nullptr, noKeys, QString(), from(Bottom), exists},
               {"view.opposite", Actions::tr("O&pposite side"), nullptr, Qt::Key_9,
                Actions::tr(
                    "Look from the other side: from the front becomes from the back, from above from below"),
                [view] { view->steer(std::mem_fn(&Camera::turnOpposite)); }, exists}});
}

/// The keys of Blender's number pad, which are also those above the letters.
void ViewActions::addMoves()
{
    Viewport* view = m_host->viewport();
    const auto exists = [this] { return hasView(); };
    const auto orbit = [view](double yaw, double pitch) {
        constexpr double step = Viewport::orbitStepRad;
        return [=] { view->steer([=](Camera& to) { to.orbit(yaw * step, pitch * step); }); };
    };
    const auto zoom = [view](double steps) {
        const double factor = std::pow(Viewport::zoomStep, -steps);
        return [=] { view->steer([=](Camera& to) { to.zoom(factor, to.target); }); };
    };
    m_moves = m_set->add(
        this,
        {{"view.orbitLeft", Actions::tr("Orbit &left"), nullptr, Qt::Key_4, QString(), orbit(-1.0, 0.0),
          exists},
         {"view.orbitRight", Actions::tr("Orbit &right"), nullptr, Qt::Key_6, QString(), orbit(1.0, 0.0),
          exists},
         {"view.orbitUp", Actions::tr("Orbit &up"), nullptr, Qt::Key_8, QString(), orbit(0.0, 1.0), exists},
         {"view.orbitDown", Actions::tr("Orbit &down"), nullptr, Qt::Key_2, QString(), orbit(0.0, -1.0),
          exists},
         {"view.zoomIn", Actions::tr("Zoom &in"), nullptr, Qt::Key_Plus, QString(), zoom(1.0), exists},
         {"view.zoomOut", Actions::tr("Zoom &out"), nullptr, Qt::Key_Minus, QString(), zoom(-1.0), exists}});
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
template <class Rows, class Mode>
static QActionGroup* addChoices(ActionSet* set, ViewSettings* settings, const Rows& rows,
                                ViewSettings::Option<Mode>& option, bool hasKeys = false)
{
    auto* group = new QActionGroup(settings);
    int key = Qt::Key_0;
    for (const auto& row : rows) {
        const bool hasKey = hasKeys && ++key <= Qt::Key_9;
        group->addAction(set->add(settings, {row.action, Actions::tr(row.text), row.icon,
                                             hasKey ? QKeySequence(Qt::ALT | Qt::Key(key)) : QKeySequence(),
                                             row.tip ? Actions::tr(row.tip) : QString(),
                                             [&option, mode = row.mode] { option.set(mode); }, nullptr,
                                             [&option, mode = row.mode] { return option() == mode; }}));
    }
    return group;
}

void ViewActions::addModes()
{
    ViewSettings* s = m_host->settings();
    m_modes = addChoices(m_set, s, displayModes(), s->displayMode, true);
    m_shading = addChoices(m_set, s, shadingModes(), s->shadingMode);
    m_qualities = addChoices(m_set, s, qualities(), s->quality);
    m_gameWinds = addChoices(m_set, s, gameWinds, s->gameWind);
    m_gameWindStrengths = addChoices(m_set, s, gameWindStrengths, s->gameWindStrength);
}

void ViewActions::addSwitches()
{
    ViewSettings* s = m_host->settings();
    const auto add = [this, s](const char* id, const QString& text, const char* icon,
                               const QKeySequence& keys, ViewSettings::Option<bool>& option,
                               const QString& tip = {}) {
        m_switches += m_set->add(s, {id, text, icon, keys, tip, [&option] { option.set(!option()); }, nullptr,
                                     [&option] { return option(); }});
    };
    add("view.leaves", Actions::tr("&Leaves"), "leaf", noKeys, s->leavesVisible);
    add("view.apples", Actions::tr("F&ruit"), "apple", noKeys, s->applesVisible);
    add("view.grid", Actions::tr("&Grid"), "grid", Qt::SHIFT | Qt::Key_G, s->gridVisible);
    add("view.ground", Actions::tr("G&round"), nullptr, noKeys, s->groundVisible,
        Actions::tr("Hide the ground to see objects below it"));
    add("view.meadow", Actions::tr("Grass and &fallen leaves"), nullptr, noKeys, s->meadowVisible,
        Actions::tr("Grass and fallen leaves on the ground around trees that stand on roots. They are not "
                    "exported"));
    add("view.figure", Actions::tr("&Person of 1.8 m"), nullptr, noKeys, s->figureVisible,
        Actions::tr("A person beside the first tree, to see how large it is"));
    add("view.outline", Actions::tr("O&utline of the selection"), nullptr, Qt::SHIFT | Qt::Key_E,
        s->outlineVisible,
        Actions::tr("An orange outline around the selection. For a second after a selection it shows through "
                    "leaves and branches"));
    add("view.crowns", Actions::tr("&Crown to fill"), nullptr, noKeys, s->crownsVisible,
        Actions::tr(
            "The envelope and the points that a selected tree fills when it grows by space colonisation"));
    add("view.orthographic", Actions::tr("&Orthographic"), "orthographic", Qt::Key_5, s->orthographic);
    m_set->update(s);
    connect(s, &ViewSettings::changed, this, [this, s] { m_set->update(s); });
    if (Viewport* view = m_host->viewport())
        view->outlineKey()->setKey([outline = m_set->find("view.outline")] {
            return outline->shortcut().toString(QKeySequence::NativeText);
        });
}

void ViewActions::addLight()
{
    m_set->add(this, {"view.light", Actions::tr("L&ight and backdrop…"), nullptr, noKeys,
                      Actions::tr("Position of the sun and background of the scene"), [this] { showLight(); },
                      [this] { return hasView(); }});
    ViewSettings* settings = m_host->settings();
    // Light is the document's, quality the machine's: that alone is remembered.
    const QString key = QStringLiteral("quality");
    const int usual = static_cast<int>(settings->quality());
    const int quality = m_preferences->viewLight().value(key, usual).toInt();
    settings->quality.set(static_cast<Quality>(std::clamp(quality, 0, static_cast<int>(Quality::Best))));
    settings->quality.follow(this, [this, key, settings] {
        m_preferences->viewLight.set({{key, static_cast<int>(settings->quality())}});
    });
}

void ViewActions::showLight()
{
    QWidget* window = m_host->window();
    auto* dialog = window->findChild<LightDialog*>();
    if (!dialog) {
        dialog = new LightDialog(m_host->settings(), window);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        connect(dialog, &LightDialog::pictureWanted, m_skyPictures, &SkyPictureActions::choose);
    }
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

void ViewActions::addPreferences()
{
    Preferences* p = m_preferences;
    const auto theme = [this, p](const char* id, const QString& text, ThemeChoice choice) {
        return m_set->add(this, {id,
                                 text,
                                 nullptr,
                                 {},
                                 {},
                                 [=] { p->theme.set(choice); },
                                 {},
                                 [=] { return p->theme() == choice; }});
    };
    const auto unit = [this, p](const char* id, const QString& text, AngleUnit choice) {
        return m_set->add(this, {id,
                                 text,
                                 nullptr,
                                 {},
                                 {},
                                 [=] { p->angleUnit.set(choice); },
                                 {},
                                 [=] { return p->angleUnit() == choice; }});
    };
    const auto language = [this, p](const QByteArray& id, const QString& text, const QString& code) {
        return m_set->add(this,
                          {id,
                           text,
                           nullptr,
                           {},
                           {},
                           [=, this] {
                               p->language.set(code);
                               emit messageRaised(tr("The language changes when Ramure is started again."));
                           },
                           {},
                           [=] { return p->language() == code; }});
    };
    m_themes = group({theme("view.theme.system", Actions::tr("As the &system"), ThemeChoice::System),
                      theme("view.theme.light", Actions::tr("&Light"), ThemeChoice::Light),
                      theme("view.theme.dark", Actions::tr("&Dark"), ThemeChoice::Dark)});
    m_units = group({unit("view.degrees", Actions::tr("&Degrees"), AngleUnit::Degrees),
                     unit("view.radians", Actions::tr("&Radians"), AngleUnit::Radians)});
    QList<QAction*> languages{language("view.language.system", Actions::tr("As the &system"), {})};
    // Languages are called by their own names in every language.
    for (const auto& [code, name] : Language::available())
        languages += language("view.language." + code.toLatin1(), name, code);
    m_languages = group(languages);
}

/// One of \p actions is chosen.
QActionGroup* ViewActions::group(const QList<QAction*>& actions)
{
    auto* made = new QActionGroup(this);
    for (QAction* action : actions)
        made->addAction(action);
    return made;
}

QList<QAction*> ViewActions::modeActions() const
{
    return m_modes->actions();
}

void ViewActions::fillMenu(QMenu* menu, const QList<QAction*>& panels)
{
    m_set->fill(menu, {"view.frameAll", "view.frameSelection"});
    menu->addMenu(tr("&View from"))->addActions(m_axes);
    menu->addMenu(tr("M&ove the view"))->addActions(m_moves);
    m_set->fill(menu, {"view.orthographic"});
    m_bookmarks->fillMenu(menu);
    m_cameras->fillMenu(menu);
    menu->addSeparator();
    QMenu* drawAs = menu->addMenu(tr("&Draw as"));
    drawAs->addActions(m_modes->actions());
    drawAs->addSeparator();
    drawAs->addActions(m_shading->actions());
    m_set->fill(menu->addMenu(tr("&Show")),
                {"view.leaves", "view.apples", nullptr, "view.grid", "view.ground", "view.meadow",
                 "view.figure", nullptr, "view.outline", "view.crowns", "view.path", "view.ghosts"});
    menu->addMenu(tr("&Quality"))->addActions(m_qualities->actions());
    QMenu* gameWind = menu->addMenu(tr("Wind of a ga&me"));
    gameWind->addActions(m_gameWinds->actions());
    gameWind->addSeparator();
    gameWind->addActions(m_gameWindStrengths->actions());
    m_set->fill(menu, {"view.light", "view.skyPicture", nullptr});
    QMenu* panelMenu = menu->addMenu(tr("Pa&nels"));
    panelMenu->addActions(panels);
    m_set->fill(panelMenu, {nullptr, "view.resetLayout"});
    menu->addMenu(tr("&Theme"))->addActions(m_themes->actions());
    menu->addMenu(tr("&Angles in"))->addActions(m_units->actions());
    menu->addMenu(tr("&Language"))->addActions(m_languages->actions());
}

} // namespace ramure
