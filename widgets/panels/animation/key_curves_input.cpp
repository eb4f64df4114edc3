// Mouse and keyboard of the curve editor.
#include "widgets/base/timeline_ruler.h"
#include "widgets/panels/animation/key_curves.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QToolTip>
#include <algorithm>
#include <array>
#include <cmath>

namespace ramure {

static constexpr double curveReach = 8.0;

std::optional<KeyCurves::Hit> KeyCurves::hitAt(const QPointF& place) const
{
    std::optional<Hit> best;
    double nearest = curveReach;
    const auto look = [&](const QPointF& at, const Hit& hit) {
        const double distance = std::hypot(at.x() - place.x(), at.y() - place.y());
        if (distance >= nearest)
            return;
        nearest = distance;
        best = hit;
    };
    for (const Curve& curve : m_curves) {
        const std::size_t end = curve.lowerBound(ticksAt(place.x() + curveReach) + 1);
        for (std::size_t i = curve.lowerBound(ticksAt(place.x() - curveReach)); i < end; ++i)
            look({xOf(secondsOf(curve.timeOf(i))), yOf(curve, curve.valueOf(i))},
                 {curve.ref(), curve.timeOf(i), 0});
        if (curve.isAngle())
            continue;
        for (const Ticks time : selectedOf(curve))
            if (const auto index = curve.find(time))
                for (const int side : {-1, 1})
                    if (showsHandle(curve, *index, side))
                        look(handlePlace(curve, *curve.numberKey(*index), side), {curve.ref(), time, side});
    }
    return best;
}

void KeyCurves::mousePressEvent(QMouseEvent* event)
{
    if (m_drag != Drag::None)
        return;
    m_press = m_at = event->position();
    m_moved = false;
    m_offset = 0;
    m_pixels = 0.0;
    if (event->button() == Qt::MiddleButton) {
        m_drag = Drag::Scroll;
        return;
    }
    if (event->button() != Qt::LeftButton)
        return;
    const auto hit = hitAt(m_press);
    if (!hit) {
        m_drag = Drag::Box;
        return;
    }
    m_hit = *hit;
    if (hit->side != 0) {
        m_drag = Drag::Handle;
        m_gesture = newGesture();
        m_model->document()->holdGesture(m_gesture);
        return;
    }
    if (event->modifiers() & Qt::ShiftModifier) {
        KeySelection selection = m_model->selection();
        std::vector<Ticks>& times = selection[hit->ref.track];
        const auto at = std::lower_bound(times.begin(), times.end(), hit->time);
        if (at != times.end() && *at == hit->time)
            times.erase(at);
        else
            times.insert(at, hit->time);
        return m_model->setSelection(selection);
    }
    if (!isSelected(hit->ref.track, hit->time))
        m_model->setSelection({{hit->ref.track, {hit->time}}});
    m_drag = Drag::Keys;
}

void KeyCurves::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF before = m_at;
    m_at = event->position();
    if (m_drag == Drag::None ||
        (!m_moved && (m_at - m_press).manhattanLength() < QApplication::startDragDistance()))
        return;
    m_moved = true;
    if (m_drag == Drag::Scroll) {
        const double frames = m_ruler->framesAt(before.x()) - m_ruler->framesAt(m_at.x());
        const double values = (m_at.y() - before.y()) * (m_high - m_low) / std::max(1, height());
        m_low += values;
        m_high += values;
        m_ruler->scrollBy(frames);
    } else if (m_drag == Drag::Keys) {
        const Ticks way = ticksAt(m_at.x()) - ticksAt(m_press.x());
        const bool valueOnly = (event->modifiers() & Qt::ControlModifier) != 0;
        const bool free = (event->modifiers() & Qt::ShiftModifier) != 0;
        m_offset = valueOnly ? 0 : free ? way : m_commands->snapped(m_hit.time + way) - m_hit.time;
        // A key on half a frame does not jump by itself.
        if (std::abs(m_at.x() - m_press.x()) < 3.0)
            m_offset = 0;
        m_pixels = m_at.y() - m_press.y();
    } else if (m_drag == Drag::Handle) {
        dragHandle(m_at);
    }
    update();
}

/// The curve follows at once; all of the drag is one step.
void KeyCurves::dragHandle(const QPointF& place)
{
    const Curve* curve = curveOf(m_hit.ref);
    const auto index = curve ? curve->find(m_hit.time) : std::nullopt;
    if (!index)
        return giveUp();
    Key key = *curve->numberKey(*index);
    const double rate = m_model->timeline().framesPerSecond;
    Handle handle;
    handle.dt = std::clamp(m_ruler->framesAt(place.x()) / rate - secondsOf(key.time), -1e6, 1e6);
    handle.dt = m_hit.side < 0 ? std::min(handle.dt, 0.0) : std::max(handle.dt, 0.0);
    handle.dv = -(place.y() - yOf(*curve, key.value)) * unitsPerPixel(*curve);
    HandleType& mine = m_hit.side < 0 ? key.before : key.behind;
    HandleType& other = m_hit.side < 0 ? key.behind : key.before;
    // As in Blender: a handle that stood by itself is now put by hand, smooth ones both.
    if (mine == HandleType::Auto || mine == HandleType::AutoClamped) {
        mine = HandleType::Aligned;
        if (other == HandleType::Auto || other == HandleType::AutoClamped)
            other = HandleType::Aligned;
    } else if (mine == HandleType::Vector) {
        mine = HandleType::Free;
    }
    (m_hit.side < 0 ? key.in : key.out) = handle;
    if (mine == HandleType::Aligned && other == HandleType::Aligned) {
        Handle& opposite = m_hit.side < 0 ? key.out : key.in;
        const double length = std::abs(opposite.dt);
        if (handle.dt != 0.0)
            opposite = {m_hit.side < 0 ? length : -length,
                        handle.dv / handle.dt * (m_hit.side < 0 ? length : -length)};
    }
    m_commands->replaceKey(m_hit.ref.track, key, m_gesture);
}

void KeyCurves::mouseReleaseEvent(QMouseEvent* event)
{
    const Drag drag = std::exchange(m_drag, Drag::None);
    m_at = event->position();
    if (drag == Drag::Handle)
        m_model->document()->keepGesture(m_gesture);
    if (drag == Drag::Keys) {
        if (m_moved)
            finishKeys();
        else
            m_model->setSelection({{m_hit.ref.track, {m_hit.time}}});
    } else if (drag == Drag::Box) {
        finishBox((event->modifiers() & Qt::ShiftModifier) != 0);
    }
    update();
}

void KeyCurves::finishKeys()
{
    if (m_offset == 0 && m_pixels == 0.0)
        return;
    std::map<CurveRef, double> shifts;
    for (const Curve& curve : m_curves)
        if (follows(curve))
            shifts[curve.ref()] = -m_pixels * unitsPerPixel(curve) * curve.unit();
    m_commands->shift(m_offset, shifts);
}

void KeyCurves::finishBox(bool adds)
{
    KeySelection selection = adds ? m_model->selection() : KeySelection();
    const QRectF box = QRectF(m_press, m_at).normalized();
    for (const Curve& curve : m_curves) {
        if (!m_moved)
            break;
        std::vector<Ticks>& times = selection[curve.ref().track];
        for (std::size_t i = 0; i < curve.size(); ++i)
            if (box.contains(xOf(secondsOf(curve.timeOf(i))), yOf(curve, curve.valueOf(i))))
                times.push_back(curve.timeOf(i));
        std::sort(times.begin(), times.end());
        times.erase(std::unique(times.begin(), times.end()), times.end());
    }
    m_model->setSelection(selection);
}

/// Also where the document has ended the gesture.
void KeyCurves::giveUp()
{
    if (std::exchange(m_drag, Drag::None) == Drag::Handle)
        m_model->document()->giveUpGesture(m_gesture);
    m_offset = 0;
    m_pixels = 0.0;
    update();
}

void KeyCurves::wheelEvent(QWheelEvent* event)
{
    const double factor = std::pow(0.8, double(event->angleDelta().y()) / 120.0);
    if (event->modifiers() & Qt::ControlModifier) {
        m_ruler->zoomAbout(m_ruler->framesAt(event->position().x()), factor);
    } else {
        const double at = m_high - (m_high - m_low) * event->position().y() / std::max(1, height());
        if ((m_high - m_low) * factor < 1e12 && (m_high - m_low) * factor > 1e-9) {
            m_low = at - (at - m_low) * factor;
            m_high = at + (m_high - at) * factor;
        }
    }
    update();
    event->accept();
}

void KeyCurves::keyPressEvent(QKeyEvent* event)
{
    const bool control = (event->modifiers() & Qt::ControlModifier) != 0;
    const bool shift = (event->modifiers() & Qt::ShiftModifier) != 0;
    const auto nudgeValue = [this, shift](double pixels) {
        std::map<CurveRef, double> shifts;
        for (const Curve& curve : m_curves)
            if (follows(curve))
                shifts[curve.ref()] = pixels * (shift ? 10.0 : 1.0) * unitsPerPixel(curve) * curve.unit();
        m_commands->shift(0, shifts);
    };
    switch (event->key()) {
    case Qt::Key_Home:
        return fit();
    case Qt::Key_Escape:
        return m_drag == Drag::None ? m_commands->selectNone() : giveUp();
    case Qt::Key_Delete:
        return m_commands->remove();
    case Qt::Key_Up:
        return nudgeValue(1.0);
    case Qt::Key_Down:
        return nudgeValue(-1.0);
    case Qt::Key_Left:
        return m_commands->nudge(shift ? -10 : -1);
    case Qt::Key_Right:
        return m_commands->nudge(shift ? 10 : 1);
    case Qt::Key_A:
        if (control)
            return m_commands->selectAll();
        break;
    case Qt::Key_C:
        if (control)
            return m_commands->copy();
        break;
    case Qt::Key_V:
        if (control)
            return m_commands->paste(shift);
        break;
    default:
        break;
    }
    QWidget::keyPressEvent(event);
}

void KeyCurves::contextMenuEvent(QContextMenuEvent* event)
{
    if (m_drag != Drag::None)
        return;
    if (event->reason() == QContextMenuEvent::Mouse)
        if (const auto hit = hitAt(event->pos()); hit && !isSelected(hit->ref.track, hit->time))
            m_model->setSelection({{hit->ref.track, {hit->time}}});
    emit menuRequested(event->globalPos());
}

/// The nearest one, looked at straight above and below.
const KeyCurves::Curve* KeyCurves::lineAt(const QPointF& place) const
{
    const double seconds = m_ruler->framesAt(place.x()) / m_model->timeline().framesPerSecond;
    const Curve* best = nullptr;
    double nearest = curveReach;
    for (const Curve& curve : m_curves) {
        const double distance = std::abs(yOf(curve, Curve::Reader(curve).at(seconds)) - place.y());
        if (distance >= nearest)
            continue;
        nearest = distance;
        best = &curve;
    }
    return best;
}

QString KeyCurves::tipOf(const Curve& curve, double value, double seconds) const
{
    const Node* node = m_model->document()->scene().find(curve.ref().track.node);
    const double frame = seconds * m_model->timeline().framesPerSecond;
    return (node ? QString::fromStdString(node->name) + QStringLiteral(" · ") : QString()) + curve.text() +
           QStringLiteral(": ") + curve.format().text(value) + QLatin1Char('\n') +
           tr("Frame %1, %2 s")
               .arg(locale().toString(std::round(1e3 * frame) / 1e3, 'g', 10),
                    locale().toString(seconds, 'f', 3));
}

QString KeyCurves::tipAt(const QPointF& place) const
{
    const auto hit = hitAt(place);
    if (hit && hit->side != 0)
        return tr("Drag the handle: how the curve leaves the key, or comes to it");
    const Curve* curve = hit ? curveOf(hit->ref) : lineAt(place);
    if (!curve)
        return {};
    if (const auto key = hit ? curve->find(hit->time) : std::nullopt)
        return tipOf(*curve, curve->valueOf(*key), secondsOf(hit->time));
    const double seconds = m_ruler->framesAt(place.x()) / m_model->timeline().framesPerSecond;
    return tipOf(*curve, Curve::Reader(*curve).at(seconds), seconds);
}

bool KeyCurves::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        QToolTip::showText(help->globalPos(), tipAt(help->pos()), this);
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        static constexpr std::array plain{Qt::Key_Delete, Qt::Key_Home, Qt::Key_Escape, Qt::Key_Up,
                                          Qt::Key_Down,   Qt::Key_Left, Qt::Key_Right};
        static constexpr std::array control{Qt::Key_A, Qt::Key_C, Qt::Key_V};
        if (std::count(plain.begin(), plain.end(), key->key()) > 0 ||
            ((key->modifiers() & Qt::ControlModifier) &&
             std::count(control.begin(), control.end(), key->key()) > 0)) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

} // namespace ramure
