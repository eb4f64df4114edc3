// A limb that follows the hand: seen at once as a pose, made anew when the hand rests or lets go.
#include "widgets/view/viewport_private.h"
#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <utility>

namespace ramure {

/// How long the hand rests before the mesh of its bends is made.
static constexpr int limbRestMs = 100;

void Viewport::connectLimb()
{
    d->limbRest.setSingleShot(true);
    d->limbRest.setInterval(limbRestMs);
    connect(&d->limbRest, &QTimer::timeout, this, &Viewport::applyLimb);
}

bool Viewport::beginLimb(const PickHit& hit)
{
    d->limb = LimbDrag::grab(*d->document, hit, d->limbBranches);
    if (!d->limb)
        return false;
    d->limbPose = std::make_unique<LimbPose>(d->limb->node(), d->limb->skeleton(), d->limb->bendsAtGrab());
    d->gesture = Gesture::Limb;
    update();
    return true;
}

void Viewport::showLimb()
{
    d->limbPose->setBends(d->limb->bends());
    d->limbRest.start();
    update();
}

void Viewport::applyLimb()
{
    if (d->limb && d->limb->apply())
        d->limbPose->noteEdit(d->document->revision(), d->limb->bends());
}

/// \param keep else everything is as it was
void Viewport::finishLimb(bool keep)
{
    if (!d->limb)
        return;
    d->limbRest.stop();
    if (keep) {
        applyLimb();
    } else {
        d->limb->cancel();
        d->limbPose->noteEdit(d->document->revision(), d->limb->bendsAtGrab());
    }
    d->limb.reset();
    d->limbPose->setBends(d->limbPose->latest());
    forgetLimbAtRest();
    d->shown.reset(); // now it is picked in again
    d->gesture = Gesture::None;
    d->button = Qt::NoButton;
    d->dragging = false;
    updateHint();
    update();
}

/// The mesh that was waited for is shown.
void Viewport::forgetLimbAtRest()
{
    if (d->limbPose && !d->limb && d->limbPose->isRest())
        d->limbPose.reset();
}

/// The draft of a bent tree is worse than its pose.
bool Viewport::isPosedDraft(const Change& change) const
{
    if (!d->limbPose || change.kinds != changeResults || change.nodes != std::vector{d->limbPose->node()})
        return false;
    const NodeResult* result = d->document->result(d->limbPose->node());
    return result && result->draft;
}

void Viewport::lengthenLimb(int branches)
{
    const auto next = static_cast<std::int64_t>(d->limb->branches()) + branches;
    d->limb->setBranches(static_cast<std::size_t>(std::max<std::int64_t>(next, 1)));
    d->limbBranches = d->limb->branches();
    showLimb();
}

/// \return whether the gesture takes the key
bool Viewport::limbKey(QKeyEvent* event, bool pressed)
{
    if (!d->limb)
        return false;
    event->accept();
    if (event->key() == Qt::Key_Shift) {
        d->limb->setWhole(pressed);
        showLimb();
    } else if (event->key() == Qt::Key_Escape && pressed) {
        finishLimb(false);
    }
    return true;
}

void Viewport::paintReach(QPainter& painter, QPointF hand)
{
    painter.setPen(QPen(QColor(255, 255, 255, 220), 2.0));
    painter.setBrush(QColor(90, 200, 90));
    painter.drawEllipse(hand, 5.0, 5.0);
    const int branches = static_cast<int>(d->limb->branches());
    QString text = branches > 0 ? tr("%n branch(es) follow", nullptr, branches)
                                : tr("The root stays; with Shift it follows");
    if (d->limb->shortBy() > 1e-3)
        text += QLatin1Char('\n') +
                tr("out of reach: %1 m short").arg(QLocale().toString(d->limb->shortBy(), 'f', 3));
    const QRectF place(hand + QPointF(14.0, -10.0), QSizeF(420.0, 60.0));
    painter.setPen(QColor(0, 0, 0, 160));
    painter.drawText(place.translated(1.0, 1.0), text);
    painter.setPen(Qt::white);
    painter.drawText(place, text);
}

} // namespace ramure
