#include "widgets/base/named.h"
#include "widgets/window/main_window_export.h"

#include "core/qt/session/motion/auto_key.h"
#include "widgets/actions/billboard_actions.h"
#include "widgets/actions/edit_actions.h"
#include "widgets/actions/file_actions.h"
#include "widgets/actions/hand_actions.h"
#include "widgets/actions/help_actions.h"
#include "widgets/actions/import_actions.h"
#include "widgets/actions/picture_actions.h"
#include "widgets/actions/program_actions.h"
#include "widgets/actions/recipe_actions.h"
#include "widgets/actions/sky_picture_actions.h"
#include "widgets/actions/transform_actions.h"
#include "widgets/actions/view_actions.h"
#include "widgets/base/action_set.h"
#include "widgets/base/chooser.h"
#include "widgets/base/message_banner.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/base/timeline_ruler.h"
#include "widgets/dialogs/variations/seeds_dialog.h"
#include "widgets/dialogs/variations/variations_dialog.h"
#include "widgets/help/help_places.h"
#include "widgets/panels/animation/key_actions.h"
#include "widgets/panels/animation/key_commands.h"
#include "widgets/panels/animation/key_panel.h"
#include "widgets/panels/arm/arm_mesh_row.h"
#include "widgets/panels/arm/arm_panel.h"
#include "widgets/panels/inspector/branch_inspector.h"
#include "widgets/panels/levels/levels_panel.h"
#include "widgets/panels/presets/gallery_panel.h"
#include "widgets/panels/properties/properties_panel.h"
#include "widgets/panels/scene/isolation.h"
#include "widgets/panels/scene/scene_panel.h"
#include "widgets/panels/scene/select_actions.h"
#include "widgets/panels/timeline/bake_actions.h"
#include "widgets/panels/timeline/play_actions.h"
#include "widgets/panels/timeline/ruler_menu.h"
#include "widgets/panels/timeline/timeline_panel.h"
#include "widgets/panels/validation/separate_dialog.h"
#include "widgets/panels/validation/validation_panel.h"
#include "widgets/view/viewport.h"
#include "widgets/view/viewport_host.h"
#include "widgets/window/hint_line.h"
#include "widgets/window/isolation_button.h"
#include "widgets/window/job_panel.h"
#include "widgets/window/panel_hints.h"
#include "widgets/window/panels.h"
#include "widgets/window/problem_button.h"
#include "widgets/window/status_panel.h"
#include "widgets/window/tool_box.h"
#include "widgets/window/tool_strip.h"
#include "widgets/window/unplaced_button.h"
#include "widgets/window/welcome_panel.h"
#include <QDockWidget>
#include <QHBoxLayout>
#include <QMenuBar>
#include <QScreen>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>
#include <algorithm>

namespace ramure {

QDockWidget* MainWindow::dockOf(const QWidget* panel)
{
    return qobject_cast<QDockWidget*>(panel->parentWidget());
}

void MainWindow::showPanel(const QWidget* panel)
{
    dockOf(panel)->show();
    dockOf(panel)->raise();
}

void MainWindow::addPanel(const PanelRow& row, QWidget* content)
{
    auto* dock = new QDockWidget(tr(row.title), this);
    m_docks += dock;
    dock->setObjectName(QString::fromLatin1(row.dock));
    dock->toggleViewAction()->setObjectName(QStringLiteral("view.panel.") + dock->objectName());
    dock->setProperty(helpPlaceProperty, row.help);
    dock->setWidget(content);
    // Among tabs the tab is the title.
    auto* noTitle = new QWidget(dock);
    // An empty layout: without one the size hint, and with it the dock's height, would be negative.
    (new QVBoxLayout(noTitle))->setContentsMargins(0, 0, 0, 0);
    const auto chooseTitle = [this, dock, noTitle] {
        const bool tabbed = !dock->isFloating() && !tabifiedDockWidgets(dock).isEmpty();
        if (tabbed == (dock->titleBarWidget() == noTitle))
            return;
        dock->setTitleBarWidget(tabbed ? noTitle : nullptr);
        noTitle->setVisible(tabbed);
    };
    connect(dock, &QDockWidget::topLevelChanged, dock, chooseTitle, Qt::QueuedConnection);
    connect(dock, &QDockWidget::visibilityChanged, dock, chooseTitle, Qt::QueuedConnection);
    connect(dock, &QDockWidget::dockLocationChanged, dock, chooseTitle, Qt::QueuedConnection);
}

void MainWindow::buildDocks()
{
    auto* plays = new PlayActions(m_document, m_player, m_actions, this);
    plays->setView(m_host->settings());
    m_bakes = new BakeActions(m_document, m_player, m_chooser, m_actions, this);
    m_keyModel = new KeyModel(m_document, this);
    auto* commands = new KeyCommands(m_keyModel, m_player, this);
    m_keyActions = new KeyActions(commands, m_actions, this);
    m_autoKey = new AutoKey(m_document, m_player, this);
    const PanelServices services{m_document, m_preferences, m_analysis, m_player,
                                 plays,      m_keyModel,    commands,   m_keyActions};
    for (const PanelRow& row : panels())
        addPanel(row, row.make(services, this));
    m_scene = findChild<ScenePanel*>();
    m_properties = findChild<PropertiesPanel*>();
    m_inspector = findChild<BranchInspector*>();
    m_validation = findChild<ValidationPanel*>();
    m_timeline = findChild<TimelinePanel*>();
    m_keys = findChild<KeyPanel*>();
    m_arm = findChild<ArmPanel*>();
    connectKeys();
}

void MainWindow::connectKeys()
{
    m_timeline->setBakeActions(m_bakes);
    m_properties->setKeys(m_autoKey);
    m_arm->setKeys(m_autoKey);
    m_timeline->rulerMenu()->addInsert(m_keyActions->insertAction());
    connect(m_keys->ruler(), &TimelineRuler::menuRequested, this, [this](const QPoint& place, qint64 frame) {
        m_timeline->rulerMenu()->popUp(m_keys->ruler(), place, frame);
    });
}

void MainWindow::resetLayout()
{
    QList<QDockWidget*> tabs[3]; // of each place
    for (std::size_t i = 0; i < panels().size(); ++i)
        tabs[std::size_t(panels()[i].place)] += m_docks[qsizetype(i)];
    QDockWidget *upper = tabs[0].front(), *lower = tabs[1].front(), *bottom = tabs[2].front();
    for (QDockWidget* first : {upper, lower, bottom}) {
        first->setFloating(false);
        addDockWidget(first == bottom ? Qt::BottomDockWidgetArea : Qt::RightDockWidgetArea, first);
        first->show();
    }
    splitDockWidget(upper, lower, Qt::Vertical);
    // At once among the tabs: below each other, all of them would make the window higher than the screen.
    for (const QList<QDockWidget*>& docks : tabs) {
        for (qsizetype i = 1; i < docks.size(); ++i) {
            docks[i]->setFloating(false);
            tabifyDockWidget(docks[i - 1], docks[i]);
            docks[i]->show();
        }
        docks.front()->raise();
    }
    m_toolBar->show();
    // Panels that share a place have one height: what comes to the front moves nothing.
    resizeDocks({upper, lower}, {300, 440}, Qt::Vertical);
    resizeDocks({bottom}, {210}, Qt::Vertical);
    resizeDocks({upper}, {384}, Qt::Horizontal);
}

void MainWindow::restoreLayout()
{
    resize(1280, std::min(screen()->availableSize().height() * 19 / 20, 948));
    resetLayout();
    restoreGeometry(m_preferences->windowGeometry());
    restoreState(m_preferences->windowState(), layoutVersion);
}

void MainWindow::buildActions()
{
    m_files = new FileActions(m_document, m_preferences, m_chooser, m_actions, this);
    m_edits = new EditActions(m_document, m_chooser, m_actions, this);
    if (const Viewport* view = m_host->viewport())
        m_edits->setEye([view] { return view->camera(); });
    m_selects = new SelectActions(m_document, m_isolation, m_actions, this);
    m_views = new ViewActions(m_document, m_host, m_preferences, m_chooser, m_actions, this);
    connect(m_views, &ViewActions::messageRaised, this,
            [this](const QString& text) { statusBar()->showMessage(text, messageMs); });
    m_transforms = new TransformActions(m_host, m_preferences, m_actions, this);
    m_recipes = new RecipeActions(m_document, m_actions, this);
    m_hands = new HandActions(m_document, m_host, m_transforms->toolGroup(), m_actions, this);
    m_actions->add(this,
                   {{"view.search", Actions::tr("Find a &parameter"), "search", QKeySequence::Find, QString(),
                     [this] {
                         showPanel(m_properties);
                         m_properties->focusSearch();
                     }},
                    {"edit.separate", Actions::tr("Move colliding branches a&part…"), nullptr, noKeys,
                     QString(), [this] { showSeparateDialog(); }},
                    {"view.resetLayout", Actions::tr("Reset the &layout"), nullptr, noKeys, QString(),
                     [this] { resetLayout(); }}});
    buildBranchActions();
    m_imports = new ImportActions(m_document, m_preferences, m_chooser, m_actions, this);
    m_files->setImports(m_imports);
    connect(m_arm->meshRow(), &ArmMeshRow::importRequested, this, [this] {
        m_imports->chooseToWear();
        m_arm->meshRow()->setWaiting(m_imports->isRunning());
    });
    connect(m_imports, &ImportActions::imported, m_arm->meshRow(), &ArmMeshRow::takeImported);
    m_pictures = new PictureActions(m_document, m_host, m_preferences, m_chooser, m_actions, this);
    m_billboards = new BillboardActions(m_document, m_host, m_preferences, m_chooser, m_actions, this);
    new ProgramActions(m_actions, m_preferences, m_host->settings(), this);
    m_help = new HelpActions(m_actions, m_document, m_preferences, this);
    m_welcome = new WelcomePanel(m_files, m_actions, m_preferences, this);
    connect(m_actions->find("file.welcome"), &QAction::triggered, this, &MainWindow::showWelcome);
    connect(m_files, &FileActions::succeeded, m_banner, &QWidget::hide);
    connect(m_document, &Document::changed, m_files, [this](const Change& change) {
        if (!(change.kinds & changeReset))
            return;
        m_files->setLastExport({}); // another tree must not go over the files of this one
        if (m_banner->severity() == Severity::Info)
            m_banner->hide(); // it told of the document that is gone; what went wrong is still to be read
    });
    connect(m_files, &FileActions::quitRequested, this, &QWidget::close);
    buildManyTrees();
    connect(m_edits, &EditActions::renameRequested, this, [this] {
        showPanel(m_scene);
        m_scene->renameActive();
    });
}

/// The windows that show many trees like one.
void MainWindow::buildManyTrees()
{
    const auto seeds = [this] {
        auto* dialog = findChild<SeedsDialog*>();
        return dialog ? dialog : new SeedsDialog(m_document, this);
    };
    connect(m_edits, &EditActions::moreRequested, this, [seeds](NodeId tree) { seeds()->offerFor(tree); });
    connect(findChild<GalleryPanel*>(), &GalleryPanel::sceneRequested, m_files, &FileActions::newFromPreset);
    connect(m_welcome, &WelcomePanel::addRequested, this,
            [this](const QString& preset) { m_edits->addTree(preset); });
    connect(findChild<GalleryPanel*>(), &GalleryPanel::moreRequested, this,
            [seeds](const Node& like) { seeds()->offerNew(like); });
    connect(m_edits, &EditActions::variationsRequested, this, [this](NodeId tree) {
        auto* dialog = findChild<VariationsDialog*>();
        if (!dialog) {
            dialog = new VariationsDialog(m_document, m_preferences, m_chooser, this);
            dialog->addActions(m_actions->find({"edit.undo", "edit.redo"})); // their keys work there, too
            connect(dialog, &VariationsDialog::presetKept, findChild<GalleryPanel*>(),
                    &GalleryPanel::refreshOwn);
        }
        dialog->offerFor(tree);
    });
}

/// What the inspector does by keys; it comes to the front for it.
void MainWindow::buildBranchActions()
{
    const auto step = [this](void (BranchInspector::*then)()) {
        return [this, then] {
            showInspector();
            (m_inspector->*then)();
        };
    };
    const auto isAny = [this] { return m_document->selection().activeBranch != noIndex; };
    m_actions->add(
        this, {{"inspect.show", Actions::tr("&Inspect the branch"), nullptr, noKeys,
                Actions::tr("Show the facts and sections of the branch"), [this] { showInspector(); }, isAny},
               {"inspect.nextSection", Actions::tr("Ne&xt section"), nullptr, Qt::CTRL | Qt::Key_Right,
                Actions::tr("Inspect the next cross-section of the branch"),
                step(&BranchInspector::nextSection), isAny},
               {"inspect.previousSection", Actions::tr("P&revious section"), nullptr, Qt::CTRL | Qt::Key_Left,
                Actions::tr("Inspect the cross-section before this one"),
                step(&BranchInspector::previousSection), isAny},
               {"inspect.roll", Actions::tr("Roll by h&and"), nullptr, Qt::SHIFT | Qt::Key_R,
                Actions::tr("Turn the frames of the selected branches"), step(&BranchInspector::focusRoll),
                isAny}});
    m_actions->update(this);
}

void MainWindow::buildMenus()
{
    QMenu* file = menuBar()->addMenu(tr("&File"));
    m_files->fillNewMenus(file);
    m_actions->fill(file, {"file.welcome", nullptr, "file.save", "file.saveAs", "file.packPictures", nullptr,
                           "file.import", "file.importFolder", "file.export", "file.exportAgain",
                           "file.billboard", "view.savePicture", "view.copyPicture", nullptr, "file.quit"});
    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    m_edits->fillMenu(edit);
    edit->addSeparator();
    m_transforms->fillMenu(edit);
    m_hands->fillMenu(edit);
    edit->addMenu(m_recipes->menu());
    m_actions->fill(edit, {"edit.separate", "view.search", nullptr, "edit.preferences"});
    QMenu* select = menuBar()->addMenu(tr("&Select"));
    select->addActions(m_pictures->selectionActions());
    m_selects->fillMenu(select);
    select->addSeparator();
    m_actions->fill(select,
                    {"inspect.show", "inspect.nextSection", "inspect.previousSection", "inspect.roll"});
    QMenu* view = menuBar()->addMenu(tr("&View"));
    QList<QAction*> shownPanels;
    for (const QDockWidget* dock : m_docks)
        shownPanels += dock->toggleViewAction();
    m_views->fillMenu(view, shownPanels);
    QMenu* play = menuBar()->addMenu(tr("&Play"));
    findChild<PlayActions*>()->fillMenu(play);
    play->addSeparator();
    m_bakes->fillMenu(play);
    QMenu* keys = menuBar()->addMenu(tr("&Keys"));
    m_keyActions->fillMenu(keys);
    QMenu* help = menuBar()->addMenu(tr("He&lp"));
    m_actions->fill(help,
                    {"help.find", "help.handbook", "help.tour", nullptr, "help.shortcuts", "help.about"});
    const QList<QMenu*> menus{file, edit, select, view, play, keys, help};
    findChild<ProgramActions*>()->setMenus(menus);
    m_help->setMenus(menus);
    m_scene->setMenuActions(m_edits->nodeActions(), m_selects, m_hands->branchActions());
}

void MainWindow::buildToolBar()
{
    m_toolBar = named(addToolBar(tr("Toolbar")), "mainToolBar");
    m_toolBar->setMovable(false);
    m_toolBar->setIconSize({18, 18});
    m_actions->fill(m_toolBar, {"file.open", "file.save", "file.export", nullptr, "edit.undo", "edit.redo",
                                nullptr, "edit.newTree", nullptr});
    m_toolBar->addActions(m_views->modeActions());
    m_actions->fill(m_toolBar, {nullptr, "view.frameAll", "view.frameSelection"});
    auto* newTree = qobject_cast<QToolButton*>(m_toolBar->widgetForAction(m_actions->find("edit.newTree")));
    newTree->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
}

/// Nodes are moved and trees are shaped in the view: the tools stand beside it, their options over it.
void MainWindow::buildHandBar(QVBoxLayout* column)
{
    QWidget* centre = centralWidget();
    const QList<QAction*> tools = m_transforms->toolActions() + m_hands->toolActions();
    auto* handBar = named(new ToolBox(centre), "handBar");
    handBar->setAccessibleName(tr("Tools"));
    handBar->addGroup(m_transforms->toolActions());
    for (const QList<QAction*>& group : m_hands->toolGroups())
        handBar->addGroup(group);
    auto* transforms = named(new QToolBar(centre), "transformBar");
    transforms->setIconSize({18, 18});
    m_transforms->fillToolBar(transforms);
    column->addWidget(new ToolStrip(m_host->settings(), tools, transforms, centre));
    auto* view = new QHBoxLayout;
    view->setSpacing(0);
    view->addWidget(handBar);
    view->addWidget(m_host, 1);
    column->addLayout(view, 1);
}

/// Seen while every edit becomes a key, whatever panel is in front; a click turns that off.
static QToolButton* newAutoKeyMark(QAction* action, QWidget* parent)
{
    auto* mark = named(new QToolButton(parent), "autoKeyMark");
    mark->setDefaultAction(action);
    mark->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    mark->setIconSize({14, 14});
    mark->setFocusPolicy(Qt::TabFocus);
    mark->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Ignored); // the bar keeps its height
    mark->setVisible(action->isChecked());
    QObject::connect(action, &QAction::toggled, mark, &QWidget::setVisible);
    return mark;
}

JobPanel* MainWindow::addJob(Job* job, const char* name)
{
    auto* panel = new JobPanel(job, QLatin1String(name), this);
    statusBar()->addPermanentWidget(panel);
    return panel;
}

void MainWindow::buildStatusBar()
{
    statusBar()->setSizeGripEnabled(false);
    m_problem = new ProblemButton(m_document, this);
    m_status = new StatusPanel(m_document, m_recompute, m_analysis, this);
    statusBar()->addWidget(m_problem, 1);
    m_hints = new HintLine(this);
    statusBar()->addWidget(m_hints, 2);
    connect(m_hints, &HintLine::gestureBegan, statusBar(), &QStatusBar::clearMessage);
    addPanelHints(m_hints, m_timeline, m_keys, findChild<LevelsPanel*>());
    statusBar()->addPermanentWidget(new UnplacedButton(m_document, this));
    statusBar()->addPermanentWidget(new IsolationButton(m_isolation, this));
    statusBar()->addPermanentWidget(newAutoKeyMark(m_keyActions->autoAction(), this));
    addJob(m_bakes->job(), "bakeProgress")->setText(tr("Baking the motion"));
    addJob(m_arm->bakeJob(), "armProgress")->setText(tr("Baking the arm to keys"));
    addJob(m_arm->meshRow()->job(), "wearProgress")->setText(tr("Putting the mesh on the arm"));
    addJob(m_pictures->job(), "pictureProgress")->setText(tr("Drawing a picture"));
    addJob(m_views->skyPictures()->job(), "skyProgress")->setText(tr("Reading a sky picture"));
    addJob(m_billboards->job(), "billboardProgress")->setText(tr("Drawing a billboard"));
    m_exports = std::make_unique<Exports>(this);
    m_status->follow(m_player);
    if (Viewport* view = m_host->viewport())
        connect(view, &Viewport::barkMissing, m_status, &StatusPanel::setMakesBark);
    connect(m_status, &StatusPanel::reportRequested, this, [this] { showPanel(m_validation); });
    statusBar()->addPermanentWidget(m_status);
}

} // namespace ramure
