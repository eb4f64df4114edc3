#include "widgets/panels/timeline/play_actions.h"

#include "core/qt/document/commands.h"
#include "core/qt/session/motion/player.h"
#include "widgets/base/action_set.h"
#include "widgets/view/view_settings.h"
#include <QActionGroup>
#include <QIcon>
#include <QMenu>

namespace ramure {

PlayActions::PlayActions(Document* document, Player* player, ActionSet* set, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_player(player)
    , m_play(set->add({"play.toggle", QT_TRANSLATE_NOOP("Actions", "&Play"), "play",
                       QKeySequence(Qt::SHIFT | Qt::Key_Space),
                       QT_TRANSLATE_NOOP("Actions", "Let the trees move, or pause")}))
    , m_stop(set->add(
          {"play.stop", QT_TRANSLATE_NOOP("Actions", "&Stop"), "stop",
           QKeySequence(Qt::CTRL | Qt::Key_Period),
           QT_TRANSLATE_NOOP("Actions", "Back to the first frame; pulls and fallen apples are forgotten")}))
    , m_forward(set->add({"play.forward", QT_TRANSLATE_NOOP("Actions", "&Next frame"), "step-forward",
                          QKeySequence(Qt::Key_Period), nullptr}))
    , m_back(set->add({"play.back", QT_TRANSLATE_NOOP("Actions", "Pre&vious frame"), "step-back",
                       QKeySequence(Qt::Key_Comma), nullptr}))
    , m_first(set->add({"play.first", QT_TRANSLATE_NOOP("Actions", "&First frame"), "to-first",
                        QKeySequence(Qt::SHIFT | Qt::Key_Comma), nullptr}))
    , m_last(set->add({"play.last", QT_TRANSLATE_NOOP("Actions", "&Last frame"), "to-last",
                       QKeySequence(Qt::SHIFT | Qt::Key_Period), nullptr}))
    , m_everyFrame(
          set->add({"play.everyFrame",
                    QT_TRANSLATE_NOOP("Actions", "&Every frame"),
                    "every-frame",
                    {},
                    QT_TRANSLATE_NOOP("Actions", "Show all frames, if need be slower; off: keep time and "
                                                 "drop frames that come too late")}))
    , m_shake(
          set->add({"play.shake",
                    QT_TRANSLATE_NOOP("Actions", "S&hake off an apple"),
                    "apple",
                    {},
                    QT_TRANSLATE_NOOP("Actions", "While playing, the next apple of the active tree falls; or "
                                                 "double-click on one")}))
    , m_wind(set->add(
          {"play.wind", QT_TRANSLATE_NOOP("Actions", "&Wind arrow"), "wind",
           QKeySequence(Qt::SHIFT | Qt::Key_W),
           QT_TRANSLATE_NOOP("Actions", "Show the wind of the active tree, and of all that have some, as "
                                        "arrows; drag a head to turn and strengthen the wind")}))
{
    addLoops(set);
    connectActions();
}

void PlayActions::addLoops(ActionSet* set)
{
    m_loops = {set->add({"play.once",
                         QT_TRANSLATE_NOOP("Actions", "Play &once"),
                         "play-once",
                         {},
                         QT_TRANSLATE_NOOP("Actions", "Stop at the last frame")}),
               set->add({"play.loop",
                         QT_TRANSLATE_NOOP("Actions", "&Loop"),
                         "play-loop",
                         {},
                         QT_TRANSLATE_NOOP("Actions", "Go on with the first frame after the last")}),
               set->add({"play.pingPong",
                         QT_TRANSLATE_NOOP("Actions", "P&ing-pong"),
                         "play-ping-pong",
                         {},
                         QT_TRANSLATE_NOOP("Actions", "Play forwards and back again")})};
    m_seamless =
        set->add({"play.seamless",
                  QT_TRANSLATE_NOOP("Actions", "Sea&mless loop"),
                  "play-seamless",
                  {},
                  QT_TRANSLATE_NOOP("Actions", "Blend the last second of the loop into its first frame, so "
                                               "that trees and arms go on without a jump")});
    m_seamless->setCheckable(true);
    connect(m_seamless, &QAction::triggered, this, [this](bool on) {
        TimelineSettings settings = m_document->scene().timeline();
        settings.seamless = on;
        edit::setTimeline(*m_document, settings);
    });
    m_everyFrame->setCheckable(true);
    m_wind->setCheckable(true);
    connect(m_shake, &QAction::triggered, this, &PlayActions::shake);
    auto* group = new QActionGroup(this);
    for (qsizetype i = 0; i < m_loops.size(); ++i) {
        m_loops[i]->setCheckable(true);
        group->addAction(m_loops[i]);
        connect(m_loops[i], &QAction::triggered, this, [this, i] {
            TimelineSettings settings = m_document->scene().timeline();
            settings.loop = static_cast<PlayLoop>(i);
            edit::setTimeline(*m_document, settings);
        });
    }
}

void PlayActions::connectActions()
{
    connect(m_play, &QAction::triggered, m_player, &Player::toggle);
    connect(m_stop, &QAction::triggered, m_player, &Player::stop);
    connect(m_forward, &QAction::triggered, m_player, &Player::stepForward);
    connect(m_back, &QAction::triggered, m_player, &Player::stepBack);
    connect(m_first, &QAction::triggered, m_player, &Player::toFirst);
    connect(m_last, &QAction::triggered, m_player, &Player::toLast);
    connect(m_everyFrame, &QAction::toggled, m_player,
            [this](bool on) { m_player->setPace(on ? PlayPace::EveryFrame : PlayPace::RealTime); });
    connect(m_player, &Player::playingChanged, this, &PlayActions::update);
    connect(m_player, &Player::settingsChanged, this, &PlayActions::update);
    connect(m_document, &Document::changed, this, [this](const Change& change) {
        if (change.has(changeTimeline | changeReset))
            update();
    });
    update();
}

QList<QAction*> PlayActions::transport() const
{
    return {m_first, m_back, m_play, m_stop, m_forward, m_last};
}

void PlayActions::fillMenu(QMenu* menu) const
{
    menu->addActions({m_play, m_stop});
    menu->addSeparator();
    menu->addActions({m_back, m_forward, m_first, m_last});
    menu->addSeparator();
    fillLoopMenu(menu);
    menu->addSeparator();
    menu->addActions({m_everyFrame, m_wind, m_shake});
}

void PlayActions::fillLoopMenu(QMenu* menu) const
{
    menu->addActions(m_loops);
    menu->addAction(m_seamless);
}

void PlayActions::setView(ViewSettings* settings)
{
    m_wind->setChecked(settings->windVisible());
    connect(m_wind, &QAction::toggled, settings, &ViewSettings::setWindVisible);
    connect(settings, &ViewSettings::windVisibleChanged, m_wind, &QAction::setChecked);
}

/// One after the other; those that lie on the ground already stay there.
void PlayActions::shake()
{
    const NodeId node = m_document->selection().activeNode();
    const NodeResult* result = m_document->result(node);
    if (!result || !result->tree.foliage || result->tree.foliage->apples.empty())
        return;
    m_player->shakeOff(node, static_cast<Index>(m_nextApple++ % result->tree.foliage->apples.size()));
}

/// The button shows what a press does.
void PlayActions::update()
{
    const bool playing = m_player->isPlaying();
    m_shake->setEnabled(playing);
    if (!playing)
        m_nextApple = 0;
    m_play->setText(playing ? tr("&Pause") : tr("&Play"));
    m_play->setIcon(
        QIcon::fromTheme(playing ? QStringLiteral("ramure-pause") : QStringLiteral("ramure-play")));
    m_everyFrame->setChecked(m_player->pace() == PlayPace::EveryFrame);
    const TimelineSettings& timeline = m_document->scene().timeline();
    m_loops[static_cast<qsizetype>(timeline.loop)]->setChecked(true);
    m_seamless->setChecked(timeline.seamless);
    m_seamless->setEnabled(timeline.loop == PlayLoop::Loop);
}

} // namespace ramure
