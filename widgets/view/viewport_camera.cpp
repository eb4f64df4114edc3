// The view of a camera node.
#include "core/evaluate/evaluator.h"
#include "widgets/base/core_text.h"
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
    lens = seen ? seen->lens : Lens();
    if (seen && seen->camera != camera())
        flight.setCamera(seen->camera);
}

/// At rest, through a lens that is open: picture after picture, each finer.
void Viewport::Private::draw(QSize pixels, const RenderOptions& options)
{
    const GLuint target = widget->defaultFramebufferObject();
    const bool blurs = through != noNode && lens.diameter > 0.0 && !settling.isActive() &&
                       !context.isPlaying() && !isWindy();
    if (!blurs) {
        lensPictures = {};
        return renderer->draw(shownScene(), camera(), pixels, target, options);
    }
    const std::shared_ptr<const RenderScene> seen = shown.scene() ? shown.scene() : scene;
    LensPictures& all = lensPictures;
    if (all.scene != seen || all.camera != camera() || !(all.lens == lens) || all.size != pixels)
        all = {0, seen, camera(), lens, pixels};
    RenderOptions own = options;
    own.lens = lens;
    renderer->drawThroughLens(*seen, camera(), pixels, target, own, all.count);
    if (all.count < lensSamples) {
        ++all.count;
        QTimer::singleShot(0, widget, qOverload<>(&QWidget::update));
    }
}

void Viewport::Private::leaveCamera()
{
    if (std::exchange(through, noNode) == noNode)
        return;
    lens = {};
    emit widget->seenThroughChanged();
    widget->wishScene();
}

/// Above the picture: the camera whose view it is, which moving the view leaves, and the game whose wind
/// blows.
void Viewport::paintLabels(QPainter& painter) const
{
    QStringList texts;
    if (const Node* node = d->document->scene().find(d->through))
        texts += tr("Through “%1”").arg(QString::fromStdString(node->name));
    if (d->isWindy())
        texts += tr("Wind: %1").arg(coreText(factsOf(d->settings->gameWind()).choice));
    double top = 10.0;
    for (const QString& text : texts) {
        QRectF box = painter.fontMetrics().boundingRect(text);
        box = box.adjusted(-10.0, -4.0, 10.0, 4.0);
        box.moveCenter({0.5 * width(), top + 0.5 * box.height()});
        top = box.bottom() + 4.0;
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(0, 0, 0, 150));
        painter.drawRoundedRect(box, 4.0, 4.0);
        painter.setPen(Qt::white);
        painter.drawText(box, Qt::AlignCenter, text);
    }
}

} // namespace ramure
