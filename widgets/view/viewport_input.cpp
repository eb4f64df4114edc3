// Mouse and keys go to the tools; the viewport is their host.
#include "widgets/view/viewport_private.h"
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QTabletEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

namespace ramure {
namespace {

/// Of keys the state after them: the event has that before.
Qt::KeyboardModifiers heldAfter(const QInputEvent& event)
{
    Qt::KeyboardModifiers held = event.modifiers();
    if (event.type() != QEvent::KeyPress && event.type() != QEvent::KeyRelease)
        return held;
    const bool pressed = event.type() == QEvent::KeyPress;
    switch (static_cast<const QKeyEvent&>(event).key()) {
    case Qt::Key_Shift:
        return held.setFlag(Qt::ShiftModifier, pressed);
    case Qt::Key_Control:
        return held.setFlag(Qt::ControlModifier, pressed);
    case Qt::Key_Alt:
        return held.setFlag(Qt::AltModifier, pressed);
    default:
        return held;
    }
}

} // namespace

PickView Viewport::Private::view() const
{
    return {camera(), glm::dvec2(std::max(1, widget->width()), std::max(1, widget->height()))};
}

ToolPoint Viewport::Private::pointAt(QPointF position) const
{
    return {view(), position, Qt::NoButton, pointer.held, position, pointer.pressure, pointer.isEraser, 0};
}

ToolPoint Viewport::Private::pointOf(const QMouseEvent& event) const
{
    return {view(),           event.position(), event.button(),   event.modifiers(),
            event.position(), pointer.pressure, pointer.isEraser, event.timestamp()};
}

void Viewport::Private::setCamera(const Camera& moved)
{
    frame.isAll = false;
    leaveCamera();
    flight.setCamera(moved);
}

const TreeResult* Viewport::Private::shownTree(NodeId node) const
{
    const auto found = trees.find(node);
    return found == trees.end() ? nullptr : &found->second;
}

std::shared_ptr<const PickScene> Viewport::Private::pickScene(std::chrono::milliseconds patience)
{
    return patience.count() > 0 ? picker.readyWithin(patience) : picker.ready();
}

bool Viewport::Private::pickBox(QPointF cornerA, QPointF cornerB,
                                std::function<void(const std::vector<PickedBranches>&)> done)
{
    return picker.pickBox(view(), {cornerA.x(), cornerA.y()}, {cornerB.x(), cornerB.y()}, std::move(done));
}

void Viewport::Private::updateHint()
{
    hints.say(tools.hint(pointAt(pointer.at)));
    hints.setGesture(tools.goesOn());
}

HintSource* Viewport::hints() const
{
    return &d->hints;
}

ViewMarks* Viewport::marks() const
{
    return &d->marks;
}

OutlineKey* Viewport::outlineKey() const
{
    return &d->outline;
}

void Viewport::setGestureKeys(std::function<QString()> keys)
{
    d->context.gestureKeys = std::move(keys);
    d->updateHint();
}

void Viewport::beginTransform(TransformTool tool)
{
    if (d->tools.current())
        return;
    QPointF at = mapFromGlobal(QCursor::pos());
    if (!rect().contains(at.toPoint()))
        at = QPointF(rect().center());
    if (!d->tools.tool<GizmoTool>().beginByKeys(tool, d->pointAt(at)))
        return;
    d->pointer.at = at;
    d->hoverRest.stop();
    setFocus(Qt::OtherFocusReason);
}

void Viewport::beginMovingCopies()
{
    beginTransform(TransformTool::Move);
    if (d->tools.tool<GizmoTool>().isBusy())
        d->document->history().joinToLast(d->tools.tool<GizmoTool>().gesture());
}

/// Only what the mouse does not say: the same event follows as that of a mouse.
void Viewport::tabletEvent(QTabletEvent* event)
{
    const bool touches = event->type() != QEvent::TabletRelease && event->buttons() != Qt::NoButton;
    d->pointer.pressure = touches ? std::optional(event->pressure()) : std::nullopt;
    d->pointer.isEraser = touches && event->pointerType() == QPointingDevice::PointerType::Eraser;
    event->ignore();
}

void Viewport::mousePressEvent(QMouseEvent* event)
{
    d->hoverRest.stop();
    d->tools.press(d->pointOf(*event));
}

void Viewport::mouseMoveEvent(QMouseEvent* event)
{
    d->pointer.at = event->position();
    if (d->tools.move(d->pointOf(*event)))
        return;
    if (d->tools.hover(d->pointOf(*event)))
        hoverAt(event->position()); // no branch is meant now
    else if (!d->hoverRest.isActive())
        d->hoverRest.start();
    setCursor(d->tools.cursor());
}

void Viewport::mouseReleaseEvent(QMouseEvent* event)
{
    d->tools.release(d->pointOf(*event));
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (!d->tools.doubleClick(d->pointOf(*event)))
        mousePressEvent(event);
}

void Viewport::wheelEvent(QWheelEvent* event)
{
    const QPoint turn = event->angleDelta();
    event->accept();
    d->tools.wheel(d->pointAt(event->position()), turn.y() != 0 ? turn.y() : turn.x());
}

void Viewport::hoverAt(QPointF position)
{
    const bool before = d->tools.isHovering();
    const bool taken = d->tools.hover(d->pointAt(position));
    if (taken != before)
        d->updateHint();
    std::optional<PickHit> hit;
    if (!taken && !d->isStale()) {
        const auto scene = d->picker.ready();
        if (!scene)
            return; // readyChanged asks again
        hit = scene->pick(d->view(), {position.x(), position.y()});
    }
    hover(hit.value_or(PickHit()));
}

void Viewport::hover(const PickHit& hit)
{
    if (hit.node == d->context.hoverNode && hit.branch == d->context.hoverBranch)
        return;
    d->context.hoverNode = hit.node;
    d->context.hoverBranch = hit.branch;
    d->highlightsStale = true;
    emit hovered(hit.node, hit.branch);
    d->updateHint();
    update();
}

void Viewport::leaveEvent(QEvent* event)
{
    d->hoverRest.stop();
    d->tools.leave();
    hover({});
    QOpenGLWidget::leaveEvent(event);
}

/// Of the mouse only a click without a drag asks for the menu, when the button is let go; of the menu key the
/// selection.
void Viewport::contextMenuEvent(QContextMenuEvent* event)
{
    event->accept();
    if (event->reason() == QContextMenuEvent::Mouse || d->tools.current())
        return;
    const Selection& selection = d->document->selection();
    const bool branch = selection.activeBranch != noIndex;
    emit menuRequested(mapToGlobal(rect().center()), branch ? selection.branchNode : selection.activeNode(),
                       selection.activeBranch);
}

void Viewport::keyPressEvent(QKeyEvent* event)
{
    const auto isKey = [event](Qt::Key key) { return event->key() == key ? 1.0 : 0.0; };
    const double yaw = isKey(Qt::Key_Right) - isKey(Qt::Key_Left);
    const double pitch = isKey(Qt::Key_Up) - isKey(Qt::Key_Down);
    const bool plain = !(event->modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier));
    if (plain && (yaw != 0.0 || pitch != 0.0))
        return steer([=](Camera& to) { to.orbit(yaw * orbitStepRad, pitch * orbitStepRad); });
    QOpenGLWidget::keyPressEvent(event);
}

void Viewport::focusOutEvent(QFocusEvent* event)
{
    if (event->reason() != Qt::ActiveWindowFocusReason)
        d->tools.focusLost();
    QOpenGLWidget::focusOutEvent(event);
}

/// \return whether the event needs nothing else
bool Viewport::giveToTools(QEvent* event)
{
    switch (event->type()) {
    case QEvent::ShortcutOverride: // what a gesture takes is no shortcut
        return d->tools.takesKey(*static_cast<QKeyEvent*>(event));
    case QEvent::KeyPress: // here: Tab, too
        return d->tools.key(*static_cast<QKeyEvent*>(event), true);
    case QEvent::KeyRelease:
        return d->tools.key(*static_cast<QKeyEvent*>(event), false);
    case QEvent::NativeGesture: {
        const auto* gesture = static_cast<QNativeGestureEvent*>(event);
        if (gesture->gestureType() != Qt::ZoomNativeGesture)
            return false;
        const PickView view = d->view();
        const QPointF at = gesture->position();
        Camera to = view.camera;
        to.zoom(std::exp(-gesture->value()),
                to.pointAtTargetDepth(view.ndc({at.x(), at.y()}), view.aspect()));
        d->setCamera(to);
        return true;
    }
    default:
        return false;
    }
}

bool Viewport::event(QEvent* event)
{
    const bool given = giveToTools(event);
    if (given)
        event->accept();
    const bool taken = given || QOpenGLWidget::event(event);
    if (event->isInputEvent() && event->type() != QEvent::ShortcutOverride) {
        d->pointer.held = heldAfter(*static_cast<QInputEvent*>(event));
        d->updateHint();
    }
    return taken;
}

} // namespace ramure
