// What the hand reaches for with Ctrl: a branch of a tree at rest, whose limb follows.
#include "core/document/player.h"
#include "widgets/viewport/viewport_private.h"
#include <QPainter>

namespace ramure {
namespace {

constexpr std::chrono::milliseconds patience(8); ///< how long a press may hold the interface up

} // namespace

/// \return whether the press is taken; else it selects
bool Viewport::beginReach(const PickView& view, const glm::dvec2& pixel)
{
    if (d->isStale())
        return false;
    const auto scene = d->picker.readyWithin(patience);
    const auto hit = scene ? scene->pick(view, pixel) : std::nullopt;
    if (!hit)
        return false;
    const auto motion = d->player ? d->player->motion() : nullptr;
    const NodeMotion* moved = motion ? motion->of(hit->node) : nullptr;
    if (moved && moved->moves())
        return false; // a bend is of the tree at rest: what is seen is not
    d->limb = LimbTool::grab(*d->document, *hit, d->limbBranches);
    if (!d->limb)
        return false;
    d->gesture = Gesture::Limb;
    update();
    return true;
}

void Viewport::lengthenLimb(int branches)
{
    const auto next = static_cast<std::int64_t>(d->limb->branches()) + branches;
    d->limb->setBranches(static_cast<std::size_t>(std::max<std::int64_t>(next, 1)));
    d->limbBranches = d->limb->branches();
    update();
}

void Viewport::paintReach(QPainter& painter, QPointF hand)
{
    painter.setPen(QPen(QColor(255, 255, 255, 220), 2.0));
    painter.setBrush(QColor(90, 200, 90));
    painter.drawEllipse(hand, 5.0, 5.0);
    QString text =
        tr("%n branch(es) follow; the wheel sets how many", nullptr, static_cast<int>(d->limb->branches()));
    if (d->limb->shortBy() > 1e-3)
        text += QLatin1Char('\n') + tr("out of reach: %1 m short").arg(d->limb->shortBy(), 0, 'f', 3);
    const QRectF place(hand + QPointF(14.0, -10.0), QSizeF(420.0, 60.0));
    painter.setPen(QColor(0, 0, 0, 160));
    painter.drawText(place.translated(1.0, 1.0), text);
    painter.setPen(Qt::white);
    painter.drawText(place, text);
}

} // namespace ramure
