#include "widgets/panels/timeline/time_field.h"

#include <QLineEdit>
#include <QWheelEvent>
#include <algorithm>

namespace ramure {

TimeField::TimeField(QWidget* parent)
    : QAbstractSpinBox(parent)
{
    setButtonSymbols(NoButtons);
    setAlignment(Qt::AlignRight);
    setFocusPolicy(Qt::StrongFocus);
    connect(this, &QAbstractSpinBox::editingFinished, this, &TimeField::commit);
    showFrame();
}

void TimeField::setDisplay(TimeDisplay display, double framesPerSecond)
{
    m_display = display;
    m_rate = framesPerSecond;
    updateGeometry();
    showFrame();
}

void TimeField::setFrame(qint64 frame)
{
    const bool typing = hasFocus() && text() != m_shown;
    m_frame = frame;
    if (!typing)
        showFrame();
}

void TimeField::stepBy(int steps)
{
    commit();
    const qint64 next = std::clamp<qint64>(m_frame + steps, leastFrame, mostFrame);
    if (next == m_frame)
        return;
    m_frame = next;
    showFrame();
    selectAll();
    emit frameEdited(next);
}

/// A text that is no time gives way to the present one.
void TimeField::commit()
{
    const auto frame = text() != m_shown ? frameFromText(text(), m_rate, m_display) : std::nullopt;
    const bool changed = frame && *frame != m_frame;
    if (changed)
        m_frame = *frame;
    showFrame();
    if (changed)
        emit frameEdited(m_frame);
}

void TimeField::showFrame()
{
    m_shown = timeText(m_frame, m_rate, m_display);
    lineEdit()->setText(m_shown);
}

QSize TimeField::sizeHint() const
{
    const QString widest =
        m_display == TimeDisplay::Timecode ? QStringLiteral("-00:00:00:00") : QStringLiteral("-000000.0");
    return {fontMetrics().horizontalAdvance(widest) + 14, QAbstractSpinBox::sizeHint().height()};
}

void TimeField::wheelEvent(QWheelEvent* event)
{
    if (hasFocus())
        QAbstractSpinBox::wheelEvent(event);
    else
        event->ignore();
}

} // namespace ramure
