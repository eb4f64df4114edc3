#include "widgets/view/tools/gizmo/gizmo_tool.h"

#include "core/math/drag_maths.h"
#include "widgets/base/texts/node_words.h"
#include "widgets/view/tools/readout.h"
#include "widgets/view/tools/tool_table.h"
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ramure {
namespace {

constexpr double clickReach = 3.0; ///< logical pixels: less is no drag

GizmoModifiers modifiersOf(Qt::KeyboardModifiers keys)
{
    return {keys.testFlag(Qt::ControlModifier), keys.testFlag(Qt::ShiftModifier)};
}

/// "Move tree".
QString toolText(TransformTool tool, const QString& target)
{
    switch (tool) {
    case TransformTool::Rotate:
        return GizmoTool::tr("Rotate %1").arg(target);
    case TransformTool::Scale:
        return GizmoTool::tr("Scale %1").arg(target);
    case TransformTool::Select:
    case TransformTool::Measure:
    case TransformTool::Move:
        break;
    }
    return GizmoTool::tr("Move %1").arg(target);
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

} // namespace

GizmoTool::GizmoTool(ToolContext& context)
    : Tool(context)
{
    connect(&context.gizmo, &GizmoSettings::changed, this, [this] {
        m_stale = true;
        m_hover.reset();
        m_context.host.repaint();
    });
}

GizmoTool::~GizmoTool() = default;

/// Nothing where no tool is chosen, nothing can be moved, or everything moves by itself.
std::optional<GizmoPlace> GizmoTool::place()
{
    if (m_drag)
        return m_drag->place();
    if (!transforms(m_context.gizmo.tool()) || m_context.isPlaying())
        return std::nullopt;
    const double seconds = m_context.seconds();
    if (std::exchange(m_stale, false) || seconds != m_restSeconds) {
        const Scene& scene = m_context.document.scene();
        const auto starts = transformStarts(scene, m_context.document.selection().nodes, seconds, false);
        m_rest.reset();
        m_restSeconds = seconds;
        if (!starts.empty())
            m_rest = GizmoPlace{shownPivot(scene, starts), transformAxes(starts, m_context.gizmo.space())};
    }
    return m_rest;
}

std::optional<GizmoHandle> GizmoTool::handleAt(const ToolPoint& point)
{
    const auto here = place();
    return here ? gizmoHandleAt(point.view, point.pixel(), *here, m_context.gizmo.tool()) : std::nullopt;
}

void GizmoTool::show(std::optional<GizmoHandle> handle)
{
    if (std::exchange(m_hover, handle) != handle)
        m_context.host.repaint();
}

bool GizmoTool::hover(const ToolPoint& point)
{
    show(handleAt(point));
    return m_hover.has_value();
}

void GizmoTool::take(TransformTool tool, std::optional<GizmoHandle> handle, const ToolPoint& point)
{
    const bool keys = m_context.keys && m_context.keys->isOn();
    m_drag = GizmoDrag::begin(m_context.document, m_context.gizmo, tool, handle, m_context.seconds(), keys,
                              point.view, point.pixel());
    m_byKeys = !handle;
    m_moves = false;
    m_last = point.at;
}

bool GizmoTool::press(const ToolPoint& point)
{
    const bool free = point.button == Qt::LeftButton && !point.held.testFlag(Qt::AltModifier);
    const auto handle = free ? handleAt(point) : std::nullopt;
    if (handle)
        take(m_context.gizmo.tool(), handle, point);
    return m_drag != nullptr;
}

bool GizmoTool::beginByKeys(TransformTool tool, const ToolPoint& point)
{
    if (m_context.isPlaying())
        m_context.player->pause();
    take(tool, std::nullopt, point);
    if (!m_drag) {
        const Selection& selection = m_context.document.selection();
        m_context.host.raiseMessage(
            selection.nodes.empty() && !selection.branches.empty()
                ? tr("Drag with Ctrl to bend branches. To move the tree, select it")
                : tr("Select a node that is shown and not locked: then it can be moved"));
        return false;
    }
    m_context.gizmo.tool.set(tool);
    begin(Qt::NoButton);
    return true;
}

/// A click ends what the keyboard began; the right button takes anything back.
void GizmoTool::pressAgain(const ToolPoint& point)
{
    if (point.button == Qt::RightButton || m_byKeys)
        finish(point.button == Qt::LeftButton);
}

void GizmoTool::drag(const ToolPoint& point)
{
    const QPointF way = point.at - point.pressed;
    m_last = point.at;
    m_moves = m_moves || m_byKeys || std::hypot(way.x(), way.y()) >= clickReach;
    follow(point.view, point.held);
}

void GizmoTool::follow(const PickView& view, Qt::KeyboardModifiers held)
{
    if (m_moves)
        m_drag->moveTo(view, {m_last.x(), m_last.y()}, modifiersOf(held));
    m_context.host.repaint();
}

void GizmoTool::release(const ToolPoint&)
{
    finish(true);
}

void GizmoTool::cancel()
{
    finish(false);
}

void GizmoTool::finish(bool keep)
{
    const auto drag = std::exchange(m_drag, nullptr);
    keep ? drag->keep() : drag->cancel();
    m_stale = true;
    end();
}

void GizmoTool::key(const QKeyEvent& event, bool pressed)
{
    if (event.key() == Qt::Key_Control || event.key() == Qt::Key_Shift) {
        Qt::KeyboardModifiers held = event.modifiers();
        held.setFlag(event.key() == Qt::Key_Control ? Qt::ControlModifier : Qt::ShiftModifier, pressed);
        m_moves = m_moves || m_byKeys;
        return follow(m_context.host.view(), held);
    }
    if (pressed && m_drag->key(event.key(), event.text(), event.modifiers()) == GizmoDrag::KeyResult::Confirm)
        finish(true);
    m_context.host.repaint();
}

void GizmoTool::documentChanged(const Change&)
{
    m_stale = true;
}

/// Whoever goes on elsewhere in the program is content with where things are.
void GizmoTool::focusLost()
{
    if (m_byKeys)
        finish(true);
}

QString GizmoTool::whatMoves() const
{
    return nodeWords(m_context.document.scene(), m_context.document.selection().nodes);
}

QString GizmoTool::hint(Qt::KeyboardModifiers) const
{
    const QString target = whatMoves();
    return toolText(m_drag ? m_drag->tool() : m_context.gizmo.tool(),
                    target.isEmpty() ? tr("selection") : target) +
           QStringLiteral(": ") +
           (m_byKeys ? tr("click or Enter: done · Esc: back · X Y Z: axis (Shift: plane) · digits: value · "
                          "Ctrl: steps · Shift: fine · Tab: next")
                     : tr("release: done · Esc: back · X Y Z: axis · digits: value · Ctrl: steps · "
                          "Shift: fine"));
}

QString GizmoTool::hintAt(const ToolPoint&) const
{
    return m_hover ? toolText(m_context.gizmo.tool(), whatMoves()) + QStringLiteral(": ") +
                         tr("drag · Ctrl: steps · Shift: fine · digits: value")
                   : QString();
}

void GizmoTool::offer(ToolOffers& offers) const
{
    const QString target = whatMoves();
    const QString keys = m_context.gestureKeys ? m_context.gestureKeys() : QString();
    const bool isMeant = m_context.hand.tool() == HandTool::None; // else a tree is shaped
    if (isMeant && offers.held() == Qt::NoModifier && !target.isEmpty() && !keys.isEmpty())
        offers.add(ToolOffers::Keys, tr("%1: move, rotate, scale %2").arg(keys, target));
}

void GizmoTool::paint(QPainter& painter, const PickView& view)
{
    const auto here = place();
    if (!here)
        return;
    if (!m_drag)
        return paintGizmo(painter, view, *here, m_context.gizmo.tool(), m_hover);
    const auto& handle = m_drag->handle();
    const bool free = !handle || handle->part == GizmoPart::Centre || handle->part == GizmoPart::View;
    for (int axis = 0; axis < 3 && !free; ++axis)
        if ((handle->part == GizmoPart::Axis) == (handle->axis == axis))
            paintAxis(painter, view, m_drag->start(), axis);
    const bool turns = m_drag->tool() == TransformTool::Rotate;
    if (turns)
        paintSweep(painter, view, *m_drag);
    paintGizmo(painter, view, *here, m_drag->tool(),
               handle ? *handle : GizmoHandle{turns ? GizmoPart::View : GizmoPart::Centre, 0});
    paintReadout(painter, m_last, sizeOf(view), m_drag->readout());
}

std::unique_ptr<Tool> makeGizmoTool(ToolContext& context)
{
    return std::make_unique<GizmoTool>(context);
}

} // namespace ramure
