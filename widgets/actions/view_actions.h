/// \file
/// The View menu: framing, display modes, what is shown, theme, units and language.
#pragma once

#include <QList>
#include <QObject>

class QAction;
class QActionGroup;
class QMenu;

namespace ramure {

class ActionSet;
class BookmarkActions;
class CameraActions;
class Document;
class Preferences;
class ViewportHost;

class ViewActions : public QObject
{
    Q_OBJECT
public:
    /// Nothing is owned; all must outlive the actions.
    ViewActions(Document* document, ViewportHost* host, Preferences* preferences, ActionSet* set,
                QObject* parent);

    /// \param panels actions that show and hide the docks.
    void fillMenu(QMenu* menu, const QList<QAction*>& panels, QAction* resetLayout);
    [[nodiscard]] QList<QAction*> modeActions() const;
    /// Leaves, apples, grid, ground, orthographic.
    [[nodiscard]] QList<QAction*> switchActions() const { return m_switches; }
    [[nodiscard]] QAction* frameAllAction() const { return m_frameAll; }
    [[nodiscard]] QAction* frameSelectionAction() const { return m_frameSelection; }
    /// The path and the ghosts of moving nodes: below the other switches. Before fillMenu.
    void setTrailActions(const QList<QAction*>& actions) { m_trail = actions; }

signals:
    /// What an action did, or why it did nothing.
    void messageRaised(const QString& text);

private:
    void addFraming(ActionSet* set);
    void addAxes(ActionSet* set);
    void addMoves(ActionSet* set);
    void addModes(ActionSet* set);
    void addSwitches(ActionSet* set);
    void addLight(ActionSet* set);
    void addPreferences(ActionSet* set);
    void takePreferences();

    ViewportHost* m_host;
    Preferences* m_preferences;
    BookmarkActions* m_bookmarks;
    CameraActions* m_cameras;
    QAction* m_frameAll = nullptr;
    QAction* m_frameSelection = nullptr;
    QAction* m_light = nullptr;
    QList<QAction*> m_axes;
    QList<QAction*> m_moves;
    QActionGroup* m_modes = nullptr;
    QActionGroup* m_shading = nullptr;
    QActionGroup* m_qualities = nullptr;
    QActionGroup* m_gameWinds = nullptr;
    QActionGroup* m_gameWindStrengths = nullptr;
    QActionGroup* m_themes = nullptr;
    QActionGroup* m_units = nullptr;
    QActionGroup* m_languages = nullptr;
    QList<QAction*> m_switches;
    QList<QAction*> m_trail;
};

} // namespace ramure
