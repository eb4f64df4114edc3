#include "widgets/base/fields/number_field.h"

#include "widgets/base/fields/number_drag.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/wheel_guard.h"
#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QStyle>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr double dragFrom = 3.0;      ///< pixels from a press to a drag
constexpr double pixelsPerStep = 4.0; ///< without a scale
constexpr double sameText = 1e-12;    ///< relative: two ways of writing one number ("18", "18 deg")

} // namespace

NumberField::NumberField(QWidget* parent)
    : QAbstractSpinBox(parent)
{
    setButtonSymbols(NoButtons);
    setKeyboardTracking(false);
    setFocusPolicy(Qt::TabFocus); // by a click: see release()
    guardFromWheel(this);
    setAlignment(Qt::AlignRight);
    lineEdit()->setPlaceholderText(QStringLiteral("—"));
    lineEdit()->installEventFilter(this);
    m_drag = new NumberDrag(this);
    connect(m_drag, &NumberDrag::moved, this, &NumberField::edit);
    connect(m_drag, &NumberDrag::ended, this, &NumberField::gestureEnded);
    showValue();
    showCursor();
}

void NumberField::setFormat(const NumberFormat& format)
{
    m_format = format;
    showValue();
    updateGeometry();
}

void NumberField::setRange(double minimum, double maximum)
{
    m_minimum = minimum;
    m_maximum = maximum;
}

void NumberField::setStep(double step)
{
    m_step = step;
}

void NumberField::addHandle(QWidget* handle)
{
    m_handles.push_back(handle);
    handle->installEventFilter(this);
    showCursor();
}

void NumberField::setDefault(std::optional<double> value)
{
    m_default = value;
}

void NumberField::setValue(std::optional<double> value)
{
    m_value = value;
    if (!lineEdit()->isModified())
        showValue();
    showCursor();
}

/// Where a press can become a drag, the cursor says so.
void NumberField::showCursor()
{
    const Qt::CursorShape onHandle = m_value ? Qt::SizeHorCursor : Qt::ArrowCursor;
    for (QWidget* handle : m_handles)
        handle->setCursor(onHandle);
    const Qt::CursorShape onText = m_value && !hasFocus() ? Qt::SizeHorCursor : Qt::IBeamCursor;
    lineEdit()->setCursor(onText);
    setCursor(onText);
}

void NumberField::showValue()
{
    const QString text = m_value ? m_format.text(*m_value) : QString();
    if (lineEdit()->text() != text) {
        const bool selected = lineEdit()->hasSelectedText();
        lineEdit()->setText(text);
        if (selected)
            lineEdit()->selectAll();
    }
    lineEdit()->setModified(false);
}

void NumberField::edit(double value)
{
    const double held = std::clamp(m_format.whole ? std::round(value) : value, m_minimum, m_maximum);
    const bool differs = !m_value || *m_value != held;
    m_value = held;
    showValue();
    if (differs)
        emit valueEdited(held);
}

/// A value whose own text was typed again is that value, not the rounded one that the text says.
double NumberField::meant(double typed) const
{
    for (const std::optional<double>& known : {m_value, m_default}) {
        if (!known)
            continue;
        const auto read = m_format.parse(m_format.text(*known));
        if (read && std::abs(*read - typed) <= sameText * std::abs(typed))
            return *known;
    }
    return typed;
}

void NumberField::commit(bool keepBadText)
{
    if (!lineEdit()->isModified())
        return;
    const auto value = m_format.parse(lineEdit()->text());
    if (value) {
        setRefusal({});
        const double wish = meant(*value);
        edit(wish);
        if (wish > m_maximum)
            setNote(tr("the largest is %1").arg(m_format.text(m_maximum)));
        else if (wish < m_minimum)
            setNote(tr("the smallest is %1").arg(m_format.text(m_minimum)));
        else
            setNote({});
        return;
    }
    if (keepBadText) {
        setRefusal(errorText(value.error()));
        return;
    }
    setRefusal({});
    showValue();
}

void NumberField::setRefusal(const QString& reason)
{
    if (!m_refused && reason.isEmpty())
        return;
    m_refused = !reason.isEmpty();
    setProperty("refused", m_refused); // the style sheet draws a red frame
    style()->unpolish(this);
    style()->polish(this);
    emit refused(reason);
}

void NumberField::setNote(const QString& note)
{
    if (m_noted || !note.isEmpty())
        emit held(note);
    m_noted = !note.isEmpty();
}

void NumberField::stepBy(int steps)
{
    commit(false);
    const double step = m_format.whole ? std::max(1.0, m_step * m_stepFactor) : m_step * m_stepFactor;
    const double from = m_value.value_or(std::clamp(0.0, m_minimum, m_maximum));
    edit(from + steps * step);
}

/// What was typed and confirmed is a step of its own; arrows and the wheel go on until the field is left.
void NumberField::enter()
{
    const bool isTyped = lineEdit()->isModified();
    commit(true);
    if (m_refused)
        return;
    selectAll();
    if (!isTyped)
        return;
    emit gestureEnded();
    emit gestureBegan();
}

bool NumberField::eventFilter(QObject* watched, QEvent* event)
{
    const bool onHandle = watched != lineEdit();
    // With the focus the mouse belongs to the text, but a drag that has begun goes on.
    if (onHandle || !hasFocus() || m_pressedAt || m_drag->isOn()) {
        switch (event->type()) {
        case QEvent::MouseButtonPress:
            return press(static_cast<QMouseEvent*>(event));
        case QEvent::MouseMove:
            return drag(static_cast<QMouseEvent*>(event));
        case QEvent::MouseButtonRelease:
            return release(static_cast<QMouseEvent*>(event));
        default:
            break;
        }
    }
    return QAbstractSpinBox::eventFilter(watched, event);
}

bool NumberField::press(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || !isEnabled())
        return false;
    // What is being typed elsewhere is entered before this number changes.
    if (QWidget* other = QApplication::focusWidget();
        other && other != this && other->testAttribute(Qt::WA_InputMethodEnabled))
        other->clearFocus();
    m_pressedAt = event->globalPosition().x();
    return true;
}

bool NumberField::drag(QMouseEvent* event)
{
    const double x = event->globalPosition().x();
    if (m_drag->isOn()) {
        m_drag->moveTo(x, event->modifiers());
        return true;
    }
    if (!m_pressedAt)
        return false;
    const double from = *m_pressedAt;
    if (!m_value || std::abs(x - from) < dragFrom)
        return true;
    m_pressedAt.reset();
    commit(false); // of a label whose field has the focus
    emit gestureBegan();
    const double reach = NumberDrag::pixels / pixelsPerStep * m_step;
    m_drag->begin(m_scale.value_or(NumberScale(0.0, reach, reach, m_format.whole)),
                  {*m_value, m_minimum, m_maximum, m_format.factor, from}, m_value);
    m_drag->moveTo(x, event->modifiers()); // a quick hand has come far with the first move
    return true;
}

bool NumberField::release(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return false;
    if (m_drag->isOn()) {
        m_drag->end();
    } else if (m_pressedAt) {
        setFocus(Qt::MouseFocusReason);
        selectAll();
    }
    m_pressedAt.reset();
    return true;
}

void NumberField::mousePressEvent(QMouseEvent* event)
{
    if (hasFocus() || !press(event))
        QAbstractSpinBox::mousePressEvent(event);
}

void NumberField::mouseMoveEvent(QMouseEvent* event)
{
    if (!drag(event))
        QAbstractSpinBox::mouseMoveEvent(event);
}

void NumberField::mouseReleaseEvent(QMouseEvent* event)
{
    if (!release(event))
        QAbstractSpinBox::mouseReleaseEvent(event);
}

/// The menu of the text while there is one being typed; else that of what lies below the field.
void NumberField::contextMenuEvent(QContextMenuEvent* event)
{
    if (lineEdit()->isModified())
        QAbstractSpinBox::contextMenuEvent(event);
    else
        event->ignore();
}

bool NumberField::event(QEvent* event)
{
    if (event->type() == QEvent::Hide || (event->type() == QEvent::EnabledChange && !isEnabled()))
        m_drag->end();
    // Ctrl+Z belongs to the document unless a text is being typed.
    if (event->type() == QEvent::ShortcutOverride && !lineEdit()->isModified()) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->ignore();
            return false;
        }
    }
    return QAbstractSpinBox::event(event);
}

void NumberField::focusInEvent(QFocusEvent* event)
{
    QAbstractSpinBox::focusInEvent(event);
    if (event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason)
        selectAll();
    setNote({});
    showCursor();
    emit gestureBegan();
}

void NumberField::focusOutEvent(QFocusEvent* event)
{
    commit(false);
    QAbstractSpinBox::focusOutEvent(event);
    showCursor();
    emit gestureEnded();
}

void NumberField::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        enter();
        return;
    case Qt::Key_Escape:
        if (lineEdit()->isModified() || m_refused) {
            setRefusal({});
            showValue();
            selectAll();
            return;
        }
        event->ignore();
        return;
    case Qt::Key_Up:
    case Qt::Key_Down:
        m_stepFactor = event->modifiers().testFlag(Qt::ShiftModifier)     ? 0.1
                       : event->modifiers().testFlag(Qt::ControlModifier) ? 10.0
                                                                          : 1.0;
        stepBy(event->key() == Qt::Key_Up ? 1 : -1);
        m_stepFactor = 1.0;
        return;
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
        stepBy(event->key() == Qt::Key_PageUp ? 10 : -10);
        return;
    default:
        QAbstractSpinBox::keyPressEvent(event);
    }
}

void NumberField::wheelEvent(QWheelEvent* event)
{
    const int steps = event->angleDelta().y() / 120;
    if (steps != 0)
        stepBy(steps);
    event->accept();
}

QSize NumberField::sizeHint() const
{
    QSize size = QAbstractSpinBox::sizeHint();
    size.setWidth(fontMetrics().horizontalAdvance(QStringLiteral("−000.00 m")) + 16);
    return size;
}

QSize NumberField::minimumSizeHint() const
{
    QSize size = QAbstractSpinBox::minimumSizeHint();
    size.setWidth(fontMetrics().horizontalAdvance(QStringLiteral("0.000°")) + 14);
    return size;
}

} // namespace ramure
