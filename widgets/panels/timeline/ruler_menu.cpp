#include "widgets/panels/timeline/ruler_menu.h"

#include "core/qt/document/commands.h"
#include "core/qt/session/motion/player.h"
#include "widgets/base/theme/icons.h"
#include "widgets/base/timeline_ruler.h"
#include "widgets/panels/timeline/bake_actions.h"
#include "widgets/panels/timeline/play_actions.h"
#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <algorithm>

namespace ramure {

RulerMenu::RulerMenu(Document* document, Player* player, PlayActions* plays, QWidget* parent)
    : QObject(parent)
    , m_document(document)
    , m_player(player)
    , m_menu(new QMenu(parent))
    , m_insert(nullptr)
{
    m_menu->setObjectName(QStringLiteral("rulerMenu"));
    m_go = m_menu->addAction(QString(), this, [this] { m_player->seek(m_frame); });
    m_insertHere = m_menu->addAction(icon("key-insert"), QString(), this, [this] {
        m_player->seek(m_frame);
        m_insert->trigger();
    });
    m_insertHere->setVisible(false);
    m_menu->addSeparator();
    m_first = m_menu->addAction(icon("to-first"), QString(), this, [this] { setRange(true); });
    m_last = m_menu->addAction(icon("to-last"), QString(), this, [this] { setRange(false); });
    m_menu->addAction(tr("Show the &whole range"), this, [this] {
        if (m_ruler)
            m_ruler->showRange();
    });
    m_menu->addSeparator();
    plays->fillLoopMenu(m_menu->addMenu(tr("At the &end")));
    QMenu* displays = m_menu->addMenu(tr("Show &moments as"));
    auto* group = new QActionGroup(displays);
    for (const auto& [display, text] : {std::pair(TimeDisplay::Frames, tr("Frames")),
                                        {TimeDisplay::Seconds, tr("Seconds")},
                                        {TimeDisplay::Timecode, tr("Timecode")}}) {
        QAction* choice =
            displays->addAction(text, this, [this, display = display] { emit displayChosen(display); });
        choice->setCheckable(true);
        group->addAction(choice);
        m_displayActions += choice;
    }
    setDisplay(TimeDisplay::Frames);
}

void RulerMenu::addBake(const BakeActions* bakes)
{
    m_menu->addSeparator();
    bakes->fillMenu(m_menu);
}

void RulerMenu::addInsert(QAction* insert)
{
    m_insert = insert;
    m_insertHere->setVisible(true);
}

void RulerMenu::setDisplay(TimeDisplay display)
{
    m_displayActions[static_cast<qsizetype>(display)]->setChecked(true);
}

/// The other end moves along where it would come to lie on the wrong side.
void RulerMenu::setRange(bool first)
{
    TimelineSettings settings = m_document->scene().timeline();
    (first ? settings.firstFrame : settings.lastFrame) = m_frame;
    if (first)
        settings.lastFrame = std::max<std::int64_t>(settings.lastFrame, m_frame);
    else
        settings.firstFrame = std::min<std::int64_t>(settings.firstFrame, m_frame);
    edit::setTimeline(*m_document, settings);
}

void RulerMenu::popUp(TimelineRuler* ruler, const QPoint& place, qint64 frame)
{
    m_ruler = ruler;
    m_frame = frame;
    m_go->setText(tr("&Go to frame %1").arg(m_frame));
    m_insertHere->setText(tr("Insert &keys at frame %1").arg(m_frame));
    m_first->setText(tr("&First frame of the range: %1").arg(m_frame));
    m_last->setText(tr("&Last frame of the range: %1").arg(m_frame));
    const TimelineSettings& settings = m_document->scene().timeline();
    m_go->setEnabled(frame != m_player->frame());
    m_first->setEnabled(frame != settings.firstFrame);
    m_last->setEnabled(frame != settings.lastFrame);
    if (m_insert)
        m_insertHere->setEnabled(m_insert->isEnabled());
    m_menu->popup(place);
}

} // namespace ramure
