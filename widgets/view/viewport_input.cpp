#include "widgets/view/tools/navigation_cube.h"
#include "widgets/view/tools/selection_edits.h"
#include "widgets/view/viewport_private.h"
#include <QGuiApplication>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QStyleHints>
#include <QWheelEvent>
#include <cmath>
#include <utility>

namespace ramure {
namespace {

/// How long a click may hold the interface up.
constexpr std::chrono::milliseconds patience(8);

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
    if (d->gizmo) { // a click ends what the keyboard began; the right button takes anything back
        if (event->button() == Qt::RightButton || d->gizmoByKeys)
            finishGizmo(event->button() == Qt::LeftButton);
        return;
    }
    if (d->gesture != Gesture::None)
        return; // a second button during a gesture
    d->gesture = gestureFor(d->settings->navigationStyle(), event->button(), event->modifiers());
    d->button = event->button();
    d->pressed = d->last = event->position();
    d->dragging = false;
    d->onCube = event->button() == Qt::LeftButton &&
                NavigationCube::place(size()).contains(event->position()) &&
                NavigationCube::sideAt(d->camera, size(), event->position());
    if (d->onCube)
        d->gesture = Gesture::Orbit;
    else if (d->gesture == Gesture::Select &&
             beginGizmo(pickView(d->camera, size()), asVector(event->position()), event->modifiers()))
        d->hoverRest.stop();
    else if (d->gesture == Gesture::Select && event->modifiers() == Qt::NoModifier)
        beginMotionGesture(pickView(d->camera, size()), asVector(event->position()));
    else if (d->gesture == Gesture::Select && event->modifiers().testFlag(Qt::ControlModifier)) {
        if (beginReach(pickView(d->camera, size()), asVector(event->position())) && d->limb)
            d->limb->setWhole(event->modifiers().testFlag(Qt::ShiftModifier));
    }
    if (d->gesture != Gesture::None && d->gesture != Gesture::Select)
        d->flight.stop();
    d->hoverRest.stop();
    d->pending.reset();
    d->boxRuns = false;
}

void Viewport::mouseMoveEvent(QMouseEvent* event)
{
    d->hoverPosition = event->position();
    if (d->gizmo)
        return dragGizmo(event->position(), event->modifiers());
    if (d->gesture == Gesture::None && hoverGizmo(event->position()))
        return;
    if (d->limb)
        d->limb->setWhole(event->modifiers().testFlag(Qt::ShiftModifier));
    if (d->gesture != Gesture::None) {
        dragTo(event->position());
        return;
    }
    if (!d->hoverRest.isActive())
        d->hoverRest.start();
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
        const bool waits = d->gesture == Gesture::Select || d->gesture == Gesture::Limb || d->onCube;
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
    applyDrag(d->camera, d->gesture, position - d->last, size());
    d->last = position;
    if (d->gesture != Gesture::Select) {
        d->framed = false;
        emit cameraChanged();
    }
    update();
}

void Viewport::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() != d->button)
        return;
    if (d->gesture == Gesture::None) {
        d->button = Qt::NoButton;
        const QPointF way = event->position() - d->pressed;
        if (event->button() == Qt::RightButton &&
            way.manhattanLength() < QGuiApplication::styleHints()->startDragDistance())
            requestMenu(event->position());
        return;
    }
    if (d->gizmo)
        return finishGizmo(true);
    // A branch that was clicked, not dragged, is selected.
    const Gesture gesture = d->gesture == Gesture::Limb && !d->dragging ? Gesture::Select : d->gesture;
    const bool onCube = d->onCube;
    if (gesture == Gesture::Pull || gesture == Gesture::Wind || gesture == Gesture::Limb ||
        gesture == Gesture::Aim || gesture == Gesture::Ring)
        return letGo();
    finishLimb(true); // nothing was bent
    d->gesture = Gesture::None;
    d->button = Qt::NoButton;
    d->onCube = false;
    if (onCube && !d->dragging) {
        if (const auto side = NavigationCube::sideAt(d->camera, size(), event->position()))
            setAxisView(*side);
    } else if (gesture == Gesture::Select) {
        d->pending = {d->pressed, event->position(), d->dragging,
                      event->modifiers().testFlag(Qt::ShiftModifier), false};
        finishSelecting();
    }
    d->dragging = false;
    update();
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton ||
        !shakeOffAt(pickView(d->camera, size()), asVector(event->position())))
        mousePressEvent(event);
}

void Viewport::finishSelecting()
{
    if (d->isStale() || d->boxRuns)
        return; // what is picked must belong to the results of now: the scene of now comes back here
    const auto scene = d->picker.readyWithin(patience);
    if (!scene || !d->pending)
        return; // readyChanged comes back here
    if (d->pending->isBox)
        return finishBox();
    const Private::Pending pick = *std::exchange(d->pending, std::nullopt);
    const PickView view = pickView(d->camera, size());
    const Selection& selection = d->document->selection();
    const auto hit = scene->pick(view, asVector(pick.to));
    if (!hit && !pick.asksMenu)
        clearDefect();
    if (!pick.asksMenu || (hit && !isSelected(selection, *hit)))
        d->document->setSelection(afterClick(selection, hit, pick.extend));
    const PickHit at = hit.value_or(PickHit());
    if (pick.asksMenu)
        emit menuRequested(mapToGlobal(pick.to.toPoint()), at.node, at.branch);
}

void Viewport::finishBox()
{
    const auto done = [this](const std::vector<PickedBranches>& picked) {
        if (!std::exchange(d->boxRuns, false) || !d->pending || d->isStale())
            return; // given up; or the scene of now comes back to finishSelecting
        const Private::Pending box = *std::exchange(d->pending, std::nullopt);
        d->document->setSelection(afterBox(d->document->selection(), picked, box.extend));
    };
    d->boxRuns = d->picker.pickBox(pickView(d->camera, size()), asVector(d->pending->from),
                                   asVector(d->pending->to), done);
}

void Viewport::hoverAt(QPointF position)
{
    const auto side = NavigationCube::sideAt(d->camera, size(), position);
    if (side != d->hoverSide) {
        d->hoverSide = side;
        updateHint();
        update();
    }
    std::optional<PickHit> hit;
    if (!side && !d->gizmoHover && !d->isStale()) {
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
    if (d->gizmo)
        return event->accept();
    if (d->gesture == Gesture::Limb)
        return lengthenLimb(event->angleDelta().y() > 0 ? 1 : -1);
    const double turn = event->angleDelta().y() != 0 ? event->angleDelta().y() : event->angleDelta().x();
    event->accept();
    if (turn == 0.0)
        return;
    d->flight.stop();
    const PickView view = pickView(d->camera, size());
    const glm::dvec2 pixel = asVector(event->position());
    glm::dvec3 fixed = d->camera.pointAtTargetDepth(view.ndc(pixel), view.aspect());
    // Over a branch: towards that very point, so that zooming on and on arrives at it.
    if (const auto scene = d->isStale() ? nullptr : d->picker.ready()) {
        if (const auto hit = scene->pick(view, pixel))
            fixed = hit->point;
    }
    d->framed = false;
    d->camera.zoom(wheelFactor(turn), fixed);
    emit cameraChanged();
    update();
}

void Viewport::leaveEvent(QEvent* event)
{
    d->hoverRest.stop();
    if (d->gizmoHover && !d->gizmo) {
        d->gizmoHover.reset();
        update();
    }
    if (d->hoverNode != noNode || d->hoverSide) {
        d->hoverNode = noNode;
        d->hoverBranch = noIndex;
        d->hoverSide.reset();
        d->highlightsStale = true;
        emit hovered(noNode, noIndex);
        update();
    }
    QOpenGLWidget::leaveEvent(event);
}

void Viewport::keyPressEvent(QKeyEvent* event)
{
    if (gizmoKey(event, true) || limbKey(event, true))
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
    // While nodes are moved, or a limb, keys are numbers and axes, not shortcuts; Tab is the next number.
    if ((d->gizmo || d->limb) && event->type() == QEvent::ShortcutOverride) {
        event->accept();
        return true;
    }
    if (d->gizmo && event->type() == QEvent::KeyPress)
        return gizmoKey(static_cast<QKeyEvent*>(event), true);
    if (event->type() == QEvent::NativeGesture) {
        const auto* gesture = static_cast<QNativeGestureEvent*>(event);
        if (gesture->gestureType() == Qt::ZoomNativeGesture) {
            const PickView view = pickView(d->camera, size());
            d->framed = false;
            d->camera.zoom(
                std::exp(-gesture->value()),
                d->camera.pointAtTargetDepth(view.ndc(asVector(gesture->position())), view.aspect()));
            emit cameraChanged();
            update();
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
