/// \file
/// The context menu of a ruler of frames, for the frame that was clicked.
#pragma once

#include "widgets/base/texts/time_text.h"
#include <QList>
#include <QObject>
#include <QPointer>

class QAction;
class QMenu;
class QPoint;
class QWidget;

namespace ramure {

class BakeActions;
class Document;
class PlayActions;
class Player;
class TimelineRuler;

class RulerMenu : public QObject
{
    Q_OBJECT
public:
    /// None is owned; all must outlive the menu. \param parent the widget that the menu belongs to.
    RulerMenu(Document* document, Player* player, PlayActions* plays, QWidget* parent);

    /// Adds further entries; each is called once.
    void addBake(const BakeActions* bakes);
    void addInsert(QAction* insert);
    void setDisplay(TimeDisplay display);
    /// \param ruler the one that was clicked.
    void popUp(TimelineRuler* ruler, const QPoint& place, qint64 frame);

signals:
    void displayChosen(ramure::TimeDisplay display);

private:
    void setRange(bool first);

    Document* m_document;
    Player* m_player;
    QMenu* m_menu;
    QAction *m_go, *m_first, *m_last, *m_insert, *m_insertHere;
    QList<QAction*> m_displayActions; ///< by TimeDisplay
    QPointer<TimelineRuler> m_ruler;
    qint64 m_frame = 0;
};

} // namespace ramure
