/// \file
/// Tools that move nodes in the view: their buttons, the Transform menu, the axes and steps of the strip over
/// the view, and the path and ghosts of the View menu. All choices but the tool are remembered.
#pragma once

#include <QObject>
#include <functional>

class QAction;
class QActionGroup;
class QComboBox;
class QMenu;
class QToolBar;

namespace ramure {

class ActionSet;
class GizmoSettings;
class HandSettings;
class Preferences;
class ViewportHost;

class TransformActions : public QObject
{
    Q_OBJECT
public:
    /// Nothing is owned; all must outlive the actions. \param window parent of the dialog
    TransformActions(ViewportHost* host, Preferences* preferences, ActionSet* set, QWidget* window);

    void fillMenu(QMenu* editMenu);
    /// Axes and steps.
    void fillToolBar(QToolBar* bar);
    /// The group of which one tool is chosen; the tools that shape trees join it.
    [[nodiscard]] QActionGroup* toolGroup() const { return m_tools; }
    [[nodiscard]] QList<QAction*> toolActions() const { return m_own; }
    /// Move, rotate, scale with the mouse.
    [[nodiscard]] QList<QAction*> gestures() const { return m_gestures; }
    /// Sets the words for the nodes that the gestures move: "tree", "3 nodes".
    void nameTarget(const QString& words);

private:
    void addTools(const std::function<bool()>& exists);
    void addGestures(const std::function<bool()>& exists);
    void addSwitches(const std::function<bool()>& exists);
    void take();
    void showSettings();

    ViewportHost* m_host;
    ActionSet* m_set;
    Preferences* m_preferences;
    QWidget* m_window;
    GizmoSettings* m_settings;
    HandSettings* m_hand;
    QActionGroup* m_tools;
    QList<QAction*> m_own; ///< the actions of m_tools
    QList<QAction*> m_gestures;
    QComboBox* m_spaceBox = nullptr;
};

} // namespace ramure
