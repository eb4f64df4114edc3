#include "widgets/window/main_window_export.h"

#include "core/params/param_relevance.h"
#include "core/qt/session/arm/arm_reach.h"
#include "core/qt/session/jobs/analysis.h"
#include "core/qt/session/jobs/scatter_watch.h"
#include "core/qt/session/motion/auto_key.h"
#include "core/qt/session/motion/player.h"
#include "widgets/actions/billboard_actions.h"
#include "widgets/actions/edit_actions.h"
#include "widgets/actions/file_actions.h"
#include "widgets/actions/hand_actions.h"
#include "widgets/actions/help_actions.h"
#include "widgets/actions/import_actions.h"
#include "widgets/actions/picture_actions.h"
#include "widgets/actions/recipe_actions.h"
#include "widgets/actions/transform_actions.h"
#include "widgets/actions/view_actions.h"
#include "widgets/base/action_set.h"
#include "widgets/base/message_banner.h"
#include "widgets/base/silence.h"
#include "widgets/base/targets.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/panels/animation/key_actions.h"
#include "widgets/panels/animation/key_commands.h"
#include "widgets/panels/arm/arm_panel.h"
#include "widgets/panels/inspector/branch_inspector.h"
#include "widgets/panels/levels/levels_panel.h"
#include "widgets/panels/presets/picture_button.h"
#include "widgets/panels/properties/properties_panel.h"
#include "widgets/panels/properties/step_form.h"
#include "widgets/panels/recipe/recipe_panel.h"
#include "widgets/panels/scene/isolation.h"
#include "widgets/panels/scene/scene_panel.h"
#include "widgets/panels/scene/select_actions.h"
#include "widgets/panels/timeline/bake_actions.h"
#include "widgets/panels/timeline/play_actions.h"
#include "widgets/panels/timeline/timeline_panel.h"
#include "widgets/panels/validation/separate_dialog.h"
#include "widgets/panels/validation/validation_panel.h"
#include "widgets/view/view_marks.h"
#include "widgets/view/viewport.h"
#include "widgets/view/viewport_host.h"
#include "widgets/window/field_leaver.h"
#include "widgets/window/hint_line.h"
#include "widgets/window/menu_search.h"
#include "widgets/window/problem_button.h"
#include "widgets/window/view_menu.h"
#include "widgets/window/welcome_panel.h"
#include <QApplication>
#include <QCloseEvent>
#include <QDir>
#include <QDockWidget>
#include <QMimeData>
#include <QStatusBar>
#include <QVBoxLayout>
#include <algorithm>
#include <functional>

namespace ramure {
namespace {

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
    , m_host(new ViewportHost(document, this))
    , m_player(new Player(document, this))
{
    setObjectName(QStringLiteral("mainWindow"));
    setAcceptDrops(true);
    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks | GroupedDragging);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    auto* centre = new QWidget(this);
    m_banner = new MessageBanner(centre);
    auto* beside = new QHBoxLayout(centre); // the welcome page and the view
    beside->setContentsMargins(0, 0, 0, 0);
    beside->setSpacing(0);
    auto* column = new QVBoxLayout; // the strip, and under it the view beside its tools
    column->setSpacing(0);
    beside->addLayout(column, 1);
    setCentralWidget(centre);

    buildDocks();
    buildActions();
    buildMenus();
    buildToolBar();
    buildHandBar(column);
    buildStatusBar();
    beside->insertWidget(0, m_welcome);
    m_banner->lieOver(m_host);
    connectPanels();
    connect(m_document, &Document::changed, this, &MainWindow::follow);
    connect(m_document->undoStack(), &QUndoStack::cleanChanged, this, &MainWindow::updateTitle);
    new ScatterWatch(m_document, this);
    qApp->installEventFilter(new SpaceKeeper(this));
    new FieldLeaver(this, m_host);
    updateTitle();
    restoreLayout();
}

MainWindow::~MainWindow()
{
    silenceChildren(this);
}

void MainWindow::connectPanels()
{
    const auto say = [this](const QString& text) { statusBar()->showMessage(text, messageMs); };
    connect(m_pictures, &PictureActions::messageRaised, this, say);
    connect(m_billboards, &BillboardActions::messageRaised, this, say);
    connect(m_welcome, &WelcomePanel::closed, this, [this] { m_host->setFocus(); });
    connect(m_scene, &ScenePanel::messageRaised, this, say);
    connect(m_scene, &ScenePanel::frameRequested, m_actions->find("view.frameSelection"), &QAction::trigger);
    connect(m_selects, &SelectActions::messageRaised, this, say);
    connect(m_edits, &EditActions::messageRaised, this, say);
    connect(m_hands, &HandActions::messageRaised, this, say);
    connect(m_edits, &EditActions::targetNamed, m_transforms, &TransformActions::nameTarget);
    connect(m_selects, &SelectActions::searchRequested, this, [this] {
        showPanel(m_scene);
        m_scene->focusSearch();
    });
    connect(m_inspector, &BranchInspector::messageRaised, this, say);
    auto* recipe = findChild<RecipePanel*>();
    connect(recipe, &RecipePanel::messageRaised, this, say);
    connect(recipe, &RecipePanel::stepChosen, m_properties->stepForm(), &StepForm::setStep);
    new MenuSearch(m_recipes->menu());
    recipe->setAddMenu(m_recipes->menu());
    connect(recipe, &RecipePanel::saveRequested, m_recipes, &RecipeActions::save);
    connect(m_recipes, &RecipeActions::messageRaised, this, say);
    connect(m_recipes, &RecipeActions::added, this, [this, recipe](NodeId, quint64 step) {
        showPanel(recipe);
        recipe->select(step);
    });
    connect(m_validation, &ValidationPanel::messageRaised, this, say);
    auto* levels = findChild<LevelsPanel*>();
    connect(levels, &LevelsPanel::messageRaised, this, say);
    connect(dockOf(levels), &QDockWidget::visibilityChanged, levels, &LevelsPanel::setSeen);
    connect(m_timeline, &TimelinePanel::messageRaised, this, say);
    connect(m_bakes, &BakeActions::messageRaised, this, say);
    connect(m_arm, &ArmPanel::messageRaised, this, say);
    connect(findChild<KeyCommands*>(), &KeyCommands::messageRaised, this, say);
    connect(m_keyActions->autoAction(), &QAction::toggled, m_autoKey, &AutoKey::setOn);
    connect(m_properties, &PropertiesPanel::messageRaised, this, say);
    connect(m_player, &Player::failed, this, [say](const Error& error) { say(errorTextWithPlace(error)); });
    connect(m_validation, &ValidationPanel::separateRequested, this, &MainWindow::showSeparateDialog);
    connect(m_problem, &ProblemButton::paramRequested, this, &MainWindow::showParam);
    connect(m_help, &HelpActions::paramRequested, this, &MainWindow::showParam);
    const auto applyUnits = [this] { m_inspector->setAngleUnit(m_preferences->angleUnit()); };
    connect(m_preferences, &Preferences::changed, this, applyUnits);
    connect(m_preferences, &Preferences::failed, this, [this](const Error& error) {
        m_chooser->report(Severity::Warning,
                          tr("The preferences cannot be stored. They hold until the program ends.") + u'\n' +
                              errorTextWithPlace(error));
    });
    connect(&m_document->history(), &UndoHistory::stepsForgotten, this, [this] {
        m_chooser->report(Severity::Info,
                          tr("The oldest steps can no longer be undone: all steps together held more than "
                             "%1 of memory.")
                              .arg(locale().formattedDataSize(qint64(UndoHistory::usualMemory), 0)));
    });
    applyUnits();
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
    connect(m_timeline, &TimelinePanel::displayChanged, m_preferences,
            [this](TimeDisplay display) { m_preferences->timeDisplay.set(display); });
    m_bakes->setSave([this] { return m_files->save(); });
    apply();
}

void MainWindow::connectViewport(Viewport* view)
{
    view->setPlayer(m_player);
    view->setKeys(m_autoKey);
    connect(view, &Viewport::messageRaised, this,
            [this](const QString& text) { statusBar()->showMessage(text, messageMs); });
    connect(view, &Viewport::menuRequested, this, &MainWindow::showViewMenu);
    connect(m_edits, &EditActions::duplicated, view, &Viewport::beginMovingCopies, Qt::QueuedConnection);
    m_hints->addSource(view, view->hints());
    m_arm->setReach(view->armReach());
    m_timeline->setReach(view->armReach());
    m_properties->setOwnEdit(*findParam("arm.target"),
                             std::bind_front(&ArmReach::editTarget, view->armReach()));
    ViewMarks* marks = view->marks();
    connect(m_isolation, &Isolation::changed, marks,
            [this, marks] { marks->isolate(m_isolation->node(), m_isolation->branches()); });
    connect(m_scene, &ScenePanel::pointedAt, marks, &ViewMarks::pointAt);
    connect(view, &Viewport::hovered, m_scene, &ScenePanel::showPointed);
    connect(m_inspector, &BranchInspector::sectionInspected, marks, &ViewMarks::inspect);
    connect(m_inspector, &BranchInspector::sectionLeft, marks, [marks] { marks->inspect(noNode, 0, 0); });
    connect(m_validation, &ValidationPanel::defectActivated, view, &Viewport::showDefect);
    connect(m_validation, &ValidationPanel::defectLeft, view, &Viewport::clearDefect);
}

void MainWindow::showViewMenu(const QPoint& at, NodeId node, Index branch)
{
    ViewMenuActions actions;
    actions.branches =
        m_actions->find({"inspect.show", "inspect.roll", "edit.straighten"}) + m_hands->branchActions();
    actions.branches += m_recipes->menu()->menuAction();
    actions.gestures = m_transforms->gestures();
    auto* ofCopy = new QObject(this);
    const Viewport* view = m_host->viewport();
    const auto hit = view ? view->hitAt(view->mapFromGlobal(QPointF(at))) : std::nullopt;
    if (hit && hit->node == node && hit->copy)
        actions.nodes = m_edits->copyActions(node, *hit->copy, ofCopy);
    actions.nodes += m_edits->nodeActions();
    actions.nodes += m_recipes->menu()->menuAction();
    actions.steps = m_selects->stepActions();
    actions.isolation = m_actions->find({"select.isolate", "select.showAll"});
    actions.frameSelection = m_actions->find("view.frameSelection");
    actions.view = m_actions->find({"view.frameAll"}) + m_pictures->selectionActions();
    actions.add = m_edits->addMenu();
    actions.modes = m_views->modeActions();
    actions.switches = m_views->switchActions();
    auto* menu = new ViewMenu(actions, *m_document, node, branch, this);
    ofCopy->setParent(menu);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->popup(at);
}

void MainWindow::showInspector()
{
    showPanel(m_inspector);
}

void MainWindow::follow(const Change& change)
{
    if (change.has(changeSelection | changeReset))
        m_actions->update(this);
    if (change.has(changeFile | changeReset))
        updateTitle();
    if (change.has(changeReset)) {
        m_host->settings()->beginDocument();
        m_properties->clearSearch();
        m_keyActions->autoAction()->setChecked(false);
    }
}

void MainWindow::showParam(const QString& key)
{
    const ParamDef* def = findParam(key.toStdString());
    if (!def)
        return;
    const NodeId node = nodeWithParam(*m_document, *def);
    if (node == noNode)
        return statusBar()->showMessage(
            QStringLiteral("%1: %2").arg(coreText(def->label), whyNoNode(*m_document, *def)), messageMs);
    showPanel(m_properties);
    const std::vector<NodeId>& shown = m_properties->nodes();
    const auto actsOn = [&](NodeId id) {
        const Node* each = m_document->scene().find(id);
        return hasParam(each->kind, *def) && acts(each->params, *def);
    };
    if (!std::ranges::all_of(shown, actsOn) || std::ranges::count(shown, node) == 0)
        m_document->setSelection({{node}, noNode, {}, noIndex});
    m_properties->showParam(key);
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
    m_preferences->windowGeometry.set(saveGeometry());
    m_preferences->windowState.set(saveState(layoutVersion));
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    if (event->mimeData()->hasFormat(QLatin1String(presetMimeType)) ||
        !droppedFile(event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

MainWindow::DropPlace MainWindow::dropPlace(QPointF at) const
{
    const Viewport* view = m_host->viewport();
    const QPointF inView = view ? QPointF(view->mapFrom(this, at.toPoint())) : QPointF();
    if (!view || !view->isVisible() || !view->rect().contains(inView.toPoint()))
        return {};
    const NodeId node = view->hitAt(inView).value_or(PickHit()).node;
    return m_edits->canBecome(node) ? DropPlace{node, {}} : DropPlace{noNode, view->groundAt(inView)};
}

/// Says what letting go would do.
void MainWindow::dragMoveEvent(QDragMoveEvent* event)
{
    event->acceptProposedAction();
    if (!event->mimeData()->hasFormat(QLatin1String(presetMimeType)))
        return;
    const DropPlace target = dropPlace(event->position());
    const Node* tree = m_document->scene().find(target.tree);
    QString text;
    if (tree)
        text = tr("Let go: “%1” becomes this tree").arg(QString::fromStdString(tree->name));
    else
        text = target.place ? tr("Let go: plant it here") : tr("Let go: plant it where there is room");
    statusBar()->showMessage(text, dropMessageMs);
}

void MainWindow::dropEvent(QDropEvent* event)
{
    if (event->mimeData()->hasFormat(QLatin1String(presetMimeType))) {
        event->acceptProposedAction();
        const QString preset = QString::fromUtf8(event->mimeData()->data(QLatin1String(presetMimeType)));
        const DropPlace target = dropPlace(event->position());
        if (target.tree != noNode)
            m_edits->makeLike(target.tree, preset);
        else
            m_edits->addTree(preset, target.place);
        return;
    }
    const QString path = droppedFile(event->mimeData());
    if (path.isEmpty())
        return;
    event->acceptProposedAction();
    // After the drag has ended: the question about unsaved changes must not hold the other program.
    QMetaObject::invokeMethod(
        this,
        [this, path, isAdded = event->modifiers().testFlag(Qt::ShiftModifier)] {
            if (isAdded && ImportActions::canImport(path))
                m_imports->importPath(path);
            else
                m_files->openFile(path);
        },
        Qt::QueuedConnection);
}

} // namespace ramure
