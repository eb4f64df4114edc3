// The view of a camera node.
#include "core/evaluate/evaluator.h"
#include "widgets/view/render/camera_items.h"
#include "widgets/view/viewport_private.h"
#include <QPainter>
#include <utility>

namespace ramure {

NodeId Viewport::seenThrough() const
{
    return d->through;
}

double Viewport::shownSeconds() const
{
    return d->context.seconds();
}

void Viewport::lookThrough(NodeId camera)
{
    if (camera == d->through)
        return;
    EvaluatedScene now(d->document->scene(), d->context.seconds());
    if (!viewThrough(now, camera))
        return d->leaveCamera();
    d->settings->setOrthographic(false);
    d->frameNext = false;
    d->framed = false;
    d->framing = Private::Framing::None;
    d->flight.stop();
    d->through = camera;
    d->followCamera();
    emit seenThroughChanged();
    wishScene();
    update();
}

/// Where it stands at the moment that is shown.
void Viewport::Private::followCamera()
{
    if (through == noNode)
        return;
    EvaluatedScene now(document->scene(), context.seconds());
    const auto seen = viewThrough(now, through);
    if (seen && seen->camera != camera())
        flight.setCamera(seen->camera);
}

void Viewport::Private::leaveCamera()
{
    if (std::exchange(through, noNode) == noNode)
        return;
    emit widget->seenThroughChanged();
    widget->wishScene();
}

/// Its name above the picture: moving the view leaves it.
void Viewport::paintSeenThrough(QPainter& painter) const
{
    const Node* node = d->document->scene().find(d->through);
    if (!node)
        return;
    const QString text = tr("Through “%1”").arg(QString::fromStdString(node->name));
    QRectF box = painter.fontMetrics().boundingRect(text);
    box = box.adjusted(-10.0, -4.0, 10.0, 4.0);
    box.moveCenter({0.5 * width(), 10.0 + 0.5 * box.height()});
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 150));
    painter.drawRoundedRect(box, 4.0, 4.0);
    painter.setPen(Qt::white);
    painter.drawText(box, Qt::AlignCenter, text);
}

} // namespace ramure
