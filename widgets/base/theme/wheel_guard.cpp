#include "widgets/base/theme/wheel_guard.h"

#include <QEvent>
#include <QWidget>

namespace ramure {
namespace {

class WheelGuard : public QObject
{
public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (event->type() != QEvent::Wheel || static_cast<QWidget*>(watched)->hasFocus())
            return false;
        event->ignore(); // what lies below it may scroll
        return true;
    }
};

} // namespace

void guardFromWheel(QWidget* widget)
{
    if (widget->focusPolicy() == Qt::WheelFocus)
        widget->setFocusPolicy(Qt::StrongFocus);
    static WheelGuard guard;
    widget->installEventFilter(&guard); // a second time moves it to the front only
}

} // namespace ramure
