#include "widgets/base/fixed_hint.h"

#include <QEvent>

namespace ramure {

FixedHint::FixedHint(QWidget* widget, std::function<QString()> text)
    : HintSource(widget)
    , m_text(std::move(text))
{
    widget->installEventFilter(this);
    say(m_text());
}

bool FixedHint::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        say(m_text());
    return HintSource::eventFilter(watched, event);
}

} // namespace ramure
