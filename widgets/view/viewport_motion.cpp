// Trees that move: what the player computed is shown, and what the hand does to it.
#include "core/document/commands.h"
#include "core/session/player.h"
#include "widgets/view/viewport_private.h"
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

namespace ramure {
namespace {

constexpr double pullStrength = 8.0; ///< of the hand, see Pull
constexpr double headReach = 12.0;   ///< logical pixels around the arrow's head
constexpr double headLength = 13.0;  ///< logical pixels
constexpr std::size_t mostArrows = 64;

void paintWind(QPainter& painter, const std::optional<QPointF>& foot, const std::optional<QPointF>& head,
               bool held)
{
    if (!foot || !head)
        return;
    const QColor colour = held ? QColor(255, 200, 80) : QColor(120, 205, 255);
    QPointF way = *head - *foot;
    const double length = std::hypot(way.x(), way.y());
    way = length > 1e-6 ? way / length : QPointF(1.0, 0.0);
    const QPointF across(-way.y(), way.x());
    for (const auto& [width, ink] : {std::pair{6.0, QColor(20, 40, 60, 150)}, std::pair{3.0, colour}}) {
        painter.setPen(QPen(ink, width, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(*foot, *head);
        painter.drawLine(*head, *head - headLength * way + 0.5 * headLength * across);
        painter.drawLine(*head, *head - headLength * way - 0.5 * headLength * across);
    }
    painter.setPen(QPen(QColor(20, 40, 60, 190), 1.0));
    painter.setBrush(colour);
    painter.drawEllipse(*foot, 4.0, 4.0);
    painter.drawEllipse(*head, 5.0, 5.0);
}

} // namespace

void Viewport::setPlayer(Player* player)
{
    d->player = d->context.player = player;
    d->reach.setPlayer(player);
    connect(player, &Player::motionChanged, this, [this] {
        const auto motion = d->player->motion();
        const auto reshapes = [](const std::shared_ptr<const MotionFrame>& frame) {
            return frame && (!frame->trees.empty() ||
                             std::ranges::any_of(frame->nodes,
                                                 [](const auto& entry) { return entry.second.reshapes; }));
        };
        if (reshapes(motion) || reshapes(d->wishedMotion)) { // trees of another shape: another scene
            d->wishedMotion = motion;
            wishScene();
        }
        update();
    });
    connect(player, &Player::frameChanged, this, [this] {
        if (!d->player->isPlaying())
            updateTrail();
        update();
    });
    connect(player, &Player::playingChanged, this, [this](bool playing) {
        updateTrail();
        updateHint();
        if (!playing)
            letGo();
    });
    update();
}

/// The scene as it is now, from the scene at rest and the player's frame.
void Viewport::Private::updateShown()
{
    auto motion = motionOfNow();
    if (limbPose)
        motion = limbPose->motion(motion);
    if (shown && shownOf == scene && shownMotion == motion && shownTrail == trail.revision() &&
        shownDefect == defect.revision())
        return;
    const bool moves = motion && MovingScene::moves(*scene, *motion);
    shown = moves ? std::make_shared<const RenderScene>(moving.moved(*scene, *motion)) : scene;
    shownOf = scene;
    shownMotion = motion;
    shownTrail = trail.revision();
    shownDefect = defect.revision();
    if (defect.isShown()) {
        auto marked = std::make_shared<RenderScene>(*shown); // of shared blocks: quickly copied
        defect.addTo(*marked);
        shown = std::move(marked);
    }
    if (!limb) // under the hand nothing is picked
        picker.setScene(shown);
    if (trail.isEmpty())
        return;
    auto more = std::make_shared<RenderScene>(*shown);
    trail.addTo(*more, [this](NodeId id) { return resultOf(id); });
    shown = std::move(more);
}

/// The box of a tree at rest, its own space: what stands on a tree that sways must not sway with it.
Box Viewport::Private::treeBox(NodeId node) const
{
    Box box;
    for (const MeshItem& item : scene->meshes)
        if (item.node == node)
            box.add(item.box);
    for (const LineItem& item : scene->lines)
        if (item.node == node)
            box.add(item.lines->box);
    return box;
}

std::vector<WindArrow> Viewport::Private::windArrows(QSize size) const
{
    if (!settings->windVisible())
        return {};
    if (wind) { // it grows and turns under the hand, but stays where it was taken
        const auto now = windArrow(document->scene(), wind->node, wind->foot, wind->reach);
        return now ? std::vector{*now} : std::vector<WindArrow>();
    }
    const NodeId active = document->selection().activeNode();
    const auto trees = windyTrees(document->scene(), active, mostArrows);
    const auto* shownTrees = std::get_if<std::vector<NodeId>>(&trees);
    if (!shownTrees)
        return {};
    const PickView view{camera, glm::dvec2(std::max(1, size.width()), std::max(1, size.height()))};
    std::vector<WindArrow> arrows;
    for (const NodeId tree : *shownTrees) {
        const bool stays = tree == active || shownTrees->size() == 1;
        if (const auto arrow = windArrowOver(document->scene(), tree, treeBox(tree), view, stays))
            arrows.push_back(*arrow);
    }
    return arrows;
}

/// Where there is nothing to see, it is said why.
void Viewport::explainWind(bool visible)
{
    const auto trees = windyTrees(d->document->scene(), d->document->selection().activeNode(), 1);
    const auto* none = std::get_if<NoWind>(&trees);
    if (!visible || !none)
        return;
    emit messageRaised(
        *none == NoWind::NoTree
            ? tr("There is no tree for a wind to blow on.")
            : tr("No wind blows in this scene: select a tree to set its wind with the arrow."));
}

/// A press that the hand takes: the wind's head, or, while trees move, a branch.
bool Viewport::beginMotionGesture(const PickView& view, const glm::dvec2& pixel)
{
    if (beginRing(view, pixel))
        return true;
    for (const WindArrow& arrow : d->windArrows(size())) {
        const auto ndc = d->camera.project(arrow.head, view.aspect());
        const glm::dvec2 head =
            ndc ? 0.5 * glm::dvec2(ndc->x + 1.0, 1.0 - ndc->y) * view.size : glm::dvec2(-1e9);
        if (glm::length(head - pixel) <= headReach && !d->document->scene().isLocked(arrow.node)) {
            d->wind = arrow;
            d->windGesture = newGesture();
            d->gesture = Gesture::Wind;
            return true;
        }
    }
    return beginPull(view, pixel);
}

/// While it plays: the hand on the branch under the cursor.
bool Viewport::beginPull(const PickView& view, const glm::dvec2& pixel)
{
    if (!d->player || !d->player->isPlaying())
        return false;
    const auto grabbed = branchUnder(view, pixel, *d->document, *d->player->motion());
    if (!grabbed)
        return false;
    d->grabbed = *grabbed;
    d->gesture = Gesture::Pull;
    dragMotion(view, pixel);
    return true;
}

void Viewport::dragMotion(const PickView& view, const glm::dvec2& pixel)
{
    if (d->gesture == Gesture::Wind) {
        const auto values = d->wind ? windAt(view, pixel, *d->wind, d->document->scene()) : std::nullopt;
        if (values)
            edit::setParams(*d->document, {d->wind->node},
                            {{findParam("physics.windStrength"), values->strength},
                             {findParam("physics.windDirection"), values->directionRad}},
                            tr("Change the wind"), d->windGesture);
        return;
    }
    d->handAt = pulledTo(view, pixel, d->grabbed.point);
    const glm::dmat4 inverse =
        glm::inverse(d->player->motion()->geometryOf(d->document->scene(), d->grabbed.node));
    d->player->setPull(d->grabbed.node, Pull{d->grabbed.branch, d->grabbed.along,
                                             glm::dvec3(inverse * glm::dvec4(d->handAt, 1.0)), pullStrength});
}

void Viewport::letGo()
{
    if (d->player && d->grabbed.node != noNode)
        d->player->setPull(d->grabbed.node, {});
    d->grabbed = {};
    finishLimb(true);
    d->ring.reset();
    d->wind.reset();
    d->builder.dispose(std::exchange(d->aimedScene, nullptr));
    if (d->gesture == Gesture::Pull || d->gesture == Gesture::Wind || d->gesture == Gesture::Aim ||
        d->gesture == Gesture::Ring) {
        d->gesture = Gesture::None;
        d->button = Qt::NoButton;
        update();
    }
}

/// A double click while trees move: the apple under the cursor falls.
bool Viewport::shakeOffAt(const PickView& view, const glm::dvec2& pixel)
{
    if (!d->player || !d->player->isPlaying())
        return false;
    const auto apple = appleUnder(view, pixel, *d->document, *d->player->motion());
    if (apple)
        d->player->shakeOff(apple->node, apple->apple);
    return apple.has_value();
}

/// The wind's arrow, and the string from the hand to the branch that it holds.
void Viewport::paintMotion(QPainter& painter)
{
    const auto point = [this](const glm::dvec3& world) -> std::optional<QPointF> {
        const auto ndc = d->camera.project(world, double(width()) / std::max(1, height()));
        if (!ndc)
            return std::nullopt;
        return QPointF(0.5 * (ndc->x + 1.0) * width(), 0.5 * (1.0 - ndc->y) * height());
    };
    painter.setRenderHint(QPainter::Antialiasing);
    paintArm(painter);
    if (d->gesture == Gesture::Pull) {
        const auto hand = point(d->handAt);
        if (hand) {
            painter.setPen(QPen(QColor(255, 255, 255, 220), 2.0));
            painter.setBrush(QColor(255, 140, 30));
            painter.drawEllipse(*hand, 5.0, 5.0);
        }
    }
    if (d->gesture == Gesture::Limb)
        if (const auto hand = point(d->limb->hand()))
            paintReach(painter, *hand);
    for (const WindArrow& arrow : d->windArrows(size()))
        paintWind(painter, point(arrow.foot), point(arrow.head), d->gesture == Gesture::Wind);
}

} // namespace ramure
