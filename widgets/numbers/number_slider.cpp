#include "widgets/numbers/number_slider.h"

#include <QKeyEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr int resolution = 10000;
constexpr double logarithmicFrom = 1000.0; ///< maximum / minimum

} // namespace

NumberSlider::NumberSlider(QWidget* parent)
    : QSlider(Qt::Horizontal, parent)
{
    setRange(0, resolution);
    setFocusPolicy(Qt::StrongFocus);
    connect(this, &QSlider::sliderPressed, this, &NumberSlider::gestureBegan);
    connect(this, &QSlider::sliderReleased, this, &NumberSlider::gestureEnded);
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
    if (isSliderDown() && value)
        return; // the handle stays under the hand
    m_showing = true;
    QSlider::setValue(value ? positionOf(*value) : 0);
    m_showing = false;
    setProperty("mixed", !value.has_value());
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

QSize NumberSlider::sizeHint() const
{
    return {60, QSlider::sizeHint().height()};
}

} // namespace ramure
