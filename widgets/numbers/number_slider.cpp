#include "widgets/numbers/number_slider.h"

#include "widgets/theme/theme.h"
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr int resolution = 10000;
constexpr double logarithmicFrom = 1000.0; ///< maximum / minimum
constexpr double knobMargin = 8.0;         ///< of the handle's centre from the ends

} // namespace

NumberSlider::NumberSlider(QWidget* parent)
    : QSlider(Qt::Horizontal, parent)
{
    setRange(0, resolution);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_Hover); // the handle grows under the mouse
    connect(this, &QSlider::valueChanged, this, [this](int position) {
        if (!m_showing)
            edit(numberAt(position));
    });
}

void NumberSlider::setSoftRange(double minimum, double maximum, double step, bool whole)
{
    m_minimum = minimum;
    m_maximum = std::max(maximum, minimum);
    m_step = step;
    m_whole = whole;
    m_logarithmic = minimum > 0.0 && maximum / minimum >= logarithmicFrom;
    setNumber(m_number);
}

double NumberSlider::numberAt(int position) const
{
    const double t = static_cast<double>(position) / resolution;
    if (m_logarithmic)
        return m_minimum * std::pow(m_maximum / m_minimum, t);
    const double value = m_minimum + t * (m_maximum - m_minimum);
    if (m_whole)
        return std::round(value);
    // Steps of the slider that the number field can show without a rest.
    const double grid = std::pow(10.0, std::floor(std::log10(std::max(m_maximum - m_minimum, 1e-9))) - 3.0);
    return std::clamp(std::round(value / grid) * grid, m_minimum, m_maximum);
}

int NumberSlider::positionOf(double value) const
{
    if (m_maximum <= m_minimum)
        return 0;
    const double held = std::clamp(value, m_minimum, m_maximum);
    const double t = m_logarithmic ? std::log(held / m_minimum) / std::log(m_maximum / m_minimum)
                                   : (held - m_minimum) / (m_maximum - m_minimum);
    return static_cast<int>(std::lround(t * resolution));
}

void NumberSlider::setNumber(std::optional<double> value)
{
    m_number = value;
    if (m_dragging && value) {
        update();
        return;
    }
    m_showing = true;
    QSlider::setValue(value ? positionOf(*value) : 0);
    m_showing = false;
    update();
}

void NumberSlider::edit(double value)
{
    if (m_number && *m_number == value)
        return;
    m_number = value;
    emit numberEdited(value);
}

void NumberSlider::moveBy(double steps)
{
    const double from = m_number.value_or(m_minimum);
    double to = m_logarithmic ? from * std::pow(1.1, steps) : from + steps * m_step;
    if (m_whole)
        to = from + (steps > 0 ? std::max(1.0, std::round(steps * m_step))
                               : std::min(-1.0, std::round(steps * m_step)));
    edit(std::clamp(to, std::min(m_minimum, from), std::max(m_maximum, from)));
    setNumber(m_number);
}

void NumberSlider::focusInEvent(QFocusEvent* event)
{
    QSlider::focusInEvent(event);
    emit gestureBegan();
}

void NumberSlider::focusOutEvent(QFocusEvent* event)
{
    QSlider::focusOutEvent(event);
    emit gestureEnded();
}

void NumberSlider::keyPressEvent(QKeyEvent* event)
{
    const bool rightToLeft = layoutDirection() == Qt::RightToLeft;
    switch (event->key()) {
    case Qt::Key_Right:
        return moveBy(rightToLeft ? -1.0 : 1.0);
    case Qt::Key_Left:
        return moveBy(rightToLeft ? 1.0 : -1.0);
    case Qt::Key_Up:
        return moveBy(1.0);
    case Qt::Key_Down:
        return moveBy(-1.0);
    case Qt::Key_PageUp:
        return moveBy(10.0);
    case Qt::Key_PageDown:
        return moveBy(-10.0);
    case Qt::Key_Home:
        edit(m_minimum);
        return setNumber(m_number);
    case Qt::Key_End:
        edit(m_maximum);
        return setNumber(m_number);
    default:
        QSlider::keyPressEvent(event);
    }
}

double NumberSlider::knobAt() const
{
    const double t = static_cast<double>(QSlider::value()) / resolution;
    return knobMargin + (layoutDirection() == Qt::RightToLeft ? 1.0 - t : t) * (width() - 2.0 * knobMargin);
}

void NumberSlider::dragTo(double x)
{
    const double t = std::clamp((x - knobMargin) / std::max(1.0, width() - 2.0 * knobMargin), 0.0, 1.0);
    QSlider::setValue(
        static_cast<int>(std::lround((layoutDirection() == Qt::RightToLeft ? 1.0 - t : t) * resolution)));
}

void NumberSlider::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        event->ignore();
        return;
    }
    m_dragging = true;
    emit gestureBegan();
    // The handle is taken where it is; a press beside it brings it there.
    m_grip =
        std::abs(event->position().x() - knobAt()) <= knobMargin ? event->position().x() - knobAt() : 0.0;
    dragTo(event->position().x() - m_grip);
}

void NumberSlider::mouseMoveEvent(QMouseEvent* event)
{
    if (m_dragging)
        dragTo(event->position().x() - m_grip);
    else
        event->ignore();
}

void NumberSlider::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || !m_dragging) {
        event->ignore();
        return;
    }
    m_dragging = false;
    setNumber(m_number); // a whole number's own place
    emit gestureEnded();
}

void NumberSlider::wheelEvent(QWheelEvent* event)
{
    if (!hasFocus()) {
        event->ignore();
        return;
    }
    const int steps = event->angleDelta().y() / 120;
    if (steps != 0)
        moveBy(steps);
    event->accept();
}

void NumberSlider::paintEvent(QPaintEvent*)
{
    const QPointF knob(knobAt(), height() / 2.0);
    const double radius = underMouse() || m_dragging ? 7.0 : 6.0;
    const bool dark = isDark(palette());
    QColor groove = palette().color(QPalette::WindowText);
    groove.setAlphaF(isEnabled() ? 0.22f : 0.12f);
    QColor filled = palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::Highlight);
    QColor edge = palette().color(QPalette::WindowText);
    edge.setAlphaF(0.4f);

    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    const QRectF whole(2.0, knob.y() - 2.0, width() - 4.0, 4.0);
    painter.setBrush(groove);
    painter.drawRoundedRect(whole, 2.0, 2.0);
    if (!m_number)
        return; // several values: no handle to believe
    QRectF part = whole;
    if (layoutDirection() == Qt::RightToLeft)
        part.setLeft(knob.x());
    else
        part.setRight(knob.x());
    painter.setBrush(filled);
    painter.drawRoundedRect(part, 2.0, 2.0);
    painter.setBrush(dark ? QColor(0xd5, 0xdb, 0xd6) : QColor(Qt::white));
    painter.setPen(QPen(hasFocus() ? filled : edge, hasFocus() ? 2.0 : 1.0));
    painter.drawEllipse(knob, radius, radius);
}

QSize NumberSlider::sizeHint() const
{
    return {60, QSlider::sizeHint().height()};
}

} // namespace ramure
