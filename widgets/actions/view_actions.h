/// \file
/// The View menu: framing, display modes, visible parts, theme, units and language.
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
class Chooser;
class Document;
class Preferences;
class SkyPictureActions;
class ViewportHost;

class ViewActions : public QObject
{
    Q_OBJECT
public:
    /// Nothing is owned; all must outlive the actions.
    ViewActions(Document* document, ViewportHost* host, Preferences* preferences, Chooser* chooser,
                ActionSet* set, QObject* parent);

    /// \param panels actions that show and hide the docks.
    void fillMenu(QMenu* menu, const QList<QAction*>& panels);
    [[nodiscard]] QList<QAction*> modeActions() const;
    /// Leaves, apples, grid, ground, orthographic.
    [[nodiscard]] QList<QAction*> switchActions() const { return m_switches; }

    [[nodiscard]] SkyPictureActions* skyPictures() const { return m_skyPictures; }

signals:
    /// Reports the result of an action, or why it did nothing.
    void messageRaised(const QString& text);

private:
    void addFraming();
    void addAxes();
    void addMoves();
    void addModes();
    void addSwitches();
    void addLight();
    void addPreferences();
    void showLight();
    [[nodiscard]] bool hasView() const;
    QActionGroup* group(const QList<QAction*>& actions);

    ViewportHost* m_host;
    Preferences* m_preferences;
    ActionSet* m_set;
    BookmarkActions* m_bookmarks;
    CameraActions* m_cameras;
    SkyPictureActions* m_skyPictures;
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
};

} // namespace ramure
