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
    , m_set(set)
{
    addTransport();
    addLoops();
    set->add(
        this,
        {{"play.everyFrame", Actions::tr("&Every frame"), "every-frame", noKeys,
          Actions::tr(
              "Show all frames, if need be slower; off: keep time and drop frames that come too late"),
          [player] {
              player->setPace(player->pace() == PlayPace::EveryFrame ? PlayPace::RealTime
                                                                     : PlayPace::EveryFrame);
          },
          nullptr, [player] { return player->pace() == PlayPace::EveryFrame; }},
         {"play.shake", Actions::tr("S&hake off an apple"), "apple", noKeys,
          Actions::tr("While playing, the next apple of the active tree falls; or double-click on one"),
          [this] { shake(); }, [player] { return player->isPlaying(); }},
         {"play.wind", Actions::tr("&Wind arrow"), "wind", Qt::SHIFT | Qt::Key_W,
          Actions::tr("Show the wind of the active tree, and of all that have some, as arrows; drag a head "
                      "to turn and strengthen the wind"),
          [this] { m_view->windVisible.set(!m_view->windVisible()); }, nullptr,
          [this] { return m_view && m_view->windVisible(); }}});
    connect(m_player, &Player::playingChanged, this, &PlayActions::update);
    connect(m_player, &Player::settingsChanged, this, &PlayActions::update);
    connect(m_document, &Document::changed, this, [this](const Change& change) {
        if (change.has(changeTimeline | changeReset))
            update();
    });
    update();
}

void PlayActions::addTransport()
{
    Player* p = m_player;
    m_set->add(this, {{"play.toggle", Actions::tr("&Play"), "play", Qt::SHIFT | Qt::Key_Space,
                       Actions::tr("Let the trees move, or pause"), [p] { p->toggle(); }},
                      {"play.stop", Actions::tr("&Stop"), "stop", Qt::CTRL | Qt::Key_Period,
                       Actions::tr("Back to the first frame; pulls and fallen apples are forgotten"),
                       [p] { p->stop(); }},
                      {"play.forward", Actions::tr("&Next frame"), "step-forward", Qt::Key_Period, QString(),
                       [p] { p->seek(p->frame() + 1); }},
                      {"play.back", Actions::tr("Pre&vious frame"), "step-back", Qt::Key_Comma, QString(),
                       [p] { p->seek(p->frame() - 1); }},
                      {"play.first", Actions::tr("&First frame"), "to-first", Qt::SHIFT | Qt::Key_Comma,
                       QString(), [this] { m_player->seek(m_document->scene().timeline().firstFrame); }},
                      {"play.last", Actions::tr("&Last frame"), "to-last", Qt::SHIFT | Qt::Key_Period,
                       QString(), [this] { m_player->seek(m_document->scene().timeline().lastFrame); }}});
}

void PlayActions::addLoops()
{
    const auto settings = [this] { return m_document->scene().timeline(); };
    const auto choose = [this, settings](PlayLoop loop) {
        return [this, settings, loop] {
            TimelineSettings next = settings();
            next.loop = loop;
            edit::setTimeline(*m_document, next);
        };
    };
    const auto isChosen = [settings](PlayLoop loop) {
        return [settings, loop] { return settings().loop == loop; };
    };
    using enum PlayLoop;
    m_loops = m_set->add(
        this,
        {{"play.once", Actions::tr("Play &once"), "play-once", noKeys, Actions::tr("Stop at the last frame"),
          choose(Once), nullptr, isChosen(Once)},
         {"play.loop", Actions::tr("&Loop"), "play-loop", noKeys,
          Actions::tr("Go on with the first frame after the last"), choose(Loop), nullptr, isChosen(Loop)},
         {"play.pingPong", Actions::tr("P&ing-pong"), "play-ping-pong", noKeys,
          Actions::tr("Play forwards and back again"), choose(PingPong), nullptr, isChosen(PingPong)}});
    auto* group = new QActionGroup(this);
    for (QAction* loop : m_loops)
        group->addAction(loop);
    m_set->add(this,
               {"play.seamless", Actions::tr("Sea&mless loop"), "play-seamless", noKeys,
                Actions::tr("Blend the last second of the loop into its first frame, so that trees and "
                            "arms go on without a jump"),
                [this, settings] {
                    TimelineSettings next = settings();
                    next.seamless = !next.seamless;
                    edit::setTimeline(*m_document, next);
                },
                [settings] { return settings().loop == Loop; }, [settings] { return settings().seamless; }});
}

QList<QAction*> PlayActions::transport() const
{
    return m_set->find({"play.first", "play.back", "play.toggle", "play.stop", "play.forward", "play.last"});
}

void PlayActions::fillMenu(QMenu* menu) const
{
    m_set->fill(menu, {"play.toggle", "play.stop", nullptr, "play.back", "play.forward", "play.first",
                       "play.last", nullptr});
    fillLoopMenu(menu);
    m_set->fill(menu, {nullptr, "play.everyFrame", "play.wind", "play.shake"});
}

void PlayActions::fillLoopMenu(QMenu* menu) const
{
    menu->addActions(m_loops);
    m_set->fill(menu, {"play.seamless"});
}

void PlayActions::setView(ViewSettings* settings)
{
    m_view = settings;
    settings->windVisible.follow(this, [this] { update(); });
    update();
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
    if (!playing)
        m_nextApple = 0;
    QAction* play = m_set->find("play.toggle");
    play->setText(playing ? tr("&Pause") : tr("&Play"));
    play->setIcon(QIcon::fromTheme(playing ? QStringLiteral("ramure-pause") : QStringLiteral("ramure-play")));
    m_set->update(this);
}

} // namespace ramure
