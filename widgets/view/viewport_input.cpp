#include "widgets/view/viewport_private.h"
#include <QGuiApplication>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QStyleHints>
#include <QWheelEvent>
#include <cmath>

namespace ramure {
namespace {

glm::dvec2 asVector(QPointF point)
{
    return {point.x(), point.y()};
}

PickView pickView(const Camera& camera, QSize size)
{
    return {camera, glm::dvec2(std::max(1, size.width()), std::max(1, size.height()))};
}

} // namespace

void Viewport::mousePressEvent(QMouseEvent* event)
{
    if (d->gesture != Gesture::None)
        return; // a second button during a gesture
    if (d->tools.press(d->pointOf(*event)))
        return d->hoverRest.stop();
    d->gesture = event->button() == Qt::LeftButton ? Gesture::Select : Gesture::None;
    d->button = event->button();
    d->pressed = d->last = event->position();
    d->dragging = false;
    if (d->gesture == Gesture::Select && event->modifiers() == Qt::NoModifier)
        beginMotionGesture(pickView(d->camera, size()), asVector(event->position()));
    else if (d->gesture == Gesture::Select && event->modifiers().testFlag(Qt::ControlModifier)) {
        if (beginReach(pickView(d->camera, size()), asVector(event->position())) && d->limb)
            d->limb->setWhole(event->modifiers().testFlag(Qt::ShiftModifier));
    }
    if (d->gesture != Gesture::None && d->gesture != Gesture::Select)
        d->flight.stop();
    d->hoverRest.stop();
}

void Viewport::mouseMoveEvent(QMouseEvent* event)
{
    d->hoverPosition = event->position();
    if (d->tools.move(d->pointOf(*event)))
        return;
    if (d->limb)
        d->limb->setWhole(event->modifiers().testFlag(Qt::ShiftModifier));
    if (d->gesture != Gesture::None) {
        dragTo(event->position());
        return;
    }
    if (d->tools.hover(d->pointOf(*event)))
        hoverAt(event->position()); // no branch is meant now
    else if (!d->hoverRest.isActive())
        d->hoverRest.start();
    setCursor(d->tools.cursor());
}

void Viewport::dragTo(QPointF position)
{
    if (d->gesture == Gesture::Pull || d->gesture == Gesture::Wind) {
        dragMotion(pickView(d->camera, size()), asVector(position));
        d->last = position;
        return update();
    }
    if (!d->dragging) {
        const bool far =
            (position - d->pressed).manhattanLength() >= QGuiApplication::styleHints()->startDragDistance();
        const bool waits = d->gesture == Gesture::Select || d->gesture == Gesture::Limb;
        if (waits && !far)
            return;
        d->dragging = true;
    }
    if (d->gesture == Gesture::Ring) {
        turnRing(pickView(d->camera, size()), asVector(position));
        d->last = position;
        return update();
    }
    if (d->gesture == Gesture::Aim) {
        aimAt(pickView(d->camera, size()), asVector(position));
        d->last = position;
        return update();
    }
    if (d->gesture == Gesture::Limb) {
        d->limb->dragTo(pickView(d->camera, size()), asVector(position));
        d->last = position;
        return showLimb();
    }
    d->last = position;
    update();
}

void Viewport::mouseReleaseEvent(QMouseEvent* event)
{
    d->tools.release(d->pointOf(*event));
    if (event->button() != d->button)
        return;
    if (d->gesture == Gesture::None) {
        d->button = Qt::NoButton;
        const QPointF way = event->position() - d->pressed;
        if (event->button() == Qt::RightButton &&
            way.manhattanLength() < QGuiApplication::styleHints()->startDragDistance())
            d->tools.picks().menu(event->position());
        return;
    }
    // A branch that was clicked, not dragged, is selected.
    const Gesture gesture = d->gesture == Gesture::Limb && !d->dragging ? Gesture::Select : d->gesture;
    if (gesture == Gesture::Pull || gesture == Gesture::Wind || gesture == Gesture::Limb ||
        gesture == Gesture::Aim || gesture == Gesture::Ring)
        return letGo();
    finishLimb(true); // nothing was bent
    d->gesture = Gesture::None;
    d->button = Qt::NoButton;
    if (gesture == Gesture::Select && d->dragging)
        d->tools.picks().box(d->pressed, event->position(), event->modifiers().testFlag(Qt::ShiftModifier));
    else if (gesture == Gesture::Select)
        d->tools.picks().click(event->position(), event->modifiers().testFlag(Qt::ShiftModifier));
    d->dragging = false;
    update();
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton ||
        !shakeOffAt(pickView(d->camera, size()), asVector(event->position())))
        mousePressEvent(event);
}

void Viewport::hoverAt(QPointF position)
{
    const bool before = d->tools.isHovering();
    const bool taken = d->tools.hover(d->pointAt(position));
    if (taken != before)
        updateHint();
    std::optional<PickHit> hit;
    if (!taken && !d->isStale()) {
        const auto scene = d->picker.ready();
        if (!scene)
            return; // readyChanged asks again
        hit = scene->pick(pickView(d->camera, size()), asVector(position));
    }
    const PickHit now = hit.value_or(PickHit());
    if (now.node == d->hoverNode && now.branch == d->hoverBranch)
        return;
    d->hoverNode = now.node;
    d->hoverBranch = now.branch;
    d->highlightsStale = true;
    emit hovered(now.node, now.branch);
    updateHint();
    update();
}

void Viewport::wheelEvent(QWheelEvent* event)
{
    if (d->gesture == Gesture::Limb)
        return lengthenLimb(event->angleDelta().y() > 0 ? 1 : -1);
    const double turn = event->angleDelta().y() != 0 ? event->angleDelta().y() : event->angleDelta().x();
    event->accept();
    d->tools.wheel(d->pointAt(event->position()), turn);
}

void Viewport::leaveEvent(QEvent* event)
{
    d->hoverRest.stop();
    d->tools.leave();
    if (d->hoverNode != noNode) {
        d->hoverNode = noNode;
        d->hoverBranch = noIndex;
        d->highlightsStale = true;
        emit hovered(noNode, noIndex);
        update();
    }
    QOpenGLWidget::leaveEvent(event);
}

void Viewport::keyPressEvent(QKeyEvent* event)
{
    if (limbKey(event, true))
        return;
    const auto isKey = [event](Qt::Key key) { return event->key() == key ? 1.0 : 0.0; };
    const double yaw = isKey(Qt::Key_Right) - isKey(Qt::Key_Left);
    const double pitch = isKey(Qt::Key_Up) - isKey(Qt::Key_Down);
    const bool plain = !(event->modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier));
    if (plain && (yaw != 0.0 || pitch != 0.0))
        return orbitBy(yaw * orbitStepRad, pitch * orbitStepRad);
    QOpenGLWidget::keyPressEvent(event);
}

bool Viewport::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride && d->tools.takesKey(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    // While a limb is bent keys are no shortcuts.
    if (d->limb && event->type() == QEvent::ShortcutOverride) {
        event->accept();
        return true;
    }
    if (event->type() == QEvent::KeyPress && d->tools.key(*static_cast<QKeyEvent*>(event), true))
        return true; // Tab, too
    if (event->type() == QEvent::NativeGesture) {
        const auto* gesture = static_cast<QNativeGestureEvent*>(event);
        if (gesture->gestureType() == Qt::ZoomNativeGesture) {
            const PickView view = pickView(d->camera, size());
            Camera to = d->camera;
            to.zoom(std::exp(-gesture->value()),
                    to.pointAtTargetDepth(view.ndc(asVector(gesture->position())), view.aspect()));
            d->setCamera(to);
            return true;
        }
    }
    if (event->type() == QEvent::LanguageChange) {
        setAccessibleName(tr("3D view"));
        updateHint();
        update(); // the labels of the cube
    }
    const bool taken = QOpenGLWidget::event(event);
    noteInput(event);
    return taken;
}

} // namespace ramure
