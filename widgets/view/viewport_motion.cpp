// What moves: what the player computed is shown, with what follows the hand, paths and ghosts.
#include "core/qt/session/motion/auto_key.h"
#include "core/qt/session/motion/player.h"
#include "widgets/view/tools/motion_tools.h"
#include "widgets/view/viewport_private.h"
#include <algorithm>
#include <utility>

namespace ramure {

void Viewport::setKeys(AutoKey* keys)
{
    d->context.keys = keys;
    d->reach.setKeys(keys);
    connect(keys, &AutoKey::changed, this, qOverload<>(&QWidget::update));
}

ArmReach* Viewport::armReach() const
{
    return &d->reach;
}

void Viewport::setPlayer(Player* player)
{
    d->context.player = player;
    d->reach.setPlayer(player);
    connect(player, &Player::motionChanged, this, [this, player] {
        d->settling.start();
        const auto motion = player->motion();
        const auto reshapes = [](const std::shared_ptr<const MotionFrame>& frame) {
            return frame && (!frame->trees.empty() ||
                             std::ranges::any_of(frame->nodes,
                                                 [](const auto& entry) { return entry.second.reshapes; }));
        };
        if (reshapes(motion) || reshapes(d->wishedMotion)) { // trees of another shape: another scene
            d->wishedMotion = motion;
            wishScene();
        }
        d->noteAge();
        update();
    });
    connect(player, &Player::busyChanged, this, [this] { d->noteAge(); });
    connect(player, &Player::frameChanged, this, [this, player] {
        if (!player->isPlaying())
            updateTrail();
        d->noteAge();
        update();
    });
    connect(player, &Player::playingChanged, this, [this](bool playing) {
        updateTrail();
        d->updateHint();
        if (!playing)
            d->tools.playingStopped();
    });
    update();
}

/// The player's frame, and in it what is on its way or follows the hand.
std::shared_ptr<const MotionFrame> Viewport::Private::motionOfNow()
{
    auto frame = context.player ? context.player->motion() : nullptr;
    const ArmProgress* progress = reach.progress();
    if (progress && !(context.player && context.player->frame() > 0))
        frame = reachPose.motion(frame, document->scene(), *progress);
    return context.limbPose ? context.limbPose->motion(frame) : frame;
}

void Viewport::Private::updateShown()
{
    shown.update(scene, motionOfNow(), defect, trail, [this](NodeId id) { return resultOf(id); });
    const bool byHand = context.limbPose && context.limbPose->isHeld(); // then nothing is picked
    if (const auto toPickIn = byHand ? nullptr : shown.takeToPickIn())
        picker.setScene(toPickIn);
}

/// Paths and ghosts follow the selection, the document and the playhead.
void Viewport::updateTrail()
{
    const GizmoSettings& how = *d->settings->gizmo();
    if (!how.showsPath() && !how.showsGhosts() && d->trail.isEmpty())
        return;
    const Player* player = d->context.player;
    const std::int64_t frame = player ? player->frame() : d->document->scene().timeline().firstFrame;
    d->trail.show(d->document->scene(), d->document->selection().nodes, how, frame, !d->context.isPlaying());
}

/// Where there is nothing to see, it is said why.
void Viewport::explainWind()
{
    const auto trees = windyTrees(d->document->scene(), d->document->selection().activeNode(), 1);
    const auto* none = std::get_if<NoWind>(&trees);
    if (!d->settings->windVisible() || !none)
        return;
    emit messageRaised(
        *none == NoWind::NoTree
            ? tr("There is no tree for a wind to blow on.")
            : tr("No wind blows in this scene: select a tree to set its wind with the arrow."));
}

/// Anything of what is shown: trees that the timeline moves do not.
bool Viewport::Private::isWindy() const
{
    return settings->gameWind() != WindProfile::None &&
           std::ranges::any_of(shownScene().meshes,
                               [](const MeshItem& item) { return item.motion.wind != nullptr; });
}

/// It begins anew with each choice.
void Viewport::beginGameWind()
{
    if (d->settings->gameWind() == WindProfile::None)
        return d->windClock.invalidate();
    if (!d->windClock.isValid())
        d->windClock.start();
    const auto& nodes = d->document->scene().nodes();
    if (std::ranges::none_of(nodes, [](const Node& node) { return node.kind == NodeKind::Tree; }))
        emit messageRaised(tr("There is no tree for a wind to blow on."));
    else if (d->context.player && d->context.player->isPlaying())
        emit messageRaised(tr("Trees that the timeline moves do not stand in the wind of a game."));
}

} // namespace ramure
