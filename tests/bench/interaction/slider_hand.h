/// \file
/// A hand on the mouse: finds the slider of a parameter in the window and drags it, with events that take the
/// way of real ones through the window.
#pragma once

#include <QEvent>
#include <QPoint>
#include <QString>

class QWidget;

namespace ramure {
class NumberSlider;
}

namespace ramure::bench {

class SliderHand
{
public:
    /// \param key of the parameter, whose row is scrolled into view. The handle is taken; released at the
    /// end.
    SliderHand(QWidget* window, const QString& key);
    ~SliderHand();
    SliderHand(const SliderHand&) = delete;
    SliderHand& operator=(const SliderHand&) = delete;

    [[nodiscard]] bool isThere() const { return m_slider != nullptr; }
    /// To a share of the way between the slider's ends.
    void moveTo(double share);

private:
    [[nodiscard]] QPoint at(double share) const;
    void send(QEvent::Type type, Qt::MouseButton button, Qt::MouseButtons buttons);

    QWidget* m_window;
    NumberSlider* m_slider = nullptr;
    QPoint m_last;
};

} // namespace ramure::bench
