#include "tests/bench/interaction/slider_hand.h"

#include "widgets/base/fields/number_slider.h"
#include "widgets/panels/properties/param_editor.h"
#include <QMouseEvent>
#include <QScrollArea>
#include <QTest>
#include <QWindow>

namespace ramure::bench {

SliderHand::SliderHand(QWidget* window, const QString& key)
    : m_window(window)
{
    const auto* editor = window->findChild<ParamEditor*>(key);
    m_slider = editor ? editor->findChild<NumberSlider*>() : nullptr;
    if (!m_slider)
        return;
    for (QWidget* parent = m_slider->parentWidget(); parent; parent = parent->parentWidget())
        if (auto* area = qobject_cast<QScrollArea*>(parent))
            area->ensureWidgetVisible(m_slider);
    (void)QTest::qWaitFor([this] { return m_slider->visibleRegion().contains(m_slider->rect().center()); });
    m_last = at(0.5);
    send(QEvent::MouseButtonPress, Qt::LeftButton, Qt::LeftButton);
}

SliderHand::~SliderHand()
{
    if (m_slider)
        send(QEvent::MouseButtonRelease, Qt::LeftButton, Qt::NoButton);
}

QPoint SliderHand::at(double share) const
{
    constexpr int margin = 9;
    const QPoint inside(margin + qRound(share * (m_slider->width() - 2 * margin)), m_slider->height() / 2);
    return m_slider->mapTo(m_window, inside);
}

void SliderHand::moveTo(double share)
{
    m_last = at(share);
    send(QEvent::MouseMove, Qt::NoButton, Qt::LeftButton);
}

// QTest's own would handle other events too before it returns.
void SliderHand::send(QEvent::Type type, Qt::MouseButton button, Qt::MouseButtons buttons)
{
    QMouseEvent event(type, QPointF(m_last), m_window->mapToGlobal(QPointF(m_last)), button, buttons,
                      Qt::NoModifier);
    QCoreApplication::sendEvent(m_window->windowHandle(), &event);
}

} // namespace ramure::bench
