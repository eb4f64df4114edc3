// The viewport as the host of its tools.
#include "core/document/joined_steps.h"
#include "widgets/view/viewport_private.h"
#include <QMouseEvent>

namespace ramure {

PickView Viewport::Private::view() const
{
    return {camera, glm::dvec2(std::max(1, widget->width()), std::max(1, widget->height()))};
}

ToolPoint Viewport::Private::pointAt(QPointF position) const
{
    return {view(), position, Qt::NoButton, held, position};
}

ToolPoint Viewport::Private::pointOf(const QMouseEvent& event) const
{
    return {view(), event.position(), event.button(), event.modifiers(), event.position()};
}

void Viewport::Private::setCamera(const Camera& moved)
{
    framed = false;
    camera = moved;
    emit widget->cameraChanged();
    widget->update();
}

std::shared_ptr<const PickScene> Viewport::Private::pickScene(std::chrono::milliseconds patience)
{
    if (isStale())
        return nullptr;
    return patience.count() > 0 ? picker.readyWithin(patience) : picker.ready();
}

bool Viewport::Private::pickBox(QPointF cornerA, QPointF cornerB,
                                std::function<void(const std::vector<PickedBranches>&)> done)
{
    return picker.pickBox(view(), {cornerA.x(), cornerA.y()}, {cornerB.x(), cornerB.y()}, std::move(done));
}

bool Viewport::isTransforming() const
{
    return d->tools.tool<GizmoTool>().isBusy();
}

void Viewport::beginTransform(TransformTool tool)
{
    if (d->gesture != Gesture::None || d->tools.current())
        return;
    QPointF at = mapFromGlobal(QCursor::pos());
    if (!rect().contains(at.toPoint()))
        at = QPointF(rect().center());
    if (!d->tools.tool<GizmoTool>().beginByKeys(tool, d->pointAt(at)))
        return;
    d->hoverPosition = at;
    d->hoverRest.stop();
    setFocus(Qt::OtherFocusReason);
}

void Viewport::beginMovingCopies()
{
    beginTransform(TransformTool::Move);
    if (isTransforming())
        joinToLastStep(*d->document, d->tools.tool<GizmoTool>().gesture());
}

void Viewport::keyReleaseEvent(QKeyEvent* event)
{
    if (!d->tools.key(*event, false) && !limbKey(event, false))
        QOpenGLWidget::keyReleaseEvent(event);
}

void Viewport::focusOutEvent(QFocusEvent* event)
{
    if (event->reason() != Qt::ActiveWindowFocusReason)
        d->tools.focusLost();
    QOpenGLWidget::focusOutEvent(event);
}

} // namespace ramure
