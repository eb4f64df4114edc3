#include "widgets/main_window/main_window.h"

#include "core/document/analysis.h"
#include "core/document/player.h"
#include "widgets/actions/action_set.h"
#include "widgets/actions/chooser.h"
#include "widgets/actions/edit_actions.h"
#include "widgets/actions/file_actions.h"
#include "widgets/actions/import_actions.h"
#include "widgets/actions/picture_actions.h"
#include "widgets/actions/program_actions.h"
#include "widgets/actions/transform_actions.h"
#include "widgets/actions/view_actions.h"
#include "widgets/animation/auto_key.h"
#include "widgets/animation/key_actions.h"
#include "widgets/animation/key_commands.h"
#include "widgets/animation/key_panel.h"
#include "widgets/arm/arm_mesh_row.h"
#include "widgets/arm/arm_panel.h"
#include "widgets/export/export_dialog.h"
#include "widgets/export/sequence_task.h"
#include "widgets/history/history_dock.h"
#include "widgets/inspector/branch_inspector.h"
#include "widgets/main_window/isolation_button.h"
#include "widgets/main_window/job_panel.h"
#include "widgets/main_window/message_banner.h"
#include "widgets/main_window/problem_button.h"
#include "widgets/main_window/status_panel.h"
#include "widgets/properties/properties_panel.h"
#include "widgets/scene/isolation.h"
#include "widgets/scene/scene_panel.h"
#include "widgets/scene/select_actions.h"
#include "widgets/support/core_text.h"
#include "widgets/support/preferences.h"
#include "widgets/timeline/bake_actions.h"
#include "widgets/timeline/play_actions.h"
#include "widgets/timeline/timeline_panel.h"
#include "widgets/validation/separate_dialog.h"
#include "widgets/validation/validation_panel.h"
#include "widgets/viewport/viewport.h"
#include "widgets/viewport/viewport_host.h"
#include "widgets/welcome/welcome_panel.h"
#include <QApplication>
#include <QCloseEvent>
#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QMenuBar>
#include <QMimeData>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>

namespace ramure {
namespace {

constexpr int messageMs = 6000;
constexpr int layoutVersion = 3; ///< of saveState; another one means another set of docks

QString droppedFile(const QMimeData* data)
{
    const QList<QUrl> urls = data->urls();
    if (urls.size() != 1 || !urls.front().isLocalFile())
        return {};
    const QString path = urls.front().toLocalFile();
    const bool known = path.endsWith(QStringLiteral(".ramure"), Qt::CaseInsensitive);
    return known || ImportActions::canImport(path) ? path : QString();
}

} // namespace

MainWindow::MainWindow(Document* document, Recompute* recompute, Preferences* preferences, Chooser* chooser,
                       QWidget* parent)
    : QMainWindow(parent)
    , m_document(document)
    , m_recompute(recompute)
    , m_analysis(new Analysis(document, this))
    , m_preferences(preferences)
    , m_chooser(chooser)
    , m_actions(new ActionSet(this))
    , m_isolation(new Isolation(document, this))
    , m_banner(new MessageBanner(this))
    , m_host(new ViewportHost(document, this))
    , m_player(new Player(document, this))
{
    setObjectName(QStringLiteral("mainWindow"));
    setAcceptDrops(true);
    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks | GroupedDragging);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    auto* centre = new QWidget(this);
    auto* layout = new QVBoxLayout(centre);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_banner);
    auto* beside = new QHBoxLayout; // the welcome page and the view
    beside->setSpacing(0);
    beside->addWidget(m_host, 1);
    layout->addLayout(beside, 1);
    setCentralWidget(centre);

    buildDocks();
    buildActions();
    buildMenus();
    buildToolBar();
    buildStatusBar();
    beside->insertWidget(0, m_welcome);
    connectPanels();
    connect(m_document, &Document::changed, this, &MainWindow::follow);
    connect(m_document->undoStack(), &QUndoStack::cleanChanged, this, &MainWindow::updateTitle);
    qApp->installEventFilter(new SpaceKeeper(this));
    retranslate();
    restoreLayout();
}

MainWindow::~MainWindow() = default;

QDockWidget* MainWindow::addPanel(const QString& name, QWidget* content, Qt::DockWidgetArea area)
{
    auto* dock = new QDockWidget(this);
    dock->setObjectName(name);
    dock->toggleViewAction()->setObjectName(QStringLiteral("view.panel.") + name);
    dock->setWidget(content);
    addDockWidget(area, dock);
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
    return dock;
}

void MainWindow::buildDocks()
{
    m_scene = new ScenePanel(m_document, m_preferences, this);
    m_properties = new PropertiesPanel(m_document, m_preferences, this);
    m_history = new HistoryDock(m_document, this);
    m_inspector = new BranchInspector(m_document, this);
    m_validation = new ValidationPanel(m_document, m_analysis, this);
    m_sceneDock = addPanel(QStringLiteral("sceneDock"), m_scene, Qt::RightDockWidgetArea);
    m_historyDock = addPanel(QStringLiteral("historyDock"), m_history, Qt::RightDockWidgetArea);
    m_propertiesDock = addPanel(QStringLiteral("propertiesDock"), m_properties, Qt::RightDockWidgetArea);
    m_inspectorDock = addPanel(QStringLiteral("inspectorDock"), m_inspector, Qt::RightDockWidgetArea);
    m_validationDock = addPanel(QStringLiteral("validationDock"), m_validation, Qt::RightDockWidgetArea);
    m_arm = new ArmPanel(m_document, this);
    m_armDock = addPanel(QStringLiteral("armDock"), m_arm, Qt::RightDockWidgetArea);
    m_plays = new PlayActions(m_document, m_player, m_actions, this);
    m_bakes = new BakeActions(m_document, m_player, m_chooser, m_actions, this);
    m_timeline = new TimelinePanel(m_document, m_player, m_plays, this);
    m_timeline->setBakeActions(m_bakes);
    m_timelineDock = addPanel(QStringLiteral("timelineDock"), m_timeline, Qt::BottomDockWidgetArea);
    m_keyModel = new KeyModel(m_document, this);
    m_keyCommands = new KeyCommands(m_keyModel, m_player, this);
    m_keyActions = new KeyActions(m_keyCommands, m_actions, this);
    m_autoKey = new AutoKey(m_document, m_player, this);
    m_properties->setKeys(m_autoKey);
    m_arm->setKeys(m_autoKey);
    m_keys = new KeyPanel(m_keyModel, m_keyCommands, m_keyActions, m_player, this);
    m_keysDock = addPanel(QStringLiteral("keysDock"), m_keys, Qt::BottomDockWidgetArea);
    // The timeline's height is no room for rows of keys: the first look at them makes some.
    connect(m_keysDock, &QDockWidget::visibilityChanged, this, [this](bool visible) {
        constexpr int least = 220, wanted = 290;
        if (visible && !std::exchange(m_keysSeen, true) && m_keysDock->height() < least)
            resizeDocks({m_keysDock}, {wanted}, Qt::Vertical);
    });
}

void MainWindow::resetLayout()
{
    for (QDockWidget* dock :
         {m_sceneDock, m_historyDock, m_propertiesDock, m_inspectorDock, m_validationDock, m_armDock}) {
        dock->setFloating(false);
        addDockWidget(Qt::RightDockWidgetArea, dock);
        dock->show();
    }
    for (QDockWidget* dock : {m_timelineDock, m_keysDock}) {
        dock->setFloating(false);
        addDockWidget(Qt::BottomDockWidgetArea, dock);
        dock->show();
    }
    splitDockWidget(m_sceneDock, m_propertiesDock, Qt::Vertical);
    tabifyDockWidget(m_sceneDock, m_historyDock);
    tabifyDockWidget(m_propertiesDock, m_inspectorDock);
    tabifyDockWidget(m_inspectorDock, m_validationDock);
    tabifyDockWidget(m_timelineDock, m_keysDock);
    m_timelineDock->raise();
    tabifyDockWidget(m_validationDock, m_armDock);
    m_sceneDock->raise();
    m_propertiesDock->raise();
    m_toolBar->show();
    resizeDocks({m_sceneDock, m_propertiesDock}, {220, 520}, Qt::Vertical);
    resizeDocks({m_sceneDock}, {384}, Qt::Horizontal);
}

void MainWindow::restoreLayout()
{
    resize(1280, 800);
    resetLayout();
    restoreGeometry(m_preferences->windowGeometry());
    restoreState(m_preferences->windowState(), layoutVersion);
}

void MainWindow::buildActions()
{
    m_files = new FileActions(m_document, m_preferences, m_chooser, m_actions, this);
    m_edits = new EditActions(m_document, m_chooser, m_actions, this);
    m_selects = new SelectActions(m_document, m_isolation, m_actions, this);
    m_views = new ViewActions(m_host, m_preferences, m_actions, this);
    m_transforms = new TransformActions(m_host, m_preferences, m_actions, this);
    m_views->setTrailActions(m_transforms->viewActions());
    m_search = m_actions->add(
        {"view.search", QT_TRANSLATE_NOOP("Actions", "Find a &parameter"), "search", QKeySequence::Find});
    m_separate = m_actions->add(
        {"edit.separate", QT_TRANSLATE_NOOP("Actions", "Move colliding branches a&part…"), nullptr, {}});
    connect(m_separate, &QAction::triggered, this, [this] { showSeparateDialog(); });
    m_resetLayout =
        m_actions->add({"view.resetLayout", QT_TRANSLATE_NOOP("Actions", "Reset the &layout"), nullptr, {}});
    buildBranchActions();
    m_imports = new ImportActions(m_document, m_preferences, m_chooser, m_actions, this);
    connect(m_arm->meshRow(), &ArmMeshRow::importRequested, this, [this] {
        m_imports->chooseFile();
        m_arm->meshRow()->setWaiting(m_imports->isRunning());
    });
    connect(m_imports, &ImportActions::imported, m_arm->meshRow(), &ArmMeshRow::takeImported);
    m_pictures = new PictureActions(m_host, m_preferences, m_chooser, m_actions, this);
    m_program = new ProgramActions(m_actions, m_preferences, m_host->settings(), this);
    m_welcome = new WelcomePanel(m_files, m_actions, m_preferences, this);
    connect(m_search, &QAction::triggered, this, [this] {
        m_propertiesDock->show();
        m_propertiesDock->raise();
        m_properties->focusSearch();
    });
    connect(m_resetLayout, &QAction::triggered, this, &MainWindow::resetLayout);
    connect(m_program->welcomeAction(), &QAction::triggered, this, &MainWindow::showWelcome);
    connect(m_files, &FileActions::succeeded, m_banner, &QWidget::hide);
    connect(m_files, &FileActions::exportRequested, this, &MainWindow::showExportDialog);
    connect(m_files, &FileActions::quitRequested, this, &QWidget::close);
    connect(m_edits, &EditActions::renameRequested, this, [this] {
        m_sceneDock->show();
        m_sceneDock->raise();
        m_scene->renameActive();
    });
}

/// What the inspector does by keys; it comes to the front for it.
void MainWindow::buildBranchActions()
{
    m_nextSection =
        m_actions->add({"inspect.nextSection", QT_TRANSLATE_NOOP("Actions", "Ne&xt section"), nullptr,
                        QKeySequence(Qt::CTRL | Qt::Key_Right),
                        QT_TRANSLATE_NOOP("Actions", "Inspect the next cross-section of the branch")});
    m_previousSection =
        m_actions->add({"inspect.previousSection", QT_TRANSLATE_NOOP("Actions", "P&revious section"), nullptr,
                        QKeySequence(Qt::CTRL | Qt::Key_Left),
                        QT_TRANSLATE_NOOP("Actions", "Inspect the cross-section before this one")});
    m_roll = m_actions->add({"inspect.roll", QT_TRANSLATE_NOOP("Actions", "Roll by h&and"), nullptr,
                             QKeySequence(Qt::SHIFT | Qt::Key_R),
                             QT_TRANSLATE_NOOP("Actions", "Turn the frames of the selected branches")});
    const std::pair<QAction*, void (BranchInspector::*)()> steps[] = {
        {m_nextSection, &BranchInspector::nextSection},
        {m_previousSection, &BranchInspector::previousSection},
        {m_roll, &BranchInspector::focusRoll},
    };
    for (const auto& [action, step] : steps) {
        action->setEnabled(false);
        connect(action, &QAction::triggered, this, [this, then = step] {
            showInspector();
            (m_inspector->*then)();
        });
    }
}

void MainWindow::buildMenus()
{
    m_fileMenu = menuBar()->addMenu(QString());
    m_files->fillMenu(m_fileMenu, m_program->welcomeAction(), m_pictures->pictureActions(),
                      m_imports->actions());
    m_editMenu = menuBar()->addMenu(QString());
    m_edits->fillMenu(m_editMenu);
    m_editMenu->addSeparator();
    m_transforms->fillMenu(m_editMenu);
    m_editMenu->addAction(m_separate);
    m_editMenu->addAction(m_search);
    m_editMenu->addSeparator();
    m_editMenu->addAction(m_program->preferencesAction());
    m_selectMenu = menuBar()->addMenu(QString());
    m_selectMenu->addActions(m_pictures->selectionActions());
    m_selects->fillMenu(m_selectMenu);
    m_selectMenu->addSeparator();
    m_selectMenu->addActions(branchActions());
    m_viewMenu = menuBar()->addMenu(QString());
    m_views->fillMenu(m_viewMenu,
                      {m_sceneDock->toggleViewAction(), m_propertiesDock->toggleViewAction(),
                       m_inspectorDock->toggleViewAction(), m_validationDock->toggleViewAction(),
                       m_historyDock->toggleViewAction(), m_timelineDock->toggleViewAction(),
                       m_keysDock->toggleViewAction(), m_armDock->toggleViewAction()},
                      m_resetLayout);
    m_playMenu = menuBar()->addMenu(QString());
    m_plays->fillMenu(m_playMenu);
    m_playMenu->addSeparator();
    m_bakes->fillMenu(m_playMenu);
    m_keysMenu = menuBar()->addMenu(QString());
    m_keyActions->fillMenu(m_keysMenu);
    m_helpMenu = menuBar()->addMenu(QString());
    m_helpMenu->addActions(m_program->helpActions());
    m_program->setMenus(
        {m_fileMenu, m_editMenu, m_selectMenu, m_viewMenu, m_playMenu, m_keysMenu, m_helpMenu});
    m_scene->setMenuActions(m_edits->nodeActions(), m_selects);
}

void MainWindow::buildToolBar()
{
    m_toolBar = addToolBar(QString());
    m_toolBar->setObjectName(QStringLiteral("mainToolBar"));
    m_toolBar->setMovable(false);
    m_toolBar->setIconSize({18, 18});
    m_toolBar->addActions({m_files->openAction(), m_files->saveAction(), m_files->exportAction()});
    m_toolBar->addSeparator();
    m_toolBar->addActions({m_edits->undoAction(), m_edits->redoAction()});
    m_toolBar->addSeparator();
    m_toolBar->addAction(m_edits->newTreeAction());
    m_toolBar->addSeparator();
    m_toolBar->addActions(m_views->modeActions());
    m_toolBar->addSeparator();
    m_toolBar->addActions({m_views->frameAllAction(), m_views->frameSelectionAction()});
    m_toolBar->addSeparator();
    m_transforms->fillToolBar(m_toolBar);
    auto* newTree = qobject_cast<QToolButton*>(m_toolBar->widgetForAction(m_edits->newTreeAction()));
    newTree->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
}

void MainWindow::buildStatusBar()
{
    statusBar()->setSizeGripEnabled(false);
    m_problem = new ProblemButton(m_document, this);
    m_status = new StatusPanel(m_document, m_recompute, m_analysis, this);
    statusBar()->addWidget(m_problem, 1);
    statusBar()->addPermanentWidget(new IsolationButton(m_isolation, this));
    m_bakeProgress = new JobPanel(m_bakes->job(), QStringLiteral("bakeProgress"), this);
    statusBar()->addPermanentWidget(m_bakeProgress);
    m_armProgress = new JobPanel(m_arm->bakeJob(), QStringLiteral("armProgress"), this);
    statusBar()->addPermanentWidget(m_armProgress);
    m_wearProgress = new JobPanel(m_arm->meshRow()->job(), QStringLiteral("wearProgress"), this);
    statusBar()->addPermanentWidget(m_wearProgress);
    buildSequences();
    statusBar()->addPermanentWidget(m_status);
}

/// Sequences are written while the work goes on.
void MainWindow::buildSequences()
{
    m_sequences = new SequenceTask(this);
    m_sequenceProgress = new JobPanel(m_sequences, QStringLiteral("sequenceProgress"), this);
    statusBar()->addPermanentWidget(m_sequenceProgress);
    connect(m_sequences, &BackgroundJob::runningChanged, this, [this](bool running) {
        if (running)
            m_sequenceProgress->setText(tr("Writing %Ln file(s)", nullptr, int(m_sequences->fileCount())));
    });
    connect(m_sequences, &BackgroundJob::finished, this, [this](const std::optional<Error>& error) {
        const QString folder = QDir::toNativeSeparators(QFileInfo(m_sequences->path()).absolutePath());
        if (error && error->code == ErrorCode::Cancelled)
            statusBar()->showMessage(tr("The export was cancelled; the files written so far are whole"),
                                     messageMs);
        else if (error)
            m_chooser->report(Severity::Error, QStringLiteral("%1\n%2").arg(
                                                   tr("The export has ended with an error; the files written "
                                                      "before it are whole."),
                                                   errorTextWithPlace(*error)));
        else
            statusBar()->showMessage(
                tr("%Ln file(s) written to %1", nullptr, int(m_sequences->fileCount())).arg(folder),
                messageMs);
    });
}

void MainWindow::connectPanels()
{
    const auto say = [this](const QString& text) { statusBar()->showMessage(text, messageMs); };
    connect(m_pictures, &PictureActions::messageRaised, this, say);
    connect(m_welcome, &WelcomePanel::closed, this, [this] { m_host->setFocus(); });
    connect(m_scene, &ScenePanel::messageRaised, this, say);
    connect(m_scene, &ScenePanel::frameRequested, m_views->frameSelectionAction(), &QAction::trigger);
    connect(m_selects, &SelectActions::messageRaised, this, say);
    connect(m_transforms, &TransformActions::hintChanged, this,
            [this](const QString& text) { statusBar()->showMessage(text); });
    connect(m_selects, &SelectActions::searchRequested, this, [this] {
        m_sceneDock->show();
        m_sceneDock->raise();
        m_scene->focusSearch();
    });
    connect(m_inspector, &BranchInspector::messageRaised, this, say);
    connect(m_validation, &ValidationPanel::messageRaised, this, say);
    connect(m_timeline, &TimelinePanel::messageRaised, this, say);
    connect(m_bakes, &BakeActions::messageRaised, this, say);
    connect(m_arm, &ArmPanel::messageRaised, this, say);
    connect(m_keyCommands, &KeyCommands::messageRaised, this, say);
    connect(m_keyActions->autoAction(), &QAction::toggled, m_autoKey, &AutoKey::setOn);
    connect(m_player, &Player::failed, this, [say](const Error& error) { say(errorTextWithPlace(error)); });
    connect(m_validation, &ValidationPanel::separateRequested, this, &MainWindow::showSeparateDialog);
    connect(m_problem, &ProblemButton::paramRequested, this, [this](const QString& key) {
        m_propertiesDock->show();
        m_propertiesDock->raise();
        m_properties->showParam(key);
    });
    const auto applyUnits = [this] { m_inspector->setAngleUnit(m_preferences->angleUnit()); };
    connect(m_preferences, &Preferences::changed, this, applyUnits);
    applyUnits();
    m_plays->setView(m_host->settings());
    m_scene->setTime([this] { return m_player->timeSeconds(); });
    connectTimeline();
    if (Viewport* view = m_host->viewport())
        connectViewport(view);
}

/// What the preferences say about motion.
void MainWindow::connectTimeline()
{
    const auto apply = [this] {
        m_timeline->setDisplay(m_preferences->timeDisplay());
        m_player->setMemoryLimit(std::size_t(m_preferences->motionMemoryMb()) << 20);
    };
    connect(m_preferences, &Preferences::changed, this, apply);
    connect(m_timeline, &TimelinePanel::displayChanged, m_preferences, &Preferences::setTimeDisplay);
    m_bakes->setSave([this] { return m_files->save(); });
    apply();
}

void MainWindow::connectViewport(Viewport* view)
{
    view->setPlayer(m_player);
    view->setKeys(m_autoKey);
    connect(view, &Viewport::messageRaised, this,
            [this](const QString& text) { statusBar()->showMessage(text, messageMs); });
    view->setAutoKey([this] { return m_autoKey->isOn(); });
    m_arm->setReach(view->armReach());
    m_timeline->setReach(view->armReach());
    m_properties->setReach(view->armReach());
    connect(m_isolation, &Isolation::changed, view,
            [this, view] { view->setIsolated(m_isolation->node(), m_isolation->branches()); });
    connect(m_inspector, &BranchInspector::sectionInspected, view, &Viewport::setInspectedSection);
    connect(m_inspector, &BranchInspector::sectionLeft, view, &Viewport::clearInspectedSection);
    connect(m_validation, &ValidationPanel::defectActivated, view, &Viewport::showDefect);
    connect(m_validation, &ValidationPanel::defectLeft, view, &Viewport::clearDefect);
}

void MainWindow::showInspector()
{
    m_inspectorDock->show();
    m_inspectorDock->raise();
}

void MainWindow::follow(const Change& change)
{
    if (change.has(changeSelection | changeReset)) {
        const bool branch = m_document->selection().activeBranch != noIndex;
        for (QAction* action : branchActions())
            action->setEnabled(branch);
    }
    if (change.has(changeFile | changeReset))
        updateTitle();
}

void MainWindow::updateTitle()
{
    setWindowTitle(QStringLiteral("%1[*] – Ramure").arg(m_files->documentName()));
    setWindowFilePath(m_document->filePath());
    setWindowModified(m_document->isModified());
}

void MainWindow::showWelcome()
{
    m_welcome->open();
}

void MainWindow::showExportDialog()
{
    auto* dialog =
        new ExportDialog(m_document, m_recompute, m_preferences, m_chooser, this, m_player->frame());
    dialog->setSequenceTask(m_sequences);
    if (const Viewport* view = m_host->viewport()) {
        const ViewSettings* settings = m_host->settings();
        PictureLook look;
        look.camera = view->camera();
        look.options.shading = settings->shadingMode();
        look.view.mode = settings->displayMode();
        look.view.leaves = settings->leavesVisible();
        look.view.apples = settings->applesVisible();
        dialog->setPictureLook(look);
    }
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAnalysis(m_analysis);
    connect(dialog, &ExportDialog::showRequested, this, [this](NodeId tree) {
        m_document->setSelection({{tree}, noNode, {}, noIndex});
        m_validationDock->show();
        m_validationDock->raise();
    });
    connect(dialog, &ExportDialog::exported, this, [this](const QString& path) {
        statusBar()->showMessage(tr("Exported to %1").arg(QDir::toNativeSeparators(path)), messageMs);
    });
    dialog->open();
}

void MainWindow::showSeparateDialog(NodeId tree)
{
    const auto isTree = [this](NodeId id) {
        const Node* node = m_document->scene().find(id);
        return node && node->kind == NodeKind::Tree;
    };
    if (!isTree(tree))
        tree = m_document->selection().activeNode();
    for (const Node& node : m_document->scene().nodes())
        if (!isTree(tree))
            tree = node.id;
    if (!isTree(tree))
        return statusBar()->showMessage(tr("There is no tree in the scene."), messageMs);
    auto* dialog = new SeparateDialog(m_document, tree, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &SeparateDialog::messageRaised, this,
            [this](const QString& text) { statusBar()->showMessage(text, messageMs); });
    dialog->open();
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!m_files->mayDiscard()) {
        event->ignore();
        return;
    }
    m_preferences->setWindow(saveGeometry(), saveState(layoutVersion));
    event->accept();
}

void MainWindow::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QMainWindow::changeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    if (!droppedFile(event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    const QString path = droppedFile(event->mimeData());
    if (path.isEmpty())
        return;
    event->acceptProposedAction();
    // After the drag has ended: the question about unsaved changes must not hold the other program.
    QMetaObject::invokeMethod(
        this,
        [this, path] {
            if (ImportActions::canImport(path))
                m_imports->importPath(path);
            else
                m_files->openFile(path);
        },
        Qt::QueuedConnection);
}

void MainWindow::retranslate()
{
    m_actions->retranslate();
    m_files->retranslate();
    m_edits->retranslate();
    m_views->retranslate();
    m_transforms->retranslate();
    m_fileMenu->setTitle(tr("&File"));
    m_editMenu->setTitle(tr("&Edit"));
    m_selectMenu->setTitle(tr("&Select"));
    m_viewMenu->setTitle(tr("&View"));
    m_playMenu->setTitle(tr("&Play"));
    m_keysMenu->setTitle(tr("&Keys"));
    m_helpMenu->setTitle(tr("He&lp"));
    m_toolBar->setWindowTitle(tr("Toolbar"));
    m_sceneDock->setWindowTitle(tr("Scene"));
    m_propertiesDock->setWindowTitle(tr("Properties"));
    m_historyDock->setWindowTitle(tr("History"));
    m_inspectorDock->setWindowTitle(tr("Inspector"));
    m_validationDock->setWindowTitle(tr("Validation"));
    m_armDock->setWindowTitle(tr("Arm"));
    m_timelineDock->setWindowTitle(tr("Timeline"));
    m_keysDock->setWindowTitle(tr("Keys"));
    m_keyActions->retranslate();
    m_plays->retranslate();
    m_bakes->retranslate();
    m_bakeProgress->setText(tr("Baking the motion"));
    m_armProgress->setText(tr("Baking the arm to keys"));
    m_wearProgress->setText(tr("Putting the mesh on the arm"));
    updateTitle();
}

} // namespace ramure
