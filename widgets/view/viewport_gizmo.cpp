// The selected nodes are moved, turned and scaled: by the handles of the gizmo, or by keys.
#include "core/document/joined_steps.h"
#include "core/math/drag_maths.h"
#include "core/session/player.h"
#include "widgets/view/viewport_private.h"
#include <QFocusEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <cmath>
#include <numbers>

namespace ramure {
namespace {

constexpr double clickReach = 3.0; ///< logical pixels: less is no drag

PickView pickView(const Camera& camera, QSize size)
{
    return {camera, glm::dvec2(std::max(1, size.width()), std::max(1, size.height()))};
}

GizmoModifiers modifiersOf(Qt::KeyboardModifiers keys)
{
    return {keys.testFlag(Qt::ControlModifier), keys.testFlag(Qt::ShiftModifier)};
}

/// A line through the pivot, across the whole picture.
void paintAxis(QPainter& painter, const PickView& view, const GizmoPlace& place, int axis)
{
    const auto middle = gizmoPixel(view, place.pivot);
    if (!middle)
        return;
    const double reach = gizmoMetres(view, place, 3000.0);
    QPolygonF line;
    for (int side : {-1, 1}) {
        // As far as it goes before the eye.
        for (double share = 1.0; share > 1e-3; share *= 0.7)
            if (const auto at = gizmoPixel(view, place.pivot + side * share * reach * place.axes[axis])) {
                line << *at;
                break;
            }
    }
    painter.setPen(QPen(QColor(16, 22, 28, 120), 3.0));
    painter.drawPolyline(line);
    painter.setPen(QPen(gizmoColour(axis), 1.4));
    painter.drawPolyline(line);
}

/// What a turn has swept so far.
void paintSweep(QPainter& painter, const PickView& view, const GizmoDrag& drag)
{
    const GizmoPlace& place = drag.start();
    const double radius = gizmoMetres(view, place, 0.8 * gizmoRingReach);
    const double whole = 2.0 * std::numbers::pi;
    const double angle = std::clamp(drag.angleRad(), -whole, whole);
    const glm::dvec3 zero = anyPerpendicular(drag.turnAxis());
    const auto middle = gizmoPixel(view, place.pivot);
    if (!middle || angle == 0.0)
        return;
    QPolygonF sector{*middle};
    const int parts = std::max(2, int(std::ceil(64.0 * std::abs(angle) / whole)));
    for (int i = 0; i <= parts; ++i)
        if (const auto at = gizmoPixel(
                view, place.pivot + radius * (turnAbout(drag.turnAxis(), angle * i / parts) * zero)))
            sector << *at;
    const auto& handle = drag.handle();
    QColor ink =
        handle && handle->part == GizmoPart::Axis ? gizmoColour(handle->axis) : QColor(245, 245, 245);
    painter.setPen(QPen(ink, 1.2));
    ink.setAlpha(70);
    painter.setBrush(ink);
    painter.drawPolygon(sector);
}

/// Beside the cursor, on a ground of its own: readable on any picture.
void paintReadout(QPainter& painter, QPointF at, QSize picture, const QString& text)
{
    QFont font = painter.font();
    font.setWeight(QFont::DemiBold);
    painter.setFont(font);
    QRectF box(QPointF(0.0, 0.0), painter.fontMetrics().size(Qt::TextSingleLine, text) + QSize(18, 10));
    box.moveTopLeft(at + QPointF(18.0, 18.0));
    if (box.right() > picture.width() - 4.0)
        box.moveRight(picture.width() - 4.0);
    if (box.bottom() > picture.height() - 4.0)
        box.moveBottom(at.y() - 12.0);
    painter.setPen(QPen(QColor(255, 255, 255, 60), 1.0));
    painter.setBrush(QColor(20, 26, 32, 215));
    painter.drawRoundedRect(box, 5.0, 5.0);
    painter.setPen(Qt::white);
    painter.drawText(box, Qt::AlignCenter, text);
}

} // namespace

void Viewport::connectGizmo()
{
    connect(d->settings->gizmo(), &GizmoSettings::changed, this, [this] {
        d->gizmoStale = true;
        d->gizmoHover.reset();
        updateTrail();
        update();
    });
    connect(&d->trail, &GizmoTrail::changed, this, qOverload<>(&QWidget::update));
}

void Viewport::setAutoKey(std::function<bool()> isOn)
{
    d->autoKey = std::move(isOn);
}

bool Viewport::isTransforming() const
{
    return d->gizmo != nullptr;
}

std::optional<GizmoPlace> Viewport::Private::gizmoPlace()
{
    if (gizmo)
        return gizmo->place();
    const GizmoSettings& how = *settings->gizmo();
    if (how.tool() == TransformTool::Select || (player && player->isPlaying()))
        return std::nullopt;
    if (std::exchange(gizmoStale, false)) {
        const auto starts = transformStarts(document->scene(), document->selection().nodes,
                                            player ? player->timeSeconds() : 0.0, false);
        gizmoRest.reset();
        if (!starts.empty())
            gizmoRest = GizmoPlace{shownPivot(document->scene(), starts), transformAxes(starts, how.space())};
    }
    return gizmoRest;
}

/// Somebody else may take the nodes away under the hand.
void Viewport::followGizmo(const Change& change)
{
    d->gizmoStale = true;
    if (change.has(changeReset) || (d->gizmo && !d->gizmo->isWhole()))
        if (d->gizmo) {
            d->gizmo.reset();
            d->gesture = Gesture::None;
            d->button = Qt::NoButton;
            updateHint();
        }
    if (change.has(~quint32(changeFile | changeResults)))
        updateTrail();
    else if (change.has(changeResults))
        d->trail.forgetSkeletons();
}

/// \return whether a handle is under the cursor
bool Viewport::hoverGizmo(QPointF position)
{
    const auto place = d->gizmoPlace();
    const auto handle = place ? gizmoHandleAt(pickView(d->camera, size()), {position.x(), position.y()},
                                              *place, d->settings->gizmo()->tool())
                              : std::nullopt;
    if (handle != d->gizmoHover) {
        d->gizmoHover = handle;
        setCursor(handle ? Qt::SizeAllCursor : Qt::ArrowCursor);
        if (handle)
            hoverAt(position); // no branch is meant now
        update();
    }
    return handle.has_value();
}

bool Viewport::beginGizmo(const PickView& view, const glm::dvec2& pixel, Qt::KeyboardModifiers modifiers)
{
    const auto place = d->gizmoPlace();
    const TransformTool tool = d->settings->gizmo()->tool();
    const auto handle = place && !modifiers.testFlag(Qt::AltModifier)
                            ? gizmoHandleAt(view, pixel, *place, tool)
                            : std::nullopt;
    if (!handle)
        return false;
    d->gizmo =
        GizmoDrag::begin(*d->document, *d->settings->gizmo(), tool, handle,
                         d->player ? d->player->timeSeconds() : 0.0, d->autoKey && d->autoKey(), view, pixel);
    if (!d->gizmo)
        return false;
    d->gizmoByKeys = false;
    startedGizmo();
    return true;
}

void Viewport::beginTransform(TransformTool tool)
{
    if (d->gizmo || d->gesture != Gesture::None || d->tools.current())
        return;
    if (d->player && d->player->isPlaying())
        d->player->pause();
    const PickView view = pickView(d->camera, size());
    QPointF at = mapFromGlobal(QCursor::pos());
    if (!rect().contains(at.toPoint()))
        at = QPointF(rect().center());
    d->gizmo = GizmoDrag::begin(*d->document, *d->settings->gizmo(), tool, std::nullopt,
                                d->player ? d->player->timeSeconds() : 0.0, d->autoKey && d->autoKey(), view,
                                {at.x(), at.y()});
    if (!d->gizmo) {
        emit messageRaised(
            d->document->selection().nodes.empty() && !d->document->selection().branches.empty()
                ? tr("Branches are bent by a drag with Ctrl; what is moved is the tree: select it")
                : tr("Select a node that is shown and not locked: then it can be moved"));
        return;
    }
    d->settings->gizmo()->setTool(tool);
    d->gizmoByKeys = true;
    d->last = d->hoverPosition = at;
    startedGizmo();
    setFocus(Qt::OtherFocusReason);
}

void Viewport::beginMovingCopies()
{
    beginTransform(TransformTool::Move);
    if (d->gizmo)
        joinToLastStep(*d->document, d->gizmo->gesture());
}

void Viewport::startedGizmo()
{
    d->flight.stop();
    d->gesture = Gesture::Gizmo;
    if (d->gizmoByKeys)
        d->button = Qt::NoButton;
    d->tools.picks().forget();
    d->hoverRest.stop();
    updateHint();
    update();
}

void Viewport::dragGizmo(QPointF position, Qt::KeyboardModifiers modifiers)
{
    const bool far = std::hypot(position.x() - d->pressed.x(), position.y() - d->pressed.y()) >= clickReach;
    d->last = position;
    if (!d->gizmoByKeys && !d->dragging && !far)
        return;
    d->dragging = true;
    d->gizmo->moveTo(pickView(d->camera, size()), {position.x(), position.y()}, modifiersOf(modifiers));
    update();
}

void Viewport::finishGizmo(bool keep)
{
    if (keep)
        d->gizmo->keep();
    else
        d->gizmo->cancel();
    d->gizmo.reset();
    d->gesture = Gesture::None;
    d->button = Qt::NoButton;
    d->dragging = false;
    d->gizmoStale = true;
    updateHint();
    update();
}

/// \return whether the gesture takes the key
bool Viewport::gizmoKey(QKeyEvent* event, bool pressed)
{
    if (!d->gizmo)
        return false;
    event->accept();
    if (event->key() == Qt::Key_Control || event->key() == Qt::Key_Shift) {
        Qt::KeyboardModifiers keys = event->modifiers();
        keys.setFlag(event->key() == Qt::Key_Control ? Qt::ControlModifier : Qt::ShiftModifier, pressed);
        if (d->dragging || d->gizmoByKeys)
            dragGizmo(d->last, keys);
        return true;
    }
    if (!pressed)
        return true;
    switch (d->gizmo->key(event->key(), event->text(), event->modifiers())) {
    case GizmoDrag::KeyResult::Confirm:
        finishGizmo(true);
        break;
    case GizmoDrag::KeyResult::Cancel:
        finishGizmo(false);
        break;
    case GizmoDrag::KeyResult::Taken:
    case GizmoDrag::KeyResult::Ignored:
        break;
    }
    update();
    return true;
}

void Viewport::keyReleaseEvent(QKeyEvent* event)
{
    if (!gizmoKey(event, false) && !limbKey(event, false))
        QOpenGLWidget::keyReleaseEvent(event);
}

void Viewport::focusOutEvent(QFocusEvent* event)
{
    // Whoever goes on elsewhere in the program is content with where things are.
    if (d->gizmo && d->gizmoByKeys && event->reason() != Qt::ActiveWindowFocusReason)
        finishGizmo(true);
    QOpenGLWidget::focusOutEvent(event);
}

void Viewport::paintGizmoOverlay(QPainter& painter)
{
    const PickView view = pickView(d->camera, size());
    const auto place = d->gizmoPlace();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    d->trail.paintPlayhead(painter, view, d->player ? d->player->timeSeconds() : 0.0);
    if (d->gizmo && place) {
        const auto& handle = d->gizmo->handle();
        const bool free = !handle || handle->part == GizmoPart::Centre || handle->part == GizmoPart::View;
        for (int axis = 0; axis < 3 && !free; ++axis)
            if ((handle->part == GizmoPart::Axis) == (handle->axis == axis))
                paintAxis(painter, view, d->gizmo->start(), axis);
        if (d->gizmo->tool() == TransformTool::Rotate)
            paintSweep(painter, view, *d->gizmo);
        const auto bright =
            handle ? handle
                   : std::optional(GizmoHandle{
                         d->gizmo->tool() == TransformTool::Rotate ? GizmoPart::View : GizmoPart::Centre, 0});
        paintGizmo(painter, view, *place, d->gizmo->tool(), bright);
        paintReadout(painter, d->last, size(), d->gizmo->readout());
    } else if (place) {
        paintGizmo(painter, view, *place, d->settings->gizmo()->tool(), d->gizmoHover);
    }
    painter.restore();
}

} // namespace ramure
