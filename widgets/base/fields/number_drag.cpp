#include "widgets/base/fields/number_drag.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <algorithm>

namespace ramure {

void NumberDrag::begin(const NumberScale& scale, const Start& start, std::optional<double> before)
{
    m_scale = scale;
    m_start = start;
    m_before = before;
    m_x = start.x;
    m_position = start.held.value_or(scale.positionOf(start.value));
    m_on = true;
    // Whoever has the focus: Esc is the drag's.
    QCoreApplication::instance()->installEventFilter(this);
}

void NumberDrag::moveTo(double x, Qt::KeyboardModifiers modifiers)
{
    if (!m_on || x == m_x)
        return;
    const double speed = modifiers.testFlag(Qt::ShiftModifier)     ? 0.1
                         : modifiers.testFlag(Qt::ControlModifier) ? 10.0
                                                                   : 1.0;
    const double precision = speed / m_start.length;
    m_position += (x - m_x) * precision;
    if (!m_start.held)
        m_position =
            std::clamp(m_position, m_scale.positionOf(m_start.least), m_scale.positionOf(m_start.most));
    m_x = x;
    emit moved(
        std::clamp(m_scale.numberAt(m_position, precision, m_start.factor), m_start.least, m_start.most));
}

void NumberDrag::end()
{
    if (!m_on)
        return;
    m_on = false;
    QCoreApplication::instance()->removeEventFilter(this);
    emit ended();
}

bool NumberDrag::eventFilter(QObject*, QEvent* event)
{
    if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)
        return false;
    const auto& key = *static_cast<QKeyEvent*>(event);
    if (key.matches(QKeySequence::Undo) || key.matches(QKeySequence::Redo))
        end(); // what the key brings shall not be dragged away again
    if (key.key() != Qt::Key_Escape)
        return false;
    event->accept();
    if (event->type() == QEvent::KeyPress) {
        if (m_before)
            emit moved(*m_before);
        end();
    }
    return true;
}

} // namespace ramure
