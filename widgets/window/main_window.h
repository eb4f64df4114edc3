/// \file
/// The window: builds menus, toolbar, docks and status bar, and connects them. Everything else is elsewhere.
#pragma once

#include "core/qt/document/document.h"
#include <QMainWindow>
#include <memory>

class QVBoxLayout;

namespace ramure {

class ArmPanel;
class ActionSet;
class Analysis;
class AutoKey;
class BakeActions;
class BillboardActions;
class BranchInspector;
class Chooser;
class EditActions;
class FileActions;
class HandActions;
class RecipeActions;
class HelpActions;
class HintLine;
class Isolation;
class IsolationButton;
class Job;
class JobPanel;
class KeyActions;
class KeyModel;
class KeyPanel;
class MessageBanner;
class ImportActions;
class PictureActions;
class Player;
class Preferences;
class ProblemButton;
class PropertiesPanel;
class Recompute;
class ScenePanel;
class SelectActions;
class StatusPanel;
class TimelinePanel;
class TransformActions;
class ValidationPanel;
class ViewActions;
class Viewport;
class ViewportHost;
class WelcomePanel;
struct PanelRow;

class MainWindow : public QMainWindow
{
    Q_OBJECT
public:
    /// Nothing is owned; all must outlive the window.
    MainWindow(Document* document, Recompute* recompute, Preferences* preferences, Chooser* chooser,
               QWidget* parent = nullptr);
    ~MainWindow() override;

    [[nodiscard]] FileActions* files() const { return m_files; }
    [[nodiscard]] EditActions* edits() const { return m_edits; }
    [[nodiscard]] ActionSet* actionSet() const { return m_actions; }
    [[nodiscard]] MessageBanner* banner() const { return m_banner; }
    [[nodiscard]] PropertiesPanel* properties() const { return m_properties; }
    [[nodiscard]] ScenePanel* scenePanel() const { return m_scene; }
    [[nodiscard]] StatusPanel* status() const { return m_status; }
    [[nodiscard]] HintLine* hints() const { return m_hints; }
    [[nodiscard]] ProblemButton* problem() const { return m_problem; }
    [[nodiscard]] BranchInspector* inspector() const { return m_inspector; }
    [[nodiscard]] Isolation* isolation() const { return m_isolation; }
    [[nodiscard]] ViewportHost* viewportHost() const { return m_host; }
    [[nodiscard]] Player* player() const { return m_player; }
    [[nodiscard]] TimelinePanel* timeline() const { return m_timeline; }
    [[nodiscard]] KeyPanel* keys() const { return m_keys; }
    [[nodiscard]] KeyModel* keyModel() const { return m_keyModel; }
    [[nodiscard]] HelpActions* help() const { return m_help; }
    [[nodiscard]] Analysis* analysis() const { return m_analysis; }

    void showWelcome();
    /// Opens the dialog for this tree, else for the active tree, else for the first one.
    void showSeparateDialog(NodeId tree = noNode);
    void resetLayout();
    /// Shows the properties with this parameter in focus, of a node that has it.
    void showParam(const QString& key);

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    class Exports; // main_window_export.h
    static constexpr int messageMs = 6000, dropMessageMs = 1500;
    static constexpr int layoutVersion = 5; ///< of saveState; another one means another set of docks

    /// The place where a tree of the gallery is dropped.
    struct DropPlace
    {
        NodeId tree = noNode;            ///< that it would change
        std::optional<glm::dvec3> place; ///< else the place where it is planted; unset: a free place
    };
    [[nodiscard]] DropPlace dropPlace(QPointF at) const;

    void addPanel(const PanelRow& row, QWidget* content);
    /// Returns the dock of a panel of the table.
    [[nodiscard]] static QDockWidget* dockOf(const QWidget* panel);
    static void showPanel(const QWidget* panel);
    void buildDocks();
    void connectKeys();
    void buildActions();
    void buildManyTrees();
    void buildBranchActions();
    void buildMenus();
    void buildToolBar();
    void buildHandBar(QVBoxLayout* column);
    void buildStatusBar();
    JobPanel* addJob(Job* job, const char* name);
    void connectPanels();
    void connectViewport(Viewport* view);
    void connectTimeline();
    void showInspector();
    void showViewMenu(const QPoint& at, NodeId node, Index branch);
    void follow(const Change& change);
    void updateTitle();
    void restoreLayout();

    Document* m_document;
    Recompute* m_recompute;
    Analysis* m_analysis;
    Preferences* m_preferences;
    Chooser* m_chooser;
    ActionSet* m_actions;
    Isolation* m_isolation;
    MessageBanner* m_banner = nullptr; ///< over the view
    ViewportHost* m_host;
    Player* m_player;
    ScenePanel* m_scene = nullptr;
    PropertiesPanel* m_properties = nullptr;
    BranchInspector* m_inspector = nullptr;
    ValidationPanel* m_validation = nullptr;
    TimelinePanel* m_timeline = nullptr;
    BakeActions* m_bakes = nullptr;
    KeyModel* m_keyModel = nullptr;
    KeyActions* m_keyActions = nullptr;
    AutoKey* m_autoKey = nullptr;
    KeyPanel* m_keys = nullptr;
    StatusPanel* m_status = nullptr;
    ProblemButton* m_problem = nullptr;
    HintLine* m_hints = nullptr;
    FileActions* m_files = nullptr;
    EditActions* m_edits = nullptr;
    SelectActions* m_selects = nullptr;
    ViewActions* m_views = nullptr;
    TransformActions* m_transforms = nullptr;
    HandActions* m_hands = nullptr;
    RecipeActions* m_recipes = nullptr;
    ImportActions* m_imports = nullptr;
    PictureActions* m_pictures = nullptr;
    BillboardActions* m_billboards = nullptr;
    HelpActions* m_help = nullptr;
    WelcomePanel* m_welcome = nullptr;
    QToolBar* m_toolBar = nullptr;
    ArmPanel* m_arm = nullptr;
    std::unique_ptr<Exports> m_exports;
    QList<QDockWidget*> m_docks; ///< one for each row of panels()
};

} // namespace ramure
