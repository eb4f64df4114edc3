// What the viewport says about itself in the status bar, and the menu of a right click.
#include "widgets/base/node_words.h"
#include "widgets/view/viewport_private.h"
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <algorithm>

namespace ramure {
namespace {

using Under = ViewportSituation::Under;

PickView pickView(const Camera& camera, QSize size)
{
    return {camera, glm::dvec2(std::max(1, size.width()), std::max(1, size.height()))};
}

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

ViewportSituation Viewport::Private::situation(QSize size) const
{
    ViewportSituation now;
    now.gesture = gesture;
    now.dragging = dragging;
    now.playing = player && player->isPlaying();
    now.wholeLimb = held.testFlag(Qt::ShiftModifier);
    now.style = settings->navigationStyle();
    now.held = held;
    now.target = nodeWords(document->scene(), document->selection().nodes);
    now.keys = gestureKeys ? gestureKeys() : QString();
    const Node* node = document->scene().find(hoverNode);
    const glm::dvec2 pixel(hoverPosition.x(), hoverPosition.y());
    if (ringUnder(pickView(camera, size), pixel, rings()))
        now.under = Under::Ring;
    else if (now.playing || (node && hoverBranch != noIndex))
        now.under = Under::Branch; // while it plays nobody looks what is under the cursor
    else if (node)
        now.under = node->kind != NodeKind::Tree && node->kind != NodeKind::Arm && armForTarget() != noNode
                        ? Under::Surface
                        : Under::Node;
    return now;
}

HintSource* Viewport::hints() const
{
    return &d->hints;
}

void Viewport::setGestureKeys(std::function<QString()> keys)
{
    d->gestureKeys = std::move(keys);
    updateHint();
}

void Viewport::updateHint()
{
    if (d->tools.current() || d->tools.isHovering()) {
        d->hints.say(d->tools.hint(d->pointAt(d->hoverPosition)));
        return d->hints.setGesture(d->tools.goesOn());
    }
    const ViewportSituation now = d->situation(size());
    d->hints.say(viewportHint(now));
    d->hints.setGesture(now.gesture != Gesture::None && (now.gesture != Gesture::Select || now.dragging));
}

/// After mouse and keys have done what they do.
void Viewport::noteInput(QEvent* event)
{
    if (!event->isInputEvent())
        return;
    d->held = heldAfter(*static_cast<QInputEvent*>(event));
    updateHint();
}

/// Of the mouse only a click without a drag asks for the menu, when the button is let go; of the menu key the
/// selection.
void Viewport::contextMenuEvent(QContextMenuEvent* event)
{
    event->accept();
    if (event->reason() == QContextMenuEvent::Mouse || d->gesture != Gesture::None || d->tools.current())
        return;
    const Selection& selection = d->document->selection();
    const bool branch = selection.activeBranch != noIndex;
    emit menuRequested(mapToGlobal(rect().center()), branch ? selection.branchNode : selection.activeNode(),
                       selection.activeBranch);
}

} // namespace ramure
