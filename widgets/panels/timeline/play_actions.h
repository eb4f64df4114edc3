/// \file
/// Actions that drive the player, with keys for menu, panel and shortcuts dialog.
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
    [[nodiscard]] ActionSet* set() const { return m_set; }
    /// First, back, play, stop, forward, last: as they stand in the panel.
    [[nodiscard]] QList<QAction*> transport() const;
    /// Once, loop, ping-pong: one of them is on.
    [[nodiscard]] QList<QAction*> loops() const { return m_loops; }
    /// Adds the choices for the last frame: whether to loop, and whether to show the seam.
    void fillLoopMenu(QMenu* menu) const;
    void fillMenu(QMenu* menu) const;

private:
    void addTransport();
    void addLoops();
    void update();
    void shake();

    Document* m_document;
    Player* m_player;
    ActionSet* m_set;
    ViewSettings* m_view = nullptr; ///< once it is set
    QList<QAction*> m_loops;        ///< by PlayLoop
    std::size_t m_nextApple = 0;
};

} // namespace ramure
