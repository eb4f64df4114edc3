#include "widgets/base/fields/number_slider.h"

#include "widgets/base/fields/number_drag.h"
#include "widgets/base/theme/theme.h"
#include "widgets/base/theme/wheel_guard.h"
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QTextDocument>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr int resolution = 10000;
constexpr double knobMargin = 8.0; ///< of the handle's centre from the ends

} // namespace

NumberSlider::NumberSlider(QWidget* parent)
    : QSlider(Qt::Horizontal, parent)
{
    setRange(0, resolution);
    setFocusPolicy(Qt::StrongFocus);
    guardFromWheel(this);
    setAttribute(Qt::WA_Hover); // the handle grows under the mouse
    m_drag = new NumberDrag(this);
    connect(m_drag, &NumberDrag::moved, this, [this](double number) {
        edit(number);
        setNumber(m_number);
    });
    connect(m_drag, &NumberDrag::ended, this, &NumberSlider::gestureEnded);
    connect(this, &QSlider::valueChanged, this, [this](int position) {
        if (!m_showing)
            edit(numberAt(position));
    });
}

void NumberSlider::setSoftRange(double minimum, double maximum, double step, bool whole)
{
    m_scale = NumberScale(minimum, maximum, step, whole);
    setNumber(m_number);
}

double NumberSlider::numberAt(int position) const
{
    const double number =
        m_scale.numberAt(static_cast<double>(position) / resolution, 1.0 / grooveLength(), m_factor);
    return std::clamp(number, m_scale.minimum(), m_scale.maximum());
}

int NumberSlider::positionOf(double value) const
{
    return static_cast<int>(std::lround(std::clamp(m_scale.positionOf(value), 0.0, 1.0) * resolution));
}

void NumberSlider::setNumber(std::optional<double> value)
{
    m_number = value;
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
    const double from = m_number.value_or(m_scale.minimum());
    const double step = steps * m_scale.step();
    double to = m_scale.isLogarithmic() ? from * std::pow(1.1, steps) : from + step;
    if (m_scale.isWhole())
        to = from + (steps > 0 ? std::max(1.0, std::round(step)) : std::min(-1.0, std::round(step)));
    edit(std::clamp(to, std::min(m_scale.minimum(), from), std::max(m_scale.maximum(), from)));
    setNumber(m_number);
}

bool NumberSlider::event(QEvent* event)
{
    if (event->type() != QEvent::ToolTip)
        return QSlider::event(event);
    const QWidget* row = this;
    while (row->toolTip().isEmpty() && !row->isWindow())
        row = row->parentWidget();
    const QString tip = row->toolTip(), fine = tr("Drag with Shift: ten times as fine");
    const QString line = tip.isEmpty()              ? fine
                         : Qt::mightBeRichText(tip) ? tip + QStringLiteral("<p>%1</p>").arg(fine)
                                                    : tip + u'\n' + fine;
    QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), line, this);
    return true;
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
        edit(m_scale.minimum());
        return setNumber(m_number);
    case Qt::Key_End:
        edit(m_scale.maximum());
        return setNumber(m_number);
    default:
        QSlider::keyPressEvent(event);
    }
}

double NumberSlider::grooveLength() const
{
    return std::max(1.0, width() - 2.0 * knobMargin);
}

double NumberSlider::knobAt() const
{
    const double t = static_cast<double>(QSlider::value()) / resolution;
    return knobMargin + (layoutDirection() == Qt::RightToLeft ? 1.0 - t : t) * grooveLength();
}

int NumberSlider::positionAt(double x) const
{
    const double t = std::clamp((x - knobMargin) / grooveLength(), 0.0, 1.0);
    return static_cast<int>(std::lround((layoutDirection() == Qt::RightToLeft ? 1.0 - t : t) * resolution));
}

double NumberSlider::along(double x) const
{
    return layoutDirection() == Qt::RightToLeft ? width() - x : x;
}

void NumberSlider::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        event->ignore();
        return;
    }
    emit gestureBegan();
    const std::optional<double> before = m_number;
    const double x = event->position().x();
    const bool isBeside = !m_number || std::abs(x - knobAt()) > knobMargin;
    const int held = isBeside ? positionAt(x) : QSlider::value();
    if (isBeside)
        QSlider::setValue(held);
    NumberDrag::Start start;
    start.least = m_scale.minimum();
    start.most = m_scale.maximum();
    start.value = std::clamp(m_number.value_or(start.least), start.least, start.most);
    start.factor = m_factor;
    start.x = along(x);
    start.length = grooveLength();
    start.held = static_cast<double>(held) / resolution;
    m_drag->begin(m_scale, start, before);
}

void NumberSlider::mouseMoveEvent(QMouseEvent* event)
{
    if (!m_drag->isOn()) {
        event->ignore();
        return;
    }
    m_drag->moveTo(along(event->position().x()), event->modifiers() & Qt::ShiftModifier);
}

void NumberSlider::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        event->ignore();
        return;
    }
    m_drag->end();
}

void NumberSlider::hideEvent(QHideEvent* event)
{
    m_drag->end();
    QSlider::hideEvent(event);
}

void NumberSlider::wheelEvent(QWheelEvent* event)
{
    const int steps = event->angleDelta().y() / 120;
    if (steps != 0)
        moveBy(steps);
    event->accept();
}

void NumberSlider::paintEvent(QPaintEvent*)
{
    const QPointF knob(knobAt(), height() / 2.0);
    const double radius = underMouse() || m_drag->isOn() ? 7.0 : 6.0;
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
