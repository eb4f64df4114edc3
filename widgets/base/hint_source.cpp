#include "widgets/base/hint_source.h"

#include <utility>

namespace ramure {

void HintSource::say(const QString& hint)
{
    if (m_hint == hint)
        return;
    m_hint = hint;
    emit changed();
}

void HintSource::setGesture(bool goesOn)
{
    if (std::exchange(m_gesture, goesOn) == goesOn)
        return;
    emit changed();
    if (goesOn)
        emit gestureBegan();
}

} // namespace ramure
