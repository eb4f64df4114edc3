/// \file
/// What drives the player: actions with keys for menu, panel and shortcuts dialog.
#pragma once

#include <QList>
#include <QObject>

class QAction;
class QMenu;

namespace ramure {

class ActionSet;
class Document;
class Player;
class ViewSettings;

class PlayActions : public QObject
{
    Q_OBJECT
public:
    /// Nothing is owned; all must outlive the object.
    PlayActions(Document* document, Player* player, ActionSet* set, QObject* parent = nullptr);

    /// The wind's arrow is switched on there.
    void setView(ViewSettings* settings);
    [[nodiscard]] QAction* playAction() const { return m_play; }
    [[nodiscard]] QAction* everyFrameAction() const { return m_everyFrame; }
    /// First, back, play, stop, forward, last: as they stand in the panel.
    [[nodiscard]] QList<QAction*> transport() const;
    /// Once, loop, ping-pong: one of them is on.
    [[nodiscard]] QList<QAction*> loops() const { return m_loops; }
    /// Checkable: the end of the loop blends into its beginning.
    /// What happens at the last frame: loops, and whether the seam shows.
    void fillLoopMenu(QMenu* menu) const;
    void fillMenu(QMenu* menu) const;

private:
    void addLoops(ActionSet* set);
    void connectActions();
    void update();
    void shake();

    Document* m_document;
    Player* m_player;
    QAction* m_play;
    QAction* m_stop;
    QAction* m_forward;
    QAction* m_back;
    QAction* m_first;
    QAction* m_last;
    QAction* m_everyFrame;
    QAction* m_shake;
    QAction* m_wind;
    QList<QAction*> m_loops; ///< by PlayLoop
    QAction* m_seamless;
    std::size_t m_nextApple = 0;
};

} // namespace ramure
