#include "widgets/view/tools/hand/number_tool.h"

#include <QKeyEvent>
#include <utility>

namespace ramure {

void NumberTool::start(std::unique_ptr<HandEdit> edit, const ToolPoint& point)
{
    setAim({});
    m_edit = std::move(edit);
    m_typed.clear();
    m_byKeys = false;
    m_at = point.at;
}

void NumberTool::release(const ToolPoint& point)
{
    if (!m_edit)
        return;
    if (isChanged() || !m_typed.isEmpty())
        return finish(true);
    m_at = point.at;
    m_byKeys = true;
    begin(Qt::NoButton);
}

void NumberTool::pressAgain(const ToolPoint& point)
{
    if (m_byKeys || point.button == Qt::RightButton)
        finish(point.button == Qt::LeftButton);
}

bool NumberTool::wheel(const ToolPoint& point, double turn)
{
    constexpr double notch = 120.0; // eighths of a degree
    if (!isBusy() || !m_edit)
        return EditTool::wheel(point, turn);
    m_typed.clear();
    turnWheel(turn / notch);
    show();
    return true;
}

void NumberTool::key(const QKeyEvent& event, bool pressed)
{
    if (!pressed || !m_edit)
        return;
    if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter)
        return finish(true);
    const bool typed = event.key() == Qt::Key_Backspace
                           ? m_typed.erase()
                           : !event.text().isEmpty() &&
                                 (takesMinus() || event.text() != QLatin1String("-")) &&
                                 m_typed.type(event.text().front());
    if (typed)
        show();
}

void NumberTool::focusLost()
{
    if (m_byKeys)
        finish(true);
}

void NumberTool::finish(bool keep)
{
    if (isBusy())
        end();
    if (const auto edit = std::exchange(m_edit, nullptr))
        keep ? edit->keep() : edit->cancel();
    setAim({});
}

} // namespace ramure
