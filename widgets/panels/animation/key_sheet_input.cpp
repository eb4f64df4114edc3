// Mouse and keyboard of the dope sheet.
#include "widgets/base/timeline_ruler.h"
#include "widgets/panels/animation/key_sheet.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>

namespace ramure {

static constexpr double keyReach = 7.0;

std::optional<Ticks> KeySheet::keyAt(std::size_t row, double x) const
{
    const std::vector<Ticks>& times = m_model->rows()[row].times;
    const Ticks from = timeAt(x - keyReach), to = timeAt(x + keyReach), mid = timeAt(x);
    std::optional<Ticks> best;
    for (auto at = std::lower_bound(times.begin(), times.end(), from); at != times.end() && *at <= to; ++at) {
        if (!best || std::abs(*at - mid) < std::abs(*best - mid))
            best = *at;
        else
            break; // further and further away
    }
    return best;
}

KeySheet::Drag KeySheet::handleAt(const QPointF& position) const
{
    const auto span = keys::spanOf(m_model->selection());
    if (position.y() >= strip || !span || span->first == span->second)
        return Drag::None;
    if (std::abs(position.x() - xOf(span->second)) <= keyReach)
        return Drag::ScaleLast;
    return std::abs(position.x() - xOf(span->first)) <= keyReach ? Drag::ScaleFirst : Drag::None;
}

void KeySheet::mousePressEvent(QMouseEvent* event)
{
    if (m_drag != Drag::None)
        return; // a second button during a drag
    m_press = m_at = event->position();
    m_dragX = m_press.x();
    m_moved = m_copies = false;
    m_preview = {};
    if (event->button() == Qt::MiddleButton) {
        m_drag = Drag::Scroll;
        return;
    }
    if (event->button() != Qt::LeftButton)
        return;
    if (const auto span = keys::spanOf(m_model->selection()))
        m_span = *span;
    m_drag = handleAt(m_press);
    if (m_drag != Drag::None)
        return;
    const auto row = rowAt(m_press.y());
    if (row) {
        m_row = *row;
        m_current = nameOf(m_model->rows()[*row]);
    }
    const auto time = row ? keyAt(*row, m_press.x()) : std::nullopt;
    if (time)
        return pressKey(*row, *time, event->modifiers());
    m_drag = Drag::Box;
    update();
}

void KeySheet::pressKey(std::size_t row, Ticks time, Qt::KeyboardModifiers modifiers)
{
    if (modifiers & Qt::AltModifier)
        return m_model->selectTimes(time, time,
                                    modifiers & Qt::ShiftModifier ? SelectHow::Toggle : SelectHow::Replace);
    const std::vector<Ticks>& selected = m_model->rows()[row].selected;
    m_wasSelected = std::binary_search(selected.begin(), selected.end(), time);
    m_grabbed = time;
    m_grabbedRow = row;
    if (modifiers & Qt::ShiftModifier)
        return m_model->select(row, row, time, time, SelectHow::Toggle);
    if (!m_wasSelected)
        m_model->select(row, row, time, time, SelectHow::Replace);
    m_drag = Drag::Key;
    m_copies = (modifiers & Qt::ControlModifier) != 0;
    m_span = *keys::spanOf(m_model->selection());
}

void KeySheet::mouseMoveEvent(QMouseEvent* event)
{
    m_at = event->position();
    if (m_drag == Drag::None) {
        setCursor(handleAt(m_at) == Drag::None ? Qt::ArrowCursor : Qt::SizeHorCursor);
        return;
    }
    if (!m_moved && (m_at - m_press).manhattanLength() < QApplication::startDragDistance())
        return;
    m_moved = true;
    dragTo(m_at, event->modifiers());
    const bool beyond = (m_at.x() < 0.0 || m_at.x() > width()) && m_drag != Drag::Scroll;
    if (beyond && !m_edgeScroll.isActive())
        m_edgeScroll.start();
    else if (!beyond)
        m_edgeScroll.stop();
}

void KeySheet::dragTo(const QPointF& position, Qt::KeyboardModifiers modifiers)
{
    if (m_drag == Drag::Scroll) {
        const double frames = m_ruler->framesAt(m_dragX) - m_ruler->framesAt(position.x());
        m_ruler->scrollBy(frames);
        m_scroll->setValue(m_scroll->value() - int(std::lround(position.y() - m_press.y())));
        m_press.setY(position.y());
        m_dragX = position.x();
    } else if (m_drag != Drag::Box) {
        dragSelection(position.x(), (modifiers & Qt::ShiftModifier) != 0);
    }
    update();
}

/// Only the preview: the document changes when the button is let go.
void KeySheet::dragSelection(double x, bool free)
{
    const auto target = [this, free](Ticks time) { return free ? time : m_commands->snapped(time); };
    if (m_drag == Drag::Key) {
        const Ticks way = timeAt(x) - timeAt(m_press.x());
        m_preview = {0, 1.0, way == 0 ? 0 : target(m_grabbed + way) - m_grabbed};
        return;
    }
    const Ticks fixed = m_drag == Drag::ScaleLast ? m_span.first : m_span.second;
    const Ticks moving = m_drag == Drag::ScaleLast ? m_span.second : m_span.first;
    const Ticks to = target(timeAt(x));
    // All keys at one time would be one key: the least is a hundredth.
    double factor = double(to - fixed) / double(moving - fixed);
    if (std::abs(factor) < 0.01)
        factor = 0.01;
    m_preview = {fixed, factor, 0};
}

void KeySheet::mouseReleaseEvent(QMouseEvent* event)
{
    const Drag drag = std::exchange(m_drag, Drag::None);
    m_edgeScroll.stop();
    const Retiming retiming = std::exchange(m_preview, {});
    const bool copies = std::exchange(m_copies, false);
    m_at = event->position();
    if (drag == Drag::Box) {
        finishBox(event->modifiers());
    } else if (drag != Drag::None && drag != Drag::Scroll) {
        if (retiming != Retiming())
            m_commands->retime(retiming, copies);
        else if (drag == Drag::Key && !m_moved && m_wasSelected)
            m_model->select(m_grabbedRow, m_grabbedRow, m_grabbed, m_grabbed, SelectHow::Replace);
    }
    update();
}

void KeySheet::finishBox(Qt::KeyboardModifiers modifiers)
{
    const bool adds = (modifiers & Qt::ShiftModifier) != 0;
    if (!m_moved) {
        if (!adds)
            m_model->setSelection({});
        return;
    }
    const QRectF box = QRectF(m_press, m_at).normalized();
    const double top = std::max(box.top(), double(strip)), bottom = box.bottom();
    const auto first =
        static_cast<std::size_t>(std::max(0.0, (top - strip + m_scroll->value()) / rowHeight()));
    if (bottom < strip || first >= m_model->rows().size())
        return adds ? void() : m_model->setSelection({});
    const auto last = static_cast<std::size_t>((bottom - strip + m_scroll->value()) / rowHeight());
    m_model->select(first, last, timeAt(box.left()), timeAt(box.right()),
                    adds ? SelectHow::Add : SelectHow::Replace);
}

void KeySheet::giveUp()
{
    m_drag = Drag::None;
    m_preview = {};
    m_copies = false;
    m_edgeScroll.stop();
    update();
}

void KeySheet::wheelEvent(QWheelEvent* event)
{
    const double notches = double(event->angleDelta().y() + event->angleDelta().x()) / 120.0;
    if (event->modifiers() & Qt::ControlModifier)
        m_ruler->zoomAbout(m_ruler->framesAt(event->position().x()), std::pow(0.8, notches));
    else if ((event->modifiers() & Qt::ShiftModifier) || event->angleDelta().x() != 0)
        m_ruler->scrollBy(-notches * 0.1 * (m_ruler->to() - m_ruler->from()));
    else
        return KeyRowsView::wheelEvent(event);
    event->accept();
}

void KeySheet::contextMenuEvent(QContextMenuEvent* event)
{
    const auto row = event->reason() == QContextMenuEvent::Mouse ? rowAt(event->pos().y()) : std::nullopt;
    const auto time = row ? keyAt(*row, event->pos().x()) : std::nullopt;
    if (time) {
        const std::vector<Ticks>& selected = m_model->rows()[*row].selected;
        if (!std::binary_search(selected.begin(), selected.end(), *time))
            m_model->select(*row, *row, *time, *time, SelectHow::Replace);
    }
    emit menuRequested(event->globalPos());
}

bool KeySheet::keyCommand(const QKeyEvent* event)
{
    const bool control = (event->modifiers() & Qt::ControlModifier) != 0;
    const bool shift = (event->modifiers() & Qt::ShiftModifier) != 0;
    switch (event->key()) {
    case Qt::Key_A:
        return control && (m_commands->selectAll(), true);
    case Qt::Key_C:
        return control && (m_commands->copy(), true);
    case Qt::Key_X:
        return control && (m_commands->cut(), true);
    case Qt::Key_V:
        return control && (m_commands->paste(shift), true);
    case Qt::Key_D:
        return control && (m_commands->duplicate(), true);
    case Qt::Key_M:
        return control && (m_commands->mirror(), true);
    case Qt::Key_K:
        return !control && (m_commands->selectColumn(), true);
    case Qt::Key_BracketLeft:
        return m_commands->selectBefore(), true;
    case Qt::Key_BracketRight:
        return m_commands->selectBehind(), true;
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        return m_commands->remove(), true;
    case Qt::Key_Escape:
        if (m_drag != Drag::None)
            giveUp();
        else
            m_commands->selectNone();
        return true;
    default:
        return false;
    }
}

bool KeySheet::keyStep(const QKeyEvent* event)
{
    const bool shift = (event->modifiers() & Qt::ShiftModifier) != 0;
    const bool alt = (event->modifiers() & Qt::AltModifier) != 0;
    const bool forward = event->key() == Qt::Key_Right || event->key() == Qt::Key_Plus;
    switch (event->key()) {
    case Qt::Key_Up:
        return setCurrentRow(m_row == 0 ? 0 : m_row - 1), true;
    case Qt::Key_Down:
        return setCurrentRow(m_row + 1), true;
    case Qt::Key_Left:
    case Qt::Key_Right:
        if (alt)
            m_commands->nudge((forward ? 1 : -1) * (shift ? 10 : 1));
        else
            stepKey(forward, shift);
        return true;
    case Qt::Key_Home:
        return fit(), true;
    case Qt::Key_Plus:
    case Qt::Key_Minus:
        return m_ruler->zoomAbout(0.5 * (m_ruler->from() + m_ruler->to()), forward ? 0.8 : 1.25), true;
    default:
        return false;
    }
}

/// From the selected keys of the current row on; without one from the playhead.
void KeySheet::stepKey(bool forward, bool extend)
{
    if (m_row >= m_model->rows().size())
        return;
    const KeyRow& row = m_model->rows()[m_row];
    Ticks from = m_commands->now() + (forward ? -1 : 1);
    if (!row.selected.empty())
        from = forward ? row.selected.back() : row.selected.front();
    auto at = forward ? std::upper_bound(row.times.begin(), row.times.end(), from)
                      : std::lower_bound(row.times.begin(), row.times.end(), from);
    if (forward ? at == row.times.end() : at == row.times.begin())
        return;
    const Ticks time = forward ? *at : *std::prev(at);
    m_model->select(m_row, m_row, time, time, extend ? SelectHow::Add : SelectHow::Replace);
}

void KeySheet::keyPressEvent(QKeyEvent* event)
{
    if (!keyCommand(event) && !keyStep(event))
        KeyRowsView::keyPressEvent(event);
}

} // namespace ramure
